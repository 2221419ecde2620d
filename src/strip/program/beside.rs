//! Coordinates of consecutive points in turns of a few, each with its place in the text.

use super::columns::{self, Code};
use super::literal::{indented, word};
use super::net;
use crate::interface::Column;
use crate::variant::{column_words, is_short, longest_run};
use std::fmt::Write;

/// How a column's fractions come about.
#[derive(Clone, Debug, Default)]
pub(super) struct Beside {
    /// Headers.
    pub(super) includes: &'static [&'static str],
    /// Declarations before `main`.
    pub(super) globals: String,
    /// Statements at the index `n` of an invocation's first point.
    pub(super) start: String,
    /// Statements at a turn's first point, which is the invocation's point `k`.
    pub(super) turn: String,
    /// The fraction of each point of a turn.
    pub(super) fractions: Vec<String>,
    /// The float of a fraction `u`.
    pub(super) unit: String,
    /// Whether the index of the first point is a multiple of their number.
    pub(super) aligned: bool,
}

/// Points of an invocation, and of each turn of its loop, a power of two.
#[derive(Clone, Copy, Debug)]
pub(super) struct Run {
    pub(super) points: u32,
    pub(super) turn: u32,
}

/// The code of column `number` for runs of points with indices below `samples`; `None` of columns
/// that take more instructions than their stores.
pub(super) fn code(column: &Column, number: usize, run: Run, samples: u64) -> Option<Beside> {
    if !(is_short(column) || is_odometer(column)) {
        return None;
    }
    let step = || {
        let code = columns::code(column, number, run.points, samples);
        stepped(code, number, run.turn)
    };
    // In long runs the start of a step costs nothing, and lets them begin anywhere.
    if run.points >= LONG {
        return Some(step());
    }
    Some(match column {
        Column::Sobol { .. } => {
            let words = column_words(*column, 0);
            let directions = words.get(6..38).unwrap_or_default();
            linear(directions, number, run, samples, |x| {
                net::scrambled(&words, x)
            })
        }
        Column::Reversed => {
            let directions: Vec<u32> = (0..32).map(|bit| 1 << (31 - bit)).collect();
            linear(&directions, number, run, samples, str::to_owned)
        }
        _ => step(),
    })
}

/// Whether a column goes from point to point by an odometer, over a run that is long enough for
/// its start.
pub(super) fn is_odometer(column: &Column) -> bool {
    matches!(column, Column::Radical(_)) && longest_run(column) >= LONG
}

/// Points.
const LONG: u32 = 48;

/// Fractions that depend on sums of the directions of an index's bits: those of a place in a turn
/// are in the text, those of the turn few.
fn linear(
    directions: &[u32],
    number: usize,
    run: Run,
    samples: u64,
    scrambled: impl Fn(&str) -> String,
) -> Beside {
    let bits = (64 - samples.saturating_sub(1).leading_zeros()) as usize;
    let [turn, points] = [run.turn, run.points].map(|count| count.trailing_zeros() as usize);
    let mut globals = String::new();
    let mut sum = |name: &str, from: usize, to: usize, at: &str| {
        let to = to.min(bits);
        if from >= to {
            return "0u".to_owned();
        }
        // Other bits of the index are zeros.
        if let Some(all) = net::whole(directions, to, at) {
            return all;
        }
        // Writing to a String cannot fail.
        let _ = write!(
            globals,
            "// What bits {from} to {} of an index add to coordinate {number}.\n{}",
            to - 1,
            net::part(directions, name, [from, to])
        );
        format!("{name}({at})")
    };
    let name = format!("net{number}");
    let start = sum(&name, points, bits, "n");
    let turns = sum(&format!("{name}_turn"), turn, points, "k");
    let x = format!("x{number}");
    let place = |place: u32| {
        let terms = directions.iter().enumerate().take(turn);
        let terms = terms.filter(|(bit, _)| place >> bit & 1 == 1);
        match terms.fold(0, |sum, (_, direction)| sum ^ direction) {
            0 => scrambled(&x),
            sum => scrambled(&format!("{x} ^ {}", word(sum))),
        }
    };
    Beside {
        includes: net::INCLUDES,
        start: format!("uint start{number} = {start};\n"),
        turn: format!("uint {x} = start{number} ^ {turns};\n"),
        fractions: (0..run.turn).map(place).collect(),
        unit: "corput_unit_floor(u)".to_owned(),
        aligned: true,
        globals,
    }
}

/// Fractions at a cursor that goes from one point to the next.
fn stepped(code: Code, number: usize, turn: u32) -> Beside {
    let cursor = format!("Cursor{number}");
    let mut globals = code.globals;
    // Writing to a String cannot fail.
    let _ = writeln!(globals, "struct {cursor} {{\n    uint n;");
    let mut values = "n".to_owned();
    for (kind, name, value) in &code.members {
        let _ = writeln!(globals, "    {kind} {name};");
        let _ = write!(values, ", {value}");
    }
    let _ = write!(
        globals,
        "}};\n\nuint next{number}(inout {cursor} c) {{\n    uint fraction = {};\n{}    \
         return fraction;\n}}\n",
        code.fraction,
        indented(&format!("c.n += 1u;\n{}\n", code.next), 4)
    );
    let places = || (0..turn).map(|place| format!("x{number}_{place}"));
    let step = |x: String| format!("uint {x} = next{number}(cursor{number});\n");
    Beside {
        includes: code.includes,
        globals,
        start: format!("{cursor} cursor{number} = {cursor}({values});\n"),
        turn: places().map(step).collect(),
        fractions: places().collect(),
        unit: code.unit,
        aligned: false,
    }
}
