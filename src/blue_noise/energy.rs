//! The energies of void-and-cluster as integers, equal on every machine.

/// Variance-free factor of the Gaussian: e^(-1 / (2 * 1.5^2)) in units of 2^-64, rounded
/// to nearest. Ulichney found 1.5 pixels best.
const FACTOR: u64 = 0xccfd_205e_362f_b68d;

/// Fractional bits of an energy.
const FRACTION: u32 = 24;

/// Energies e^(-d^2 / (2 * 1.5^2)) of a pixel at squared distance d^2, in units of 2^-24,
/// rounded to nearest; d^2 = 77 is the last whose energy is not 0, so the Gaussian ends
/// by itself and is not cut.
///
/// The sum over a whole plane is below 2^28, and over time at one pixel below 2^26: the
/// energy of a pixel never reaches 2^31, which leaves the top bit of a word free.
///
/// Powers of the factor are truncated to 2^-64, so the k-th is off by less than k units
/// of that, and no table entry lies so near to a tie that its rounding could differ.
#[must_use]
pub fn energies() -> Vec<u32> {
    let mut power = u64::MAX;
    let mut list = vec![1 << FRACTION];
    loop {
        power = ((u128::from(power) * u128::from(FACTOR)) >> 64) as u64;
        let half = 1u64 << (63 - FRACTION);
        let rounded = (power + half) >> (64 - FRACTION);
        if rounded == 0 {
            return list;
        }
        list.push(rounded as u32);
    }
}
