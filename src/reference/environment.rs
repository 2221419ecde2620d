//! Directions by the light of an environment map, with pdf and inverse: row and column by
//! CDFs, or the texel by an alias table; within it uniform in solid angle.
//!
//! Source: Pharr, Jakob and Humphreys, PBRT 4th ed., 12.5, on integer weights times exact
//! solid angles. Domain: fractions of 2^32; tables as `environment::Environment` makes
//! them, 1 x 1 to 8192 x 4096 texels. Range: unit vectors to 2^-23; a direction drawn in a
//! texel is one that `envmap_texel` finds in it, always. Pdf: with respect to solid angle,
//! constant in a texel. Tier I.
//! Mirror: `shaders/corput/environment.glsl`.
//!
//! The shader reads its tables by its hooks, the twin as `words`.

use crate::reference::discrete::{
    alias_index, alias_weight, cdf, cdf_invert, cdf_weight, discrete_divide, discrete_scale,
};
use crate::reference::elementary::{atan2, sincos_scaled};
use crate::reference::envmap::{envmap_order, envmap_texel};
use crate::reference::fixed::{add64, mul64, shr64, sub64};
use crate::reference::real::{
    Real, real, real_add, real_divide, real_float, real_fraction, real_less, real_multiply,
    real_negate, real_scaled, real_sqrt, real_square, real_subtract, real_uint, real_wide,
};
use glam::{UVec2, UVec3, Vec3, uvec2, vec3};

/// A direction and its pdf.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Environment {
    /// A unit vector.
    pub direction: Vec3,
    /// Its density with respect to solid angle.
    pub pdf: f32,
}

/// 1 - z of a row's upper edge, in units of 2^-62; of row `height` it is that of the pole.
#[inline]
#[must_use]
pub fn environment_cap(size: UVec2, row: u32, words: &[u32]) -> UVec2 {
    let at = (size.y + 2 * row) as usize;
    uvec2(words[at], words[at + 1])
}

/// First word of the marginal CDF, or of the alias table.
#[inline]
#[must_use]
pub fn environment_first(size: UVec2) -> u32 {
    3 * size.y + 2
}

/// First word of a row's CDF.
#[inline]
#[must_use]
pub fn environment_row(size: UVec2, row: u32) -> u32 {
    4 * size.y + 2 + row * size.x
}

/// The float nearest to z that lies in the row, by the edges of `envmap_texel`.
#[inline]
#[must_use]
pub fn environment_z(size: UVec2, row: u32, z: f32, words: &[u32]) -> f32 {
    let mut order = envmap_order(z.to_bits());
    if row + 1 < size.y {
        order = order.max(envmap_order(words[row as usize + 1]) + 1);
    }
    if row > 0 {
        order = order.min(envmap_order(words[row as usize]));
    }
    // The least above an edge at 0 would be a denormal.
    if order > 0x8000_0000 && order < 0x8080_0000 {
        order = 0x8080_0000;
    }
    f32::from_bits(if order >> 31 != 0 {
        order & 0x7fff_ffff
    } else {
        !order
    })
}

/// The direction at a place of a texel: fractions from its left and upper edges.
#[inline]
#[must_use]
pub fn environment_direction(size: UVec2, texel: UVec2, place: UVec2, words: &[u32]) -> Vec3 {
    let cap = environment_cap(size, texel.y, words);
    let extent = sub64(environment_cap(size, texel.y + 1, words), cap);
    // 1 - z and 1 + z, neither by a difference that cancels; the fraction's middle, which
    // is never at a pole, where the azimuth would be lost.
    let mut down = add64(cap, discrete_scale(extent, place.y));
    down = add64(down, shr64(extent, 33));
    let up = sub64(uvec2(0, 0x8000_0000), down);
    let below = down.y >= 0x4000_0000;
    let rest = sub64(uvec2(0, 0x4000_0000), if below { up } else { down });
    let z = real_wide(rest, -62);
    let radius = real_sqrt(real_multiply(real_wide(down, -62), real_wide(up, -62)));
    // 2^-26 of a turn is more than what rounding x and y to floats can turn them by.
    let margin = size.x << 6;
    let across = place.x.clamp(margin, !margin);
    let phi = sincos_scaled(discrete_divide(uvec2(across, texel.x), size.x));
    vec3(
        real_float(real_multiply(
            radius,
            real_scaled(phi.cosine, phi.cosine_negative),
        )),
        real_float(real_multiply(
            radius,
            real_scaled(phi.sine, phi.sine_negative),
        )),
        environment_z(
            size,
            texel.y,
            real_float(if below { real_negate(z) } else { z }),
            words,
        ),
    )
}

/// Probability over the solid angle of a texel of this row.
#[inline]
#[must_use]
pub fn environment_density(size: UVec2, row: u32, probability: Real, words: &[u32]) -> f32 {
    let extent = sub64(
        environment_cap(size, row + 1, words),
        environment_cap(size, row, words),
    );
    let texels = real_multiply(probability, real_uint(size.x, 0));
    // width / (2 pi), and 1/(2 pi) to 32 bits.
    let turn = real_multiply(texels, real_uint(2_734_261_102, -34));
    real_float(real_divide(turn, real_wide(extent, -62)))
}

/// Pdf of the hierarchical tables in a texel, as column and row.
#[inline]
#[must_use]
pub fn environment_texel_pdf(size: UVec2, texel: UVec2, words: &[u32]) -> f32 {
    let row = cdf_weight(environment_first(size), texel.y, words);
    let column = cdf_weight(environment_row(size, texel.y), texel.x, words);
    environment_density(
        size,
        texel.y,
        real_multiply(real_wide(row, -32), real_wide(column, -32)),
        words,
    )
}

/// Direction by the hierarchical tables: u.x gives the row, u.y the column.
#[inline]
#[must_use]
pub fn environment(size: UVec2, u: UVec2, words: &[u32]) -> Environment {
    let row = cdf(environment_first(size), u.x, words);
    let column = cdf(environment_row(size, row.index), u.y, words);
    let probability = real_multiply(real_wide(row.weight, -32), real_wide(column.weight, -32));
    Environment {
        direction: environment_direction(
            size,
            uvec2(column.index, row.index),
            uvec2(column.rest, row.rest),
            words,
        ),
        pdf: environment_density(size, row.index, probability, words),
    }
}

/// The density with which `environment` draws a direction.
#[inline]
#[must_use]
pub fn environment_pdf(size: UVec2, direction: Vec3, edges: &[f32], words: &[u32]) -> f32 {
    environment_texel_pdf(size, envmap_texel(direction, size, edges), words)
}

/// Place of a direction in its texel: fractions from the left and upper edges.
#[inline]
#[must_use]
pub fn environment_place(size: UVec2, direction: Vec3, texel: UVec2, words: &[u32]) -> UVec2 {
    let across = mul64(atan2(direction.y, direction.x), size.x).x;
    let one = real_uint(1, 0);
    let z = real(direction.z);
    let near = real(f32::from_bits(direction.z.to_bits() & 0x7fff_ffff));
    let mut cap = real_subtract(one, near);
    // Near a pole x and y tell 1 - |z| better than z does.
    if !real_less(near, real_uint(1, -1)) {
        let x = real_square(real(direction.x));
        let y = real_square(real(direction.y));
        cap = real_divide(real_add(x, y), real_add(one, near));
    }
    // From the upper edge, or from the lower one where the pole below is nearer.
    let below = z.negative;
    let upper = environment_cap(size, texel.y, words);
    let lower = environment_cap(size, texel.y + 1, words);
    let edge = if below {
        sub64(uvec2(0, 0x8000_0000), lower)
    } else {
        upper
    };
    let extent = real_wide(sub64(lower, upper), -62);
    let down = real_subtract(cap, real_wide(edge, -62));
    let fraction = real_fraction(real_divide(down, extent));
    uvec2(across, if below { !fraction } else { fraction })
}

/// The fractions that give this direction by the hierarchical tables.
#[inline]
#[must_use]
pub fn environment_invert(size: UVec2, direction: Vec3, edges: &[f32], words: &[u32]) -> UVec2 {
    let texel = envmap_texel(direction, size, edges);
    let place = environment_place(size, direction, texel, words);
    uvec2(
        cdf_invert(environment_first(size), texel.y, place.y, words),
        cdf_invert(environment_row(size, texel.y), texel.x, place.x, words),
    )
}

/// Pdf of the alias table in a texel, as column and row.
#[inline]
#[must_use]
pub fn environment_alias_texel_pdf(size: UVec2, texel: UVec2, words: &[u32]) -> f32 {
    let weight = alias_weight(environment_first(size), texel.y * size.x + texel.x, words);
    environment_density(size, texel.y, real_wide(weight, -32), words)
}

/// Direction by the alias table: u.x gives the texel, u.y the place across, u.z down.
#[inline]
#[must_use]
pub fn environment_alias(size: UVec2, u: UVec3, words: &[u32]) -> Environment {
    let index = alias_index(environment_first(size), size.x * size.y, u.x, words);
    let row = index / size.x;
    let texel = uvec2(index - row * size.x, row);
    Environment {
        direction: environment_direction(size, texel, uvec2(u.y, u.z), words),
        pdf: environment_alias_texel_pdf(size, texel, words),
    }
}

/// The density with which `environment_alias` draws a direction.
#[inline]
#[must_use]
pub fn environment_alias_pdf(size: UVec2, direction: Vec3, edges: &[f32], words: &[u32]) -> f32 {
    environment_alias_texel_pdf(size, envmap_texel(direction, size, edges), words)
}
