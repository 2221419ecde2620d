//! Which kernel a job runs, with which constants.

use super::columns::{STORED_RUN, column_words, longest_run, padded};
use super::places::{PLACES_RUN, is_permuted, places};
use super::wide::{LEAST, wide};
use crate::interface::{COLUMN_STRIDE, Column, Family, KERNELS, KINDS, Kernel, output};

/// A job in plain words.
#[derive(Clone, Copy, Debug)]
pub struct Work<'a> {
    /// The columns of the points.
    pub columns: &'a [Column],
    /// Index of the first point.
    pub first: u64,
    /// Number of points.
    pub points: u64,
    /// Fractions instead of floats.
    pub fractions: bool,
    /// A map that the kernels of points know, and whether its pdf is wanted; the points
    /// are then two columns.
    pub map: Option<FusedMap>,
    /// The native profile.
    pub native: bool,
    /// The device is a CPU, which likes long runs of wide stores per invocation.
    pub cpu: bool,
    /// The device has integers of 64 bits, which some devices store faster.
    pub int64: bool,
}

/// A map in the kernel that makes its points.
#[derive(Clone, Copy, Debug)]
pub struct FusedMap {
    /// Value of `MAP`.
    pub id: u32,
    /// Coordinates of a sample.
    pub coordinates: u32,
    /// Whether the pdf follows them.
    pub with_pdf: bool,
}

/// The kernel for a job.
#[derive(Clone, Debug)]
pub struct Plan {
    /// The module.
    pub kernel: &'static Kernel,
    /// Values of its specialization constants, for each dispatch that the points take:
    /// one, or one per part of a wide row.
    pub specializations: Vec<Vec<(u32, u32)>>,
    /// The table of columns, for kernels that read one.
    pub table: Option<Vec<u32>>,
    /// Points of an invocation in the dispatch where it makes most; 0 for the general kernel,
    /// which makes four words. Of estimates those of a tile, of which an invocation sums some.
    pub tile: u32,
    /// The index of the first point must be a multiple of this.
    pub aligned: u32,
    /// Points of an invocation in each dispatch; empty for kernels that read a table of columns.
    pub tiles: Vec<u32>,
}

/// Below this many words the general kernel starts sooner than a tile kernel, which is
/// compiled anew for its columns.
const SMALL: u64 = 1 << 16;

/// Wide rows take a tile kernel per four columns, each compiled anew: about as long as
/// the general kernel takes for so many words.
const LARGE: u64 = 1 << 21;

/// Decides. Every choice gives the same bytes; they differ in speed only.
#[must_use]
pub fn plan(work: &Work) -> Plan {
    let words = work.points * work.columns.len() as u64;
    if let Some(map) = work.map {
        let name = if work.native { "fused_native" } else { "fused" };
        let mut plan = tiled(name, work.columns, work.cpu);
        plan.set("MAP", map.id);
        plan.set("COORDINATES", map.coordinates);
        plan.set("WITH_PDF", u32::from(map.with_pdf));
        return plan;
    }
    let output = if work.fractions {
        output::FRACTIONS
    } else {
        output::FLOATS
    };
    if let Some(mut plan) = wide(work) {
        plan.set("OUTPUT", output);
        return plan;
    }
    let tile = [
        "generate_tile_1",
        "generate_tile_2",
        "generate_tile_3",
        "generate_tile_4",
    ];
    let width = work.columns.len();
    let parts = width.div_ceil(4) as u64;
    // Words one by one, so far apart, were measured on a CPU alone.
    let rows = work.cpu || width.is_multiple_of(4);
    let mut plan = match (eight(work, words), tile.get(width - 1)) {
        (Some(name), _) => tiled(&name, work.columns, work.cpu),
        (_, Some(name)) if words >= SMALL => tiled(name, work.columns, work.cpu),
        (_, None) if rows && words >= parts * LARGE => tiled(tile[3], work.columns, work.cpu),
        _ => general(work),
    };
    plan.set("OUTPUT", output);
    plan
}

/// The kernel of tiles that stores eight words at a time, where there is one for these columns and
/// the device, and it is worth its compilation.
fn eight(work: &Work, words: u64) -> Option<String> {
    let name = format!("generate_eight_{}", work.columns.len());
    let fits = work.cpu && work.int64 && words >= LEAST;
    let known = |kernel: &Kernel| kernel.name == format!("{name}{}", family(work.columns).suffix());
    (fits && KERNELS.iter().any(known)).then_some(name)
}

/// The general kernel for a job without a map: the yardstick of the others.
#[must_use]
pub fn general(work: &Work) -> Plan {
    let mut plan = tabled(kernel("generate", family(work.columns)), work.columns, 0);
    plan.set("DIMENSIONS", work.columns.len() as u32);
    plan.set(
        "OUTPUT",
        if work.fractions {
            output::FRACTIONS
        } else {
            output::FLOATS
        },
    );
    plan
}

/// A kernel that reads columns from a table, but for the shapes that it takes as constants;
/// with odometers where windows of `window` points have one (0: never).
pub(super) fn tabled(kernel: &'static Kernel, columns: &[Column], window: u32) -> Plan {
    let words: Vec<_> = columns.iter().map(|&c| column_words(c, window)).collect();
    let mut values = vec![(KINDS, kinds(&words))];
    let known: Vec<u32> = kernel.specialization().iter().map(|c| c.0).collect();
    for (first, words) in (16..).step_by(COLUMN_STRIDE as usize).zip(&words) {
        let shape = (first..).zip(words.iter().copied());
        values.extend(shape.filter(|(id, _)| known.contains(id)));
    }
    Plan {
        kernel,
        specializations: vec![values],
        table: Some(words.into_iter().flat_map(padded).collect()),
        tile: 0,
        aligned: 1,
        tiles: Vec::new(),
    }
}

/// A bit for each kind of column that occurs.
pub(super) fn kinds(columns: &[Vec<u32>]) -> u32 {
    let kind = |words: &Vec<u32>| words.first().map_or(0, |kind| 1 << (kind & 31));
    columns.iter().map(kind).fold(0, |kinds, kind| kinds | kind)
}

/// A kernel of tiles of these columns.
pub(super) fn tiled(name: &str, columns: &[Column], cpu: bool) -> Plan {
    let mut plan = Plan {
        kernel: kernel(name, family(columns)),
        specializations: Vec::new(),
        table: None,
        tile: 0,
        aligned: 1,
        tiles: Vec::new(),
    };
    let has_places = plan.kernel.bindings.iter().any(|b| b.name == "places");
    let mut table = Vec::new();
    let parts = parts(columns.len());
    for first in &parts {
        let part = &columns[*first..columns.len().min(first + 4)];
        // A GPU's lanes should write side by side; a CPU's run on by themselves, the longer
        // the better.
        let run = |column: &Column| match has_places && is_permuted(column) {
            true => PLACES_RUN,
            false => longest_run(column),
        };
        let longest = part.iter().map(run).min();
        let tile = if cpu {
            longest.map_or(16, |run| run.min(STORED_RUN))
        } else {
            4
        };
        let mut words: Vec<_> = part.iter().map(|&c| column_words(c, tile)).collect();
        for (words, column) in words.iter_mut().zip(part).filter(|_| has_places) {
            place(words, column, &mut table);
        }
        let mut values = vec![(KINDS, kinds(&words))];
        for (index, words) in (0..).zip(words) {
            values.extend((16 + COLUMN_STRIDE * index..).zip(words));
        }
        plan.specializations.push(values);
        plan.tiles.push(tile);
        plan.tile = plan.tile.max(tile);
    }
    for part in 0..plan.tiles.len() {
        plan.set_in(part, "TILE", plan.tiles[part]);
    }
    if has_places {
        // Kernels of other scrambles do not look into it, but a buffer has bytes.
        table.resize(table.len().max(4), 0);
        plan.table = Some(table);
    }
    plan.set("ROW_WORDS", columns.len() as u32);
    for (part, first) in parts.iter().enumerate() {
        plan.set_in(part, "FIRST_COLUMN", *first as u32);
        plan.set_in(part, "SKIPPED", (4 * part - first) as u32);
    }
    plan
}

/// The first columns of the parts of a row, of four columns each: the last begins where four are
/// left, within the part before it.
fn parts(width: usize) -> Vec<usize> {
    let last = width.saturating_sub(4);
    (0..width).step_by(4).map(|first| first.min(last)).collect()
}

/// Appends the places of a permuted column to the table, and writes where they are.
fn place(words: &mut [u32], column: &Column, table: &mut Vec<u32>) {
    let (Column::Digits { base, seed, .. }, true) = (column, is_permuted(column)) else {
        return;
    };
    if let [_, _, low, _, at, ..] = words {
        *at = table.len() as u32;
        table.extend(places(*base, *seed, *low));
    }
}

impl Plan {
    /// Gives a constant a value in every dispatch, if the kernel has it.
    pub(super) fn set(&mut self, name: &str, value: u32) {
        for part in 0..self.specializations.len() {
            self.set_in(part, name, value);
        }
    }

    /// The same in one dispatch.
    pub(super) fn set_in(&mut self, part: usize, name: &str, value: u32) {
        let constant = self.kernel.constants.iter().find(|c| c.name == name);
        if let (Some(constant), Some(values)) = (constant, self.specializations.get_mut(part)) {
            values.retain(|(id, _)| *id != constant.id);
            values.push((constant.id, value));
        }
    }
}

/// The family of the columns; one sequence has columns of one family.
pub(super) fn family(columns: &[Column]) -> Family {
    columns.first().map_or(Family::Radical, Column::family)
}

/// The row of a family with this name; the names are those of the table.
pub(super) fn kernel(name: &str, family: Family) -> &'static Kernel {
    KERNELS
        .iter()
        .find(|kernel| kernel.name.strip_suffix(family.suffix()) == Some(name))
        .unwrap_or(&KERNELS[0])
}

#[cfg(test)]
mod tests {
    use super::parts;

    #[test]
    fn parts_cover_a_row_and_the_last_has_four_columns() {
        assert_eq!(parts(1), [0]);
        assert_eq!(parts(4), [0]);
        assert_eq!(parts(5), [0, 1]);
        assert_eq!(parts(7), [0, 3]);
        assert_eq!(parts(12), [0, 4, 8]);
        assert_eq!(parts(14), [0, 4, 8, 10]);
    }
}
