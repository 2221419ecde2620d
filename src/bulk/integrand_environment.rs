//! The twin of `shaders/kernels/integrand_environment.glsl`.

use crate::catalog::{LightMap, Problem};
use crate::interface::integrand;
use crate::reference::irradiance::{
    irradiance_cosine, irradiance_environment, irradiance_mis, irradiance_uniform,
};
use crate::reference::real::Real;
use glam::{UVec3, uvec2};

/// The integrand at a point.
pub(super) fn environment_term(problem: &Problem, map: &LightMap, point: &[u32]) -> Real {
    let [width, height, axis, _] = problem.coefficients().head;
    let size = uvec2(width, height);
    let [x, y, z] = [0, 1, 2].map(|j| point.get(j).copied().unwrap_or(0));
    let u = uvec2(x, y);
    let (edges, words) = (map.edges(), map.words());
    match problem.id() {
        integrand::IRRADIANCE_UNIFORM => irradiance_uniform(size, axis, u, edges, words),
        integrand::IRRADIANCE_COSINE => irradiance_cosine(size, axis, u, edges, words),
        integrand::IRRADIANCE_ENVIRONMENT => irradiance_environment(size, axis, u, edges, words),
        _ => irradiance_mis(size, axis, UVec3::new(x, y, z), edges, words),
    }
}
