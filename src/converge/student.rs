//! Student's t distribution, as far as intervals of means need it.

use std::f64::consts::FRAC_2_PI;
use std::f64::consts::FRAC_PI_2;

/// t with P(|T| <= t) = `share` for a share in (0, 1) and whole degrees of freedom, 1 or more;
/// within 1e-10 of itself for shares to 0.9999. Takes as many steps as a hundred times half the
/// degrees.
pub fn two_sided(share: f64, degrees: u32) -> f64 {
    // The share rises with the angle.
    let (mut low, mut high) = (0.0, FRAC_PI_2);
    for _ in 0..100 {
        let middle = f64::midpoint(low, high);
        match within(middle, degrees) < share {
            true => low = middle,
            false => high = middle,
        }
    }
    f64::from(degrees).sqrt() * f64::midpoint(low, high).tan()
}

/// P(|T| <= sqrt(degrees) tan(angle)): the finite series of Abramowitz and Stegun 1964, 26.7.3
/// and 26.7.4.
fn within(angle: f64, degrees: u32) -> f64 {
    let (sin, cos) = angle.sin_cos();
    let odd = degrees % 2 == 1;
    let first = if odd { cos } else { 1.0 };
    // The k-th term over the one before: cos^2 (k - 1) / k, with k = 3, 5, ... or 2, 4, ...
    let terms = (2 + u32::from(odd)..degrees)
        .step_by(2)
        .scan(first, |term, k| {
            *term *= cos * cos * f64::from(k - 1) / f64::from(k);
            Some(*term)
        });
    let rest = sin * terms.sum::<f64>();
    match degrees {
        1 => FRAC_2_PI * angle,
        _ if odd => FRAC_2_PI * (angle + sin * first + rest),
        _ => sin * first + rest,
    }
}

#[cfg(test)]
mod tests {
    use super::two_sided;

    /// The usual tables, to seven digits and more.
    #[test]
    fn quantiles_are_those_of_tables() {
        for (degrees, t) in [
            (1, 12.706_204_736),
            (2, 4.302_652_730),
            (3, 3.182_446_305),
            (4, 2.776_445_105),
            (5, 2.570_581_836),
            (10, 2.228_138_852),
            (15, 2.131_449_546),
            (30, 2.042_272_456),
            (31, 2.039_513_446),
            (120, 1.979_930_405),
        ] {
            let found = two_sided(0.95, degrees);
            assert!((found - t).abs() < 1e-8, "{degrees}: {found}");
        }
        assert!((two_sided(0.99, 10) - 3.169_272_673).abs() < 1e-8);
        // The median of |T| of one degree of freedom is 1.
        assert!((two_sided(0.5, 1) - 1.0).abs() < 1e-12);
    }

    /// Cornish and Fisher: z + (z^3 + z) / (4 n) + ..., of which the rest is below 1e-6 here.
    #[test]
    fn many_degrees_come_to_the_normal_quantile() {
        let z = 1.959_963_984_540_054_f64;
        for degrees in [2000, 4094, 4095] {
            let expected = z + (z.powi(3) + z) / (4.0 * f64::from(degrees));
            let found = two_sided(0.95, degrees);
            assert!((found - expected).abs() < 1e-6, "{degrees}: {found}");
            assert!((found - z).abs() > 1e-4, "more than the normal's");
        }
    }
}
