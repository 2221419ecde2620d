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
    let scale = problem.coefficients().scale;
    let run = |begin: u64, end: u64| -> Result<Estimate> {
        let mut total = Estimate::new(scale);
        let mut at = begin;
        while at < end {
            let next = (at + RUN).min(end);
            total = total.merged(sums(problem, &columns, first + at, next - at))?;
            at = next;
        }
        Ok(total)
    };
    std::thread::scope(|scope| {
        let begins = (0..count).step_by(share as usize);
        let parts: Vec<_> = begins
            .map(|begin| scope.spawn(move || run(begin, (begin + share).min(count))))
            .collect();
        let mut total = Estimate::new(scale);
        for part in parts {
            // A panic of a thread is a bug, and one here too.
            let part = part.join().unwrap_or_else(|panic| resume_unwind(panic));
            total = total.merged(part?)?;
        }
        Ok(total)
    })
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
