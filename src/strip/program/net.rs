//! Coordinates of digital nets, with their direction numbers in the text.

use super::SHORT_RUN;
use super::columns::Code;
use super::literal::word;
use crate::interface::column_kind as kind;
use crate::reference::pmj02::sobol_pair;
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
        code.includes = INCLUDES;
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
    let x = match whole(directions, bits, "c.n") {
        Some(all) => all,
        None => {
            let runs = if run <= SHORT_RUN { FEW_BITS } else { LOW_BITS };
            let low = if bits <= runs { bits } else { LOW_BITS };
            sum(directions, [low, bits], &name, number, code)
        }
    };
    code.includes = INCLUDES;
    code.fraction = scrambled(words, &x);
}

/// The headers of nets.
pub(super) const INCLUDES: &[&str] = &["corput/owen.glsl", "corput/pmj02.glsl", "corput/unit.glsl"];

/// The fraction of a net's coordinate `x`.
pub(super) fn scrambled(words: &[u32], x: &str) -> String {
    let w = |at: usize| words.get(at).copied().unwrap_or(0);
    match w(0) {
        kind::SOBOL_OWEN => {
            let seed = format!("uvec2({}, {})", word(w(3)), word(w(4)));
            format!("corput_owen({x}, {}, {seed})", word(w(2)))
        }
        kind::SOBOL_OWEN_HASH => format!("corput_owen_hash_reversed({x}, {})", word(w(5))),
        _ if w(1) == 0 => x.to_owned(),
        _ => format!("corput_digital_shift({x}, {})", word(w(1))),
    }
}

/// What `bits` bits of the index `n` add up to, at once, where their directions are those of the
/// first two dimensions, scrambled or not.
pub(super) fn whole(directions: &[u32], bits: usize, n: &str) -> Option<String> {
    let all = |direction: fn(u32) -> u32| {
        let mut known = (0..).zip(directions).take(bits);
        known.all(|(bit, known)| *known == direction(bit))
    };
    // For the hash in reverse, as its directions are.
    if all(|bit| 1 << (31 - bit)) {
        Some(format!("bitfieldReverse({n})"))
    } else if all(|bit| 1 << bit) {
        Some(n.to_owned())
    } else if all(|bit| sobol_pair(1 << bit).y) {
        Some(format!("corput_sobol_pair({n}).y"))
    } else {
        let known = all(|bit| sobol_pair(1 << bit).y.reverse_bits());
        known.then(|| format!("bitfieldReverse(corput_sobol_pair({n}).y)"))
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
    let part = |name: &str, from, to| part(directions, name, [from, to]);
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

/// A function that adds up what bits of an index from one to before another contribute.
pub(super) fn part(directions: &[u32], name: &str, [from, to]: [usize; 2]) -> String {
    let known: Vec<(usize, u32)> = directions.iter().copied().enumerate().collect();
    let bits = known.get(from..to.min(known.len())).unwrap_or_default();
    // A bit as all bits, four at a time: modules are much smaller than of one after the other.
    let terms = bits.chunks(4).map(|four| {
        let at = |place: usize| four.get(place).copied().unwrap_or_default();
        let [a, b, c, d] = [0, 1, 2, 3].map(at);
        let shifts = [a, b, c, d].map(|(bit, _)| (31 - bit).to_string());
        let directions = [a, b, c, d].map(|(_, direction)| word(direction));
        format!(
            "(((bits << ivec4({})) >> 31) & ivec4({}))",
            shifts.join(", "),
            directions.join(", ")
        )
    });
    let terms: Vec<String> = terms.collect();
    format!(
        "uint {name}(uint n) {{\n    ivec4 bits = ivec4(n);\n    ivec4 sum = {};\n    \
         return uint(sum.x ^ sum.y ^ sum.z ^ sum.w);\n}}\n",
        terms.join("\n        ^ ")
    )
}
