//! Indices, shifts, strata and intervals: integers of which floats, signed words and shorter
//! loops lose something.

use super::case::{Case, Measure, Reading, Source, Subject, Truth};
use super::elementary::unit;
use crate::bulk::Reference;
use crate::catalog::{Engine, Options, Request, Scramble, Sequence};
use crate::reference::random::random;
use crate::reference::stratified::stratified;
use crate::{Result, judge};

/// A call whose words are fractions of 2^32, and must be these.
fn call(
    number: u32,
    input: impl Into<String>,
    name: &'static str,
    call: [u32; 4],
    first: usize,
    naive: &[f64],
    truth: &[u64],
) -> Case {
    let fraction = |word: &u64| *word as f64 / 4_294_967_296.0;
    Case::of(
        number,
        input,
        naive,
        Reading {
            first,
            measure: Measure::Fraction,
        },
        Truth {
            values: truth.iter().map(fraction).collect(),
            source: Source::Integers,
        },
        0.0,
        Subject::Function { name, call },
    )
}

fn fraction(word: u32) -> f64 {
    f64::from(word) / 4_294_967_296.0
}

/// Indices that leave 32 bits, or the positive half of them.
pub(super) fn indices() -> Vec<Case> {
    let next = call(
        1,
        "the index after 2^32 - 1: its high word",
        "add64",
        [u32::MAX, 0, 1, 0],
        1,
        // The word that there is wraps to 0, and there is no other.
        &[0.0],
        &[1],
    );
    let mut cases = vec![next];
    for index in [1 << 31, (1 << 31) + 5, u32::MAX] {
        let truth = judge::radical_inverse(index, 3);
        cases.push(call(
            11,
            format!("radical inverse in base 3 of pixel x + 65536 y = {index}"),
            "radical_inverse",
            [index, 3, 0, 0],
            0,
            &[signed_inverse(index as i32, 3)],
            &[truth],
        ));
    }
    cases
}

/// Points that there are not: of none, and beyond the last index.
pub(super) fn refusals() -> Vec<Case> {
    let refused = |asked: &Options| match Request::new(asked) {
        Ok(_) => f64::INFINITY,
        Err(_) => 0.0,
    };
    let share = |k: u32, n: u32| f64::from(k as f32 / n as f32);
    let none = Options::new(Sequence::Hammersley, 0);
    let beyond = Options {
        first: (1 << 32) - 1,
        ..Options::new(Sequence::VanDerCorput, 2)
    };
    // The second of these would be the first point again.
    let wrapped = u32::MAX.wrapping_add(1) == 0;
    vec![
        Case::host(
            2,
            "N = 0: k / N, which is refused",
            [share(0, 0), refused(&none)],
            Source::Integers,
            0.0,
        ),
        Case::host(
            11,
            "points 2^32 - 1 and 2^32, which are refused: share of repeated ones",
            [f64::from(u8::from(wrapped)) / 2.0, refused(&beyond)],
            Source::Integers,
            0.0,
        ),
    ]
}

/// Digits of a signed index, in doubles so that nothing but the sign is lost.
fn signed_inverse(mut index: i32, base: i32) -> f64 {
    let (mut sum, mut scale) = (0.0, 1.0 / f64::from(base));
    while index != 0 {
        sum += f64::from(index % base) * scale;
        scale /= f64::from(base);
        index /= base;
    }
    sum
}

/// Shifts by as many bits as a word has, which C, GLSL and SPIR-V leave undefined.
pub(super) fn shifts() -> Vec<Case> {
    // What processors of today take of the count is its lower five bits.
    let naive = |low: u32, high: u32, shift: u32| {
        let carried = low.wrapping_shr(32u32.wrapping_sub(shift));
        [
            low.wrapping_shl(shift),
            high.wrapping_shl(shift).wrapping_add(carried),
        ]
        .map(fraction)
    };
    let case = |(low, high, shift): (u32, u32, u32)| {
        let wide = (u64::from(low) | (u64::from(high) << 32)) << shift;
        call(
            7,
            format!("{high:#x} {low:08x} shifted left by {shift}, of two words"),
            "shl64",
            [low, high, shift, 0],
            0,
            &naive(low, high, shift),
            &[wide & 0xffff_ffff, wide >> 32],
        )
    };
    [
        (0x8000_0001, 0, 0),
        (0x8000_0001, 5, 32),
        (0xdead_beef, 0, 63),
    ]
    .map(case)
    .into()
}

/// Conversions to integers of what does not fit them, which SPIR-V leaves undefined.
pub(super) fn conversions() -> Vec<Case> {
    let case = |(text, x, truth): (&str, f32, u64)| {
        // The lowest bits, where hardware wraps; undefined of a NaN.
        let scaled = f64::from(x) * 2_147_483_648.0;
        let naive = match scaled.is_finite() {
            true => fraction(scaled as u64 as u32),
            false => f64::NAN,
        };
        call(
            10,
            format!("floor(x 2^31) in 32 bits, x = {text}, saturated at 1"),
            "fixed64",
            [x.to_bits(), 0, 0, 0],
            0,
            &[naive],
            &[truth],
        )
    };
    let below_one = f32::from_bits(1.0f32.to_bits() - 1);
    [
        ("2", 2.0, 1 << 31),
        ("2^32", 4_294_967_296.0, 1 << 31),
        ("1 - 2^-24", below_one, (1 << 31) - (1 << 7)),
        ("infinity", f32::INFINITY, 1 << 31),
        ("NaN", f32::NAN, 0),
    ]
    .map(case)
    .into()
}

/// A rotation by slightly less than a whole turn.
pub(super) fn rotations() -> Vec<Case> {
    let case = |(u, shift): (u32, i32)| {
        let moved = unit(u) + shift as f32 / 4_294_967_296.0;
        let truth = (i64::from(u) + i64::from(shift)).rem_euclid(1 << 32) as u64;
        call(
            9,
            format!("u = {u} 2^-32 rotated by {shift} 2^-32"),
            "lattice",
            [u, shift as u32, 0, 0],
            2,
            &[f64::from(moved - moved.floor())],
            &[truth],
        )
    };
    [(0, -4), (3, -3), (1 << 31, i32::MIN), (u32::MAX, 1)]
        .map(case)
        .into()
}

/// The share of cells that do not have exactly one of as many points.
fn not_one(cells: u64, points: impl Iterator<Item = u64>) -> f64 {
    let mut seen = vec![0u8; cells as usize];
    for cell in points {
        // A point beyond the last cell is in none.
        if let Some(count) = seen.get_mut(cell as usize) {
            *count = count.saturating_add(1);
        }
    }
    seen.iter().filter(|&&count| count != 1).count() as f64 / cells as f64
}

fn cell(u: u32, cells: u64) -> u64 {
    (u64::from(u) * cells) >> 32
}

/// The ends of elementary intervals are points of the net: who rounds them down moves them to
/// the interval before.
pub(super) fn intervals() -> Vec<Case> {
    let mut cases = Vec::new();
    for (base, digits) in [(3u32, 10), (5, 6), (7, 5)] {
        let cells = u64::from(base).pow(digits);
        let points = 0..cells as u32;
        let down = |n| {
            let up = judge::radical_inverse(n, base);
            // n has few digits: its inverse is k / cells.
            let k = ((u128::from(up) * u128::from(cells)) >> 32) as u64;
            (k << 32) / cells
        };
        let naive = not_one(cells, points.clone().map(|n| cell(down(n) as u32, cells)));
        let up = |n| crate::reference::radical_inverse::radical_inverse(n, base);
        let ours = not_one(cells, points.map(|n| cell(up(n), cells)));
        cases.push(Case::host(
            5,
            format!("{base}^{digits} points in as many intervals: share without exactly one"),
            [naive, ours],
            Source::Integers,
            0.0,
        ));
        let floor = (1u64 << 32) / u64::from(base);
        cases.push(call(
            5,
            format!("1 / {base}, where an elementary interval begins"),
            "radical_inverse",
            [1, base, 0, 0],
            0,
            &[fraction(floor as u32)],
            &[floor + 1],
        ));
    }
    cases
}

/// A jittered point of each stratum.
pub(super) fn strata() -> Vec<Case> {
    let case = |count: u32| {
        let jitter = |n| match n % 3 {
            2 => u32::MAX,
            _ => random(n, 0, glam::UVec2::new(7, 0)),
        };
        let floats = (0..count).map(|n| {
            let x = (n as f32 + (jitter(n) >> 8) as f32 / 16_777_216.0) / count as f32;
            (f64::from(x) * f64::from(count)) as u64
        });
        let exact = (0..count).map(|n| cell(stratified(n, 1, count, jitter(n)), count.into()));
        let errors = [not_one(count.into(), floats), not_one(count.into(), exact)];
        let input = format!(
            "{count} strata, every third jitter 1 - 2^-32: share without exactly one point"
        );
        Case::host(8, input, errors, Source::Integers, 0.0)
    };
    let last = |count: u32| {
        // The largest jitter of a stratum stays in it.
        let n = count / 3;
        call(
            8,
            format!("stratum {n} of {count} with a jitter of 1 - 2^-32"),
            "stratum",
            [n, count, 0, u32::MAX],
            0,
            &[((n as f32 + 1.0) / count as f32).into()],
            &[judge::stratum(n.into(), count.into(), u32::MAX)],
        )
    };
    let mut cases: Vec<Case> = [3, 7, 1_000_000].map(case).into();
    cases.extend([3, 7, 1_000_000].map(last));
    cases
}

/// Two high bases at indices below both: the points lie on a line, until digits are permuted.
pub(super) fn high_bases() -> Result<Vec<Case>> {
    let mut cases = Vec::new();
    for bases in [[107u64, 109], [617, 619], [7907, 7919]] {
        let count = bases[0] - 1;
        let plain = correlation(bases, count, Scramble::None)?;
        let permuted = correlation(bases, count, Scramble::Permute)?;
        cases.push(Case::host(
            6,
            format!(
                "correlation of the first {count} points in bases {} and {}",
                bases[0], bases[1]
            ),
            [plain.abs(), permuted.abs()],
            Source::ClosedForm,
            // Three standard deviations of the correlation of independent points.
            3.0 / (count as f64).sqrt(),
        ));
    }
    Ok(cases)
}

/// Pearson's correlation of two columns.
fn correlation(bases: [u64; 2], count: u64, scramble: Scramble) -> Result<f64> {
    let request = Request::new(&Options {
        bases: Some(bases.into()),
        dimensions: Some(2),
        scramble: Some(scramble),
        seed: (scramble != Scramble::None).then_some(1),
        fractions: true,
        ..Options::new(Sequence::Halton, count)
    })?;
    let mut words = vec![0; 2 * count as usize];
    Reference::new(&request).fill(0, &mut words)?;
    let column = |j: usize| words.iter().skip(j).step_by(2).map(|&u| fraction(u));
    let mean = |j| column(j).sum::<f64>() / count as f64;
    let means = [mean(0), mean(1)];
    let product = |i: usize, j: usize, [a, b]: [f64; 2]| -> f64 {
        let pairs = column(i).zip(column(j));
        pairs.map(|(x, y)| (x - a) * (y - b)).sum()
    };
    let [a, b] = means;
    let variances = product(0, 0, [a, a]) * product(1, 1, [b, b]);
    Ok(product(0, 1, means) / variances.sqrt())
}
