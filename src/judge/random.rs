//! Random numbers and scrambles, from their definitions in wide integers.

/// Wellons's triple32.
#[must_use]
pub fn hash(x: u32) -> u32 {
    let mut x = u64::from(x);
    for (shift, factor) in [
        (17, 0xed5a_d4bb),
        (11, 0xac4c_1b51),
        (15, 0x3184_8bab),
        (14, 1),
    ] {
        x = ((x ^ (x >> shift)) * factor) % (1 << 32);
    }
    x as u32
}

/// Jarzynski and Olano's pcg4d: two rounds.
#[must_use]
pub fn pcg4d(v: [u32; 4]) -> [u32; 4] {
    let v = v.map(|x| (u64::from(x) * 1_664_525 + 1_013_904_223) % (1 << 32));
    round(folded(round(v))).map(|x| x as u32)
}

/// A third round of pcg4d, folded.
#[must_use]
pub fn mix4(v: [u32; 4]) -> [u32; 4] {
    folded(round(folded(pcg4d(v).map(u64::from)))).map(|x| x as u32)
}

/// Each word takes the product of two others, in this order.
fn round(mut v: [u64; 4]) -> [u64; 4] {
    for (to, a, b) in [(0, 1, 3), (1, 2, 0), (2, 0, 1), (3, 1, 2)] {
        v[to] = ((u128::from(v[to]) + u128::from(v[a]) * u128::from(v[b])) % (1 << 32)) as u64;
    }
    v
}

/// The upper 16 bits of each word added to the lower ones without carry.
fn folded(v: [u64; 4]) -> [u64; 4] {
    v.map(|x| x ^ (x / 65_536))
}

/// `rounds` rounds of Philox-4x32 of Salmon et al. 2011, whose keys are a Weyl sequence.
/// Ten rounds make Philox-4x32-10.
#[must_use]
pub fn philox(counter: [u32; 4], key: [u32; 2], rounds: u32) -> [u32; 4] {
    let mut counter = counter.map(u64::from);
    for round in 0..u64::from(rounds) {
        let key = [
            (u64::from(key[0]) + round * 0x9e37_79b9) % (1 << 32),
            (u64::from(key[1]) + round * 0xbb67_ae85) % (1 << 32),
        ];
        let products = [counter[0] * 0xd251_1f53, counter[2] * 0xcd9e_8d57];
        let (high, low) = (products.map(|p| p >> 32), products.map(|p| p % (1 << 32)));
        counter = [
            high[1] ^ counter[1] ^ key[0],
            low[1],
            high[0] ^ counter[3] ^ key[1],
            low[0],
        ];
    }
    counter.map(|x| x as u32)
}

/// O'Neill's PCG32 (XSH-RR 64/32): state and increment.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Pcg32 {
    /// The state.
    pub state: u64,
    /// What each step adds.
    pub increment: u64,
}

impl Pcg32 {
    /// The generator with this seed and stream.
    #[must_use]
    pub fn new(state: u64, stream: u64) -> Self {
        let mut new = Self {
            state: 0,
            increment: stream.wrapping_mul(2) | 1,
        };
        new.step();
        new.state = new.state.wrapping_add(state);
        new.step();
        new
    }

    /// One step.
    pub fn step(&mut self) {
        let next = u128::from(self.state) * 6_364_136_223_846_793_005 + u128::from(self.increment);
        self.state = next as u64;
    }

    /// The number of the current state.
    #[must_use]
    pub fn value(&self) -> u32 {
        let mixed = ((self.state ^ (self.state >> 18)) >> 27) as u32;
        mixed.rotate_right((self.state >> 59) as u32)
    }

    /// Many steps: half of them, twice, and one more for an odd number.
    #[must_use]
    pub fn advanced(self, steps: u64) -> Self {
        let (multiplier, increment) = power(steps, u128::from(self.increment));
        let state = (multiplier * u128::from(self.state) + increment) as u64;
        Self { state, ..self }
    }
}

/// The map of so many steps: state times x plus y.
fn power(steps: u64, increment: u128) -> (u128, u128) {
    const MASK: u128 = u64::MAX as u128;
    if steps == 0 {
        return (1, 0);
    }
    let (m, c) = power(steps / 2, increment);
    let (m, c) = ((m * m) & MASK, (m * c + c) & MASK);
    if steps.is_multiple_of(2) {
        return (m, c);
    }
    const STEP: u128 = 6_364_136_223_846_793_005;
    ((m * STEP) & MASK, (c * STEP + increment) & MASK)
}

/// Owen's nested uniform scrambling: a walk down the tree that asks each node for its flip.
#[must_use]
pub fn owen(x: u32, dimension: u32, seed: [u32; 2]) -> u32 {
    let digits: Vec<bool> = (0..32).map(|i| (x >> (31 - i)) & 1 == 1).collect();
    let mut result = 0u32;
    for level in 0..32 {
        let flip = owen_flip(&digits[..level], dimension, seed);
        result = 2 * result + u32::from(digits[level] ^ flip);
    }
    result
}

/// The flip of the node that these digits lead to.
#[must_use]
pub fn owen_flip(path: &[bool], dimension: u32, seed: [u32; 2]) -> bool {
    let number = |digits: &[bool], from: u32| {
        digits
            .iter()
            .fold(from, |n, digit| 2 * n + u32::from(*digit))
    };
    let (above, within) = path.split_at(path.len() / 7 * 7);
    let counter = [number(above, 0), path.len() as u32 / 7, dimension, 1];
    let block = philox(counter, seed, 10);
    let bits = (0..4).fold(0u128, |bits, i| bits | (u128::from(block[i]) << (32 * i)));
    (bits >> number(within, 1)) & 1 == 1
}

/// Matousek's random linear matrix scrambling: each digit of the result as a sum of
/// products, row by row.
#[must_use]
pub fn matrix_scramble(x: u32, dimension: u32, seed: [u32; 2]) -> u32 {
    let digit = |word: u32, i: u32| (word >> (31 - i)) & 1;
    let column = |j: u32| philox([j / 4, 0, dimension, 2], seed, 10)[j as usize % 4];
    let columns: Vec<u32> = (0..32).map(column).collect();
    let mut result = 0;
    for row in 0..32 {
        let below = (0..row).map(|j| digit(columns[j as usize], row) * digit(x, j));
        let sum: u32 = digit(x, row) + below.sum::<u32>();
        result |= (sum % 2) << (31 - row);
    }
    result
}

/// The Laine-Karras hash on digits in reverse, in 64 bits.
#[must_use]
pub fn owen_hash(x: u32, seed: u32) -> u32 {
    let reverse = |x: u64| (0..32).fold(0, |y, i| y | (((x >> i) & 1) << (31 - i)));
    let xored = |x: u64, factor: u64| x ^ ((x * factor) % (1 << 32));
    let seed = u64::from(seed);
    let mut y = xored(reverse(u64::from(x)), 0x3d20_adea);
    y = (y + seed) % (1 << 32);
    y = y * (seed >> 16 | 1) % (1 << 32);
    y = xored(xored(y, 0x0552_6c56), 0x53a2_2864);
    reverse(y) as u32
}
