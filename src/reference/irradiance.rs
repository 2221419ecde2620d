//! Estimators of the irradiance of an environment map on a surface that faces along an axis:
//! for each sample, the light that it meets times cos t over its pdf.
//!
//! Source: Veach and Guibas 1995, SIGGRAPH; Pharr, Jakob and Humphreys, PBRT 4th ed., 2.2
//! and 12.5. Domain: fractions of 2^32; axes 0 to 5: +x, -x, +y, -y, +z, -z; the words of
//! `environment`, followed by the bits of each texel's luminance, a float that is 0 or
//! normal. Range: each sample within 2^-22 of itself but for directions that lie within
//! 2^-23 of a texel's edge, which may meet its neighbour. Tier I.
//! Mirror: `shaders/corput/irradiance.glsl`.
//!
//! The shader reads its tables by its hooks, the twin as `words` and the row `edges`.

use crate::reference::axis::{axis_cosine, axis_turned};
use crate::reference::environment::{environment, environment_row, environment_texel_pdf};
use crate::reference::envmap::envmap_texel;
use crate::reference::hemisphere::{cosine_hemisphere, uniform_hemisphere};
use crate::reference::real::{
    Real, real, real_add, real_divide, real_multiply, real_shift, real_uint,
};
use glam::{UVec2, UVec3, Vec3Swizzles};

/// The luminance of a texel, as column and row.
#[inline]
#[must_use]
pub fn irradiance_light(size: UVec2, texel: UVec2, words: &[u32]) -> Real {
    let first = environment_row(size, size.y);
    let at = first + texel.y * size.x + texel.x;
    real(f32::from_bits(words[at as usize]))
}

/// A uniform direction of the hemisphere: 2 pi L cos t.
#[inline]
#[must_use]
pub fn irradiance_uniform(size: UVec2, axis: u32, u: UVec2, edges: &[f32], words: &[u32]) -> Real {
    let d = uniform_hemisphere(u);
    let texel = envmap_texel(axis_turned(d, axis), size, edges);
    let weight = real_multiply(real(d.z), real_uint(3_373_259_426, -29));
    real_multiply(irradiance_light(size, texel, words), weight)
}

/// A cosine-weighted direction: pi L.
#[inline]
#[must_use]
pub fn irradiance_cosine(size: UVec2, axis: u32, u: UVec2, edges: &[f32], words: &[u32]) -> Real {
    let d = cosine_hemisphere(u);
    let texel = envmap_texel(axis_turned(d, axis), size, edges);
    real_multiply(
        irradiance_light(size, texel, words),
        real_uint(3_373_259_426, -30),
    )
}

/// A direction by the map's light: L cos t / pdf.
#[inline]
#[must_use]
pub fn irradiance_environment(
    size: UVec2,
    axis: u32,
    u: UVec2,
    edges: &[f32],
    words: &[u32],
) -> Real {
    let s = environment(size, u, words);
    let light = irradiance_light(size, envmap_texel(s.direction, size, edges), words);
    let flow = real_multiply(light, axis_cosine(s.direction, axis));
    real_divide(flow, real(s.pdf))
}

/// A cosine-weighted direction for half of all u.z and one by the map's light for the
/// others, with the balance heuristic: L cos t over the mean of both pdfs.
#[inline]
#[must_use]
pub fn irradiance_mis(size: UVec2, axis: u32, u: UVec3, edges: &[f32], words: &[u32]) -> Real {
    let mut d = axis_turned(cosine_hemisphere(u.xy()), axis);
    let other = environment(size, u.xy(), words).direction;
    if u.z >= 0x8000_0000 {
        d = other;
    }
    let texel = envmap_texel(d, size, edges);
    let cosine = axis_cosine(d, axis);
    // 1/pi to 32 bits.
    let pdf = real_multiply(cosine, real_uint(2_734_261_102, -33));
    let both = real_add(pdf, real(environment_texel_pdf(size, texel, words)));
    let flow = real_multiply(irradiance_light(size, texel, words), cosine);
    real_divide(flow, real_shift(both, -1))
}
