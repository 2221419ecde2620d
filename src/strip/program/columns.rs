//! The coordinates of points, with the constants of one sampler in the text.

use super::SHORT_RUN;
use super::literal::word;
use crate::interface::{Column, Family, column_kind as kind};
use crate::variant::column_words;
use std::fmt::Write;

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
        Family::Radical => match few_digits(column, run, samples) {
            Some((base, digits)) => short_radical(base, digits, number, &mut code),
            None => radical(&words, number, &mut code),
        },
        Family::Net => net(&words, number, samples, &mut code),
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

/// The base of a radical inverse, and the digits that every index has at most: where those are few
/// and runs short, a sum over them is less than a table of the base and a start for each run.
fn few_digits(column: &Column, run: u32, samples: u64) -> Option<(u32, u32)> {
    let Column::Radical(base) = *column else {
        return None;
    };
    let most = u64::from(FEW);
    let powers = (1..).map_while(|digits| Some((digits, u64::from(base).checked_pow(digits)?)));
    let mut powers = powers.take_while(|(_, power)| *power <= most);
    let (digits, _) = powers.find(|(_, power)| *power >= samples)?;
    (run <= SHORT_RUN).then_some((base, digits))
}

/// The largest power whose products with a number below it have 32 bits, and room for a ceiling.
const FEW: u32 = 1 << 16;

/// With r the mirrored digits below c = base^digits, ceil(2^32 r / c) is r q + ceil(r m / c), where
/// q and m are quotient and remainder of 2^32 by c.
fn short_radical(base: u32, digits: u32, number: usize, code: &mut Code) {
    let power = u64::from(base).pow(digits);
    let (q, m) = ((1 << 32) / power, (1 << 32) % power);
    code.includes = &["corput/unit.glsl"];
    code.unit = "corput_unit_ceil(u)".to_owned();
    code.globals = format!(
        "// The radical inverse in base {base} of an index below {base}^{digits}, rounded up.\n\
         uint radical{number}(uint n) {{\n    uint r = 0u;\n    \
         for (uint k = 0u; k < {digits}u; k++) {{\n        \
         r = {base}u * r + n % {base}u;\n        n /= {base}u;\n    }}\n    \
         return r * {q}u + (r * {m}u + {}u) / {power}u;\n}}\n",
        power - 1
    );
    code.fraction = format!("radical{number}(c.n)");
}

fn radical(words: &[u32], number: usize, code: &mut Code) {
    let t = |at: usize| word(words.get(at).copied().unwrap_or(0));
    let base = || (1..8).map(t).collect::<Vec<_>>().join(", ");
    code.unit = "corput_unit_ceil(u)".to_owned();
    match words.first().copied().unwrap_or(0) {
        kind::REVERSED => {
            code.includes = &["corput/radical_inverse.glsl", "corput/unit.glsl"];
            code.fraction = "corput_van_der_corput(c.n)".to_owned();
            code.unit = "corput_unit_floor(u)".to_owned();
        }
        kind::ODOMETER => {
            let name = format!("base{number}");
            code.includes = &["corput/odometer.glsl", "corput/unit.glsl"];
            code.globals = format!(
                "const CorputOdometerBase {name} = CorputOdometerBase(CorputBase({}), {}, {}, {});\n",
                base(),
                t(8),
                t(9),
                t(10)
            );
            let member = format!("odometer{number}");
            code.fraction = format!("corput_odometer_value(c.{member}, {name})");
            code.next = format!("c.{member} = corput_odometer_next(c.{member}, {name});");
            let start = format!("corput_odometer_start(n, {name})");
            code.members = vec![("CorputOdometer", member, start)];
        }
        kind::GRID => {
            code.includes = &["corput/hammersley.glsl", "corput/unit.glsl"];
            let member = format!("grid{number}");
            let step = format!("CorputGridPoint({}, {})", t(9), t(10));
            code.fraction = format!("corput_hammersley_value(c.{member})");
            code.next = format!(
                "c.{member} = corput_hammersley_next(c.{member}, {step}, {});",
                t(8)
            );
            let start = format!("corput_hammersley_start(n, {})", t(8));
            code.members = vec![("CorputGridPoint", member, start)];
        }
        _ => {
            code.includes = &["corput/radical_inverse.glsl", "corput/unit.glsl"];
            code.fraction = format!("corput_radical_inverse_table(c.n, CorputBase({}))", base());
        }
    }
}

/// Bits of an index that a function of a block's points adds up; the others are the same for
/// all points of a block.
const LOW_BITS: usize = 8;

fn net(words: &[u32], number: usize, samples: u64, code: &mut Code) {
    let w = |at: usize| words.get(at).copied().unwrap_or(0);
    let seed = format!("uvec2({}, {})", word(w(3)), word(w(4)));
    if w(0) == kind::PMJ02 {
        code.includes = &["corput/pmj02.glsl", "corput/unit.glsl"];
        let axis = if w(2) == 0 { "x" } else { "y" };
        code.fraction = format!(
            "corput_pmj02_scramble(corput_sobol_pair(corput_pmj02_index(c.n, {seed})).{axis}, {}, \
             {seed})",
            word(w(2))
        );
        return;
    }
    // No index has a bit from this one on.
    let bits = (64 - samples.saturating_sub(1).leading_zeros()) as usize;
    let directions = words.get(6..38).unwrap_or_default();
    let name = format!("net{number}");
    let x = match whole(directions, bits) {
        Some(all) => all.to_owned(),
        None => sum(directions, bits, &name, number, code),
    };
    code.includes = &["corput/owen.glsl", "corput/unit.glsl"];
    code.fraction = match w(0) {
        kind::SOBOL_OWEN => format!("corput_owen({x}, {}, {seed})", word(w(2))),
        kind::SOBOL_OWEN_HASH => format!("corput_owen_hash_reversed({x}, {})", word(w(5))),
        _ if w(1) == 0 => x,
        _ => format!("corput_digital_shift({x}, {})", word(w(1))),
    };
}

/// All bits of an index at once, where that is what the lowest of these directions add up to: in
/// the first dimension, scrambled or not.
fn whole(directions: &[u32], bits: usize) -> Option<&'static str> {
    let all = |direction: fn(usize) -> u32| {
        let mut known = directions.iter().enumerate().take(bits);
        known.all(|(bit, known)| *known == direction(bit))
    };
    if all(|bit| 1 << (31 - bit)) {
        Some("bitfieldReverse(c.n)")
    } else {
        all(|bit| 1 << bit).then_some("c.n")
    }
}

/// Declares what adds up the directions of an index's bits, and gives the term that does.
fn sum(directions: &[u32], bits: usize, name: &str, number: usize, code: &mut Code) -> String {
    let part = |name: &str, from: usize, to: usize| {
        let terms = directions.iter().enumerate().take(to).skip(from);
        // A bit as all bits.
        let terms: Vec<String> = terms
            .map(|(bit, direction)| {
                format!("(bitfieldExtract(bits, {bit}, 1) & int({direction:#010x}u))")
            })
            .collect();
        format!(
            "uint {name}(uint n) {{\n    int bits = int(n);\n    return uint({});\n}}\n",
            terms.join("\n        ^ ")
        )
    };
    let (low, high) = (format!("{name}_low"), format!("{name}_high"));
    // Writing to a String cannot fail.
    let _ = write!(
        code.globals,
        "// What bits of an index below {LOW_BITS} add to coordinate {number} of the net.\n{}",
        part(&low, 0, bits.min(LOW_BITS))
    );
    if bits <= LOW_BITS {
        return format!("{low}(c.n)");
    }
    let _ = write!(
        code.globals,
        "// What the others add.\n{}",
        part(&high, LOW_BITS, bits)
    );
    let after = format!("{name}_after");
    code.next = format!("c.{name} = (c.n & 255u) == 0u ? c.{after} : c.{name};");
    code.members = vec![
        ("uint", name.to_owned(), format!("{high}(n)")),
        ("uint", after, format!("{high}(n + 256u)")),
    ];
    format!("c.{name} ^ {low}(c.n)")
}
