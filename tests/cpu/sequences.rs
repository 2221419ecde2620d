//! Radical inverses and grids against exact rationals, and their net properties.

use corput::bulk::Reference;
use corput::catalog::{Engine, Options, Request, Scramble, Sequence};
use corput::judge;
use corput::reference::{hammersley, odometer, radical_inverse, unit};
use corput::tables::PRIMES;
use corput::variant::{odometer_base, radical_base};

fn mix(mut x: u32) -> u32 {
    x ^= x >> 16;
    x = x.wrapping_mul(0x7feb_352d);
    x ^= x >> 15;
    x = x.wrapping_mul(0x846c_a68b);
    x ^ (x >> 16)
}

/// Indices around every multiple of every power of the base, and random ones.
fn indices(base: u32) -> Vec<u32> {
    let mut list = vec![0, 1, 2, u32::MAX, u32::MAX - 1];
    let mut power = 1u64;
    while power < 1 << 32 {
        for multiple in 1..=u64::from(base.min(40)) {
            for offset in -2i64..=2 {
                if let Ok(n) = u32::try_from((power * multiple) as i64 + offset) {
                    list.push(n);
                }
            }
        }
        power *= u64::from(base);
    }
    list.extend((0..500).map(|i| mix(i ^ base.wrapping_mul(0x9e37_79b9))));
    list
}

#[test]
fn radical_inverses_of_1024_primes_are_exact() {
    for base in PRIMES {
        let table = radical_base(base);
        for n in indices(base) {
            let truth = judge::radical_inverse(n, base);
            assert!(truth < 1 << 32, "overflow at n = {n}, b = {base}");
            assert_eq!(
                u64::from(radical_inverse::radical_inverse(n, base)),
                truth,
                "n {n} b {base}"
            );
            assert_eq!(
                u64::from(radical_inverse::radical_inverse_table(n, table)),
                truth,
                "n {n} b {base}"
            );
        }
    }
}

#[test]
#[ignore = "all 2^32 indices: minutes"]
fn radical_inverse_of_every_index() {
    for base in [3, 8161] {
        let table = radical_base(base);
        for n in 0..=u32::MAX {
            let truth = judge::radical_inverse(n, base);
            assert_eq!(
                u64::from(radical_inverse::radical_inverse_table(n, table)),
                truth,
                "n {n} b {base}"
            );
        }
    }
}

#[test]
fn golden_values() {
    let halton: Vec<[f32; 2]> = (0..8)
        .map(|n| {
            [
                unit::unit_floor(radical_inverse::radical_inverse(n, 2)),
                unit::unit_ceil(radical_inverse::radical_inverse(n, 3)),
            ]
        })
        .collect();
    let truth = [
        (0, 0),
        (4, 3),
        (2, 6),
        (6, 1),
        (1, 4),
        (5, 7),
        (3, 2),
        (7, 5),
    ];
    for (p, (x, y)) in halton.iter().zip(truth) {
        assert_eq!(p[0], x as f32 / 8.0);
        let up = (f64::from(y) / 9.0 * 16_777_216.0).ceil() / 16_777_216.0;
        assert_eq!(f64::from(p[1]), up);
    }
    // Row 5 of the set of 8 points in 4 dimensions: 5/8, then bases 2, 3, 5.
    assert_eq!(hammersley::hammersley(5, 8), 0xa000_0000);
    assert_eq!(radical_inverse::radical_inverse(5, 2), 0xa000_0000);
    assert_eq!(
        unit::unit_ceil(radical_inverse::radical_inverse(5, 5)),
        671_089.0 / 16_777_216.0
    );
}

#[test]
fn odometer_equals_the_radical_inverse() {
    for base in PRIMES.into_iter().skip(1).take_while(|&p| p <= 251) {
        for window in [4, 16, 48, 120, 240] {
            let Some(b) = odometer_base(base, window) else {
                assert!(
                    window > 16,
                    "base {base} has no odometer for {window} points"
                );
                continue;
            };
            assert!(b.power >= window);
            for start in indices(base) {
                let mut o = odometer::odometer_start(start, b);
                for i in 0..window {
                    let Some(n) = start.checked_add(i) else { break };
                    assert_eq!(
                        odometer::odometer_value(o, b),
                        radical_inverse::radical_inverse_table(n, b.radical),
                        "n {n} b {base}"
                    );
                    o = odometer::odometer_next(o, b);
                }
            }
        }
    }
    assert!(odometer_base(2, 16).is_none());
    assert!(odometer_base(257, 16).is_none());
}

#[test]
fn hammersley_is_the_ceiling_of_the_exact_quotient() {
    let counts = [
        1u64,
        2,
        3,
        5,
        7,
        10,
        1000,
        1 << 20,
        1_000_003,
        (1 << 31) - 1,
        1 << 31,
        (1 << 31) + 1,
        (1 << 32) - 1,
        1 << 32,
    ];
    for count in counts {
        let written = count as u32;
        let step = hammersley::hammersley_start(1, written);
        let mut ks: Vec<u64> = (0..200).chain((count.saturating_sub(200))..count).collect();
        ks.extend((0..2000).map(|i| u64::from(mix(i)) % count));
        for k in ks.into_iter().filter(|k| *k < count) {
            let k = k as u32;
            let truth = judge::hammersley(k, count);
            assert!(truth < 1 << 32);
            assert_eq!(
                u64::from(hammersley::hammersley(k, written)),
                truth,
                "{k}/{count}"
            );
            if count > 1 && u64::from(k) + 1 < count {
                let next = hammersley::hammersley_next(
                    hammersley::hammersley_start(k, written),
                    step,
                    written,
                );
                assert_eq!(
                    next,
                    hammersley::hammersley_start(k + 1, written),
                    "{k}/{count}"
                );
            }
        }
    }
}

#[test]
fn base_tables_divide_exactly() {
    for base in PRIMES {
        let b = radical_base(base);
        assert!(b.power > 256 && b.power <= 65535 && b.power == base.pow(b.digits));
        for x in indices(base) {
            assert_eq!(
                radical_inverse::divide_by(x, b.base_magic, b.base_shift),
                x / base
            );
            assert_eq!(
                radical_inverse::divide_by(x, b.power_magic, b.power_shift),
                x / b.power
            );
        }
    }
}

/// Cells of width b^-k each hold one point of b^k consecutive ones, as exactly as the
/// representation allows: for n <= 2^32 - b^k as fractions, 2^24 - b^k as floats.
#[test]
fn elementary_intervals_hold_one_point_each() {
    for (base, digits) in [(3u32, 12), (5, 8), (7, 6), (2, 18)] {
        let cells = u64::from(base).pow(digits);
        for (first, bits) in [
            (0, 32),
            (cells, 32),
            ((1 << 32) / cells * cells - 2 * cells, 32),
            (0, 24),
            ((1 << 24) / cells * cells - 2 * cells, 24),
        ] {
            let mut seen = vec![false; cells as usize];
            for n in first..first + cells {
                let fraction = radical_inverse::radical_inverse(n as u32, base);
                let cell = if bits == 32 {
                    (u64::from(fraction) * cells) >> 32
                } else {
                    let x = if base == 2 {
                        unit::unit_floor(fraction)
                    } else {
                        unit::unit_ceil(fraction)
                    };
                    (f64::from(x) * cells as f64) as u64
                };
                assert!(
                    !std::mem::replace(&mut seen[cell as usize], true),
                    "cell {cell} twice: n {n} b {base} {bits} bits"
                );
            }
        }
    }
}

/// Pearson's correlation of the first `count` points in two bases.
fn correlation(bases: [u64; 2], count: u64, scramble: Scramble, seed: Option<u64>) -> f64 {
    let request = Request::new(&Options {
        bases: Some(bases.into()),
        dimensions: Some(2),
        scramble: Some(scramble),
        seed,
        fractions: true,
        ..Options::new(Sequence::Halton, count)
    })
    .expect("a pair of bases");
    let warned = request
        .warnings
        .iter()
        .any(|text| text.contains("on lines"));
    assert_eq!(warned, seed.is_none(), "{:?}", request.warnings);
    let mut words = vec![0; 2 * count as usize];
    Reference::new(&request).fill(0, &mut words).unwrap();
    let column = |j| words.iter().skip(j).step_by(2).map(|&u| f64::from(u));
    let mean = |j| column(j).sum::<f64>() / count as f64;
    let [a, b] = [mean(0), mean(1)];
    let product = |i, j, a: f64, b: f64| -> f64 {
        column(i)
            .zip(column(j))
            .map(|(x, y)| (x - a) * (y - b))
            .sum()
    };
    product(0, 1, a, b) / (product(0, 0, a, a) * product(1, 1, b, b)).sqrt()
}

/// Indices below both bases have one digit: n / b in each, on a line, which the scrambles part.
#[test]
fn pairs_of_high_bases_lie_on_lines_until_permuted() {
    for bases in [[107, 109], [617, 619], [7907, 7919]] {
        let count = bases[0] - 1;
        let bound = 3.0 / (count as f64).sqrt();
        assert!(correlation(bases, count, Scramble::None, None) > 0.999);
        for scramble in [Scramble::Permute, Scramble::Owen] {
            let strays = (0..64)
                .filter(|&seed| correlation(bases, count, scramble, Some(seed)).abs() > bound);
            // Of a normal distribution 0.17 of 64 are beyond three deviations.
            let strays = strays.count();
            assert!(strays <= 2, "{bases:?}: {strays} of 64 seeds");
        }
    }
}
