//! Permutations: bijective for every length, equal to the judge's tables, and over seeds as
//! uniform as random ones.

mod significance;

use corput::judge;
use corput::reference::permute::{permute, permute_mix};
use significance::{critical, deviate};

/// Lengths up to the whole of 2^32, which is written as 0, around powers of two and others.
fn long_lengths() -> Vec<u32> {
    let mut list: Vec<u32> = (13..32)
        .flat_map(|bit| [-1i64, 0, 1].map(|offset| ((1i64 << bit) + offset) as u32))
        .collect();
    list.extend([
        1_000_003,
        3_000_000_019,
        0xc000_0001,
        u32::MAX - 1,
        u32::MAX,
        0,
    ]);
    list
}

#[test]
fn every_length_up_to_4096_is_permuted() {
    for seed in [0, 1, 0x9e37_79b9] {
        for length in 1..=4096u32 {
            let mut seen = vec![false; length as usize];
            for i in 0..length {
                let to = permute(i, length, seed) as usize;
                assert!(
                    !std::mem::replace(&mut seen[to], true),
                    "{length}: {i} to {to}"
                );
            }
        }
    }
}

#[test]
fn tables_of_the_judge_are_met() {
    let lengths = (1..=70).chain([127, 128, 129, 1000, 1021, 4096, 65_521, 100_000]);
    for length in lengths {
        for seed in [0, 1, 2, 0xdead_beef, u32::MAX] {
            let table = judge::permutation(length, seed);
            for (i, &to) in table.iter().enumerate() {
                assert_eq!(
                    permute(i as u32, length as u32, seed),
                    to,
                    "{length} {seed}: {i}"
                );
            }
        }
    }
}

/// The x of the low `bits` bits with x (b + 2 a x) = y, found bit by bit: the polynomial
/// modulo 2^k does not depend on higher bits.
fn root(y: u32, a: u32, b: u32, bits: u32) -> u32 {
    (0..bits).fold(0u32, |x, bit| {
        let value = x.wrapping_mul(b.wrapping_add(2u32.wrapping_mul(a).wrapping_mul(x)));
        x | ((value ^ y) & (1 << bit))
    })
}

/// Where `permute` comes from: rotation, rounds and walk undone, for more than 16 elements.
fn inverse(to: u32, length: u32, seed: u32) -> u32 {
    let total = if length == 0 {
        1 << 32
    } else {
        u64::from(length)
    };
    let bits = 64 - (total - 1).leading_zeros();
    let keys: Vec<u32> = (0..9u32)
        .map(|j| permute_mix(permute_mix(seed).wrapping_add(j.wrapping_mul(0x9e37_79b9))))
        .collect();
    let offset = (u64::from(keys[8]) * total) >> 32;
    let mut x = ((u64::from(to) + total - offset) % total) as u32;
    loop {
        for key in keys[..8].iter().rev() {
            let y = x.reverse_bits() >> (32 - bits);
            let x0 = root(y, key >> 8, key.rotate_left(16) | 1, bits);
            x = ((u64::from(x0 ^ key)) % (1 << bits)) as u32;
        }
        if u64::from(x) < total {
            return x;
        }
    }
}

#[test]
fn long_permutations_have_an_inverse() {
    for length in long_lengths() {
        let last = length.wrapping_sub(1);
        for seed in [0, 7, u32::MAX] {
            let spread = (0..500).map(|i| permute_mix(i) % last.max(1));
            for i in (0..20).chain(last - 20..=last).chain(spread) {
                let to = permute(i, length, seed);
                assert!(to <= last, "{length} {seed}: {i} to {to}");
                assert_eq!(inverse(to, length, seed), i, "{length} {seed}: {to}");
            }
        }
    }
}

#[test]
fn what_lies_outside_counts_as_the_last() {
    for length in [1, 5, 16, 17, 1000, 1 << 20] {
        let last = permute(length - 1, length, 3);
        assert_eq!(permute(u32::MAX, length, 3), last);
        assert_eq!(permute(length, length, 3), last);
    }
}

/// Kensler 2013, the listing of section 4: the baseline that the test below must refuse.
fn kensler(i: u32, length: u32, seed: u32) -> u32 {
    let mask = (length - 1) | (length - 1) >> 1;
    let mask = mask | mask >> 2;
    let mask = mask | mask >> 4;
    let mask = mask | mask >> 8;
    let mask = mask | mask >> 16;
    let mut x = i;
    loop {
        x ^= seed;
        x = x.wrapping_mul(0xe170_893d);
        x ^= seed >> 16;
        x ^= (x & mask) >> 4;
        x ^= seed >> 8;
        x = x.wrapping_mul(0x0929_eb3f);
        x ^= seed >> 23;
        x ^= (x & mask) >> 1;
        x = x.wrapping_mul(1 | seed >> 27);
        x = x.wrapping_mul(0x6935_fa69);
        x ^= (x & mask) >> 11;
        x = x.wrapping_mul(0x74dc_b303);
        x ^= (x & mask) >> 2;
        x = x.wrapping_mul(0x9e50_1cc3);
        x ^= (x & mask) >> 2;
        x = x.wrapping_mul(0xc860_a3df);
        x &= mask;
        x ^= x >> 5;
        if x < length {
            return x.wrapping_add(seed) % length;
        }
    }
}

/// Seeds of a statistical test.
const SEEDS: u32 = 1 << 17;

/// The largest deviates over `SEEDS` seeds, and how many there were of each: where each
/// element goes, and where each pair of the first elements and the last goes.
fn deviates(length: u32, permute: impl Fn(u32, u32, u32) -> u32) -> [(f64, usize); 2] {
    let side = length as usize;
    let mut tested: Vec<u32> = (0..length.min(8)).collect();
    if length > 8 {
        tested.push(length - 1);
    }
    let mut single = vec![vec![0u32; side]; tested.len()];
    let pairs: Vec<(usize, usize)> = (0..tested.len())
        .flat_map(|i| (0..i).map(move |j| (i, j)))
        .collect();
    let mut joint = vec![vec![0u32; side * side]; pairs.len()];
    for seed in 0..SEEDS {
        let to: Vec<usize> = tested
            .iter()
            .map(|&i| permute(i, length, seed) as usize)
            .collect();
        for (counts, &to) in single.iter_mut().zip(&to) {
            counts[to] += 1;
        }
        for (counts, &(i, j)) in joint.iter_mut().zip(&pairs) {
            counts[to[i] * side + to[j]] += 1;
        }
    }
    let worst = |all: &[Vec<u32>], cells: usize| {
        let expected = f64::from(SEEDS) / cells as f64;
        all.iter()
            .map(|counts| deviate(counts, expected))
            .fold(f64::NEG_INFINITY, f64::max)
    };
    // Two elements never go to the same place: those cells are no outcomes.
    for counts in &mut joint {
        let mut at = 0;
        counts.retain(|&count| {
            at += 1;
            let same = (at - 1) % (side + 1) == 0;
            assert!(!same || count == 0, "two elements at one place");
            !same
        });
    }
    [
        (worst(&single, side), single.len()),
        (worst(&joint, side * (side - 1)), joint.len()),
    ]
}

#[test]
fn elements_and_pairs_are_uniform_over_seeds() {
    let lengths = [2, 3, 4, 5, 7, 12, 16, 17, 23, 31, 32, 33, 64, 97, 128];
    let found: Vec<_> = lengths.map(|length| deviates(length, permute)).to_vec();
    let tests = found.iter().flatten().map(|(_, tests)| tests).sum();
    for (length, found) in lengths.iter().zip(&found) {
        let [single, joint] = found.map(|(worst, _)| worst);
        println!("{length}: {single:.2} {joint:.2} of {:.2}", critical(tests));
        assert!(
            single.max(joint) < critical(tests),
            "{length}: {single} {joint}"
        );
    }
}

#[test]
fn what_favours_some_permutations_is_refused() {
    let refused = |length, permute: &dyn Fn(u32, u32, u32) -> u32| {
        let found = deviates(length, permute);
        let tests = found.iter().map(|(_, tests)| tests).sum();
        found.iter().any(|(worst, _)| *worst > critical(tests))
    };
    for length in [3, 5, 7, 12, 17] {
        assert!(refused(length, &kensler), "Kensler's, {length}");
    }
    // A rotation alone, and one round in place of eight.
    assert!(refused(5, &|i, n, seed| (i + permute_mix(seed) % n) % n));
    let round =
        |i: u32, _, seed| corput::reference::permute::permute_round(i, 27, permute_mix(seed));
    assert!(refused(32, &round));
    assert!(!refused(32, &permute));
}
