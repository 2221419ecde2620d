//! The filter of Mitchell and Netravali: `shaders/kernels/map_filter_mitchell.comp`, line by
//! line.

use crate::catalog::Profile;
use crate::interface::MAP_PARAMETERS;
use crate::reference::filter_mitchell::{
    FilterMitchell, filter_mitchell, filter_mitchell_invert, filter_mitchell_pdf,
    filter_mitchell_prepare,
};
use crate::reference::native::filter_mitchell::{
    NativeFilterMitchell, native_filter_mitchell, native_filter_mitchell_invert,
    native_filter_mitchell_pdf, native_filter_mitchell_prepare,
};
use glam::{uvec2, vec2};

fn exact(p: &[f32; MAP_PARAMETERS]) -> FilterMitchell {
    filter_mitchell_prepare(p[0], p[1], p[2])
}

fn native(p: &[f32; MAP_PARAMETERS]) -> NativeFilterMitchell {
    NativeFilterMitchell {
        tail: p[3].to_bits(),
        lobe: p[4].to_bits(),
        ..native_filter_mitchell_prepare(p[0], p[1], p[2])
    }
}

/// Coordinates and pdf.
pub(super) fn sample(profile: Profile, p: &[f32; MAP_PARAMETERS], u: [u32; 3]) -> [u32; 4] {
    let u = uvec2(u[0], u[1]);
    let (at, pdf) = match profile {
        Profile::Exact => {
            let made = filter_mitchell(exact(p), u);
            (made.p, made.pdf)
        }
        Profile::Native => {
            let made = native_filter_mitchell(native(p), u);
            (made.p, made.pdf)
        }
    };
    [at.x, at.y, pdf, 0.0].map(f32::to_bits)
}

/// The pdf.
pub(super) fn pdf(profile: Profile, p: &[f32; MAP_PARAMETERS], [x, y, _]: [f32; 3]) -> f32 {
    let at = vec2(x, y);
    match profile {
        Profile::Exact => filter_mitchell_pdf(exact(p), at),
        Profile::Native => native_filter_mitchell_pdf(native(p), at),
    }
}

/// The fractions.
pub(super) fn invert(profile: Profile, p: &[f32; MAP_PARAMETERS], [x, y, _]: [f32; 3]) -> [u32; 3] {
    let at = vec2(x, y);
    let u = match profile {
        Profile::Exact => filter_mitchell_invert(exact(p), at),
        Profile::Native => native_filter_mitchell_invert(native(p), at),
    };
    [u.x, u.y, 0]
}
