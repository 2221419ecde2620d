//! The arithmetic floor of an integrand: the error that no number of points removes.

use crate::bulk::integrand_term;
use crate::catalog::Problem;
use crate::check::judged_range;
use crate::reference::random::random;
use glam::UVec2;

/// Points that measure it.
const POINTS: u32 = 1 << 14;

/// Points are cells of 2^-32, of which the lower corner stands for all: the integrand is
/// compared between corners so many cells apart, and the difference scaled down, since over
/// one cell it would drown in the rounding of `f64`.
const APART: u32 = 1 << 12;

/// What is left of the error of a mean however many points there are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Floor {
    /// |mean error of a term|, against the same terms in `f64`.
    pub terms: f64,
    /// |mean change of the integrand over half a cell of every coordinate|.
    pub points: f64,
}

impl Floor {
    /// Both together.
    #[must_use]
    pub fn total(&self) -> f64 {
        self.terms + self.points
    }
}

/// Measures the floor of an integrand at 2^14 random points. Where no `f64` form of it is
/// known, the bound of its terms stands in, which is larger.
#[must_use]
pub fn floor(problem: &Problem) -> Floor {
    let unit = f64::powi(2.0, -problem.coefficients().scale);
    let mut errors = 0.0;
    let mut changes = 0.0;
    let mut unknown = false;
    for n in 0..POINTS {
        let coordinate = |j| random(n, j, UVec2::new(0x666c, 0x6f6f));
        let point: Vec<u32> = (0..problem.dimensions()).map(coordinate).collect();
        let term = integrand_term(problem, &point);
        let magnitude = (u64::from(term.m.x) | (u64::from(term.m.y) << 32)) as f64;
        let got = if term.negative { -magnitude } else { magnitude } * unit;
        let [least, most] = judged_range(problem, &point);
        // Within the judge's range there is no error to be seen.
        errors += (got - most).max(0.0) - (least - got).max(0.0);
        let moved: Vec<u32> = point.iter().map(|u| u.saturating_add(APART)).collect();
        let [other_least, other_most] = judged_range(problem, &moved);
        changes += 0.5 * (other_least + other_most) - 0.5 * (least + most);
        unknown |= least.is_nan();
    }
    let mean = |sum: f64| (sum / f64::from(POINTS)).abs();
    if unknown {
        return Floor {
            terms: problem.integrand().error * problem.coefficients().peak,
            points: 0.0,
        };
    }
    Floor {
        terms: mean(errors),
        points: mean(changes) / f64::from(2 * APART),
    }
}
