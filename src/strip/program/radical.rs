//! Radical inverses and k/N, with the constants of one base in the text.

use super::SHORT_RUN;
use super::columns::Code;
use super::literal::word;
use crate::interface::{Column, column_kind as kind};

/// The base of a radical inverse, and the digits that every index has at most: where those are few
/// and runs short, a sum over them is less than a table of the base and a start for each run.
pub(super) fn few_digits(column: &Column, run: u32, samples: u64) -> Option<(u32, u32)> {
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
pub(super) fn short(base: u32, digits: u32, number: usize, code: &mut Code) {
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

/// The code of column `number`, whatever its indices.
pub(super) fn code(words: &[u32], number: usize, code: &mut Code) {
    let t = |at: usize| word(words.get(at).copied().unwrap_or(0));
    let base = || (1..8).map(t).collect::<Vec<_>>().join(", ");
    code.unit = "corput_unit_ceil(u)".to_owned();
    match words.first().copied().unwrap_or(0) {
        kind::REVERSED => {
            code.includes = &["corput/unit.glsl"];
            code.fraction = "bitfieldReverse(c.n)".to_owned();
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
