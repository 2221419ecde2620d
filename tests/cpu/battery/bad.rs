//! Generators with a known fault.

use super::{STREAMS, families, limit, rejections, words};
use corput::glam::{UVec2, uvec2, uvec4};
use corput::reference::hash::{hash, pcg4d};
use corput::reference::random::{pcg32_seed, pcg32_value, random};

/// A good word.
fn good(i: u32) -> u32 {
    random(i, 0, UVec2::ZERO)
}

/// The affine map x -> m x + c, i times from 1, modulo 2^32.
fn affine(m: u32, c: u32, i: u32) -> u32 {
    let (mut x, mut step, mut i) = (1u32, (m, c), i);
    while i != 0 {
        if i & 1 == 1 {
            x = x.wrapping_mul(step.0).wrapping_add(step.1);
        }
        let twice = step.0.wrapping_mul(step.1).wrapping_add(step.1);
        step = (step.0.wrapping_mul(step.0), twice);
        i >>= 1;
    }
    x
}

/// A generator and the families that must each reject it.
type Bad = (&'static str, fn(u32) -> u32, &'static [&'static str]);

const BAD: [Bad; 13] = [
    // 2^20 numbers repeat 128 times where those of a bijection do not at all.
    ("a bijection of the index", hash, &["collisions"]),
    (
        "RANDU",
        |i| affine(65_539, 0, i) << 1,
        &["frequency", "ranks"],
    ),
    (
        "an LCG",
        |i| affine(1_664_525, 1_013_904_223, i),
        &["bit serial", "ranks", "birthdays"],
    ),
    (
        "a constant bit",
        |i| good(i) | 1 << 13,
        &["frequency", "bytes", "ranks", "collisions"],
    ),
    (
        "a bit of two others",
        |i| {
            let x = good(i);
            (x & !1) | (((x >> 9) ^ (x >> 20)) & 1)
        },
        &["ranks"],
    ),
    (
        "every word twice",
        |i| good(i / 2),
        &["serial", "bit serial", "runs", "gaps", "collisions"],
    ),
    (
        "means of two",
        |i| good(i) / 2 + good(i + 1) / 2,
        &["serial", "bytes", "runs"],
    ),
    (
        "a Weyl sequence",
        |i| i.wrapping_mul(0x9e37_79b9),
        &["birthdays", "serial", "gaps"],
    ),
    (
        "all in order of four",
        |i| {
            let mut x: [u32; 4] = std::array::from_fn(|k| good((i & !3) + k as u32));
            x.sort_unstable();
            x[i as usize & 3]
        },
        &["runs", "serial"],
    ),
    (
        "pcg4d as it is",
        |i| pcg4d(uvec4(i, 5, 7, 0)).x,
        &["bit serial", "ranks"],
    ),
    (
        "pcg4d's last word",
        |i| pcg4d(uvec4(i, 5, 7, 0)).w,
        &["bit serial", "ranks"],
    ),
    (
        "pcg32 of successive seeds",
        |i| pcg32_value(pcg32_seed(uvec2(i, 0), uvec2(54, 0))),
        &["serial"],
    ),
    (
        "pcg32 of successive streams",
        |i| pcg32_value(pcg32_seed(uvec2(42, 0), uvec2(i, 0))),
        &["serial"],
    ),
];

#[test]
fn bad_generators_are_rejected() {
    let mut missed = Vec::new();
    for (name, stream, wanted) in BAD {
        let found = families::all(&words(stream));
        // As strict as with all streams together.
        let limit = limit((STREAMS.len() + 1) * found.len());
        let rejected = rejections(name, found, limit);
        let mut by: Vec<&str> = rejected.iter().map(|(family, _, _)| *family).collect();
        by.sort_unstable();
        by.dedup();
        println!("  by {by:?}; first {:?}", rejected.first());
        missed.extend(
            wanted
                .iter()
                .filter(|family| !by.contains(family))
                .map(|family| (name, *family)),
        );
    }
    assert!(missed.is_empty(), "{missed:?}");
}
