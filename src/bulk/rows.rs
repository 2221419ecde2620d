//! Columns into rows.

use super::points::{Batch, STRIDE};
use std::array::from_fn;

/// Columns of a batch at most.
pub const TOGETHER: usize = 64;

/// Rows at a time: a number that the compiler knows.
const STRIP: usize = 64;

/// Writes a batch into its place in rows of `width` words.
#[inline(always)]
pub fn interleave(batch: &Batch, width: usize, rows: &mut [u32]) {
    match width {
        // With the width known, loads and stores are wide.
        1 => band::<1>(batch, 0, 1, rows),
        2 => band::<2>(batch, 0, 2, rows),
        3 => band::<3>(batch, 0, 3, rows),
        4 => band::<4>(batch, 0, 4, rows),
        8 => band::<8>(batch, 0, 8, rows),
        _ => {
            let taken = (width - batch.first).min(TOGETHER);
            let mut column = 0;
            while column < taken {
                column += match taken - column {
                    8.. => {
                        band::<8>(batch, column, width, rows);
                        8
                    }
                    4.. => {
                        band::<4>(batch, column, width, rows);
                        4
                    }
                    _ => {
                        band::<1>(batch, column, width, rows);
                        1
                    }
                };
            }
        }
    }
}

/// Writes D columns of a batch from `first` on.
#[inline(always)]
fn band<const D: usize>(batch: &Batch, first: usize, width: usize, rows: &mut [u32]) {
    let columns: [&[u32]; D] = from_fn(|c| &batch.words[(first + c) * STRIDE..][..batch.rows]);
    let place = batch.first + first;
    let whole = columns.map(|column| column.as_chunks::<STRIP>().0);
    for (i, strip) in rows.chunks_exact_mut(STRIP * width).enumerate() {
        let columns = whole.map(|column| &column[i]);
        for (j, row) in strip.chunks_exact_mut(width).enumerate().take(STRIP) {
            if let Some(words) = row[place..].first_chunk_mut::<D>() {
                *words = from_fn(|c| columns[c][j]);
            }
        }
    }
    let done = batch.rows / STRIP * STRIP;
    for (i, row) in (done..).zip(rows[done * width..].chunks_exact_mut(width)) {
        for (word, column) in row[place..].iter_mut().zip(&columns) {
            *word = column[i];
        }
    }
}
