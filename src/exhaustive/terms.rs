//! The sum of 2^28 equal floats, in groups of six sizes and split into dispatches in three ways.

use super::Subject;
use super::compare::Watch;
use super::row::{Figures, Row};
use crate::Result;
use crate::bulk::reduce;
use crate::estimate::FloatSum;
use crate::kernels::{Reducer, Split};
use crate::report::hexadecimal;
use sha2::{Digest, Sha256};
use std::time::Instant;

/// Every bit of a significand, so that each place of a tally fills.
const TERM: f32 = -1.999_999_9;

/// Terms, and those of them that lie in memory.
const TERMS: u64 = 1 << 28;
const PART: usize = 1 << 22;

/// Invocations of a group: every device runs 128.
const GROUPS: [u32; 6] = [1, 7, 32, 64, 96, 128];

/// Terms of a dispatch and of a run.
const SPLITS: [(usize, u32); 3] = [(PART, 256), (1 << 20, 1_000), (PART / 3 + 1, 64)];

/// What the row compares.
pub const INPUTS: &str = "2^28 equal terms, in groups of 6 sizes and 3 splits";

/// The row, by reducers in groups of the sizes that `reducer` is asked for; of fewer terms where
/// `terms` is below 2^28, a multiple of 2^22.
///
/// # Errors
/// Those of the reducers and of `watch`.
pub fn compare_terms(
    terms: u64,
    reducer: &mut dyn FnMut(u32) -> Result<Reducer>,
    watch: Watch,
) -> Result<Row> {
    let begun = Instant::now();
    let part = vec![TERM; PART];
    let parts = (terms.min(TERMS) / PART as u64).max(1);
    let many = |part: FloatSum| (1..parts).try_fold(part, |all, _| all.merged(part));
    let twin = many(reduce(&part)?)?;
    let product = f64::from(TERM) * (parts * PART as u64) as f64;
    let total = (GROUPS.len() * SPLITS.len()) as u64 * parts;
    let mut row = Row::new(&Subject::Terms);
    if parts * (PART as u64) < TERMS {
        row.inputs = format!("{parts} times 2^22 of them");
    }
    let (mut figures, mut hash, mut done) = (Figures::default(), Sha256::new(), 0);
    for group in GROUPS {
        let sums = reducer(group)?;
        for (dispatch, run) in SPLITS {
            let split = Split { dispatch, run };
            let mut got = FloatSum::default();
            for _ in 0..parts {
                watch(done, total)?;
                got = got.merged(sums.reduce_in(&part, split)?)?;
                done += 1;
            }
            let index = figures.compared;
            figures.compared += 1;
            figures.judged += 1;
            let words = got.words();
            words
                .iter()
                .for_each(|word| hash.update(word.to_le_bytes()));
            let what = || format!("groups of {group}, {split:?}");
            if got != twin {
                figures.differs(index, || format!("{}: {words:016x?}", what()));
            }
            figures.error(index, ((got.value() - product) / product).abs(), what);
        }
    }
    watch(done, total)?;
    let mut row = row.judged(figures, hexadecimal(&hash.finalize()));
    row.seconds = begun.elapsed().as_secs_f64();
    Ok(row)
}
