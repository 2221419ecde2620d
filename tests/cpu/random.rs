//! Hashes and random numbers: published vectors, the judge, bijections, jumps.

use corput::glam::{UVec2, UVec4, uvec2};
use corput::judge::random as judge;
use corput::reference::hash::{hash, mix4, pcg4d, seed};
use corput::reference::random::{
    Pcg32, pcg32_advance, pcg32_next, pcg32_seed, pcg32_value, philox, random, random_fast,
};

/// Rows `philox4x32 10` of the file of known answers of Random123: counter, key, result.
const PHILOX: [([u32; 4], [u32; 2], [u32; 4]); 3] = [
    (
        [0; 4],
        [0; 2],
        [0x6627_e8d5, 0xe169_c58d, 0xbc57_ac4c, 0x9b00_dbd8],
    ),
    (
        [u32::MAX; 4],
        [u32::MAX; 2],
        [0x408f_276d, 0x41c8_3b0e, 0xa20b_c7c6, 0x6d54_51fd],
    ),
    (
        [0x243f_6a88, 0x85a3_08d3, 0x1319_8a2e, 0x0370_7344],
        [0xa409_3822, 0x299f_31d0],
        [0xd16c_fe09, 0x94fd_cceb, 0x5001_e420, 0x2412_6ea1],
    ),
];

/// The first numbers of PCG32 with state 42 and stream 54, as its author's demo prints.
const PCG32: [u32; 6] = [
    0xa15c_02b7,
    0x7b47_f409,
    0xba1d_3330,
    0x83d2_f293,
    0xbfa4_784b,
    0xcbed_606e,
];

/// Words to try: edges, and multiples of an odd constant.
fn words() -> Vec<u32> {
    let edges = (0..32).flat_map(|bit| [1u32 << bit, (1u32 << bit) - 1, !(1u32 << bit)]);
    let spread = (0..4000u32).map(|i| i.wrapping_mul(0x9e37_79b9));
    edges.chain([u32::MAX]).chain(spread).collect()
}

/// Four words for each word of the list.
fn fours() -> impl Iterator<Item = [u32; 4]> {
    let turned = |x: u32| {
        [
            x,
            x.rotate_left(9) ^ 0x55,
            !x.rotate_left(19),
            x ^ 0xdead_beef,
        ]
    };
    words().into_iter().map(turned)
}

fn wide(v: UVec2) -> u64 {
    u64::from(v.x) | (u64::from(v.y) << 32)
}

fn halves(x: u64) -> UVec2 {
    uvec2(x as u32, (x >> 32) as u32)
}

#[test]
fn philox_gives_the_known_answers() {
    for (counter, key, result) in PHILOX {
        let got = philox(UVec4::from_array(counter), UVec2::from_array(key));
        assert_eq!(got.to_array(), result);
        assert_eq!(judge::philox(counter, key, 10), result);
        // Seven rounds, which pass the same batteries, are another generator.
        assert_ne!(judge::philox(counter, key, 7), result);
    }
}

#[test]
fn pcg32_gives_the_known_answers() {
    let mut p = pcg32_seed(uvec2(42, 0), uvec2(54, 0));
    let mut q = judge::Pcg32::new(42, 54);
    for known in PCG32 {
        assert_eq!(pcg32_value(p), known);
        assert_eq!(q.value(), known);
        p = pcg32_next(p);
        q.step();
    }
}

#[test]
fn twins_agree_with_the_judge() {
    for a in fours() {
        let v = UVec4::from_array(a);
        assert_eq!(hash(a[0]), judge::hash(a[0]));
        assert_eq!(pcg4d(v).to_array(), judge::pcg4d(a));
        assert_eq!(mix4(v).to_array(), judge::mix4(a));
        let key = [a[1] ^ a[2], !a[3]];
        assert_eq!(
            philox(v, UVec2::from_array(key)).to_array(),
            judge::philox(a, key, 10)
        );
        let p = pcg32_seed(uvec2(a[0], a[1]), uvec2(a[2], a[3]));
        let q = judge::Pcg32::new(wide(uvec2(a[0], a[1])), wide(uvec2(a[2], a[3])));
        assert_eq!(
            (wide(p.state), wide(p.increment)),
            (q.state, q.increment),
            "{a:x?}"
        );
        assert_eq!(pcg32_value(p), q.value());
        let far = q.advanced(wide(uvec2(a[3], a[0])));
        assert_eq!(wide(pcg32_advance(p, uvec2(a[3], a[0])).state), far.state);
    }
}

#[test]
fn random_numbers_are_words_of_blocks() {
    for a in fours() {
        let [index, dimension, low, high] = a;
        let block = judge::philox([index, dimension / 4, 0, 0], [low, high], 10);
        let got = random(index, dimension, uvec2(low, high));
        assert_eq!(got, block[dimension as usize % 4]);
        let fast = random_fast(index, dimension, uvec2(low, high));
        assert_eq!(fast, judge::mix4(a)[0]);
        let other = seed(uvec2(low, high), dimension, index);
        assert_eq!(other, judge::mix4([low, high, dimension, index])[0]);
    }
}

#[test]
fn jumps_equal_steps() {
    for (start, stream) in [(42, 54), (0, 0), (u64::MAX, u64::MAX), (1 << 63, 1 << 62)] {
        let begin = pcg32_seed(halves(start), halves(stream));
        let mut p = begin;
        for steps in 0..2000u64 {
            assert_eq!(pcg32_advance(begin, halves(steps)), p, "{steps} steps");
            // Back again: minus `steps`, modulo 2^64.
            assert_eq!(pcg32_advance(p, halves(steps.wrapping_neg())), begin);
            p = pcg32_next(p);
        }
        // Far jumps add up, and 2^63 twice is the whole period.
        let (a, b) = (0x0123_4567_89ab_cdefu64, 0xfedc_ba98_7654_3210);
        let sum = pcg32_advance(begin, halves(a.wrapping_add(b)));
        assert_eq!(
            pcg32_advance(pcg32_advance(begin, halves(a)), halves(b)),
            sum
        );
        let half = pcg32_advance(begin, halves(1 << 63));
        assert_ne!(half, begin);
        assert_eq!(pcg32_advance(half, halves(1 << 63)), begin);
    }
}

#[test]
fn streams_differ_but_for_the_highest_bit() {
    let with = |stream: u64| pcg32_seed(uvec2(1, 2), halves(stream));
    let values = |mut p: Pcg32| {
        std::array::from_fn::<u32, 4, _>(|_| {
            p = pcg32_next(p);
            pcg32_value(p)
        })
    };
    let mut seen: Vec<[u32; 4]> = (0..63).map(|bit| values(with(1 << bit))).collect();
    seen.sort_unstable();
    seen.dedup();
    assert_eq!(seen.len(), 63);
    assert_eq!(with(1 << 63), with(0));
}

/// Marks each result; true if none came twice.
fn distinct(results: impl Iterator<Item = u32>) -> bool {
    let mut seen = vec![0u64; 1 << 26];
    for x in results {
        let word = &mut seen[(x >> 6) as usize];
        if *word >> (x & 63) & 1 == 1 {
            return false;
        }
        *word |= 1 << (x & 63);
    }
    true
}

/// The inverse of the hash: its steps undone, which only a bijection allows.
fn unhash(mut x: u32) -> u32 {
    let inverse = |odd: u32| {
        (0..5).fold(odd, |y, _| {
            y.wrapping_mul(2u32.wrapping_sub(odd.wrapping_mul(y)))
        })
    };
    for (factor, shift) in [
        (1, 14),
        (0x3184_8bab, 15),
        (0xac4c_1b51, 11),
        (0xed5a_d4bb, 17),
    ] {
        x = x.wrapping_mul(inverse(factor));
        let mut y = x;
        for _ in 0..32 / shift {
            y = x ^ (y >> shift);
        }
        x = y;
    }
    x
}

#[test]
fn the_hash_is_a_bijection() {
    assert!(distinct((0..1 << 24).map(hash)));
    assert!(distinct((0..1 << 16).map(|i| hash(i << 16))));
    for x in words().into_iter().chain(0..1 << 20) {
        assert_eq!(unhash(hash(x)), x);
    }
    // What is none is seen: a shift that loses bits.
    assert!(!distinct((0..1 << 24).map(|x| hash(x) & !1)));
}

#[test]
#[ignore = "all 2^32 words: half a minute"]
fn the_hash_is_a_bijection_of_every_word() {
    assert!(distinct((0..=u32::MAX).map(hash)));
}
