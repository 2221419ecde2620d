//! The exact sum of floats on the CPU.

use crate::Result;
use crate::estimate::{Estimate, FloatSum, WINDOWS, window_scale};
use crate::reference::sum::{tally_add, tally_sum, tally_zero, term_window};

/// Terms of a tally.
const RUN: usize = 1 << 15;

/// The sum of these floats, exact; infinities and NaN are counted apart.
///
/// # Errors
/// [`Error::Arguments`](crate::Error::Arguments) for more than 2^62 of them.
pub fn reduce(terms: &[f32]) -> Result<FloatSum> {
    let mut all = FloatSum::default();
    for run in terms.chunks(RUN) {
        let special = run.iter().filter(|x| !x.is_finite()).count() as u64;
        for window in 0..WINDOWS {
            let sum = tally_sum(run.iter().fold(tally_zero(), |tally, x| {
                tally_add(tally, term_window(x.to_bits(), window as u32))
            }));
            let [a, b, c, d] = sum.squares.to_array();
            let [e, f] = sum.squares_high.to_array();
            let count = run.len() as u32;
            let squares = [a, b, c, d, e, f];
            let scale = window_scale(window);
            let sum = Estimate::from_words(count, scale, sum.total.to_array(), squares);
            all = all.with(window, sum, special)?;
        }
    }
    Ok(all)
}
