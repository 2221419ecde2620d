//! The normals of a Beckmann microsurface, all of them by D cos, and reflection at them,
//! in the native profile, with pdf and inverse.
//!
//! Source: Walter et al. 2007, as beckmann.glsl. Domain: finite alpha; its sign does not
//! count, and what is below 1e-9 counts as that. wo of any length near 1; wo = 0 has the
//! sample 0 and as its pdf the largest float. Two fractions of 2^32. Range: unit vectors to
//! the device's precision. Pdf: with respect to solid angle; the largest float where it is
//! infinite, 0 for h.z = 0, beyond r = 10 and for what is no direction. Errors: about 2^-19
//! of normals, directions and, relative, their pdf.
//! Mirror: `shaders/corput/native/beckmann.glsl`.

use crate::reference::native::disk::{native_density, native_fraction, native_turns, native_unit};
use crate::reference::native::ggx::native_ggx_alpha;
use crate::reference::native::hemisphere::native_complement;
use crate::reference::native::scattered::{
    NativeScattered, native_around, native_fraction_of, native_quotient,
};
use glam::{UVec2, Vec2, Vec3, uvec2, vec2, vec3};

/// -ln(1 - u): by its series for small u, where Vulkan's log has an absolute error of 2^-21.
#[must_use]
pub fn native_beckmann_square(u: u32) -> f32 {
    let x = native_unit(u);
    if u < 0x0100_0000 {
        return x * (1.0 + x * (0.5 + x * 0.33333334));
    }
    -(native_complement(u)).ln()
}

/// (slopes, 1), not normalised.
#[must_use]
pub fn native_beckmann_slopes(alpha: Vec2, u: UVec2) -> Vec3 {
    let around = native_around(native_beckmann_square(u.x).sqrt(), u.y, 1.0);
    vec3(
        around.x * native_ggx_alpha(alpha.x),
        around.y * native_ggx_alpha(alpha.y),
        1.0,
    )
}

/// D cos at the slopes, where e^-r^2 is rest.
#[must_use]
pub fn native_beckmann_density(alpha: Vec2, slopes: Vec3, rest: f32) -> f32 {
    let square = slopes.dot(slopes);
    native_density(
        std::f32::consts::FRAC_1_PI * rest / native_ggx_alpha(alpha.x) / native_ggx_alpha(alpha.y)
            * square
            * square.sqrt(),
    )
}

/// e^-r^2 for the slopes; 0 beyond r = 10.
#[must_use]
pub fn native_beckmann_rest(alpha: Vec2, slopes: Vec3) -> f32 {
    let x = slopes.x / native_ggx_alpha(alpha.x);
    let y = slopes.y / native_ggx_alpha(alpha.y);
    let square = x * x + y * y;
    if square < 100.0 { (-square).exp() } else { 0.0 }
}

/// The fractions that give these slopes.
#[must_use]
pub fn native_beckmann_fractions(alpha: Vec2, slopes: Vec3) -> UVec2 {
    let rest = native_beckmann_rest(alpha, slopes);
    let around = vec2(
        slopes.x / native_ggx_alpha(alpha.x),
        slopes.y / native_ggx_alpha(alpha.y),
    );
    uvec2(
        native_fraction_of(1.0 - rest, rest),
        native_fraction(native_turns(around)),
    )
}

/// Normal and pdf.
#[must_use]
pub fn native_beckmann_normal(alpha: Vec2, u: UVec2) -> NativeScattered {
    let slopes = native_beckmann_slopes(alpha, u);
    NativeScattered {
        direction: slopes * (1.0 / (slopes.dot(slopes)).sqrt()),
        pdf: native_beckmann_density(alpha, slopes, native_complement(u.x)),
    }
}

/// The pdf of a normal: 0 for normal.z <= 0.
#[must_use]
pub fn native_beckmann_normal_pdf(alpha: Vec2, normal: Vec3) -> f32 {
    if normal.z <= 0.0 {
        return 0.0;
    }
    let slopes = vec3(normal.x / normal.z, normal.y / normal.z, 1.0);
    native_beckmann_density(alpha, slopes, native_beckmann_rest(alpha, slopes))
}

/// The fractions that give this normal.
#[must_use]
pub fn native_beckmann_normal_invert(alpha: Vec2, normal: Vec3) -> UVec2 {
    native_beckmann_fractions(alpha, vec3(normal.x / normal.z, normal.y / normal.z, 1.0))
}

/// Direction and pdf.
#[must_use]
pub fn native_beckmann(alpha: Vec2, wo: Vec3, u: UVec2) -> NativeScattered {
    let o = wo * native_quotient(1.0, (wo.dot(wo)).sqrt());
    let slopes = native_beckmann_slopes(alpha, u);
    let square = slopes.dot(slopes);
    let cosine = o.dot(slopes);
    let pdf = native_beckmann_density(alpha, slopes, native_complement(u.x));
    NativeScattered {
        direction: slopes * (2.0 * cosine / square) - o,
        pdf: native_density(pdf * square.sqrt() / (4.0 * cosine.abs())),
    }
}

/// The pdf of a direction.
#[must_use]
pub fn native_beckmann_pdf(alpha: Vec2, wo: Vec3, wi: Vec3) -> f32 {
    let h = wi + wo * native_quotient(1.0, (wo.dot(wo)).sqrt());
    if h.z == 0.0 {
        return 0.0;
    }
    let slopes = vec3(h.x / h.z, h.y / h.z, 1.0);
    native_density(
        native_beckmann_density(alpha, slopes, native_beckmann_rest(alpha, slopes))
            / (2.0 * (h.dot(h)).sqrt()),
    )
}

/// The fractions that give this direction.
#[must_use]
pub fn native_beckmann_invert(alpha: Vec2, wo: Vec3, wi: Vec3) -> UVec2 {
    let h = wi + wo * native_quotient(1.0, (wo.dot(wo)).sqrt());
    native_beckmann_fractions(alpha, vec3(h.x / h.z, h.y / h.z, 1.0))
}
