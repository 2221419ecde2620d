//! Offsets from a pixel's centre by the magnitude of the filter of Mitchell and
//! Netravali, as a product of two coordinates, with pdf, inverse and signed weight.
//!
//! Source: Mitchell and Netravali 1988, Reconstruction filters in computer graphics, eq.
//! 8; PBRT 4th ed., 8.8.5 and 8.8.6: the weight of a sample is f / pdf. In terms of y =
//! 2 - |t|, the lobe outside 1 is y^2 ((B + 6 C) y - 6 C) / 6, whose sign changes at y =
//! 6 C / (B + 6 C). Each part is a quartic from the end where its density is least,
//! without cancellation, inverted by 5 steps of Newton's method. Domain: radius > 0, B
//! and C from 0 to 1, what is beyond counts as the end; two fractions of 2^32, which
//! stand for midpoints of their parts. radius <= 0 gives the centre; a NaN counts as an
//! infinity. Range: coordinates from -radius to radius. Pdf: with respect to area, of
//! |f| over its integral, f(t) at t = 2 x / r: 0 beyond the radius. That of a sample is
//! the one before its coordinates are rounded. The filter itself is pdf times the
//! weight, which is one of two numbers of equal magnitude, and whose mean is 1. Errors:
//! coordinates 0.6 ULP, pdf of a sample 1 ULP, for shares of the parts that are rounded
//! to even fractions of 2^32: samples are those of fractions 2^-31 away. The weight 0.51
//! ULP; next to the change of sign it is that of the rounded offset. Tier I.
//! Mirror: `shaders/corput/filter_mitchell.glsl`.

use crate::reference::exponential::real_power;
use crate::reference::filter::{
    FilterSample, filter_distance, filter_fraction, filter_offset, filter_share,
};
use crate::reference::fixed::mulhi;
use crate::reference::free_flight::real_positive;
use crate::reference::gaussian::gaussian_area_pdf;
use crate::reference::real::{
    Real, real_add, real_divide, real_float, real_fraction, real_less, real_max, real_min,
    real_multiply, real_negate, real_shift, real_sqrt, real_square, real_subtract, real_uint,
    real_zero,
};
use crate::reference::real_angle::real_complement;
use glam::{UVec2, Vec2};

/// The filter of a radius.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FilterMitchell {
    /// The radius.
    pub radius: Real,
    /// B.
    pub b: Real,
    /// C.
    pub c: Real,
    /// B + 6 C.
    pub sum: Real,
    /// The change of sign, from the edge.
    pub zero: Real,
    /// The integral of 6 |f| over one side.
    pub total: Real,
    /// What share of it lies beyond 1/2.
    pub inner: u32,
    /// Beyond 1.
    pub tail: u32,
    /// Beyond the change of sign.
    pub lobe: u32,
}

/// A distance z within a part: 0 from the centre, 1 from 1 inwards, 2 from the change of sign
/// inwards, 3 from there outwards, 4 from the edge. The integral of 6 |f| up to it is c1 z +
/// c2 z^2 + c3 z^3 + c4 z^4.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Mitchell {
    /// The part.
    pub part: u32,
    /// The distance.
    pub z: Real,
    /// The linear term.
    pub c1: Real,
    /// The square.
    pub c2: Real,
    /// The cube.
    pub c3: Real,
    /// The fourth power.
    pub c4: Real,
}

/// x within 0 and 1.
#[inline]
#[must_use]
pub fn mitchell_unit(x: f32) -> Real {
    real_min(real_positive(x), real_uint(1, 0))
}

/// A distance within a part.
#[inline]
#[must_use]
pub fn mitchell(f: FilterMitchell, part: u32, z: Real) -> Mitchell {
    let mut c1 = real_zero();
    let mut c2 = real_zero();
    let mut c3 = real_shift(f.c, 2);
    let mut c4 = real_shift(f.sum, -2);
    if part < 2 {
        // 3 - 9/4 B - 3/2 C.
        let bent = real_add(
            real_multiply(f.b, real_uint(9, -2)),
            real_multiply(f.c, real_uint(3, -1)),
        );
        c4 = real_subtract(real_uint(3, 0), bent);
        c3 = real_subtract(
            real_add(real_shift(f.b, 2), real_shift(f.c, 1)),
            real_uint(6, 0),
        );
        c1 = real_subtract(real_uint(6, 0), real_shift(f.b, 1));
    }
    if part == 1 {
        c4 = real_negate(c4);
        c3 = real_negate(real_add(c3, real_add(f.b, real_shift(f.c, 1))));
        c2 = real_multiply(real_add(f.b, real_shift(f.c, 1)), real_uint(3, -1));
        c1 = f.b;
    }
    if part == 2 || part == 3 {
        c2 = real_multiply(real_multiply(f.c, f.zero), real_uint(3, 0));
    }
    if part == 3 {
        c3 = real_negate(c3);
    }
    if part == 4 {
        c3 = real_shift(f.c, 1);
        c4 = real_negate(c4);
    }
    Mitchell {
        part,
        z,
        c1,
        c2,
        c3,
        c4,
    }
}

/// The integral of 6 |f| over the part up to z.
#[inline]
#[must_use]
pub fn mitchell_mass(at: Mitchell) -> Real {
    let mut p = real_add(real_multiply(at.z, at.c4), at.c3);
    p = real_add(real_multiply(at.z, p), at.c2);
    p = real_add(real_multiply(at.z, p), at.c1);
    real_multiply(at.z, p)
}

/// 6 |f| there.
#[inline]
#[must_use]
pub fn mitchell_density(at: Mitchell) -> Real {
    let three = real_multiply(at.c3, real_uint(3, 0));
    let mut p = real_add(real_multiply(at.z, real_shift(at.c4, 2)), three);
    p = real_add(real_multiply(at.z, p), real_shift(at.c2, 1));
    real_max(real_add(real_multiply(at.z, p), at.c1), real_zero())
}

/// A share of the total as an even fraction of 2^32: samples have odd ones.
#[inline]
#[must_use]
pub fn mitchell_share(mass: Real, total: Real) -> u32 {
    let half_share = real_shift(real_divide(mass, total), -1);
    real_fraction(real_add(half_share, real_uint(1, -33))) << 1
}

/// The filter of this radius, B and C.
#[inline]
#[must_use]
pub fn filter_mitchell_prepare(radius: f32, b: f32, c: f32) -> FilterMitchell {
    let r = real_positive(radius);
    let first = mitchell_unit(b);
    let second = mitchell_unit(c);
    let six = real_multiply(second, real_uint(6, 0));
    let sum = real_add(first, six);
    let zero = real_divide(six, sum);
    // C y^3 / 2; all parts, signs counted, are 3.
    let lobe = real_shift(
        real_multiply(second, real_multiply(zero, real_square(zero))),
        -1,
    );
    let total = real_add(real_uint(3, 0), real_shift(lobe, 1));
    let mut f = FilterMitchell {
        radius: r,
        b: first,
        c: second,
        sum,
        zero,
        total,
        inner: 0,
        tail: 0,
        lobe: 0,
    };
    let outer = mitchell_mass(mitchell(f, 2, real_divide(first, sum)));
    let core = mitchell_mass(mitchell(f, 0, real_uint(1, -1)));
    f.inner = mitchell_share(real_subtract(total, core), total);
    f.tail = mitchell_share(real_add(outer, lobe), total);
    f.lobe = mitchell_share(lobe, total);
    f
}

/// A distance at least that of this mass in the part, and at most twice it; or, of part 0, at
/// most that.
#[inline]
#[must_use]
pub fn mitchell_start(at: Mitchell, mass: Real) -> Real {
    let mut scaled = mass;
    if at.part == 3 {
        // 1 / (1 - 4/3 z + z^2/2) at its end, the third of the lobe.
        scaled = real_multiply(mass, real_uint(13, -3));
    }
    let mut z = real_min(
        real_divide(mass, at.c1),
        real_sqrt(real_divide(scaled, at.c2)),
    );
    if at.part == 1 || at.part == 4 {
        let mut cubic = real_shift(at.c3, -1);
        if at.part == 1 {
            cubic = real_uint(3, 0);
        }
        let third = Real {
            m: 0xaaaa_aaab,
            e: -33,
            negative: false,
        };
        z = real_min(z, real_power(real_divide(mass, cubic), third));
    }
    if at.part == 2 {
        z = real_min(z, real_sqrt(real_sqrt(real_divide(mass, at.c4))));
    }
    z
}

/// Where this share of one side, an odd fraction of 2^32, lies within.
#[inline]
#[must_use]
pub fn mitchell_quantile(f: FilterMitchell, share: u32) -> Mitchell {
    let rest = 0u32.wrapping_sub(share);
    let mut part = 0;
    let mut left = share;
    if rest < f.inner {
        part = 1;
        left = rest.wrapping_sub(f.tail);
    }
    if rest < f.tail {
        part = 2;
        left = rest - f.lobe;
    }
    if rest < f.lobe {
        part = 3;
        left = f.lobe - rest;
    }
    // 16/27 of the lobe are beyond its peak.
    if rest < mulhi(f.lobe, 2_545_165_805) {
        part = 4;
        left = rest;
    }
    let mass = real_multiply(f.total, real_uint(left, -32));
    let mut at = mitchell(f, part, real_zero());
    at.z = mitchell_start(at, mass);
    // From there on 2^-39 of z in five steps.
    for _ in 0..5 {
        let excess = real_subtract(mitchell_mass(at), mass);
        at.z = real_subtract(at.z, real_divide(excess, mitchell_density(at)));
    }
    at
}

/// |x| over the radius.
#[inline]
#[must_use]
pub fn mitchell_distance(f: FilterMitchell, at: Mitchell) -> Real {
    let one = real_uint(1, 0);
    if at.part == 0 {
        return real_shift(at.z, -1);
    }
    if at.part == 1 {
        return real_shift(real_subtract(one, at.z), -1);
    }
    let mut y = at.z;
    if at.part == 2 {
        y = real_add(f.zero, at.z);
    }
    if at.part == 3 {
        y = real_subtract(f.zero, at.z);
    }
    real_subtract(one, real_shift(y, -1))
}

/// Where |x| lies, at most the radius.
#[inline]
#[must_use]
pub fn mitchell_locate(f: FilterMitchell, x: f32) -> Mitchell {
    let d = real_shift(filter_distance(x), 1);
    let mut y = real_subtract(real_shift(f.radius, 1), d);
    y = real_divide(real_max(y, real_zero()), f.radius);
    let mut part = 4;
    let mut z = y;
    // Two thirds of the lobe's width.
    if real_less(
        real_multiply(
            f.zero,
            Real {
                m: 0xaaaa_aaab,
                e: -32,
                negative: false,
            },
        ),
        y,
    ) {
        part = 3;
        z = real_subtract(f.zero, y);
    }
    if real_less(f.zero, y) {
        part = 2;
        z = real_subtract(y, f.zero);
    }
    if real_less(d, f.radius) {
        part = 1;
        z = real_divide(real_subtract(f.radius, d), f.radius);
    }
    if real_less(real_shift(d, 1), f.radius) {
        part = 0;
        z = real_divide(d, f.radius);
    }
    mitchell(f, part, z)
}

/// The magnitude of the filter around the centre.
#[inline]
#[must_use]
pub fn filter_mitchell(f: FilterMitchell, u: UVec2) -> FilterSample {
    let mut density = real_uint(1, 0);
    let mut p = Vec2::ZERO;
    for i in 0..2 {
        let at = mitchell_quantile(f, filter_share(u[i]));
        density = real_multiply(density, real_divide(mitchell_density(at), f.total));
        let d = real_multiply(f.radius, mitchell_distance(f, at));
        p[i] = filter_offset(d, f.radius, u[i]);
    }
    FilterSample {
        p,
        pdf: gaussian_area_pdf(density, f.radius),
    }
}

/// |f(2 x / r) f(2 y / r)| over its integral, within the square.
#[inline]
#[must_use]
pub fn filter_mitchell_pdf(f: FilterMitchell, p: Vec2) -> f32 {
    if real_less(
        f.radius,
        real_max(filter_distance(p.x), filter_distance(p.y)),
    ) {
        return 0.0;
    }
    let mut density = real_uint(1, 0);
    for i in 0..2 {
        let own = mitchell_density(mitchell_locate(f, p[i]));
        density = real_multiply(density, real_divide(own, f.total));
    }
    gaussian_area_pdf(density, f.radius)
}

/// The filter, of integral 1, over the pdf: the integral of its magnitude, with its sign; 0
/// beyond the radius.
#[inline]
#[must_use]
pub fn filter_mitchell_weight(f: FilterMitchell, p: Vec2) -> f32 {
    if real_less(
        f.radius,
        real_max(filter_distance(p.x), filter_distance(p.y)),
    ) {
        return 0.0;
    }
    let mut negative = false;
    for i in 0..2 {
        if mitchell_locate(f, p[i]).part > 2 {
            negative = !negative;
        }
    }
    let magnitude = real_square(real_divide(f.total, real_uint(3, 0)));
    real_float(Real {
        m: magnitude.m,
        e: magnitude.e,
        negative,
    })
}

/// The fractions that give this offset.
#[inline]
#[must_use]
pub fn filter_mitchell_invert(f: FilterMitchell, p: Vec2) -> UVec2 {
    let mut u = UVec2::ZERO;
    for i in 0..2 {
        let at = mitchell_locate(f, p[i]);
        let mut share = real_divide(mitchell_mass(at), f.total);
        let mut beyond = 0;
        if at.part == 1 {
            beyond = f.tail;
        }
        if at.part == 2 || at.part == 3 {
            beyond = f.lobe;
        }
        if at.part == 3 {
            share = real_negate(share);
        }
        if at.part != 0 {
            share = real_subtract(real_complement(beyond), share);
        }
        u[i] = filter_fraction(share, p[i]);
    }
    u
}
