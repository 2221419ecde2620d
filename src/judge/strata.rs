//! Strata and lattices as exact quotients of 128 bits.

use super::digits::permutation;

/// floor(2^32 x) of the point that `jitter` 2^-32 of the way into cell `cell` of `strata`
/// is, where the way leads over the multiples of 2^-32 in the cell.
#[must_use]
pub fn stratum(cell: u64, strata: u64, jitter: u32) -> u64 {
    let edge = |cell: u64| (u128::from(cell) << 32).div_ceil(u128::from(strata));
    let (first, end) = (edge(cell), edge(cell + 1));
    (first + ((u128::from(jitter) * (end - first)) >> 32)) as u64
}

/// Point n of Kensler's set of width * height points, by whole permutations: `keys` are the
/// seeds of the order, of the rows and of the columns.
#[must_use]
pub fn cmj(n: usize, grid: [usize; 2], keys: [u32; 3], jitter: [u32; 2]) -> [u64; 2] {
    let [width, height] = grid;
    let count = width * height;
    let cell = permutation(count, keys[0])[n] as usize;
    let (column, row) = (cell % width, cell / width);
    let x = column * height + permutation(height, keys[1])[row] as usize;
    let y = row * width + permutation(width, keys[2])[column] as usize;
    [
        stratum(x as u64, count as u64, jitter[0]),
        stratum(y as u64, count as u64, jitter[1]),
    ]
}

/// ceil(2^32 (n z mod count) / count).
#[must_use]
pub fn korobov(n: u32, z: u32, count: u64) -> u64 {
    let k = u128::from(n) * u128::from(z) % u128::from(count);
    (k << 32).div_ceil(u128::from(count)) as u64
}

/// floor(2^32 frac(1/2 + n alpha)), alpha a fraction of 2^64.
#[must_use]
pub fn additive(n: u32, alpha: u64) -> u64 {
    let turns = u128::from(n) * u128::from(alpha) + (1 << 63);
    ((turns % (1 << 64)) >> 32) as u64
}
