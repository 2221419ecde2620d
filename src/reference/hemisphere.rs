//! Directions of the hemisphere around +z, uniform and cosine-weighted, with pdf and
//! inverse.
//!
//! Source: Malley's method over the disk maps; z from the integer samples, never from
//! 1 - x^2 - y^2. Domain: two fractions of 2^32. Range: unit vectors to 2^-22, z >= 0.
//! Pdf: with respect to solid angle, 1/(2 pi) and z/pi; 0 below the horizon. Errors: x
//! and y as the disk maps, z and the pdf 0.53 ULP; inverses agree with the sample to 2^-22 a
//! coordinate, angles modulo one turn; at the pole the angle is lost. Tier I.
//! Mirror: `shaders/corput/hemisphere.glsl`.

use crate::reference::disk::{
    concentric_disk, concentric_disk_invert, disk_magnitude, polar_disk, polar_disk_invert,
};
use crate::reference::elementary::{atan2, sincos_scaled, sqrt_fraction, sqrt_fraction64};
use crate::reference::fixed::{Scaled, fixed31, mul64, pack, scaled, scaled_mul, shl64, sub64};
use glam::{UVec2, Vec3, uvec2, vec3};

/// z/pi for z > 0, else 0: the pdf of both cosine-weighted forms. For z below 2^-124 it
/// is 0 as well; infinities and NaN are no directions and have pdf 0.
#[inline(always)]
#[must_use]
pub fn cosine_over_pi(z: f32) -> f32 {
    let bits = z.to_bits();
    // z below 2^-124 is where z/pi could leave the normal floats.
    if !(0x0180_0000..0x7f80_0000).contains(&bits) {
        return 0.0;
    }
    let scaled = Scaled {
        m: (bits << 8) | 0x8000_0000,
        e: (bits >> 23) as i32 - 158,
    };
    // 1/pi to 32 bits: its float alone would be half a ULP off.
    let over_pi = Scaled {
        m: 2_734_261_102,
        e: -33,
    };
    pack(scaled_mul(scaled, over_pi), false)
}

/// Uniform direction: z = u.x, phi = 2 pi u.y.
#[inline(always)]
#[must_use]
pub fn uniform_hemisphere(u: UVec2) -> Vec3 {
    let z = scaled(u.x, -32);
    let mut radius = Scaled {
        m: 0x8000_0000,
        e: -31,
    };
    if u.x != 0 {
        radius = sqrt_fraction64(sub64(uvec2(0, 0), mul64(u.x, u.x)));
    }
    let phi = sincos_scaled(u.y);
    vec3(
        pack(scaled_mul(radius, phi.cosine), phi.cosine_negative),
        pack(scaled_mul(radius, phi.sine), phi.sine_negative),
        pack(z, false),
    )
}

/// 1/(2 pi) for z >= 0, else 0.
#[inline(always)]
#[must_use]
pub fn uniform_hemisphere_pdf(direction: Vec3) -> f32 {
    // By the bits: a device may compare denormals as zeros.
    let z = direction.z.to_bits();
    if z <= 0x7f80_0000 || z == 0x8000_0000 {
        f32::from_bits(0x3e22_f983)
    } else {
        0.0
    }
}

/// The fractions that give this direction.
#[inline]
#[must_use]
pub fn uniform_hemisphere_invert(direction: Vec3) -> UVec2 {
    let z = fixed31(direction.z);
    uvec2(
        if z >= 0x8000_0000 {
            0xffff_ffff
        } else {
            z << 1
        },
        atan2(direction.y, direction.x),
    )
}

/// Cosine-weighted direction over the concentric disk.
#[inline(always)]
#[must_use]
pub fn cosine_hemisphere(u: UVec2) -> Vec3 {
    let radius = disk_magnitude(u.x).max(disk_magnitude(u.y));
    let mut z = Scaled {
        m: 0x8000_0000,
        e: -31,
    };
    if radius != 0 {
        // 1 - radius^2, exact, as a fraction of 2^62.
        let square = sub64(uvec2(0, 0x4000_0000), mul64(radius, radius));
        z = sqrt_fraction64(shl64(square, 2));
    }
    concentric_disk(u).extend(pack(z, false))
}

/// z/pi.
#[inline(always)]
#[must_use]
pub fn cosine_hemisphere_pdf(direction: Vec3) -> f32 {
    cosine_over_pi(direction.z)
}

/// The fractions that give this direction.
#[inline]
#[must_use]
pub fn cosine_hemisphere_invert(direction: Vec3) -> UVec2 {
    concentric_disk_invert(direction.truncate())
}

/// Cosine-weighted direction over the polar disk: z = sqrt(1 - u.x), phi = 2 pi u.y.
#[inline(always)]
#[must_use]
pub fn cosine_hemisphere_polar(u: UVec2) -> Vec3 {
    // In this order: where z is first, the compiler copies the root of u.x into both of its cases,
    // and makes no vectors of loops any more.
    let p = polar_disk(u);
    let mut z = Scaled {
        m: 0x8000_0000,
        e: -31,
    };
    if u.x != 0 {
        z = sqrt_fraction(0u32.wrapping_sub(u.x));
    }
    p.extend(pack(z, false))
}

/// z/pi.
#[inline(always)]
#[must_use]
pub fn cosine_hemisphere_polar_pdf(direction: Vec3) -> f32 {
    cosine_over_pi(direction.z)
}

/// The fractions that give this direction.
#[inline]
#[must_use]
pub fn cosine_hemisphere_polar_invert(direction: Vec3) -> UVec2 {
    polar_disk_invert(direction.truncate())
}
