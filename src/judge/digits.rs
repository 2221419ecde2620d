//! Permutations as whole tables, and scrambled radical inverses as exact fractions of their
//! digits.

/// The mixer that seeds and keys go through, by its definition modulo 2^32.
fn mix(x: u32) -> u64 {
    let times = |x: u64, odd: u64| x * odd % (1 << 32);
    let mut x = u64::from(x);
    x = times(x ^ (x / (1 << 16)), 0x7feb_352d);
    x = times(x ^ (x / (1 << 15)), 0x846c_a68b);
    x ^ (x / (1 << 16))
}

/// Key `index` of a stream.
fn key(stream: u64, index: u64) -> u64 {
    mix(((stream + index * 0x9e37_79b9) % (1 << 32)) as u32)
}

/// The permutation of 0 .. length - 1 that a seed chooses, as a table.
///
/// Domain: length from 1 to what memory holds.
#[must_use]
pub fn permutation(length: usize, seed: u32) -> Vec<u32> {
    let stream = mix(seed);
    let mut table = vec![0; length];
    if length <= 16 {
        let mut order: Vec<usize> = (0..length).collect();
        order.sort_by_key(|&i| key(stream, i as u64));
        for (rank, &i) in order.iter().enumerate() {
            table[i] = rank as u32;
        }
        return table;
    }
    let size = length.next_power_of_two() as u128;
    let bits = size.ilog2();
    let image: Vec<u128> = (0..size)
        .map(|start| {
            (0..8).fold(start, |x, round| {
                let k = u128::from(key(stream, round));
                let x = (x ^ k) % size;
                // The halves of the key swapped, and made odd.
                let odd = (k / 65536 + k % 65536 * 65536) | 1;
                let y = (odd * x + 2 * (k / 256) * x * x) % size;
                (0..bits).fold(0, |r, bit| 2 * r + (y >> bit) % 2)
            })
        })
        .collect();
    let offset = (u128::from(key(stream, 8)) * length as u128) >> 32;
    for (i, entry) in table.iter_mut().enumerate() {
        let mut x = image[i];
        while x >= length as u128 {
            x = image[x as usize];
        }
        *entry = ((x + offset) % length as u128) as u32;
    }
    table
}

/// Faure's permutation in a base of at least 1, by his recursion.
#[must_use]
pub fn faure_permutation(base: u32) -> Vec<u32> {
    if base == 1 {
        return vec![0];
    }
    if base.is_multiple_of(2) {
        let half: Vec<u32> = faure_permutation(base / 2).iter().map(|x| 2 * x).collect();
        let odd = half.iter().map(|x| x + 1);
        return half.iter().copied().chain(odd).collect();
    }
    let middle = (base - 1) / 2;
    let mut table: Vec<u32> = faure_permutation(base - 1)
        .iter()
        .map(|&x| x + u32::from(x >= middle))
        .collect();
    table.insert(middle as usize, middle);
    table
}

/// A fraction whose digits in a base are `digits`, the most significant first.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Scrambled {
    /// The base.
    pub base: u32,
    /// The digits.
    pub digits: Vec<u32>,
}

impl Scrambled {
    /// The digits of n from the lowest on: as many as whole groups need to reach 2^-32.
    #[must_use]
    pub fn of(n: u32, base: u32) -> Self {
        let per_group = (1..).take_while(|&k| base.pow(k) <= 65535).count();
        let mut length = per_group;
        while u128::from(base).pow(length as u32) < 1 << 32 {
            length += per_group;
        }
        let mut rest = n;
        let digits = (0..length).map(|_| {
            let digit = rest % base;
            rest /= base;
            digit
        });
        Self {
            base,
            digits: digits.collect(),
        }
    }

    /// The first `count` digits as an integer: the number of the b-adic cell.
    #[must_use]
    pub fn cell(&self, count: usize) -> u128 {
        let digits = &self.digits[..count.min(self.digits.len())];
        let value = |v: u128, d: &u32| v * u128::from(self.base) + u128::from(*d);
        digits.iter().fold(0, value)
    }

    /// The fraction times 2^32, and what it is to be divided by.
    fn ratio(&self) -> (u128, u128) {
        let length = self.digits.len();
        (
            self.cell(length) << 32,
            u128::from(self.base).pow(length as u32),
        )
    }

    /// floor(2^32 x).
    #[must_use]
    pub fn floor(&self) -> u64 {
        let (numerator, denominator) = self.ratio();
        (numerator / denominator) as u64
    }

    /// ceil(2^32 x), at most 2^32 - 1.
    #[must_use]
    pub fn ceil(&self) -> u64 {
        let (numerator, denominator) = self.ratio();
        (numerator.div_ceil(denominator) as u64).min((1 << 32) - 1)
    }
}

/// The key of each position of a digit, for a seed and a base.
fn position_keys(base: u32, seed: u32, count: usize) -> Vec<u32> {
    let stream = mix(key(mix(seed), base.into()) as u32);
    (0..count as u64).map(|i| key(stream, i) as u32).collect()
}

/// The radical inverse with one random permutation per position, by whole tables.
#[must_use]
pub fn permuted(n: u32, base: u32, seed: u32) -> Scrambled {
    let mut x = Scrambled::of(n, base);
    let keys = position_keys(base, seed, x.digits.len());
    for (digit, key) in x.digits.iter_mut().zip(keys) {
        *digit = permutation(base as usize, key)[*digit as usize];
    }
    x
}

/// The radical inverse with a random permutation per position and preceding digits.
#[must_use]
pub fn owen(n: u32, base: u32, seed: u32) -> Scrambled {
    let plain = Scrambled::of(n, base);
    let keys = position_keys(base, seed, plain.digits.len());
    let mut x = plain.clone();
    for (i, key) in keys.into_iter().enumerate() {
        // The digits before this one as a number: n mod b^i.
        let before = plain.digits[..i].iter().rev();
        let prefix = before.fold(0, |v: u64, d| v * u64::from(base) + u64::from(*d));
        let node = key ^ mix(prefix as u32) as u32;
        x.digits[i] = permutation(base as usize, node)[plain.digits[i] as usize];
    }
    x
}

/// The radical inverse of n more than a random b-adic number.
#[must_use]
pub fn started(n: u32, base: u32, seed: u32) -> Scrambled {
    let mut x = Scrambled::of(n, base);
    let wide = u128::from(base);
    let keys = position_keys(base, seed, x.digits.len());
    let start = keys.into_iter().rev().fold(0, |v: u128, key| {
        v * wide + ((u128::from(key) * wide) >> 32)
    });
    let mut sum = start + u128::from(n);
    for digit in &mut x.digits {
        *digit = (sum % wide) as u32;
        sum /= wide;
    }
    x
}
