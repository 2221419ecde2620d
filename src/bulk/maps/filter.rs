//! Pixel filters without an inverse in closed form: `map_filter_window.comp` of
//! `shaders/kernels`, line by line.

use crate::catalog::Profile;
use crate::interface::MAP_PARAMETERS;
use crate::reference::filter_blackman_harris::{
    filter_blackman_harris, filter_blackman_harris_invert, filter_blackman_harris_pdf,
};
use crate::reference::native::filter_blackman_harris::{
    native_filter_blackman_harris, native_filter_blackman_harris_invert,
    native_filter_blackman_harris_pdf,
};
use glam::{uvec2, vec2};

/// Coordinates and pdf.
pub(super) fn sample(profile: Profile, p: &[f32; MAP_PARAMETERS], u: [u32; 3]) -> [u32; 4] {
    let u = uvec2(u[0], u[1]);
    let (at, pdf) = match profile {
        Profile::Exact => {
            let made = filter_blackman_harris(p[0], u);
            (made.p, made.pdf)
        }
        Profile::Native => {
            let made = native_filter_blackman_harris(p[0], u);
            (made.p, made.pdf)
        }
    };
    [at.x, at.y, pdf, 0.0].map(f32::to_bits)
}

/// The pdf.
pub(super) fn pdf(profile: Profile, p: &[f32; MAP_PARAMETERS], [x, y, _]: [f32; 3]) -> f32 {
    let at = vec2(x, y);
    match profile {
        Profile::Exact => filter_blackman_harris_pdf(p[0], at),
        Profile::Native => native_filter_blackman_harris_pdf(p[0], at),
    }
}

/// The fractions.
pub(super) fn invert(profile: Profile, p: &[f32; MAP_PARAMETERS], [x, y, _]: [f32; 3]) -> [u32; 3] {
    let at = vec2(x, y);
    let u = match profile {
        Profile::Exact => filter_blackman_harris_invert(p[0], at),
        Profile::Native => native_filter_blackman_harris_invert(p[0], at),
    };
    [u.x, u.y, 0]
}
