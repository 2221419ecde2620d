//! Coordinates of digital nets, with their direction numbers in the text.

use super::SHORT_RUN;
use super::columns::Code;
use super::literal::word;
use crate::interface::column_kind as kind;
use std::fmt::Write;

/// Bits of an index that a function of a block's points adds up; the others are the same for
/// all points of a block.
const LOW_BITS: usize = 8;

/// Bits of all indices that a short run adds up for each point sooner than for a block and its
/// points.
const FEW_BITS: usize = 12;

/// The code of coordinate `number` of a net, for runs of `run` points with indices below `samples`.
pub(super) fn code(words: &[u32], number: usize, run: u32, samples: u64, code: &mut Code) {
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
        None => {
            let runs = if run <= SHORT_RUN { FEW_BITS } else { LOW_BITS };
            let low = if bits <= runs { bits } else { LOW_BITS };
            sum(directions, [low, bits], &name, number, code)
        }
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

/// Declares what adds up the directions of an index's bits, of the low ones for each point and of
/// the others for a block, and gives the term that does.
fn sum(
    directions: &[u32],
    [low_bits, bits]: [usize; 2],
    name: &str,
    number: usize,
    code: &mut Code,
) -> String {
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
        "// What bits of an index below {low_bits} add to coordinate {number} of the net.\n{}",
        part(&low, 0, low_bits)
    );
    if bits <= low_bits {
        return format!("{low}(c.n)");
    }
    let _ = write!(
        code.globals,
        "// What the others add.\n{}",
        part(&high, low_bits, bits)
    );
    let after = format!("{name}_after");
    code.next = format!("c.{name} = (c.n & 255u) == 0u ? c.{after} : c.{name};");
    code.members = vec![
        ("uint", name.to_owned(), format!("{high}(n)")),
        ("uint", after, format!("{high}(n + 256u)")),
    ];
    format!("c.{name} ^ {low}(c.n)")
}
