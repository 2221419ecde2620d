//! Powers of the cosine: `shaders/kernels/map_lobe.comp`, line by line.

use crate::catalog::Profile;
use crate::interface::MAP_PARAMETERS;
use crate::reference::cosine_power::{
    cosine_power, cosine_power_invert, cosine_power_pdf, cosine_power_prepare,
};
use crate::reference::native::cosine_power::{
    native_cosine_power, native_cosine_power_invert, native_cosine_power_pdf,
    native_cosine_power_prepare,
};
use glam::{Vec3, uvec2};

/// Coordinates and pdf.
pub(super) fn sample(profile: Profile, p: &[f32; MAP_PARAMETERS], u: [u32; 3]) -> [u32; 4] {
    let u = uvec2(u[0], u[1]);
    let (d, pdf) = match profile {
        Profile::Exact => {
            let made = cosine_power(cosine_power_prepare(p[0]), u);
            (made.direction, made.pdf)
        }
        Profile::Native => {
            let made = native_cosine_power(native_cosine_power_prepare(p[0]), u);
            (made.direction, made.pdf)
        }
    };
    [d.x, d.y, d.z, pdf].map(f32::to_bits)
}

/// The pdf.
pub(super) fn pdf(profile: Profile, p: &[f32; MAP_PARAMETERS], d: [f32; 3]) -> f32 {
    let d = Vec3::from_array(d);
    match profile {
        Profile::Exact => cosine_power_pdf(cosine_power_prepare(p[0]), d),
        Profile::Native => native_cosine_power_pdf(native_cosine_power_prepare(p[0]), d),
    }
}

/// The fractions.
pub(super) fn invert(profile: Profile, p: &[f32; MAP_PARAMETERS], d: [f32; 3]) -> [u32; 3] {
    let d = Vec3::from_array(d);
    let u = match profile {
        Profile::Exact => cosine_power_invert(cosine_power_prepare(p[0]), d),
        Profile::Native => native_cosine_power_invert(native_cosine_power_prepare(p[0]), d),
    };
    [u.x, u.y, 0]
}
