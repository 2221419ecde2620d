//! Scrambles: the judge, bijections that keep elementary intervals, fair and independent
//! flips, moments.

#[path = "owen/flips.rs"]
mod flips;
#[path = "owen/moments.rs"]
mod moments;
#[allow(dead_code, reason = "the battery uses the rest")]
#[path = "battery/p_value.rs"]
mod p_value;

use corput::glam::{UVec2, uvec2};
use corput::judge::random as judge;
use corput::reference::hash::{hash, seed};
use corput::reference::owen::{digital_shift, matrix_scramble, owen, owen_hash};

/// A scramble by its number of a seed and a dimension.
type Scramble = fn(u32, u32, UVec2) -> u32;

/// Every scramble of the header.
const SCRAMBLES: [(&str, Scramble); 4] = [
    ("owen", owen),
    ("owen_hash", |x, d, s| owen_hash(x, seed(s, d, 1))),
    ("matrix_scramble", matrix_scramble),
    ("digital_shift", |x, d, s| digital_shift(x, seed(s, d, 0))),
];

#[test]
fn twins_agree_with_the_judge() {
    let edges = (0..32).flat_map(|bit| [1u32 << bit, (1 << bit) - 1, !(1u32 << bit)]);
    for x in edges.chain([u32::MAX]).chain((0..1000).map(hash)) {
        for i in 0..4 {
            let (dimension, low, high) = (hash(i) >> (8 * i), hash(x ^ 9), hash(x ^ i));
            let s = uvec2(low, high);
            assert_eq!(
                owen(x, dimension, s),
                judge::owen(x, dimension, [low, high])
            );
            assert_eq!(
                matrix_scramble(x, dimension, s),
                judge::matrix_scramble(x, dimension, [low, high])
            );
            assert_eq!(owen_hash(x, high), judge::owen_hash(x, high));
            assert_eq!(digital_shift(x, high), (x | high) - (x & high));
        }
    }
}

/// What a map of 16 digits lacks of one that permutes the intervals of every level, each
/// within its parent; `None` if it lacks nothing.
fn fault(map: impl Fn(u32) -> u32) -> Option<String> {
    let mut prefixes = Vec::with_capacity(1 << 16);
    for x in 0..1u32 << 16 {
        // Digits below do not reach up: any tail gives the same 16 digits.
        let tops = [0, 0xffff, hash(x) & 0xffff].map(|tail| map((x << 16) | tail) >> 16);
        if tops[1..].iter().any(|top| *top != tops[0]) {
            return Some(format!("{x:04x}: a tail shows in {tops:04x?}"));
        }
        prefixes.push(tops[0]);
    }
    for level in 1..=16 {
        let mut seen = vec![false; 1 << level];
        for interval in 0..1usize << level {
            let members = &prefixes[interval << (16 - level)..(interval + 1) << (16 - level)];
            let image = members[0] >> (16 - level);
            if members.iter().any(|x| x >> (16 - level) != image) {
                return Some(format!("level {level}: interval {interval} is torn"));
            }
            if std::mem::replace(&mut seen[image as usize], true) {
                return Some(format!("level {level}: interval {image} is hit twice"));
            }
        }
    }
    None
}

#[test]
fn elementary_intervals_are_kept_at_16_bits() {
    for (name, scramble) in SCRAMBLES {
        for (dimension, s) in [(0, uvec2(0, 0)), (3, uvec2(1, 2)), (21_200, uvec2(!0, !7))] {
            let found = fault(|x| scramble(x, dimension, s));
            assert_eq!(found, None, "{name} {dimension} {s}");
        }
    }
    assert_eq!(fault(|x| owen_hash(x, 0)), None);
    assert_eq!(fault(|x| owen_hash(x, !0)), None);
}

#[test]
fn torn_intervals_are_seen() {
    let s = uvec2(5, 6);
    // Digits in the wrong order, a tail that reaches up, two images in one.
    let wrong: [(&str, &dyn Fn(u32) -> u32); 4] = [
        ("not reversed", &|x| {
            owen_hash(x.reverse_bits(), 77).reverse_bits()
        }),
        ("a hash", &hash),
        ("a tail", &|x| owen(x, 0, s) ^ ((x & 1) << 20)),
        ("a lost digit", &|x| owen(x & !0x1_0000, 0, s)),
    ];
    for (name, map) in wrong {
        let found = fault(map);
        println!("{name}: {found:?}");
        assert!(found.is_some(), "{name}");
    }
}

/// Below 16 bits: the lowest digits of one interval of width 2^-16, each once.
#[test]
fn tails_are_bijections() {
    for (name, scramble) in SCRAMBLES {
        for top in [0u32, 0x5a5a, 0xffff] {
            let mut seen = vec![false; 1 << 16];
            for tail in 0..1u32 << 16 {
                let y = scramble((top << 16) | tail, 2, uvec2(11, 13));
                assert!(
                    !std::mem::replace(&mut seen[(y & 0xffff) as usize], true),
                    "{name}"
                );
            }
        }
    }
}

#[test]
fn dimensions_and_seeds_scramble_apart() {
    for (name, scramble) in SCRAMBLES {
        let x = 0xdead_beef;
        let mut images: Vec<u32> = (0..64)
            .map(|i| scramble(x, i, uvec2(1, 1)))
            .chain((0..64).map(|i| scramble(x, 0, uvec2(2 + i, 1))))
            .chain((0..64).map(|i| scramble(x, 0, uvec2(1, 2 + i))))
            .collect();
        images.sort_unstable();
        images.dedup();
        assert_eq!(images.len(), 192, "{name}");
    }
}
