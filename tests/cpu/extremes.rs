//! Extreme cases of elementary functions, disks, hemispheres, tables and heuristics; those
//! of directions and of scattering are beside their distributions' tests.

mod extreme;

use corput::environment::{alias_table, cdf_table, quantise};
use corput::glam::uvec2;
use corput::judge;
use corput::reference::discrete::{alias_rest, cdf};
use corput::reference::disk::concentric_disk;
use corput::reference::elementary::cos_sin;
use corput::reference::exponential::{exp, power};
use corput::reference::hemisphere::cosine_hemisphere;
use corput::reference::logarithm::negative_log;
use corput::reference::mis::{mis_balance, mis_power};
use extreme::extreme;
use std::f32::consts::{FRAC_PI_4, TAU};

const ULP: f64 = 1.0 / (1 << 23) as f64;

/// The error relative to the truth; that of a zero is the result itself.
fn relative(got: f64, truth: f64) -> f64 {
    let error = (got - truth).abs() / if truth == 0.0 { 1.0 } else { truth.abs() };
    if error.is_nan() { f64::INFINITY } else { error }
}

fn unit(u: u32) -> f32 {
    u as f32 * 2f32.powi(-32)
}

#[test]
fn extreme_logarithms() {
    for (case, u) in [
        (12, 1u32),
        (12, 256),
        (12, 1 << 16),
        (12, 1 << 31),
        (13, u32::MAX),
        (13, !255),
    ] {
        let truth = -(-f64::from(u) * f64::powi(2.0, -32)).ln_1p();
        let naive = -(1.0 - unit(u)).ln();
        let input = format!("-ln(1 - u), u = {u} 2^-32");
        let (naive, ours) = (
            relative(naive.into(), truth),
            relative(negative_log(u).into(), truth),
        );
        extreme(case, &input, naive, ours, ULP);
    }
}

#[test]
fn extreme_angles() {
    for u in [
        1u32,
        0x4000_0001,
        0x3fff_ff00,
        0x8000_0001,
        0xc000_0100,
        u32::MAX,
    ] {
        let (s, c) = judge::sin_cos(u);
        let (sine, cosine) = (TAU * unit(u)).sin_cos();
        let naive = relative(sine.into(), s).max(relative(cosine.into(), c));
        let got = cos_sin(u);
        let ours = relative(got.y.into(), s).max(relative(got.x.into(), c));
        extreme(
            14,
            &format!("sin and cos(2 pi u), u = {u} 2^-32"),
            naive,
            ours,
            ULP,
        );
    }
}

#[test]
fn extreme_powers() {
    for (x, y) in [
        (0.999_999f32, 1e6f32),
        (0.5, 100.0),
        (0.999, 5e4),
        (1e-3, 12.0),
    ] {
        let truth = f64::from(x).powf(f64::from(y));
        let naive = (y * x.log2()).exp2();
        let (naive, ours) = (
            relative(naive.into(), truth),
            relative(power(x, y).into(), truth),
        );
        extreme(16, &format!("{x}^{y}"), naive, ours, 2.0 * ULP);
    }
    for x in [80.0f32, -80.0, -1e-7, 1e-20] {
        let truth = f64::from(x).exp();
        let naive = (x * std::f32::consts::LOG2_E).exp2();
        let (naive, ours) = (
            relative(naive.into(), truth),
            relative(exp(x).into(), truth),
        );
        extreme(16, &format!("e^{x}"), naive, ours, ULP);
    }
}

#[test]
fn extreme_hemispheres_and_disks() {
    for u in [
        [u32::MAX, 1 << 31],
        [0, 1 << 31],
        [0xffff_ff00, 1 << 31],
        [1 << 31, 255],
    ] {
        let truth = judge::cosine_hemisphere(u)[2];
        let d = cosine_hemisphere(uvec2(u[0], u[1]));
        let naive = (1.0 - d.x * d.x - d.y * d.y).max(0.0).sqrt();
        let input = format!("cosine-hemisphere, u = {u:?} 2^-32, z");
        extreme(
            17,
            &input,
            relative(naive.into(), truth),
            relative(d.z.into(), truth),
            ULP,
        );
    }
    let centre = concentric_disk(uvec2(1 << 31, 1 << 31));
    let (x, y) = (2.0 * unit(1 << 31) - 1.0, 2.0 * unit(1 << 31) - 1.0);
    let naive = x * (FRAC_PI_4 * (y / x)).cos();
    let ours = centre.abs().max_element();
    extreme(
        18,
        "concentric-disk, u = (1/2, 1/2)",
        relative(naive.into(), 0.0),
        ours.into(),
        0.0,
    );
}

/// Weights of which one outweighs all others, and the share of the others.
fn hot(count: usize) -> (Vec<u64>, f64) {
    let mut weights = vec![1u64; count];
    weights[count / 2] = 1_000_000_000;
    (weights, (count - 1) as f64 / (1e9 + (count - 1) as f64))
}

/// Row 35: beside one hot texel a float CDF has no steps left; every bin keeps its own here.
#[test]
fn extreme_tables() {
    for bits in [12, 20] {
        let count = 1usize << bits;
        let (weights, _) = hot(count);
        let total: f64 = weights.iter().map(|&w| w as f64).sum();
        let (mut sum, mut lost) = (0f32, 0);
        for &weight in &weights {
            let next = sum + (weight as f64 / total) as f32;
            lost += usize::from(next == sum);
            sum = next;
        }
        let exact = quantise(&weights).unwrap();
        let empty = exact.iter().filter(|&&w| w == 0).count();
        assert_eq!(exact.iter().sum::<u64>(), 1 << 32);
        let input = format!("CDF of 2^{bits} bins, one 1e9 times the others: share of empty bins");
        let share = |n: usize| n as f64 / count as f64;
        extreme(35, &input, share(lost), share(empty), 0.0);
    }
}

/// Row 38: what is left of a float fraction after a bin of 2^20 is 4 bits.
#[test]
fn extreme_rests_of_alias_tables() {
    let count = 1u32 << 20;
    let table = alias_table(&vec![1; count as usize]).unwrap();
    let (mut naive, mut ours) = (
        std::collections::BTreeSet::new(),
        std::collections::BTreeSet::new(),
    );
    for i in 0..4096u32 {
        // Fractions of the last bin, which is 2^-20 wide.
        let u = uvec2(!i, i.wrapping_mul(0x9e37_79b9));
        let scaled = (unit(u.x) * count as f32).fract();
        naive.insert((scaled * 4096.0) as u32);
        ours.insert(alias_rest(0, count, u, &table) >> 20);
    }
    let missing = |seen: usize| 1.0 - seen as f64 / 4096.0;
    let input =
        "rest of a fraction in an alias table of 2^20 bins: share of 4096 cells without one";
    // Random cells, as many as there are: 1/e of them stay empty.
    extreme(38, input, missing(naive.len()), missing(ours.len()), 0.4);
}

/// Row 39: a fraction that meets an edge, and tails of weight 0.
#[test]
fn extreme_edges_of_tables() {
    let weights = [0, 1, 0, 0, 1, 0, 2, 0, 0];
    let table = cdf_table(&weights).unwrap();
    let float: Vec<f32> = weights
        .iter()
        .scan(0f32, |sum, &w| {
            *sum += w as f32 / 4.0;
            Some(*sum)
        })
        .collect();
    let edges = [
        0u32,
        1 << 30,
        1 << 31,
        u32::MAX,
        (1 << 30) - 1,
        (1 << 31) - 1,
    ];
    let (mut naive, mut ours) = (0, 0);
    for u in edges {
        let found = float
            .iter()
            .position(|&c| unit(u) <= c)
            .unwrap_or(weights.len() - 1);
        naive += usize::from(weights[found] == 0);
        ours += usize::from(weights[cdf(0, u, &table).index as usize] == 0);
    }
    let share = |n: usize| n as f64 / edges.len() as f64;
    let input = "CDF with empty bins, u at its edges: share drawn from empty bins";
    extreme(39, input, share(naive), share(ours), 0.0);
}

/// Row 40: squares of pdfs leave the floats.
#[test]
fn extreme_heuristics() {
    for (a, b) in [
        (1e20f32, 1e30f32),
        (1e-25, 1e-25),
        (3e38, 3e38),
        (1e-38, 1e30),
    ] {
        let (x, y) = (f64::from(a), f64::from(b));
        let truth = x * x / (x * x + y * y);
        let naive = a * a / (a * a + b * b);
        let got = mis_power(1, a, 1, b);
        let input = format!("power heuristic of pdfs {a:e} and {b:e}");
        // Below 2^-126 a weight is 0.
        let truth = if truth < f64::from(f32::MIN_POSITIVE) {
            0.0
        } else {
            truth
        };
        let naive = relative(naive.into(), truth);
        extreme(40, &input, naive, relative(got.into(), truth), ULP);
        let balance = x / (x + y);
        let naive = a / (a + b);
        let got = mis_balance(1, a, 1, b);
        let input = format!("balance heuristic of pdfs {a:e} and {b:e}");
        let balance = if balance < f64::from(f32::MIN_POSITIVE) {
            0.0
        } else {
            balance
        };
        extreme(
            40,
            &input,
            relative(naive.into(), balance),
            relative(got.into(), balance),
            ULP,
        );
    }
}

/// The table's own claim: the page is written by assertions that can fail.
#[test]
#[should_panic(expected = "case 12, -ln")]
fn an_error_beyond_the_bound_fails() {
    let naive = f64::from(-(1.0 - unit(1)).ln());
    extreme(
        12,
        "-ln(1 - u), u = 1 2^-32",
        naive,
        relative(naive, f64::powi(2.0, -32)),
        ULP,
    );
}
