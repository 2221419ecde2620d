//! A fraction of 2^32 as a float in [0, 1), never 1, exact in every rounding direction.
//!
//! Source: 24 leading bits are what a float holds; `u as f32 * 2^-32` would give 1.0
//! for `u >= 0xffff_ff80` (Goualard 2020). Range: multiples of 2^-24 in [0, 1 - 2^-24].
//! Mirror: `shaders/corput/unit.glsl`.

/// `floor(u / 2^8) * 2^-24`: for base 2, Sobol, random and scrambled points.
#[inline]
#[must_use]
pub fn unit_floor(u: u32) -> f32 {
    (u >> 8) as f32 * 5.960_464_477_539_062_5e-8
}

/// `min(ceil(u / 2^8), 2^24 - 1) * 2^-24`: for unscrambled radical inverses in other
/// bases and for k/N, where rounding up keeps a point on the lower edge of a b-adic
/// cell inside that cell.
#[inline]
#[must_use]
pub fn unit_ceil(u: u32) -> f32 {
    let k = (u >> 8) + u32::from(u & 0xff != 0);
    k.min(0xff_ffff) as f32 * 5.960_464_477_539_062_5e-8
}
