//! The normal distribution with one set of bits everywhere: quantile, inverse error
//! function, tail, density, and the fraction that a value stands for.
//!
//! Source: Giles 2010, "Approximating the erfinv function", 2, for the two ranges: a
//! polynomial in the square of the distance from 1/2, and in sqrt(-2 ln q) for tails q;
//! the tail as Mills' ratio in 4 / (4 + z) (Shepherd and Laframboise 1981) times
//! e^(-z^2/2). Coefficients: `scripts/elementary_polynomials.py`. Domain: all fractions u
//! of 2^32, which stand for the midpoints (2 u + 1) / 2^33: 0 and 1 are not among them,
//! so that nothing is infinite, and ~u gives exactly -z. Range: quantiles from -6.33796
//! to 6.33796, reals within 2^-28 of themselves, floats 0.55 ULP; tails within 2^-26 of
//! themselves, densities within 2^-29 for |z| <= 2^5. The fraction of a quantile differs
//! from its own by 4 units at most. Tier I.
//! Mirror: `shaders/corput/normal_quantile.glsl`.

use crate::reference::exponential::real_gaussian;
use crate::reference::fixed::{mul64, mulhi, shl64};
use crate::reference::logarithm::real_log;
use crate::reference::real::{
    Real, real_add, real_divide, real_float, real_fraction, real_multiply, real_negate, real_shift,
    real_sqrt, real_square, real_subtract, real_uint,
};

/// The mass of the normal distribution from 0 to some |z|, and beyond it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NormalMasses {
    /// The mass within the edge, on one side.
    pub mass: Real,
    /// The mass beyond it.
    pub tail: Real,
}

/// c + x p, for x a fraction of 2^32.
#[inline]
#[must_use]
pub fn horner(c: i32, x: u32, p: i32) -> i32 {
    let mut product = mulhi(x, p as u32);
    if p < 0 {
        product = product.wrapping_sub(x);
    }
    c.wrapping_add(product as i32)
}

/// z / (2 m) as a fraction of 2^31, for the mass m from 0 to z, w = 8 m^2 a fraction of 2^32.
#[inline]
#[must_use]
pub fn quantile_centre(w: u32) -> u32 {
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

/// z >= 0 with this mass from 0 to z, and this tail beyond, which is 1/2 - mass and at
/// least 2^-33: either may be small, and each is taken where it is.
#[inline]
#[must_use]
pub fn real_quantile(mass: Real, tail: Real) -> Real {
    let w = real_shift(real_square(mass), 3);
    if mass.m == 0 || w.e <= -32 {
        let p = quantile_centre(real_fraction(w));
        return real_multiply(mass, real_uint(p, -30));
    }
    let t = real_sqrt(real_shift(real_negate(real_log(tail)), 1));
    // From 1.96 to 6.77; at 3.75 the far range begins.
    if t.e < -30 || (t.e == -30 && t.m < 4_026_531_840) {
        return real_uint(quantile_near(t.m >> (-30 - t.e) as u32), -30);
    }
    real_uint(quantile_far(t.m >> (-29 - t.e) as u32), -29)
}

/// z such that the normal distribution has mass (2 u + 1) / 2^33 below it.
#[inline]
#[must_use]
pub fn real_normal_quantile(u: u32) -> Real {
    let negative = u < 0x8000_0000;
    // a * 2^-33 lies between 1/2 and the midpoint.
    let a = (if negative { !u } else { u } << 1) | 1;
    let z = real_quantile(real_uint(a, -33), real_uint(0u32.wrapping_sub(a), -33));
    Real {
        m: z.m,
        e: z.e,
        negative,
    }
}

/// The mass of the normal distribution from 0 to |z|, for z^2/2 = w < 1.
#[inline]
#[must_use]
pub fn real_normal_near(z: Real, w: Real) -> Real {
    let x = real_fraction(w);
    let mut p = 171_074 - mulhi(x, 14_679);
    p = 1_288_308 - mulhi(x, p);
    p = 7_928_138 - mulhi(x, p);
    p = 40_795_163 - mulhi(x, p);
    p = 171_344_265 - mulhi(x, p);
    p = 571_148_009 - mulhi(x, p);
    p = 1_713_444_047 - mulhi(x, p);
    real_multiply(
        Real {
            m: z.m,
            e: z.e,
            negative: false,
        },
        real_uint(p, -32),
    )
}

/// The mass of the normal distribution above |z|, for z^2/2 >= 1.
#[inline]
#[must_use]
pub fn real_normal_far(z: Real) -> Real {
    let four = real_uint(4, 0);
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

/// The masses of the normal distribution within and beyond |z|.
#[inline]
#[must_use]
pub fn real_normal_masses(z: Real) -> NormalMasses {
    let w = real_shift(real_square(z), -1);
    let near = z.m == 0 || w.e <= -32;
    let mut part = real_normal_near(z, w);
    if !near {
        part = real_normal_far(z);
    }
    let rest = real_subtract(real_uint(1, -1), part);
    if near {
        return NormalMasses {
            mass: part,
            tail: rest,
        };
    }
    NormalMasses {
        mass: rest,
        tail: part,
    }
}

/// The fraction whose midpoint's quantile is z: floor(2^32 Phi(z)), and ~ of it for -z.
#[inline]
#[must_use]
pub fn normal_fraction(z: Real) -> u32 {
    let tail = real_fraction(real_normal_masses(z).tail);
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
