//! Scattering distributions: `map_phase.comp`, `map_ggx.comp`, `map_ggx_cap.comp` and
//! `map_beckmann.comp` of `shaders/kernels`.

use crate::catalog::Profile;
use crate::interface::{MAP_PARAMETERS, map};
use crate::reference::{
    beckmann, ggx_lobe, ggx_vndf, ggx_vndf_bounded, ggx_vndf_cap, henyey_greenstein, native,
};
use glam::{UVec2, Vec2, Vec3, uvec2, vec2, vec3};

/// The parameters of a map, as its functions take them.
#[derive(Clone, Copy)]
struct Given {
    id: u32,
    alpha: Vec2,
    wo: Vec3,
    rest: f32,
    backward: bool,
}

impl Given {
    fn new(id: u32, p: &[f32; MAP_PARAMETERS]) -> Self {
        Self {
            id,
            alpha: vec2(p[0], p[1]),
            wo: vec3(p[2], p[3], p[4]),
            rest: p[0],
            backward: p[1].to_bits() != 0,
        }
    }

    fn phase(&self) -> henyey_greenstein::HenyeyGreenstein {
        henyey_greenstein::henyey_greenstein_complement(self.rest, self.backward)
    }

    fn lobe(&self) -> ggx_lobe::Ggx {
        match self.id {
            map::GGX_VNDF_BOUNDED => {
                ggx_vndf_bounded::ggx_vndf_bounded_prepare(self.alpha, self.wo)
            }
            _ => ggx_lobe::ggx_prepare(self.alpha, self.wo),
        }
    }

    fn native_phase(&self) -> native::henyey_greenstein::NativeHenyeyGreenstein {
        native::henyey_greenstein::native_henyey_greenstein_complement(self.rest, self.backward)
    }

    fn native_lobe(&self) -> native::ggx_lobe::NativeGgx {
        match self.id {
            map::GGX_VNDF_BOUNDED => {
                native::ggx_vndf_bounded::native_ggx_vndf_bounded_prepare(self.alpha, self.wo)
            }
            _ => native::ggx_lobe::native_ggx_prepare(self.alpha, self.wo),
        }
    }
}

/// Coordinates and pdf.
pub(super) fn sample(
    profile: Profile,
    id: u32,
    p: &[f32; MAP_PARAMETERS],
    u: [u32; 3],
) -> [u32; 4] {
    let (given, u) = (Given::new(id, p), uvec2(u[0], u[1]));
    let (d, pdf) = match profile {
        Profile::Exact => {
            let made = exact(&given, u);
            (made.direction, made.pdf)
        }
        Profile::Native => {
            let made = native(&given, u);
            (made.direction, made.pdf)
        }
    };
    [d.x, d.y, d.z, pdf].map(f32::to_bits)
}

fn exact(given: &Given, u: UVec2) -> crate::reference::scattered::Scattered {
    match given.id {
        map::HENYEY_GREENSTEIN => henyey_greenstein::henyey_greenstein(given.phase(), u),
        map::GGX_VNDF => ggx_vndf::ggx_vndf(given.lobe(), u),
        map::GGX_VNDF_NORMAL => ggx_vndf::ggx_vndf_normal(given.lobe(), u),
        map::GGX_VNDF_CAP => ggx_vndf_cap::ggx_vndf_cap(given.lobe(), u),
        map::GGX_VNDF_BOUNDED => ggx_vndf_bounded::ggx_vndf_bounded(given.lobe(), u),
        map::BECKMANN_NORMAL => beckmann::beckmann_normal(given.alpha, u),
        _ => beckmann::beckmann(given.alpha, given.wo, u),
    }
}

fn native(given: &Given, u: UVec2) -> native::scattered::NativeScattered {
    match given.id {
        map::HENYEY_GREENSTEIN => {
            native::henyey_greenstein::native_henyey_greenstein(given.native_phase(), u)
        }
        map::GGX_VNDF => native::ggx_vndf::native_ggx_vndf(given.native_lobe(), u),
        map::GGX_VNDF_NORMAL => native::ggx_vndf::native_ggx_vndf_normal(given.native_lobe(), u),
        map::GGX_VNDF_CAP => native::ggx_vndf_cap::native_ggx_vndf_cap(given.native_lobe(), u),
        map::GGX_VNDF_BOUNDED => {
            native::ggx_vndf_bounded::native_ggx_vndf_bounded(given.native_lobe(), u)
        }
        map::BECKMANN_NORMAL => native::beckmann::native_beckmann_normal(given.alpha, u),
        _ => native::beckmann::native_beckmann(given.alpha, given.wo, u),
    }
}

/// The pdf.
pub(super) fn pdf(
    profile: Profile,
    id: u32,
    p: &[f32; MAP_PARAMETERS],
    [x, y, z]: [f32; 3],
) -> f32 {
    let (given, d) = (Given::new(id, p), vec3(x, y, z));
    match (profile, id) {
        (Profile::Exact, map::HENYEY_GREENSTEIN) => {
            henyey_greenstein::henyey_greenstein_pdf(given.phase(), d)
        }
        (Profile::Exact, map::GGX_VNDF_NORMAL) => ggx_vndf::ggx_vndf_normal_pdf(given.lobe(), d),
        (Profile::Exact, map::BECKMANN_NORMAL) => beckmann::beckmann_normal_pdf(given.alpha, d),
        (Profile::Exact, map::BECKMANN) => beckmann::beckmann_pdf(given.alpha, given.wo, d),
        (Profile::Exact, _) => ggx_lobe::ggx_pdf(given.lobe(), d),
        (Profile::Native, map::HENYEY_GREENSTEIN) => {
            native::henyey_greenstein::native_henyey_greenstein_pdf(given.native_phase(), d)
        }
        (Profile::Native, map::GGX_VNDF_NORMAL) => {
            native::ggx_vndf::native_ggx_vndf_normal_pdf(given.native_lobe(), d)
        }
        (Profile::Native, map::BECKMANN_NORMAL) => {
            native::beckmann::native_beckmann_normal_pdf(given.alpha, d)
        }
        (Profile::Native, map::BECKMANN) => {
            native::beckmann::native_beckmann_pdf(given.alpha, given.wo, d)
        }
        (Profile::Native, _) => native::ggx_lobe::native_ggx_pdf(given.native_lobe(), d),
    }
}

/// The fractions.
pub(super) fn invert(
    profile: Profile,
    id: u32,
    p: &[f32; MAP_PARAMETERS],
    [x, y, z]: [f32; 3],
) -> [u32; 3] {
    let (given, d) = (Given::new(id, p), vec3(x, y, z));
    let u = match profile {
        Profile::Exact => exact_fractions(&given, d),
        Profile::Native => native_fractions(&given, d),
    };
    [u.x, u.y, 0]
}

fn exact_fractions(given: &Given, d: Vec3) -> UVec2 {
    match given.id {
        map::HENYEY_GREENSTEIN => henyey_greenstein::henyey_greenstein_invert(given.phase(), d),
        map::GGX_VNDF => ggx_vndf::ggx_vndf_invert(given.lobe(), d),
        map::GGX_VNDF_NORMAL => ggx_vndf::ggx_vndf_normal_invert(given.lobe(), d),
        map::BECKMANN_NORMAL => beckmann::beckmann_normal_invert(given.alpha, d),
        map::BECKMANN => beckmann::beckmann_invert(given.alpha, given.wo, d),
        _ => ggx_vndf_cap::ggx_vndf_cap_invert(given.lobe(), d),
    }
}

fn native_fractions(given: &Given, d: Vec3) -> UVec2 {
    match given.id {
        map::HENYEY_GREENSTEIN => {
            native::henyey_greenstein::native_henyey_greenstein_invert(given.native_phase(), d)
        }
        map::GGX_VNDF => native::ggx_vndf::native_ggx_vndf_invert(given.native_lobe(), d),
        map::GGX_VNDF_NORMAL => {
            native::ggx_vndf::native_ggx_vndf_normal_invert(given.native_lobe(), d)
        }
        map::BECKMANN_NORMAL => native::beckmann::native_beckmann_normal_invert(given.alpha, d),
        map::BECKMANN => native::beckmann::native_beckmann_invert(given.alpha, given.wo, d),
        _ => native::ggx_vndf_cap::native_ggx_vndf_cap_invert(given.native_lobe(), d),
    }
}
