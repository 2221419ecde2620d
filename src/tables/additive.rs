//! Steps of additive recurrences.

/// The steps of the generalised R_d sequence in d dimensions as fractions of 2^64, each
/// rounded to nearest: g^-1, g^-2, ..., g^-d, where g > 1 solves g^(d+1) = g + 1.
///
/// Domain: any d; 0 has none. For d = 1 it is the golden ratio, for d = 2 the plastic number.
/// Source: Roberts 2018, The unreasonable effectiveness of quasirandom sequences.
#[must_use]
pub fn additive_alphas(d: usize) -> Vec<u64> {
    // x = 1/g solves x^d + x^(d+1) = 1, and the left side grows: bit by bit.
    let mut x = 0u128;
    for bit in (0..FRACTION).rev() {
        let trial = x | (1 << bit);
        let power = (1..d).fold(trial, |power, _| multiply(power, trial));
        if power + multiply(power, trial) <= ONE {
            x = trial;
        }
    }
    let mut power = ONE;
    (0..d)
        .map(|_| {
            power = multiply(power, x);
            ((power >> (FRACTION - 65)).div_ceil(2)) as u64
        })
        .collect()
}

/// Bits of a fraction. Each product is cut to them: an error of 2^-126, which d products and
/// the root they give leave far below 2^-65.
const FRACTION: u32 = 126;
const ONE: u128 = 1 << FRACTION;

/// floor(a b / 2^126) less at most 1, for a, b <= 2^126.
fn multiply(a: u128, b: u128) -> u128 {
    const LOW: u128 = (1 << 63) - 1;
    let (a_high, a_low) = (a >> 63, a & LOW);
    let (b_high, b_low) = (b >> 63, b & LOW);
    a_high * b_high + ((a_high * b_low + a_low * b_high) >> 63)
}
