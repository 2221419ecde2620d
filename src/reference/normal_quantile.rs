//! The normal distribution with one set of bits everywhere: quantile, inverse error
//! function, tail, density, and the fraction that a value stands for.
//!
//! Source: Giles 2010, "Approximating the erfinv function", 2, for the two ranges: a
//! polynomial in the square of the distance from 1/2, and in sqrt(-2 ln q) for tails q; the
//! tail as Mills' ratio in 4 / (4 + z) (Shepherd and Laframboise 1981) times e^(-z^2/2).
//! Coefficients: `scripts/elementary_polynomials.py`. Domain: all fractions u of 2^32,
//! which stand for the midpoints (2 u + 1) / 2^33: 0 and 1 are not among them, so that
//! nothing is infinite, and ~u gives exactly -z. Range: quantiles from -6.33796 to 6.33796,
//! reals within 2^-28 of themselves, floats 0.54 ULP; tails within 2^-26 of themselves,
//! densities within 2^-29 for |z| <= 2^5. The fraction of a quantile differs from its own by
//! 4 units at most. Tier I.
//! Mirror: `shaders/corput/normal_quantile.glsl`.

use crate::reference::exponential::real_gaussian;
use crate::reference::fixed::{mul64, mulhi, shl64};
use crate::reference::logarithm::real_log;
use crate::reference::real::{
    Real, real_add, real_divide, real_float, real_fraction, real_multiply, real_shift, real_sqrt,
    real_square, real_subtract, real_uint,
};

/// c + x p, for x a fraction of 2^32.
#[inline]
#[must_use]
pub fn horner(c: i32, x: u32, p: i32) -> i32 {
    let product = mulhi(x, p as u32);
    c.wrapping_add(if p < 0 {
        product.wrapping_sub(x)
    } else {
        product
    } as i32)
}

/// z / (2 a) as a fraction of 2^31, for the mass a * 2^-33 from 0 to z: a^2 <= 2^63.
#[inline]
#[must_use]
pub fn quantile_centre(a: u32) -> u32 {
    let w = shl64(mul64(a, a), 1).y;
    let mut p = horner(-4_005_107, w, 1_041_235);
    p = horner(7_802_295, w, p);
    p = horner(-7_962_297, w, p);
    p = horner(6_624_098, w, p);
    p = horner(-552_001, w, p);
    p = horner(5_660_002, w, p);
    p = horner(12_193_799, w, p);
    p = horner(32_871_832, w, p);
    p = horner(96_846_255, w, p);
    p = horner(352_312_827, w, p);
    2_691_471_616 + mulhi(w, p as u32)
}

/// z in units of 2^-30, for t = sqrt(-2 ln q) in units of 2^-30, from 1.9375 to 3.75.
#[inline]
#[must_use]
pub fn quantile_near(t: u32) -> u32 {
    let s = (t - 2_080_374_784) << 1;
    let mut p = horner(-5_604_921, s, 854_037);
    p = horner(17_377_399, s, p);
    p = horner(-34_834_799, s, p);
    p = horner(53_018_350, s, p);
    p = horner(-69_188_333, s, p);
    p = horner(85_256_918, s, p);
    p = horner(-105_625_932, s, p);
    p = horner(135_808_689, s, p);
    p = horner(-184_688_656, s, p);
    p = horner(1_347_462_260, s, p);
    1_098_883_931 + shl64(mul64(s, p as u32), 1).y
}

/// z in units of 2^-29, for t = sqrt(-2 ln q) in units of 2^-29, from 3.75 to 6.8125.
#[inline]
#[must_use]
pub fn quantile_far(t: u32) -> u32 {
    let s = (t - 2_013_265_920) << 1;
    let mut p = horner(7_603_437, s, -1_434_311);
    p = horner(-19_298_240, s, p);
    p = horner(32_499_054, s, p);
    p = horner(-43_216_171, s, p);
    p = horner(51_443_856, s, p);
    p = horner(-59_549_370, s, p);
    p = horner(69_888_028, s, p);
    p = horner(-84_963_774, s, p);
    p = horner(1_183_881_170, s, p);
    1_678_647_636 + shl64(mul64(s, p as u32), 1).y
}

/// z such that the normal distribution has mass (2 u + 1) / 2^33 below it.
#[inline]
#[must_use]
pub fn real_normal_quantile(u: u32) -> Real {
    let negative = u < 0x8000_0000;
    // a * 2^-33 lies between 1/2 and the midpoint.
    let a = (if negative { !u } else { u } << 1) | 1;
    if a <= 0xb504_f333 {
        let distance = real_uint(a, -32);
        let z = real_multiply(
            distance,
            Real {
                m: quantile_centre(a),
                e: -31,
                negative: false,
            },
        );
        return Real {
            m: z.m,
            e: z.e,
            negative,
        };
    }
    let log_q = real_log(real_uint(0u32.wrapping_sub(a), -33));
    let t = real_sqrt(Real {
        m: log_q.m,
        e: log_q.e + 1,
        negative: false,
    });
    // From 1.96 to 6.77; at 3.75 the far range begins.
    if t.e < -30 || (t.e == -30 && t.m < 4_026_531_840) {
        let z = real_uint(quantile_near(t.m >> (-30 - t.e) as u32), -30);
        return Real {
            m: z.m,
            e: z.e,
            negative,
        };
    }
    let z = real_uint(quantile_far(t.m >> (-29 - t.e) as u32), -29);
    Real {
        m: z.m,
        e: z.e,
        negative,
    }
}

/// The mass of the normal distribution above |z|.
#[inline]
#[must_use]
pub fn real_normal_tail(z: Real) -> Real {
    let half_square = real_shift(real_square(z), -1);
    if z.m == 0 || half_square.e <= -32 {
        let w = real_fraction(half_square);
        let mut p = 171_074 - mulhi(w, 14_679);
        p = 1_288_308 - mulhi(w, p);
        p = 7_928_138 - mulhi(w, p);
        p = 40_795_163 - mulhi(w, p);
        p = 171_344_265 - mulhi(w, p);
        p = 571_148_009 - mulhi(w, p);
        p = 1_713_444_047 - mulhi(w, p);
        let mass = real_multiply(
            Real {
                m: z.m,
                e: z.e,
                negative: false,
            },
            real_uint(p, -32),
        );
        return real_subtract(
            Real {
                m: 0x8000_0000,
                e: -32,
                negative: false,
            },
            mass,
        );
    }
    let four = Real {
        m: 0x8000_0000,
        e: -29,
        negative: false,
    };
    let sum = real_add(
        Real {
            m: z.m,
            e: z.e,
            negative: false,
        },
        four,
    );
    let s = real_fraction(real_divide(four, sum));
    let mut p = horner(194_367_399, s, -137_488_665);
    p = horner(419_245_307, s, p);
    p = horner(-148_357_307, s, p);
    p = horner(670_920_889, s, p);
    p = horner(260_209_733, s, p);
    p = horner(465_125_121, s, p);
    p = horner(423_049_695, s, p);
    p = horner(329_745, s, p);
    real_multiply(real_gaussian(z), real_uint(p as u32, -32))
}

/// The fraction whose midpoint's quantile is z: floor(2^32 Phi(z)), and ~ of it for -z.
#[inline]
#[must_use]
pub fn normal_fraction(z: Real) -> u32 {
    let tail = real_fraction(real_normal_tail(z));
    if z.negative { tail } else { !tail }
}

/// The density at z, e^(-z^2/2) / sqrt(2 pi).
#[inline]
#[must_use]
pub fn real_normal_density(z: Real) -> Real {
    real_multiply(
        real_gaussian(z),
        Real {
            m: 3_426_888_095,
            e: -33,
            negative: false,
        },
    )
}

/// z such that the normal distribution has mass (2 u + 1) / 2^33 below it.
#[inline]
#[must_use]
pub fn normal_quantile(u: u32) -> f32 {
    real_float(real_normal_quantile(u))
}

/// erf^-1((2 u + 1) / 2^32 - 1), which is the quantile over sqrt(2).
#[inline]
#[must_use]
pub fn inverse_erf(u: u32) -> f32 {
    real_float(real_multiply(
        real_normal_quantile(u),
        Real {
            m: 3_037_000_500,
            e: -32,
            negative: false,
        },
    ))
}
