//! Reflection at the visible normals of a GGX lobe by spherical caps, with pdf and
//! inverse.
//!
//! Source: Dupuy and Benyoub 2023, Sampling visible GGX normals with spherical caps, CGF
//! 42(8): seen from V, the reflections V' of a unit sphere's visible normals fill the cap
//! z > -b uniformly, b = V.z. Their 1 - z^2 cancels; here 1 - z = u (1 + b) and 1 + z =
//! (1 - u)(1 + b) + (1 - b), and the z of V + V' is (1 - u)(1 + b) + V.z - b. Domain: two
//! fractions of 2^32: u.x height, u.y angle around +z. Lobes as ggx_lobe.glsl. Range:
//! unit vectors to 2^-23. Pdf: with respect to solid angle; a direction of the rim may
//! be rounded out of the cap. Errors: a coordinate half a ULP and 2^-26 + 2^-31 k / V.n, k
//! the largest of alpha_x, alpha_y and 1 over the least. The pdf 0.9 ULP and 2^-30 k where
//! V.n is above 1/64, and 2^-28 k / V.n of it where the sampled normal is nearer to perpendicular to wo, for V + V' is then a small sum of
//! two unit vectors. The inverse agrees with the sample to 2^-20 + 2^-21 / (alpha |wo +
//! wi|). Tier I.
//! Mirror: `shaders/corput/ggx_vndf_cap.glsl`.

use crate::reference::ggx::ggx_stretched;
use crate::reference::ggx_lobe::{
    Ggx, ggx_half, ggx_pdf, ggx_reflected, ggx_reflected_pdf, ggx_sphere_sum,
};
use crate::reference::real::{
    real_add, real_divide, real_multiply, real_shift, real_sqrt, real_square, real_subtract,
    real_uint,
};
use crate::reference::real_angle::{real_complement, real_fraction_of, real_turns};
use crate::reference::real_vector::{Real3, real3_dot, real3_normalize};
use crate::reference::scattered::{Scattered, real3_around, scattered};
use glam::{UVec2, Vec3, uvec2};

/// V + V' for a point V' of the cap.
#[inline]
#[must_use]
pub fn ggx_cap_sum(g: Ggx, u: UVec2) -> Real3 {
    let height = real_multiply(real_complement(u.x), g.cap_above);
    let below = real_multiply(real_uint(u.x, -32), g.cap_above);
    let above = real_add(height, g.cap_below);
    let radius = real_sqrt(real_multiply(below, above));
    let around = real3_around(radius, u.y, real_add(height, g.excess));
    Real3 {
        x: real_add(around.x, g.view.x),
        y: real_add(around.y, g.view.y),
        z: around.z,
    }
}

/// Direction and pdf.
#[inline]
#[must_use]
pub fn ggx_vndf_cap(g: Ggx, u: UVec2) -> Scattered {
    let n = ggx_cap_sum(g, u);
    let square = real3_dot(n, n);
    let s = ggx_stretched(g.alpha_x, g.alpha_y, n);
    let s_square = real3_dot(s, s);
    // Of a small n half its square is not V.n to all its digits.
    let wi = real3_normalize(ggx_reflected(g, s, s_square, real_shift(square, -1)));
    scattered(wi, ggx_reflected_pdf(g, s_square, square))
}

/// The pdf of a direction.
#[inline]
#[must_use]
pub fn ggx_vndf_cap_pdf(g: Ggx, wi: Vec3) -> f32 {
    ggx_pdf(g, wi)
}

/// The fractions that give this direction.
#[inline]
#[must_use]
pub fn ggx_vndf_cap_invert(g: Ggx, wi: Vec3) -> UVec2 {
    let n = ggx_sphere_sum(g, ggx_half(g, wi));
    let x = real_subtract(n.x, g.view.x);
    let y = real_subtract(n.y, g.view.y);
    let height = real_subtract(n.z, g.excess);
    let above = real_add(height, g.cap_below);
    let square = real_add(real_square(x), real_square(y));
    let below = real_divide(square, above);
    uvec2(
        real_fraction_of(
            real_divide(below, g.cap_above),
            real_divide(height, g.cap_above),
        ),
        real_turns(y, x),
    )
}
