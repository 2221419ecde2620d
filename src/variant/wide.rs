//! Kernels without loops over points that store eight words at a time.

use super::columns::column_words;
use super::plan::{Plan, Work, family, kernel, kinds};
use crate::interface::{COLUMN_STRIDE, Column, Generator, KINDS, NetScramble};

/// Below so many words other kernels end long before those that store eight at a time are compiled;
/// of more than four columns they take longer still.
pub(super) const LEAST: u64 = 1 << 24;
const LEAST_OF_MANY: u64 = 1 << 25;

/// The plan for a device of the CPU kind, where one of these kernels makes such columns and is
/// faster.
pub(super) fn wide(work: &Work) -> Option<Plan> {
    let columns = work.columns;
    let words = work.points.saturating_mul(columns.len() as u64);
    let least = if columns.len() <= 4 {
        LEAST
    } else {
        LEAST_OF_MANY
    };
    let fits = work.cpu && work.int64 && work.map.is_none() && words >= least;
    if !fits || !columns.iter().all(is_short) {
        return None;
    }
    let part = match columns.len() {
        few @ (1..=4 | 8) => few,
        many if many.is_multiple_of(16) => 16,
        _ => return None,
    };
    let kernel = kernel(&format!("generate_wide_{part}"), family(columns));
    let points = kernel.defines.iter().find(|one| one.0 == "WIDE_POINTS")?;
    let points: u32 = points.1.parse().ok()?;
    let aligned = if columns.iter().any(steps) { points } else { 1 };
    if !work.first.is_multiple_of(aligned.into()) {
        return None;
    }
    let parts = columns.chunks(part);
    let end = work.first.saturating_add(work.points);
    let mut plan = Plan {
        kernel,
        specializations: parts.map(|part| values(part, end)).collect(),
        table: None,
        tile: points,
        aligned,
        tiles: vec![points; columns.len() / part],
    };
    plan.set("ROW", columns.len() as u32 / 8);
    for index in 0..plan.tiles.len() {
        plan.set_in(index, "PART", index as u32);
    }
    Some(plan)
}

/// The constants of the columns of a part, for indices below `end`.
fn values(columns: &[Column], end: u64) -> Vec<(u32, u32)> {
    let words: Vec<_> = columns.iter().map(|one| short_words(one, end)).collect();
    let mut values = vec![(KINDS, kinds(&words))];
    for (index, words) in (0..).zip(words) {
        values.extend((16 + COLUMN_STRIDE * index..).zip(words));
    }
    values
}

/// A column's words, without what bits contribute that no index has.
fn short_words(column: &Column, end: u64) -> Vec<u32> {
    // No odometers: they are long, and few points share the start of one.
    let mut words = column_words(*column, 0);
    let bits = u64::BITS - end.saturating_sub(1).leading_zeros();
    if matches!(column, Column::Sobol { .. }) {
        for direction in words.iter_mut().skip(NET_HEAD + bits as usize) {
            *direction = 0;
        }
    }
    words
}

/// Words of a net's column before its direction numbers.
const NET_HEAD: usize = 6;

/// Whether a coordinate takes so few instructions that stores are what counts.
#[must_use]
pub fn is_short(column: &Column) -> bool {
    match column {
        Column::Reversed | Column::Grid(_) | Column::Additive { .. } => true,
        Column::Sobol { scramble, .. } => *scramble != NetScramble::Owen,
        Column::Random { generator, .. } => *generator != Generator::Pcg32,
        _ => false,
    }
}

/// Whether it goes from point to point by the bits of the index that change.
fn steps(column: &Column) -> bool {
    matches!(
        column,
        Column::Sobol { .. } | Column::Reversed | Column::Grid(_)
    )
}
