//! Weights of combined techniques.

use super::case::{Case, Measure, Reading, Source, Subject, Truth, ULP};

/// One weight of two techniques with a sample each; of the balance heuristic word 0, of the
/// power heuristic word 1.
fn weight(
    number: u32,
    input: String,
    word: usize,
    [a, b]: [f32; 2],
    naive: f32,
    truth: f64,
    bound: f64,
) -> Case {
    // Below 2^-126 a weight is 0.
    let least = f64::from(f32::MIN_POSITIVE);
    let truth = if truth < least { 0.0 } else { truth };
    Case::of(
        number,
        input,
        &[naive.into()],
        Reading {
            first: word,
            measure: Measure::Relative,
        },
        Truth {
            values: vec![truth],
            source: Source::ClosedForm,
        },
        bound,
        Subject::Function {
            name: "mis",
            call: [a.to_bits(), b.to_bits(), 1, 1],
        },
    )
}

/// Squares of pdfs leave the floats.
pub(super) fn heuristics() -> Vec<Case> {
    let mut cases = Vec::new();
    for [a, b] in [[1e20f32, 1e30], [1e-25, 1e-25], [3e38, 3e38], [1e-38, 1e30]] {
        let (x, y) = (f64::from(a), f64::from(b));
        cases.push(weight(
            40,
            format!("power heuristic of pdfs {a:e} and {b:e}"),
            1,
            [a, b],
            a * a / (a * a + b * b),
            x * x / (x * x + y * y),
            ULP,
        ));
        cases.push(weight(
            40,
            format!("balance heuristic of pdfs {a:e} and {b:e}"),
            0,
            [a, b],
            a / (a + b),
            x / (x + y),
            ULP,
        ));
    }
    cases
}

/// A delta distribution has an infinite pdf.
pub(super) fn deltas() -> Vec<Case> {
    let delta = f32::INFINITY;
    let case = |(name, word, other, naive, truth): (&str, usize, f32, f32, f64)| {
        let beside = if other == 1.0 { "1" } else { "inf" };
        let input = format!("{name} heuristic of pdfs inf (a delta) and {beside}");
        weight(41, input, word, [delta, other], naive, truth, 0.0)
    };
    [
        ("balance", 0, 1.0, delta / (delta + 1.0), 1.0),
        ("power", 1, 1.0, delta * delta / (delta * delta + 1.0), 1.0),
        ("balance", 0, delta, delta / (delta + delta), 0.5),
    ]
    .map(case)
    .into()
}
