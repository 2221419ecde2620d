//! Uniform directions of solid angles: `shaders/kernels/map_spherical.comp`, line by line.

use crate::catalog::Profile;
use crate::interface::{MAP_PARAMETERS, map};
use crate::reference::native::{cone as native_cone, sphere as native_sphere};
use crate::reference::{cone, sphere};
use glam::{UVec2, Vec3, uvec2, vec3};

fn words(d: Vec3, pdf: f32) -> [u32; 4] {
    [d.x, d.y, d.z, pdf].map(f32::to_bits)
}

/// Coordinates and pdf.
pub(super) fn sample(
    profile: Profile,
    id: u32,
    p: &[f32; MAP_PARAMETERS],
    u: [u32; 3],
) -> [u32; 4] {
    let u = uvec2(u[0], u[1]);
    match (profile, id) {
        (Profile::Exact, map::UNIFORM_SPHERE) => {
            words(sphere::uniform_sphere(u), sphere::uniform_sphere_pdf())
        }
        (Profile::Exact, map::CONE) => {
            let d = cone::cone(p[0], u);
            words(d, cone::cone_pdf(p[0], d))
        }
        (Profile::Native, map::UNIFORM_SPHERE) => words(
            native_sphere::native_uniform_sphere(u),
            native_sphere::native_uniform_sphere_pdf(),
        ),
        (Profile::Native, map::CONE) => {
            let d = native_cone::native_cone(p[0], u);
            words(d, native_cone::native_cone_pdf(p[0], d))
        }
        _ => [0; 4],
    }
}

/// The pdf.
pub(super) fn pdf(
    profile: Profile,
    id: u32,
    p: &[f32; MAP_PARAMETERS],
    [x, y, z]: [f32; 3],
) -> f32 {
    let d = vec3(x, y, z);
    match (profile, id) {
        (Profile::Exact, map::UNIFORM_SPHERE) => sphere::uniform_sphere_pdf(),
        (Profile::Exact, map::CONE) => cone::cone_pdf(p[0], d),
        (Profile::Native, map::UNIFORM_SPHERE) => native_sphere::native_uniform_sphere_pdf(),
        (Profile::Native, map::CONE) => native_cone::native_cone_pdf(p[0], d),
        _ => 0.0,
    }
}

/// The fractions.
pub(super) fn invert(
    profile: Profile,
    id: u32,
    p: &[f32; MAP_PARAMETERS],
    [x, y, z]: [f32; 3],
) -> [u32; 3] {
    let d = vec3(x, y, z);
    let u = match (profile, id) {
        (Profile::Exact, map::UNIFORM_SPHERE) => sphere::uniform_sphere_invert(d),
        (Profile::Exact, map::CONE) => cone::cone_invert(p[0], d),
        (Profile::Native, map::UNIFORM_SPHERE) => native_sphere::native_uniform_sphere_invert(d),
        (Profile::Native, map::CONE) => native_cone::native_cone_invert(p[0], d),
        _ => UVec2::ZERO,
    };
    [u.x, u.y, 0]
}
