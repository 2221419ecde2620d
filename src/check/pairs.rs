//! The kernels over pairs of points: their sums and nearest pairs.

use super::inputs::mix;
use super::rows::{Row, words128};
use crate::Result;
use crate::bulk::{Columns, NearestWords, nearest_words, pair_kind_of, pair_scale, pair_sum};
use crate::kernels::Pairs;
use crate::stats::{L2, L2_KINDS, Points, Source};
use crate::vulkan::Device;
use std::sync::Arc;

/// Sets: points, and coordinates of each. The first takes several blocks of later points,
/// the last several dispatches for a block on a CPU.
const SETS: [(u32, u32); 3] = [(5_003, 1), (257, 2), (1_003, 9)];

/// A sum that a check wants: the discrepancy, the points, the scale.
pub type Sum<'a> = &'a mut dyn FnMut(L2, &Columns, u32) -> Result<u128>;

/// Random words, with coordinates at the ends, the middle, and equal ones.
fn columns(count: u32, dimensions: u32) -> Result<Columns> {
    let special = [0, 1, 0x7fff_ffff, 0x8000_0000, 0x8000_0001, u32::MAX];
    let word = |i: u32| match mix(i ^ 0x5bd1_e995) % 8 {
        0 => special[mix(i) as usize % special.len()],
        _ => mix(i.wrapping_mul(dimensions)),
    };
    let values = (0..count * dimensions).map(|i| f64::from(word(i)) / 4_294_967_296.0);
    let points = Points::new(dimensions as usize, values.collect(), Source::U32)?;
    Columns::new(&points)
}

/// Compares the sums of every discrepancy.
pub fn check_sums(device: &Arc<Device>) -> Result<Row> {
    compare_pair_sums(&mut |kind, columns, scale| {
        let pairs = Pairs::sums(
            device,
            columns.words(),
            columns.dimensions(),
            pair_kind_of(kind),
        )?;
        pairs.sum(scale, &mut |_, _| Ok(()))
    })
}

/// Compares sums of the caller's with the CPU's.
///
/// # Errors
/// Those of `sum`.
pub fn compare_pair_sums(sum: Sum) -> Result<Row> {
    let mut row = Row::exact(
        "pair sums: star, centred, wrap-around, mixture, modified",
        "pairs",
    );
    for (count, dimensions) in SETS {
        let columns = columns(count, dimensions)?;
        for kind in L2_KINDS {
            let scale = pair_scale(kind, dimensions);
            let got = sum(kind, &columns, scale)?;
            row.hash(&words128(got));
            let expected = pair_sum(kind, &columns, scale);
            row.count(got == expected, || {
                format!("{kind:?}, {dimensions} dimensions: {got:x}, not {expected:x}")
            });
        }
    }
    Ok(row.judged())
}

/// A nearest pair that a check wants: the points, and whether on the torus.
pub type Search<'a> = &'a mut dyn FnMut(&Columns, bool) -> Result<Option<NearestWords>>;

/// Compares the nearest pairs.
pub fn check_nearest(device: &Arc<Device>) -> Result<Row> {
    compare_nearest(&mut |columns, toroidal| {
        let pairs = Pairs::nearest(device, columns.words(), columns.dimensions(), toroidal)?;
        let mut best = None;
        pairs.search(
            &mut |row, square, other| NearestWords::keep(&mut best, row, square, other),
            &mut |_, _| Ok(()),
        )?;
        Ok(best)
    })
}

/// Compares nearest pairs of the caller's with the CPU's.
///
/// # Errors
/// Those of `search`.
pub fn compare_nearest(search: Search) -> Result<Row> {
    let mut row = Row::exact("nearest pair: torus, cube", "nearest");
    for (count, dimensions) in SETS {
        let columns = columns(count, dimensions)?;
        for toroidal in [true, false] {
            let got = search(&columns, toroidal)?;
            if let Some(found) = &got {
                row.hash(&found.square.to_array());
                row.hash(&found.rows);
            }
            let expected = nearest_words(&columns, toroidal);
            row.count(got == expected, || {
                format!("{dimensions} dimensions: {got:x?}, not {expected:x?}")
            });
        }
    }
    Ok(row.judged())
}
