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
    /// |mean change of the integrand over half a cell of every coordinate|, and what its jumps
    /// and poles may add.
    pub points: f64,
}

impl Floor {
    /// Both together.
    #[must_use]
    pub fn total(&self) -> f64 {
        self.terms + self.points
    }
}

/// Of so many points at least the measure must be made: fewer say nothing of what they missed.
const HITS: f64 = 100.0;

/// Measures the floor of an integrand at 2^14 random points. Where no `f64` form of it is
/// known, or hardly a point meets what the integral consists of, the bound of its terms stands
/// in, which is larger: a share of the peak, or of the integral.
#[must_use]
pub fn floor(problem: &Problem) -> Floor {
    let unit = f64::powi(2.0, -problem.coefficients().scale);
    let mut errors = 0.0;
    let mut changes = 0.0;
    let (mut sum, mut squares) = (0.0, 0.0);
    let mut unknown = false;
    for n in 0..POINTS {
        let coordinate = |j| random(n, j, UVec2::new(0x666c, 0x6f6f));
        let point: Vec<u32> = (0..problem.dimensions()).map(coordinate).collect();
        let term = integrand_term(problem, &point);
        let magnitude = (u64::from(term.m.x) | (u64::from(term.m.y) << 32)) as f64;
        let got = if term.negative { -magnitude } else { magnitude } * unit;
        sum += got.abs();
        squares += got * got;
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
            points: problem.roughness(),
        };
    }
    // Kish's effective number of points.
    let seen = sum * sum >= HITS * squares && squares > 0.0;
    Floor {
        terms: match seen {
            true => mean(errors),
            false => problem.integrand().error * problem.truth().abs(),
        },
        points: mean(changes) / f64::from(2 * APART) + problem.roughness(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(text: &str, estimator: Option<&str>) -> Floor {
        let problem = Problem::parse(text).expect("an integrand");
        floor(&match estimator {
            Some(name) => problem.with_estimator(name).expect("its estimator"),
            None => problem,
        })
    }

    /// Sums over all 2^32 points have closed forms.
    #[test]
    fn floors_hold_of_all_points() {
        // 1/3 - (N - 1) (2 N - 1) / (6 N^2), N = 2^32.
        let square = of("x-squared", None).total();
        let truth = f64::powi(2.0, -33);
        assert!((square / truth - 1.0).abs() < 0.05, "{square:e}");
        // Two of three cells: the corners below 1/3, and from 2/3 on.
        let all = 4_294_967_296u64;
        let even = all.div_ceil(3) + (all - (2 * all).div_ceil(3));
        let error = (even as f64 / all as f64 - 2.0 / 3.0).abs();
        let cells = of("checkerboard:d=1,cells=3", None).total();
        assert!(
            error > 7e-11 && (error..10.0 * error).contains(&cells),
            "{cells:e} {error:e}"
        );
        // 2 - (sum of the middles' values), which the catalogue states.
        let root = of("inverse-root", None).total();
        assert!((9.23e-6..1e-5).contains(&root), "{root:e}");
        // A quarter disk by corners has up to a cell more along each axis.
        let disk = of("disk-step", None).total();
        assert!((2e-10..5e-10).contains(&disk), "{disk:e}");
    }

    /// Points that miss what the integral consists of do not measure it.
    #[test]
    fn what_is_not_met_has_the_bound_of_its_terms() {
        let problem = Problem::parse("gaussian-peak:sigma=1e-6").expect("an integrand");
        let met = of("gaussian-peak:sigma=1e-6", Some("uniform")).terms;
        assert_eq!(met, problem.integrand().error * problem.truth());
        let lobe = "ggx-lobe:alpha=0.3,cosine=0.6,radius=0.002,offset=0";
        let missed = of(lobe, Some("ggx")).total();
        let problem = Problem::parse(lobe).expect("an integrand");
        assert!(missed > 1e-6 * problem.truth(), "{missed:e}");
    }

    /// Reals are cut, not rounded: each factor and each product of `product` loses about 1.7e-10
    /// in the mean, as its row says, and the floor has it.
    #[test]
    fn products_are_low_by_what_their_row_says() {
        for dimensions in [8, 64] {
            let found = of(&format!("product:d={dimensions}"), None).terms;
            let each = found / f64::from(dimensions);
            assert!((3.1e-10..3.8e-10).contains(&each), "{dimensions}: {each:e}");
        }
        let row = crate::catalog::Integrand::from_name("product").expect("a row");
        assert!(
            row.formula
                .contains("low by some 3.5e-10 of themselves a dimension")
        );
    }
}
