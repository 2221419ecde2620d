//! The twin of the estimate kernel: exact sums of an integrand over points, on every core.

use super::column::Prepared;
use super::integrand::integrand_term;
use crate::Result;
use crate::catalog::{Problem, Request};
use crate::estimate::Estimate;
use crate::reference::sum::{sum_add, sum_zero};
use std::panic::resume_unwind;

/// Points of a sum in words; what several come to is added in wider integers.
const RUN: u64 = 1 << 20;

/// Exact sums of an integrand over `count` points of a request, `start` counted from its
/// first.
///
/// # Errors
/// [`crate::Error::Arguments`] for a request of other dimensions, or points that it does not have.
pub fn estimate(problem: &Problem, request: &Request, start: u64, count: u64) -> Result<Estimate> {
    problem.check(request, start, count)?;
    let columns: Vec<Prepared> = request.columns.iter().map(Prepared::new).collect();
    let threads = std::thread::available_parallelism().map_or(1, usize::from) as u64;
    let share = count.div_ceil(threads).max(1);
    let first = request.first + start;
    let run = |begin: u64| run(problem, &columns, first + begin, share.min(count - begin));
    std::thread::scope(|scope| {
        let begins = (0..count).step_by(share as usize);
        let parts: Vec<_> = begins
            .map(|begin| scope.spawn(move || run(begin)))
            .collect();
        let mut total = Estimate::new(problem.coefficients().scale);
        for part in parts {
            // A panic of a thread is a bug, and one here too.
            let part = part.join().unwrap_or_else(|panic| resume_unwind(panic));
            total = total.merged(part?)?;
        }
        Ok(total)
    })
}

/// The same on one core.
pub(super) fn run(
    problem: &Problem,
    columns: &[Prepared],
    first: u64,
    count: u64,
) -> Result<Estimate> {
    let mut total = Estimate::new(problem.coefficients().scale);
    let mut done = 0;
    while done < count {
        let points = RUN.min(count - done);
        total = total.merged(sums(problem, columns, first + done, points))?;
        done += points;
    }
    Ok(total)
}

fn sums(problem: &Problem, columns: &[Prepared], first: u64, count: u64) -> Estimate {
    let mut point = vec![0; columns.len()];
    let mut sum = sum_zero();
    for n in first..first + count {
        for (u, column) in point.iter_mut().zip(columns) {
            *u = column.fraction(n as u32);
        }
        sum = sum_add(sum, integrand_term(problem, &point));
    }
    let ([a, b, c, d], [e, f]) = (sum.squares.to_array(), sum.squares_high.to_array());
    Estimate::from_words(
        count as u32,
        problem.coefficients().scale,
        sum.total.to_array(),
        [a, b, c, d, e, f],
    )
}
