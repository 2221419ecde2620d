//! The twin of `shaders/kernels/integrand_scene.glsl`.

use crate::catalog::{Problem, Words};
use crate::interface::integrand;
use crate::reference::defocus::{defocus_concentric, defocus_polar, defocus_square};
use crate::reference::ggx_furnace::{furnace_cosine, furnace_uniform, furnace_visible};
use crate::reference::ggx_lobe::Ggx;
use crate::reference::henyey_greenstein::henyey_greenstein_prepare;
use crate::reference::highlight::{
    highlight_light, highlight_mis, highlight_uniform, highlight_visible,
};
use crate::reference::lambert::{
    lambert_cosine, lambert_light, lambert_mis, lambert_uniform, sky_cosine, sky_uniform,
};
use crate::reference::pixel_edge::{pixel_filter, pixel_uniform};
use crate::reference::real::{Real, real_zero};
use crate::reference::real_vector::Real3;
use crate::reference::single_scattering::{scattering_phase, scattering_uniform};
use crate::reference::soft_shadow::{shadow_cosine, shadow_light, shadow_mis, shadow_uniform};
use crate::reference::sphere_light::SphereLight;
use crate::reference::spherical_triangle::SphericalTriangle;
use glam::{UVec3, Vec3Swizzles};

/// The integrand at a point.
pub(super) fn scene_term(problem: &Problem, point: &[u32]) -> Real {
    let words = problem.coefficients().columns.as_flattened();
    let [x, y, z] = [0, 1, 2].map(|j| point.get(j).copied().unwrap_or(0));
    let u = UVec3::new(x, y, z);
    let triangle = || SphericalTriangle::of(words);
    let phase = || {
        let g = f32::from_bits(problem.coefficients().head[0]);
        (henyey_greenstein_prepare(g), Real::of(words))
    };
    let shadow = || {
        let mut rest = words;
        let light = SphereLight::take(&mut rest);
        (light, Real3::take(&mut rest))
    };
    let lobe = || {
        let mut rest = words;
        let g = Ggx::take(&mut rest);
        (g, SphereLight::take(&mut rest))
    };
    match problem.id() {
        integrand::SKY_UNIFORM => sky_uniform(Real::of(words), u.xy()),
        integrand::SKY_COSINE => sky_cosine(Real::of(words), u.xy()),
        integrand::POLYGON_UNIFORM => lambert_uniform(triangle(), u.xy()),
        integrand::POLYGON_COSINE => lambert_cosine(triangle(), u.xy()),
        integrand::POLYGON_LIGHT => lambert_light(triangle(), u.xy()),
        integrand::POLYGON_MIS => lambert_mis(triangle(), u),
        integrand::FURNACE_UNIFORM => furnace_uniform(Ggx::of(words), u.xy()),
        integrand::FURNACE_COSINE => furnace_cosine(Ggx::of(words), u.xy()),
        integrand::FURNACE_VISIBLE => furnace_visible(Ggx::of(words), u.xy()),
        integrand::LENS_SQUARE => defocus_square(Real3::of(words), u.xy()),
        integrand::LENS_POLAR => defocus_polar(Real3::of(words), u.xy()),
        integrand::LENS_CONCENTRIC => defocus_concentric(Real3::of(words), u.xy()),
        integrand::SCATTERING_UNIFORM => {
            let (h, depth) = phase();
            scattering_uniform(h, depth, u)
        }
        integrand::SCATTERING_PHASE => {
            let (h, depth) = phase();
            scattering_phase(h, depth, u)
        }
        integrand::SHADOW_UNIFORM => {
            let (light, edge) = shadow();
            shadow_uniform(light, edge, u.xy())
        }
        integrand::SHADOW_COSINE => {
            let (light, edge) = shadow();
            shadow_cosine(light, edge, u.xy())
        }
        integrand::SHADOW_LIGHT => {
            let (light, edge) = shadow();
            shadow_light(light, edge, u.xy())
        }
        integrand::SHADOW_MIS => {
            let (light, edge) = shadow();
            shadow_mis(light, edge, u)
        }
        integrand::LOBE_UNIFORM => {
            let (g, light) = lobe();
            highlight_uniform(g, light, u.xy())
        }
        integrand::LOBE_GGX => {
            let (g, light) = lobe();
            highlight_visible(g, light, u.xy())
        }
        integrand::LOBE_LIGHT => {
            let (g, light) = lobe();
            highlight_light(g, light, u.xy())
        }
        integrand::LOBE_MIS => {
            let (g, light) = lobe();
            highlight_mis(g, light, u)
        }
        integrand::PIXEL_UNIFORM => pixel_uniform(Real3::of(words), u.xy()),
        integrand::PIXEL_FILTER => pixel_filter(Real3::of(words), u.xy()),
        _ => real_zero(),
    }
}
