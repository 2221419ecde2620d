//! Tail probabilities, all from the incomplete gamma function.

/// ln Gamma(x) for x > 0: Stirling's series above 12, reached by the recurrence.
pub fn ln_gamma(x: f64) -> f64 {
    let (mut x, mut shift) = (x, 0.0);
    while x < 12.0 {
        shift -= x.ln();
        x += 1.0;
    }
    let y = 1.0 / (x * x);
    let series = (1.0 / 12.0 - y * (1.0 / 360.0 - y * (1.0 / 1260.0 - y / 1680.0))) / x;
    (x - 0.5) * x.ln() - x + 0.5 * std::f64::consts::TAU.ln() + series + shift
}

/// (P(a, x), Q(a, x)): the regularised incomplete gamma functions for a > 0, x >= 0.
/// P by its power series below the mean, Q by its continued fraction above (DLMF 8.7.1
/// and 8.9.2), each where it converges fast; the other is the rest.
pub fn gamma_tails(a: f64, x: f64) -> (f64, f64) {
    if x <= 0.0 {
        return (0.0, 1.0);
    }
    let scale = (a * x.ln() - x - ln_gamma(a)).exp();
    if x < a + 1.0 {
        let (mut term, mut sum, mut n) = (1.0 / a, 1.0 / a, a);
        while term > sum * 1e-17 {
            n += 1.0;
            term *= x / n;
            sum += term;
        }
        let p = scale * sum;
        return (p, 1.0 - p);
    }
    // Evaluated from the top by Lentz's method.
    let (mut b, mut d) = (x + 1.0 - a, 1.0 / (x + 1.0 - a));
    let (mut c, mut h) = (f64::MAX, d);
    for i in 1..100_000 {
        let i = f64::from(i);
        let numerator = -i * (i - a);
        b += 2.0;
        d = 1.0 / (numerator * d + b);
        c = b + numerator / c;
        h *= d * c;
        if (d * c - 1.0).abs() < 1e-15 {
            break;
        }
    }
    let q = scale * h;
    (1.0 - q, q)
}

/// Twice the smaller tail: both a bad fit and one too good are small.
fn two_sided((lower, upper): (f64, f64)) -> f64 {
    (2.0 * lower.min(upper)).min(1.0)
}

/// For a standard normal variable.
pub fn normal(z: f64) -> f64 {
    gamma_tails(0.5, 0.5 * z * z).1
}

/// For chi-square with so many degrees of freedom.
pub fn chi_square(x: f64, freedom: f64) -> f64 {
    two_sided(gamma_tails(0.5 * freedom, 0.5 * x))
}

/// For a Poisson variable of this mean.
pub fn poisson(count: u64, mean: f64) -> f64 {
    let at_least = if count == 0 {
        1.0
    } else {
        gamma_tails(count as f64, mean).0
    };
    two_sided((gamma_tails(count as f64 + 1.0, mean).1, at_least))
}

/// For a binomial variable of p = 1/2, in the normal limit.
pub fn fair(ones: u64, trials: u64) -> f64 {
    let trials = trials as f64;
    normal((2.0 * ones as f64 - trials) / trials.sqrt())
}

/// For counts in cells of these probabilities.
pub fn cells(counts: &[u64], probabilities: &[f64]) -> f64 {
    let total = counts.iter().sum::<u64>() as f64;
    let square = |(&count, &p): (&u64, &f64)| (count as f64 - total * p).powi(2) / (total * p);
    let x = counts.iter().zip(probabilities).map(square).sum();
    chi_square(x, counts.len() as f64 - 1.0)
}

/// scipy.special.gammaln(x).
const GAMMALN: [(f64, f64); 5] = [
    (0.5, 0.5723649429247),
    (1.5, -0.12078223763524526),
    (3.7, 1.428072326665388),
    (127.5, 489.13037043064287),
    (2048.0, 13564.326353384677),
];

/// scipy.special.gammainc(a, x), gammaincc(a, x).
const GAMMAINC: [(f64, f64, f64, f64); 8] = [
    (0.5, 0.01, 0.11246291601828491, 0.887537083981715),
    (0.5, 15.0, 0.9999999567953695, 4.3204630578274955e-08),
    (127.5, 60.0, 2.484413246047568e-14, 0.9999999999999751),
    (127.5, 250.0, 1.0, 4.384961916799239e-18),
    (20.0, 20.0, 0.5297427331607607, 0.4702572668392401),
    (1024.0, 900.0, 2.7539301763359477e-05, 0.9999724606982366),
    (1024.0, 1200.0, 0.9999999121766728, 8.782332721924083e-08),
    (129.0, 128.0, 0.47651555134729917, 0.5234844486527008),
];

/// 2 * scipy.stats.norm.sf(z).
const NORM: [(f64, f64); 3] = [
    (0.5, 0.6170750774519738),
    (3.0, 0.0026997960632601866),
    (6.5, 8.032001167718176e-11),
];

/// 2 * min(scipy.stats.poisson.cdf(k, m), poisson.sf(k - 1, m)).
const POISSON: [(u64, f64, f64); 5] = [
    (0, 128.0, 5.144418745284823e-56),
    (40, 128.0, 1.7727583922889636e-19),
    (100, 128.0, 0.012030499460703555),
    (180, 128.0, 1.6871299630202182e-05),
    (1200, 1024.0, 9.141217765731394e-08),
];

#[test]
fn tails_are_those_of_scipy() {
    let close = |got: f64, truth: f64| {
        assert!((got / truth - 1.0).abs() < 1e-11, "{got:e}, not {truth:e}");
    };
    for (x, truth) in GAMMALN {
        close(ln_gamma(x), truth);
    }
    for (a, x, p, q) in GAMMAINC {
        let got = gamma_tails(a, x);
        // The smaller tail has all its digits.
        if p < q {
            close(got.0, p);
        } else {
            close(got.1, q);
        }
    }
    for (z, truth) in NORM {
        close(normal(z), truth);
    }
    for (k, mean, truth) in POISSON {
        close(poisson(k, mean), truth);
    }
}
