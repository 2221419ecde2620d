//! Columns into rows.

use super::points::Batch;
use std::array::from_fn;

/// Columns of a batch at most.
pub const TOGETHER: usize = 64;

/// Points that are moved at a time, where the width of a row is known.
const STRIP: usize = 64;

/// Writes a batch into its place in rows of `width` words.
pub fn interleave(batch: &Batch, width: usize, rows: &mut [u32]) {
    match width {
        2 => narrow::<2>(batch, rows),
        3 => narrow::<3>(batch, rows),
        4 => narrow::<4>(batch, rows),
        8 => narrow::<8>(batch, rows),
        _ => wide(batch, 0, width, rows),
    }
}

/// Rows of D words, which a batch fills.
fn narrow<const D: usize>(batch: &Batch, rows: &mut [u32]) {
    let columns: [&[u32]; D] = from_fn(|c| &batch.words[c * batch.stride..][..batch.rows]);
    let columns = columns.map(|column| column.as_chunks::<STRIP>().0);
    let mut done = 0;
    for (i, strip) in rows.chunks_exact_mut(STRIP * D).enumerate() {
        let columns = columns.map(|column| &column[i]);
        for (j, row) in strip
            .as_chunks_mut::<D>()
            .0
            .iter_mut()
            .enumerate()
            .take(STRIP)
        {
            *row = from_fn(|c| columns[c][j]);
        }
        done += STRIP;
    }
    wide(batch, done, D, &mut rows[done * D..]);
}

/// Rows of any width, from row `first` of the batch on.
fn wide(batch: &Batch, first: usize, width: usize, rows: &mut [u32]) {
    let taken = (width - batch.first).min(TOGETHER);
    for (i, row) in (first..).zip(rows.chunks_exact_mut(width)) {
        let columns = batch.words[i..].iter().step_by(batch.stride);
        for (word, column) in row[batch.first..][..taken].iter_mut().zip(columns) {
            *word = *column;
        }
    }
}
