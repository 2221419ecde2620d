//! The twin of `shaders/kernels/integrand_scene.glsl`.

use crate::catalog::{Problem, Words};
use crate::interface::integrand;
use crate::reference::ggx_furnace::{furnace_cosine, furnace_uniform, furnace_visible};
use crate::reference::ggx_lobe::Ggx;
use crate::reference::lambert::{
    lambert_cosine, lambert_light, lambert_mis, lambert_uniform, sky_cosine, sky_uniform,
};
use crate::reference::real::{Real, real_zero};
use crate::reference::spherical_triangle::SphericalTriangle;
use glam::{UVec3, Vec3Swizzles};

/// The integrand at a point.
pub(super) fn scene_term(problem: &Problem, point: &[u32]) -> Real {
    let words = problem.coefficients().columns.as_flattened();
    let [x, y, z] = [0, 1, 2].map(|j| point.get(j).copied().unwrap_or(0));
    let u = UVec3::new(x, y, z);
    let triangle = || SphericalTriangle::of(words);
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
        _ => real_zero(),
    }
}
