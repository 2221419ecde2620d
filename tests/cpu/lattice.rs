//! Lattices against exact integers, the intervals that they fill, and the published
//! generators against random ones.

use corput::judge;
use corput::reference::lattice::{additive, korobov, lattice, rotate};
use corput::reference::permute::permute_mix;
use corput::tables::{KOROBOV, additive_alphas, is_prime, lattice_vector};
use glam::{UVec2, uvec2};

fn words(count: u32) -> impl Iterator<Item = u32> {
    let edges = [
        0,
        1,
        2,
        0x7fff_ffff,
        0x8000_0000,
        0x8000_0001,
        u32::MAX - 1,
        u32::MAX,
    ];
    edges.into_iter().chain((0..count).map(permute_mix))
}

fn halves(alpha: u64) -> UVec2 {
    uvec2(alpha as u32, (alpha >> 32) as u32)
}

#[test]
fn a_lattice_sequence_is_the_multiple_of_its_radical_inverse() {
    for n in words(2000) {
        for z in lattice_vector()
            .iter()
            .copied()
            .step_by(17)
            .chain([2, u32::MAX])
        {
            // Bit i of n is worth z 2^-(i+1).
            let bits = (0..32).filter(|i| n >> i & 1 == 1);
            let sum: u128 = bits.map(|i| u128::from(z) << (31 - i)).sum();
            assert_eq!(u128::from(lattice(n, z)), sum % (1 << 32), "{n} {z}");
        }
    }
}

/// How many of 2^k intervals do not hold exactly one of the points first .. first + 2^k.
fn missed(first: u32, k: u32, z: u32) -> usize {
    let mut held = vec![0u32; 1 << k];
    for n in first..first + (1 << k) {
        held[(lattice(n, z) >> (32 - k)) as usize] += 1;
    }
    held.iter().filter(|&&count| count != 1).count()
}

#[test]
fn blocks_of_2_to_the_k_points_fill_intervals() {
    for &z in lattice_vector() {
        for k in 1..=12 {
            for block in [0, 1, 5] {
                assert_eq!(missed(block << k, k, z), 0, "{z}: {k}");
            }
        }
    }
    assert!(
        missed(0, 12, 182_668) > 0,
        "an even generator leaves half of them empty"
    );
    assert!(missed(1, 12, 182_667) > 0, "so does a block out of step");
}

#[test]
fn korobov_points_are_ceilings_of_the_exact_quotients() {
    let primes = KOROBOV.iter().map(|&(count, _)| u64::from(count));
    let counts = [
        1u64,
        2,
        3,
        1000,
        (1 << 31) + 1,
        3_000_000_019,
        (1 << 32) - 1,
        1 << 32,
    ];
    for count in primes.chain(counts) {
        for n in words(100).map(|n| (u64::from(n) % count) as u32) {
            for z in words(20).map(|z| (u64::from(z) % count) as u32) {
                let truth = judge::korobov(n, z, count);
                assert_eq!(
                    u64::from(korobov(n, z, count as u32)),
                    truth,
                    "{n} {z} {count}"
                );
            }
        }
    }
}

#[test]
fn korobov_coordinates_are_regular() {
    for &(count, a) in KOROBOV {
        for z in [
            1,
            a,
            (u64::from(a) * u64::from(a) % u64::from(count)) as u32,
        ] {
            let mut held = vec![false; count as usize];
            for n in 0..count {
                let k = (u64::from(korobov(n, z, count)) * u64::from(count)) >> 32;
                assert!(
                    !std::mem::replace(&mut held[k as usize], true),
                    "{count} {z}: {k}"
                );
            }
        }
    }
}

fn power_mod(base: u64, exponent: u64, modulus: u64) -> u64 {
    (0..exponent).fold(1, |power, _| power * base % modulus)
}

/// The squared distance of the nearest points of the lattice (k, k z) mod n, over the most
/// that a lattice of n points can have, 2 n / sqrt 3 (Gauss's reduction).
fn closeness(z: u64, n: u64) -> f64 {
    let length = |v: [i64; 2]| v[0] * v[0] + v[1] * v[1];
    let (mut u, mut v) = ([1, z as i64], [0, n as i64]);
    if length(u) > length(v) {
        std::mem::swap(&mut u, &mut v);
    }
    loop {
        let dot = u[0] * v[0] + u[1] * v[1];
        let times = (dot as f64 / length(u) as f64).round() as i64;
        v = [v[0] - times * u[0], v[1] - times * u[1]];
        if length(v) >= length(u) {
            return length(u) as f64 / (2.0 * n as f64 / 3f64.sqrt());
        }
        std::mem::swap(&mut u, &mut v);
    }
}

/// The least over the planes of the first coordinate and any of the next 23.
fn merit(a: u64, n: u64) -> f64 {
    (1..24)
        .map(|j| closeness(power_mod(a, j, n), n))
        .fold(1.0, f64::min)
}

#[test]
fn korobov_generators_are_good_in_every_plane() {
    for &(count, a) in KOROBOV {
        let (n, a) = (u64::from(count), u64::from(a));
        assert!(is_prime(n));
        let primes = (2..n).filter(|&p| (n - 1).is_multiple_of(p) && is_prime(p));
        assert!(
            primes
                .into_iter()
                .all(|p| power_mod(a, (n - 1) / p, n) != 1),
            "{n}: {a}"
        );
        let random =
            (0..300).filter(|&i| merit(2 + u64::from(permute_mix(i)) % (n - 3), n) > 0.085);
        let as_good = random.count();
        println!(
            "{n}: {:.3}; {as_good} of 300 random ones exceed 0.085",
            merit(a, n)
        );
        assert!(merit(a, n) > 0.085, "{n}: {a}");
        assert!(as_good < 60, "{n}: the bound tells nothing");
    }
}

/// The square of the worst-case error of order-2 weights over 2^k points, up to a constant:
/// products of Bernoulli's second polynomial over all pairs.
fn pair_error(vector: &[u32], k: u32) -> f64 {
    let bernoulli: Vec<Vec<f64>> = vector
        .iter()
        .map(|&z| {
            let at = |n: u32| f64::from(lattice(n, z)) / 4_294_967_296.0;
            (0..1 << k)
                .map(|n| at(n) * at(n) - at(n) + 1.0 / 6.0)
                .collect()
        })
        .collect();
    let mut sum = 0.0;
    for i in 0..vector.len() {
        for j in 0..i {
            sum += bernoulli[i]
                .iter()
                .zip(&bernoulli[j])
                .map(|(x, y)| x * y)
                .sum::<f64>();
        }
    }
    sum / f64::from(1u32 << k)
}

#[test]
fn the_lattice_vector_beats_random_ones() {
    for k in [10, 12, 14, 16] {
        let ours = pair_error(&lattice_vector()[..12], k);
        let random: Vec<f64> = (0..100)
            .map(|i| {
                let vector: Vec<u32> = (0..12).map(|j| permute_mix(12 * i + j) | 1).collect();
                pair_error(&vector, k)
            })
            .collect();
        let better = random.iter().filter(|&&error| error <= ours).count();
        println!("2^{k}: {ours:.3e}, {better} of 100 random vectors as good");
        assert_eq!(better, 0, "2^{k}");
    }
}

#[test]
fn alphas_are_those_of_300_bits() {
    let path = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/tests/data/additive_alphas.txt"
    );
    let text = std::fs::read_to_string(path).expect("the vectors are there");
    let lines: Vec<&str> = text.lines().filter(|line| !line.starts_with('#')).collect();
    assert_eq!(lines.len(), 16);
    for (d, line) in (1..).zip(lines) {
        let truth: Vec<u64> = line
            .split(' ')
            .map(|word| u64::from_str_radix(word, 16).expect("a word"))
            .collect();
        assert_eq!(additive_alphas(d), truth, "{d}");
    }
    assert!(additive_alphas(0).is_empty());
    // Far dimensions: rising, distinct, below 1.
    assert!(additive_alphas(300).is_sorted_by(|a, b| a > b));
}

#[test]
fn additive_points_are_exact_to_the_last_bit() {
    let golden = additive_alphas(1)[0];
    assert_eq!(additive(0, halves(golden)), 0x8000_0000);
    for alpha in (1..=16).flat_map(additive_alphas).chain([0, 1, u64::MAX]) {
        for n in words(300) {
            let truth = judge::additive(n, alpha);
            assert_eq!(
                u64::from(additive(n, halves(alpha))),
                truth,
                "{n} {alpha:#x}"
            );
        }
    }
    // 32 bits of alpha drift by far more than the spacing of points.
    let n = 4_000_000_000;
    let cut = additive(n, halves(golden & !0xffff_ffff));
    assert!(additive(n, halves(golden)).abs_diff(cut) > 1 << 30);
}

#[test]
fn a_rotation_wraps() {
    assert_eq!(rotate(0xf000_0000, 0x2000_0000), 0x1000_0000);
    assert_eq!(rotate(5, 0u32.wrapping_sub(5)), 0);
}
