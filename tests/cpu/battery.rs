//! A small battery of statistical tests for the random numbers, and for the battery: bad
//! generators, each rejected by the family that is made for it.

#[path = "battery/bad.rs"]
mod bad;
#[path = "battery/families.rs"]
mod families;
#[path = "battery/p_value.rs"]
mod p_value;

use corput::glam::uvec2;
use corput::reference::hash::seed;
use corput::reference::random::{pcg32_next, pcg32_seed, pcg32_value, random, random_fast};
use families::Finding;

/// Words of a stream.
const LENGTH: u32 = 1 << 20;
/// Chance that the battery rejects perfect random numbers, all streams together.
const SIGNIFICANCE: f64 = 1e-3;

/// A name, and word i of the stream.
type Stream = (&'static str, fn(u32) -> u32);

/// i from the highest bit down: all differences are of high bits.
fn high(i: u32) -> u32 {
    i.reverse_bits()
}

/// The streams of the counter-based numbers and of seeds: along each argument, and with
/// dimensions between the points.
#[rustfmt::skip]
const STREAMS: [Stream; 27] = [
    ("random, index", |i| random(i, 5, uvec2(7, 0))),
    ("random, high index", |i| random(high(i), 5, uvec2(7, 0))),
    ("random, dimension", |i| random(5, i, uvec2(7, 0))),
    ("random, high dimension", |i| random(5, high(i), uvec2(7, 0))),
    ("random, seed", |i| random(5, 3, uvec2(i, 0))),
    ("random, high bits of a seed", |i| random(5, 3, uvec2(high(i), 0))),
    ("random, high seed", |i| random(5, 3, uvec2(1, i))),
    ("random, highest bits of a seed", |i| random(5, 3, uvec2(1, high(i)))),
    ("random, 4 dimensions", |i| random(i / 4, i % 4, uvec2(0, 0))),
    ("random, 3 dimensions", |i| random(i / 3, i % 3, uvec2(0, 0))),
    ("fast, index", |i| random_fast(i, 5, uvec2(7, 0))),
    ("fast, high index", |i| random_fast(high(i), 5, uvec2(7, 0))),
    ("fast, dimension", |i| random_fast(5, i, uvec2(7, 0))),
    ("fast, high dimension", |i| random_fast(5, high(i), uvec2(7, 0))),
    ("fast, seed", |i| random_fast(5, 3, uvec2(i, 0))),
    ("fast, high bits of a seed", |i| random_fast(5, 3, uvec2(high(i), 0))),
    ("fast, high seed", |i| random_fast(5, 3, uvec2(1, i))),
    ("fast, highest bits of a seed", |i| random_fast(5, 3, uvec2(1, high(i)))),
    ("fast, 4 dimensions", |i| random_fast(i / 4, i % 4, uvec2(0, 0))),
    ("fast, 3 dimensions", |i| random_fast(i / 3, i % 3, uvec2(0, 0))),
    ("seed, seed", |i| seed(uvec2(i, 0), 3, 1)),
    ("seed, high bits of a seed", |i| seed(uvec2(high(i), 0), 3, 1)),
    ("seed, high seed", |i| seed(uvec2(1, i), 3, 1)),
    ("seed, highest bits of a seed", |i| seed(uvec2(1, high(i)), 3, 1)),
    ("seed, dimension", |i| seed(uvec2(7, 0), i, 1)),
    ("seed, purpose", |i| seed(uvec2(7, 0), 3, i)),
    ("seed, 2 purposes", |i| seed(uvec2(7, 0), i / 2, i % 2)),
];

fn words(stream: fn(u32) -> u32) -> Vec<u32> {
    (0..LENGTH).map(stream).collect()
}

/// Successive numbers of one generator.
fn sequential() -> Vec<u32> {
    let mut p = pcg32_seed(uvec2(42, 0), uvec2(54, 0));
    let mut list = Vec::new();
    for _ in 0..LENGTH {
        list.push(pcg32_value(p));
        p = pcg32_next(p);
    }
    list
}

/// The p-value below which one of `tests` rejects: Sidak's correction.
fn limit(tests: usize) -> f64 {
    -f64::exp_m1(f64::ln_1p(-SIGNIFICANCE) / tests as f64)
}

/// The findings below a limit, the smallest first, and a line that says so.
fn rejections(name: &str, found: Vec<Finding>, limit: f64) -> Vec<Finding> {
    let tests = found.len();
    let least = found.iter().map(|(_, _, p)| *p).fold(1.0, f64::min);
    let mut rejected: Vec<Finding> = found.into_iter().filter(|(_, _, p)| *p < limit).collect();
    rejected.sort_by(|a, b| a.2.total_cmp(&b.2));
    println!(
        "{name}: {} of {tests} reject, least p {least:.1e}",
        rejected.len()
    );
    rejected
}

#[test]
fn random_streams_pass() {
    let mut streams: Vec<(&str, Vec<Finding>)> = STREAMS
        .iter()
        .map(|(name, stream)| (*name, families::all(&words(*stream))))
        .collect();
    streams.push(("pcg32", families::all(&sequential())));
    let tests = streams.iter().map(|(_, found)| found.len()).sum();
    let limit = limit(tests);
    println!("{tests} tests, each rejects below p = {limit:.1e}");
    let rejected: Vec<_> = streams
        .into_iter()
        .map(|(name, found)| (name, rejections(name, found, limit)))
        .filter(|(_, rejected)| !rejected.is_empty())
        .collect();
    assert!(rejected.is_empty(), "{rejected:#?}");
}
