//! Offsets from a pixel's centre by the 4-term window of Blackman and Harris, as a
//! product of two coordinates, with pdf and inverse.
//!
//! Source: Harris 1978, On the use of windows for harmonic analysis with the discrete
//! Fourier transform, table 1, 4 terms of -92 dB; Ernst, Stamminger and Greiner 2006,
//! Filter importance sampling. The exact inverse of the cumulative distribution by 5
//! steps of Newton's method, from the middle or from the edge, whichever is nearer: the
//! window ends at 6e-5, where 1 less the mass has no digits. Polynomials by
//! scripts/blackman_harris.py. Domain: radius > 0, two fractions of 2^32, which stand for
//! midpoints of their parts. radius <= 0 gives the centre; a NaN counts as an infinity.
//! Range: coordinates from -radius to radius. Pdf: with respect to area: w(x/r) / (2 a0
//! r) a coordinate, w(t) = a0 + a1 cos(pi t) + a2 cos(2 pi t) + a3 cos(3 pi t); 0 beyond
//! the radius. That of a sample is the one before its coordinates are rounded. Errors:
//! coordinates 0.6 ULP, pdf of a sample 1 ULP. Tier I.
//! Mirror: `shaders/corput/filter_blackman_harris.glsl`.

use crate::reference::filter::{
    FilterSample, filter_distance, filter_fraction, filter_offset, filter_share,
};
use crate::reference::fixed::mulhi;
use crate::reference::free_flight::real_positive;
use crate::reference::gaussian::gaussian_area_pdf;
use crate::reference::real::{
    Real, real_add, real_divide, real_fraction, real_less, real_max, real_min, real_multiply,
    real_shift, real_sqrt, real_square, real_subtract, real_uint, real_zero,
};
use glam::{UVec2, Vec2};

/// A distance of at most half the radius, as a share of it: from the middle or the edge.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BlackmanHarris {
    /// The distance.
    pub x: Real,
    /// Whether from the edge.
    pub edge: bool,
}

/// w / a0 in the middle, or at the edge.
#[inline]
#[must_use]
pub fn blackman_harris_end(edge: bool) -> Real {
    if edge {
        return Real {
            m: 2_942_247_143,
            e: -44,
            negative: false,
        };
    }
    Real {
        m: 2_993_008_569,
        e: -30,
        negative: false,
    }
}

/// |mass / x - end| / z, z a fraction of 2^32.
#[inline]
#[must_use]
pub fn blackman_harris_integral(z: u32, edge: bool) -> Real {
    if edge {
        let mut p = 529_456 - mulhi(z, 35_059);
        p = 4_870_504 - mulhi(z, p);
        p = 29_919_324 - mulhi(z, p);
        p = 100_155_239 - mulhi(z, p);
        p = 2_777_020 + mulhi(z, p);
        p = 1_003_538_625 - mulhi(z, p);
        return real_uint(278_560_413 + mulhi(z, p), -33);
    }
    let mut p = 72_044 - mulhi(z, 4573);
    p = 734_309 - mulhi(z, p);
    p = 5_723_992 - mulhi(z, p);
    p = 34_632_754 - mulhi(z, p);
    p = 160_972_548 - mulhi(z, p);
    p = 561_051_895 - mulhi(z, p);
    real_uint(1_425_948_196 - mulhi(z, p), -30)
}

/// |density - end| / z, z a fraction of 2^32.
#[inline]
#[must_use]
pub fn blackman_harris_slope(z: u32, edge: bool) -> Real {
    if edge {
        let mut p = 376_026 - mulhi(z, 21_810);
        p = 4_082_724 - mulhi(z, p);
        p = 31_740_190 - mulhi(z, p);
        p = 164_588_727 - mulhi(z, p);
        p = 450_705_315 - mulhi(z, p);
        p = 9_718_918 + mulhi(z, p);
        p = 2_508_846_541 - mulhi(z, p);
        return real_uint(417_840_620 + mulhi(z, p), -32);
    }
    let mut p = 97_622 - mulhi(z, 5557);
    p = 1_109_150 - mulhi(z, p);
    p = 9_566_883 - mulhi(z, p);
    p = 62_972_181 - mulhi(z, p);
    p = 311_696_501 - mulhi(z, p);
    p = 1_126_808_004 - mulhi(z, p);
    p = 2_805_259_479 - mulhi(z, p);
    real_uint(4_277_844_588 - mulhi(z, p), -30)
}

/// 4 x^2.
#[inline]
#[must_use]
pub fn blackman_harris_square(x: Real) -> Real {
    real_shift(real_square(x), 2)
}

/// w / a0 there: the density of the distance.
#[inline]
#[must_use]
pub fn blackman_harris_density(at: BlackmanHarris) -> Real {
    let square = blackman_harris_square(at.x);
    let rest = real_multiply(
        square,
        blackman_harris_slope(real_fraction(square), at.edge),
    );
    real_add(
        blackman_harris_end(at.edge),
        Real {
            m: rest.m,
            e: rest.e,
            negative: rest.m != 0 && !at.edge,
        },
    )
}

/// The mass of the half between there and the middle or the edge.
#[inline]
#[must_use]
pub fn blackman_harris_mass(at: BlackmanHarris) -> Real {
    let square = blackman_harris_square(at.x);
    let rest = real_multiply(
        square,
        blackman_harris_integral(real_fraction(square), at.edge),
    );
    let mean = real_add(
        blackman_harris_end(at.edge),
        Real {
            m: rest.m,
            e: rest.e,
            negative: rest.m != 0 && !at.edge,
        },
    );
    real_multiply(at.x, mean)
}

/// Where this share of the half, a fraction of 2^32 other than 0, lies within.
#[inline]
#[must_use]
pub fn blackman_harris_quantile(share: u32) -> BlackmanHarris {
    // 3_993_430_636 = 2^32 times the share of the inner half of the radius.
    let edge = share > 3_993_430_636;
    let mass = real_uint(
        if edge {
            0u32.wrapping_sub(share)
        } else {
            share
        },
        -32,
    );
    let mut x = real_divide(mass, blackman_harris_end(edge));
    if edge {
        let root = real_sqrt(real_sqrt(mass));
        x = real_min(real_min(x, root), real_uint(1, -1));
    }
    let mut at = BlackmanHarris { x, edge };
    // From there on 2^-40 of x in five steps.
    for _ in 0..5 {
        let excess = real_subtract(blackman_harris_mass(at), mass);
        at.x = real_subtract(at.x, real_divide(excess, blackman_harris_density(at)));
    }
    at
}

/// Where |x| lies, at most the radius.
#[inline]
#[must_use]
pub fn blackman_harris_locate(radius: Real, x: f32) -> BlackmanHarris {
    let d = filter_distance(x);
    let rest = real_max(real_subtract(radius, d), real_zero());
    if real_less(d, rest) {
        return BlackmanHarris {
            x: real_divide(d, radius),
            edge: false,
        };
    }
    BlackmanHarris {
        x: real_divide(rest, radius),
        edge: true,
    }
}

/// The window around the centre.
#[inline]
#[must_use]
pub fn filter_blackman_harris(radius: f32, u: UVec2) -> FilterSample {
    let r = real_positive(radius);
    let mut density = real_uint(1, -2);
    let mut p = Vec2::ZERO;
    for i in 0..2 {
        let at = blackman_harris_quantile(filter_share(u[i]));
        density = real_multiply(density, blackman_harris_density(at));
        let mut d = at.x;
        if at.edge {
            d = real_subtract(real_uint(1, 0), d);
        }
        p[i] = filter_offset(real_multiply(r, d), r, u[i]);
    }
    FilterSample {
        p,
        pdf: gaussian_area_pdf(density, r),
    }
}

/// w(x/r) w(y/r) / (2 a0 r)^2 within the square.
#[inline]
#[must_use]
pub fn filter_blackman_harris_pdf(radius: f32, p: Vec2) -> f32 {
    let r = real_positive(radius);
    if real_less(r, real_max(filter_distance(p.x), filter_distance(p.y))) {
        return 0.0;
    }
    let mut density = real_uint(1, -2);
    for i in 0..2 {
        density = real_multiply(
            density,
            blackman_harris_density(blackman_harris_locate(r, p[i])),
        );
    }
    gaussian_area_pdf(density, r)
}

/// The fractions that give this offset.
#[inline]
#[must_use]
pub fn filter_blackman_harris_invert(radius: f32, p: Vec2) -> UVec2 {
    let r = real_positive(radius);
    let mut u = UVec2::ZERO;
    for i in 0..2 {
        let at = blackman_harris_locate(r, p[i]);
        let mut share = blackman_harris_mass(at);
        if at.edge {
            share = real_subtract(real_uint(1, 0), share);
        }
        u[i] = filter_fraction(share, p[i]);
    }
    u
}
