//! Arguments to check functions with: every critical value, and random ones.

use super::strata;
use crate::catalog::Kind;
use crate::reference::hemisphere;
pub use crate::reference::permute::permute_mix as mix;
use crate::tables::PRIMES;
use glam::uvec2;

/// Random arguments of each function, besides the critical ones.
const RANDOM: u32 = 1 << 18;

/// Arguments for a kind of function.
pub fn arguments(kind: Kind) -> Vec<[u32; 4]> {
    match kind {
        Kind::Word => {
            let strided = (0..1u32 << 20).map(|i| i.wrapping_mul(4097));
            words().into_iter().chain(strided).map(spread).collect()
        }
        Kind::Words => pairs(&words(), mix, 1, RANDOM),
        Kind::CostlyWords => pairs(&words(), mix, 8, RANDOM / 16),
        Kind::Float => {
            let random = (0..RANDOM).map(|i| normal(mix(i)));
            floats().into_iter().chain(random).map(spread).collect()
        }
        Kind::Floats => pairs(&floats(), |i| normal(mix(i)), 1, RANDOM),
        Kind::Radical => radical(),
        Kind::Grid => grid(),
        Kind::Direction => directions(),
        Kind::Strata => strata::strata(),
        Kind::Digits => strata::digits(),
    }
}

/// The values that functions of several arguments meet in all pairs: floats for those of
/// floats, words for others.
#[must_use]
pub fn critical(kind: Kind) -> Vec<u32> {
    match kind {
        Kind::Float | Kind::Floats => floats(),
        _ => words(),
    }
}

fn spread(x: u32) -> [u32; 4] {
    [x, mix(x), mix(!x), mix(x ^ 0x9e37_79b9)]
}

/// One in `every` pairs of critical values, so that each value stands in either place as
/// often, and random pairs.
fn pairs(critical: &[u32], random: impl Fn(u32) -> u32, every: usize, count: u32) -> Vec<[u32; 4]> {
    let mut list = Vec::with_capacity(critical.len().pow(2) / every + count as usize);
    for (i, &x) in critical.iter().enumerate() {
        for &y in critical.iter().skip(i % every).step_by(every) {
            list.push([x, y, mix(x ^ y), mix(x.wrapping_add(y))]);
        }
    }
    list.extend((0..count).map(|i| {
        [
            random(4 * i),
            random(4 * i + 1),
            mix(4 * i + 2),
            mix(4 * i + 3),
        ]
    }));
    list
}

/// Words around 0, every power of two and every eighth of 2^32.
fn words() -> Vec<u32> {
    let mut list = Vec::new();
    for bit in 0..32 {
        for offset in [-2i64, -1, 0, 1, 2] {
            list.push(((1i64 << bit) + offset) as u32);
            list.push((-(1i64 << bit) + offset) as u32);
        }
    }
    list.extend(
        (0..8u32).flat_map(|eighth| [-1i64, 0, 1].map(|o| ((i64::from(eighth) << 29) + o) as u32)),
    );
    list.sort_unstable();
    list.dedup();
    list
}

/// Floats of many exponents with critical mantissas, zeros, denormals, infinities and
/// NaN. Loads and bitcasts keep denormals on every device.
fn floats() -> Vec<u32> {
    let mut list = vec![0, 0x8000_0000, 0x7f80_0000, 0xff80_0000, 0x7fc0_0000];
    for denormal in [1, 2, 0x40_0000, 0x7f_ffff] {
        list.extend([denormal, denormal | 0x8000_0000]);
    }
    for exponent in [
        1, 2, 60, 96, 100, 119, 120, 124, 125, 126, 127, 128, 129, 140, 150, 200, 253, 254,
    ] {
        for mantissa in [
            0, 1, 2, 0x3f_ffff, 0x40_0000, 0x40_0001, 0x7f_fffe, 0x7f_ffff,
        ] {
            let bits = (exponent << 23) | mantissa;
            list.extend([bits, bits | 0x8000_0000]);
        }
    }
    list
}

/// Any bits as a normal float of either sign.
#[must_use]
pub fn normal(bits: u32) -> u32 {
    let exponent = (bits >> 23) & 0xff;
    if exponent == 0 || exponent == 255 {
        (bits & 0x807f_ffff) | (127 << 23)
    } else {
        bits
    }
}

/// Small, high and edge indices of primes all over the table.
fn radical() -> Vec<[u32; 4]> {
    let mut list = Vec::new();
    for base in PRIMES.into_iter().step_by(13).chain([2, 3, 5, 7, 8161]) {
        let mut power = 1u64;
        while power < 1 << 32 {
            for multiple in 1..=u64::from(base.min(8)) {
                for offset in -1i64..=1 {
                    if let Ok(n) = u32::try_from((power * multiple) as i64 + offset) {
                        list.push([n, base, 0, 0]);
                    }
                }
            }
            power *= u64::from(base);
        }
        list.extend((0..1024).map(|i| [mix(i ^ (base << 12)), base, 0, 0]));
        list.extend([[u32::MAX, base, 0, 0], [u32::MAX - 1, base, 0, 0]]);
    }
    list
}

/// k < N for all kinds of N; N = 2^32 is written as 0.
fn grid() -> Vec<[u32; 4]> {
    let mut list = Vec::new();
    for count in [
        1u64,
        2,
        3,
        5,
        7,
        1000,
        1 << 20,
        1_000_003,
        (1 << 31) - 1,
        1 << 31,
        (1 << 31) + 1,
        (1 << 32) - 1,
        1 << 32,
    ] {
        let ends = (0..64).chain(count.saturating_sub(64)..count);
        let random = (0..4096).map(|i| u64::from(mix(i)) % count);
        list.extend(
            ends.chain(random)
                .filter(|k| *k < count)
                .map(|k| [k as u32, count as u32, 0, 0]),
        );
    }
    list
}

/// Unit vectors: the axes, all pairs of critical fractions, random ones, both
/// hemispheres, and slightly tilted axes.
fn directions() -> Vec<[u32; 4]> {
    let mut list: Vec<[f32; 3]> = Vec::new();
    for tilt in [0.0, 1e-3, 1e-6, 1e-10, 1e-14, 1e-20, 1e-30] {
        for sign in [1.0, -1.0] {
            list.extend([
                [sign, tilt, -tilt],
                [tilt, sign, tilt],
                [-tilt, tilt, sign],
                [tilt, 0.0, sign],
            ]);
        }
    }
    let critical: Vec<u32> = words().into_iter().step_by(4).collect();
    let mut sample = |x: u32, y: u32| {
        let d = hemisphere::uniform_hemisphere(uvec2(x, y));
        list.push([d.x, d.y, if (x ^ y) & 1 == 0 { d.z } else { -d.z }]);
        let d = hemisphere::cosine_hemisphere(uvec2(x, y));
        list.push([d.x, d.y, d.z]);
    };
    for &x in &critical {
        for &y in &critical {
            sample(x, y);
        }
    }
    for i in 0..RANDOM / 2 {
        sample(mix(2 * i), mix(2 * i + 1));
    }
    (0..)
        .zip(list)
        .map(|(i, v)| [v[0].to_bits(), v[1].to_bits(), v[2].to_bits(), mix(i)])
        .collect()
}
