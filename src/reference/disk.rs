//! The unit disk, uniformly: concentric and polar maps, with pdf and inverse.
//!
//! Source: Shirley and Chiu 1997, JGT 2(3). Domain: two fractions of 2^32.
//! Pdf: with respect to area, 1/pi. Errors: concentric 0.6 ULP a coordinate, polar 1.6;
//! inverses agree with the sample to 2^-22 a coordinate, angles modulo one turn; the
//! centre has no angle: concentric gives (1/2, 1/2) back for it, polar (0, 0). Tier I.
//! Mirror: `shaders/corput/disk.glsl`.

use crate::reference::elementary::{
    atan_ratio, atan2, cos_polynomial, ratio, sin_polynomial, sincos_scaled, sqrt_fraction,
    sqrt_fraction64, square31,
};
use crate::reference::fixed::{
    Scaled, add64, fixed31, mul64, pack, scaled, scaled_mul, shl64, shr64,
};
use glam::{UVec2, Vec2, uvec2, vec2};

/// |2u - 1| as a fraction of 2^31: 0 to 2^31.
#[inline(always)]
#[must_use]
pub fn disk_magnitude(u: u32) -> u32 {
    if u < 0x8000_0000 {
        0x8000_0000 - u
    } else {
        u - 0x8000_0000
    }
}

/// The fraction u of 2^32 with 2u - 1 = (negative ? -1 : 1) * a / 2^31; below 1.
#[inline]
#[must_use]
pub fn disk_coordinate(a: u32, negative: bool) -> u32 {
    if negative {
        0x8000_0000 - a
    } else {
        a.min(0x7fff_ffff) + 0x8000_0000
    }
}

/// Whether x < 0, by its bits: a device may compare denormals as zeros.
#[inline]
#[must_use]
pub fn disk_negative(x: f32) -> bool {
    x.to_bits() > 0x8000_0000
}

/// x^2 + y^2 as a fraction of 2^62, below 2^62.
#[inline]
#[must_use]
pub fn disk_radius_squared(p: Vec2) -> UVec2 {
    let x = fixed31(p.x);
    let y = fixed31(p.y);
    let sum = add64(mul64(x, x), mul64(y, y));
    if sum.y >= 0x4000_0000 {
        uvec2(0xffff_ffff, 0x3fff_ffff)
    } else {
        sum
    }
}

/// Point of the disk, concentric map.
#[inline(always)]
#[must_use]
pub fn concentric_disk(u: UVec2) -> Vec2 {
    let x = disk_magnitude(u.x);
    let y = disk_magnitude(u.y);
    let large = x.max(y);
    let small = x.min(y);
    let w = square31(ratio(small, large.max(1)) << 1);
    let near = scaled_mul(
        scaled(large, -31),
        Scaled {
            m: cos_polynomial(w),
            e: -32,
        },
    );
    let far = scaled_mul(
        scaled(small, -31),
        Scaled {
            m: sin_polynomial(w),
            e: -32,
        },
    );
    let x_large = x >= y;
    vec2(
        pack(if x_large { near } else { far }, u.x < 0x8000_0000),
        pack(if x_large { far } else { near }, u.y < 0x8000_0000),
    )
}

/// 1/pi.
#[inline]
#[must_use]
pub fn concentric_disk_pdf() -> f32 {
    f32::from_bits(0x3ea2_f983)
}

/// The fractions that the concentric map takes to p.
#[inline]
#[must_use]
pub fn concentric_disk_invert(p: Vec2) -> UVec2 {
    let x = fixed31(p.x);
    let y = fixed31(p.y);
    let radius = sqrt_fraction64(shl64(disk_radius_squared(p), 2));
    let large = if radius.m == 0 {
        0
    } else {
        radius.m >> (-31 - radius.e).min(31) as u32
    };
    let angle = atan_ratio(x.min(y), x.max(y));
    let small = shr64(mul64(large, angle), 29).x;
    let x_large = x >= y;
    uvec2(
        disk_coordinate(if x_large { large } else { small }, disk_negative(p.x)),
        disk_coordinate(if x_large { small } else { large }, disk_negative(p.y)),
    )
}

/// Point of the disk, polar map: r = sqrt(u.x), phi = 2 pi u.y.
#[inline(always)]
#[must_use]
pub fn polar_disk(u: UVec2) -> Vec2 {
    let radius = sqrt_fraction(u.x);
    let phi = sincos_scaled(u.y);
    vec2(
        pack(scaled_mul(radius, phi.cosine), phi.cosine_negative),
        pack(scaled_mul(radius, phi.sine), phi.sine_negative),
    )
}

/// 1/pi.
#[inline]
#[must_use]
pub fn polar_disk_pdf() -> f32 {
    f32::from_bits(0x3ea2_f983)
}

/// The fractions that the polar map takes to p.
#[inline]
#[must_use]
pub fn polar_disk_invert(p: Vec2) -> UVec2 {
    uvec2(shr64(disk_radius_squared(p), 30).x, atan2(p.y, p.x))
}
