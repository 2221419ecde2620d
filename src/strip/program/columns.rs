//! The coordinates of points, with the constants of one sampler in the text.

use super::literal::word;
use super::{net, radical};
use crate::interface::{Column, Family, column_kind as kind};
use crate::variant::column_words;

/// How a column's fractions come about in a kernel.
#[derive(Clone, Debug, Default)]
pub(super) struct Code {
    /// Headers.
    pub(super) includes: &'static [&'static str],
    /// Declarations before the cursor.
    pub(super) globals: String,
    /// Members of the cursor: type, name and the value at index `n`.
    pub(super) members: Vec<(&'static str, String, String)>,
    /// The fraction at a cursor `c`.
    pub(super) fraction: String,
    /// A statement that takes the cursor to the next index, which `c.n` already has.
    pub(super) next: String,
    /// The float of a fraction `u`.
    pub(super) unit: String,
}

/// The code of column `number` for runs of `run` points with indices below `samples`.
pub(super) fn code(column: &Column, number: usize, run: u32, samples: u64) -> Code {
    let words = column_words(*column, run);
    let w = |at: usize| words.get(at).copied().unwrap_or(0);
    let t = |at: usize| word(w(at));
    let mut code = Code {
        unit: "corput_unit_floor(u)".to_owned(),
        ..Code::default()
    };
    match column.family() {
        Family::Radical => match radical::few_digits(column, run, samples) {
            Some((base, digits)) => radical::short(base, digits, number, &mut code),
            None => radical::code(&words, number, &mut code),
        },
        Family::Net => net::code(&words, number, run, samples, &mut code),
        Family::Random => {
            let seed = format!("uvec2({}, {})", t(3), t(4));
            code.includes = &["corput/random.glsl", "corput/unit.glsl"];
            code.fraction = match w(0) {
                kind::PHILOX => format!("corput_random(c.n, {}, {seed})", t(1)),
                kind::PCG4D => format!("corput_random_fast(c.n, {}, {seed})", t(1)),
                _ => {
                    // Row after row from one stream, that of PCG's demonstration program.
                    code.includes = &[
                        "corput/fixed.glsl",
                        "corput/random.glsl",
                        "corput/unit.glsl",
                    ];
                    let place = format!(
                        "corput_add64(corput_mul64(c.n, {}), uvec2({}, 0u))",
                        t(2),
                        t(1)
                    );
                    format!(
                        "corput_pcg32_value(corput_pcg32_advance(\
                         corput_pcg32_seed({seed}, uvec2(54u, 0u)), {place}))"
                    )
                }
            };
        }
        Family::Strata => {
            let jitter = format!(
                "corput_random_of(c.n, {}, {}, uvec2({}, {}))",
                t(1),
                t(0),
                t(2),
                t(3)
            );
            code.includes = &["corput/random.glsl", "corput/stratified.glsl"];
            code.unit = format!("corput_unit_stratum(u, {})", t(5));
            code.fraction = match w(0) {
                kind::STRATIFIED => {
                    format!("corput_stratified(c.n, {}, {}, {jitter})", t(4), t(5))
                }
                kind::LATIN_HYPERCUBE => {
                    format!("corput_latin_hypercube(c.n, {}, {}, {jitter})", t(5), t(6))
                }
                _ => {
                    let axis = if w(1) == 0 { "x" } else { "y" };
                    format!(
                        "corput_cmj(c.n, uvec2({}, {}), {}, uvec2({jitter})).{axis}",
                        t(7),
                        t(8),
                        t(6)
                    )
                }
            };
        }
        Family::Digits => {
            code.includes = &["corput/scrambled_radical_inverse.glsl", "corput/unit.glsl"];
            let name = match w(0) {
                kind::FAURE => "faure",
                kind::PERMUTED => "permuted",
                kind::OWEN => "owen",
                _ => "started",
            };
            code.fraction = match w(0) {
                kind::FAURE => format!("corput_radical_inverse_faure(c.n, {})", t(5)),
                _ => format!("corput_radical_inverse_{name}(c.n, {}, {})", t(5), t(1)),
            };
            if w(0) == kind::FAURE && w(5) != 2 {
                code.unit = "corput_unit_ceil(u)".to_owned();
            }
        }
        Family::Lattice => {
            code.includes = &["corput/lattice.glsl", "corput/unit.glsl"];
            let value = match w(0) {
                kind::LATTICE => format!("corput_lattice(c.n, {})", t(1)),
                kind::ADDITIVE => format!("corput_additive(c.n, uvec2({}, {}))", t(1), t(2)),
                _ => format!("corput_korobov(c.n, {}, {})", t(1), t(3)),
            };
            code.fraction = match w(4) {
                0 => value,
                _ => format!("corput_rotate({value}, {})", t(4)),
            };
            if w(0) == kind::KOROBOV {
                code.unit = "corput_unit_ceil(u)".to_owned();
            }
        }
    }
    code
}
