//! Uniform points of plane figures: `shaders/kernels/map_planar.comp`, line by line.

use crate::catalog::Profile;
use crate::interface::{MAP_PARAMETERS, map};
use crate::reference::native::{
    annulus as native_annulus, regular_polygon as native_regular_polygon,
    triangle as native_triangle,
};
use crate::reference::{annulus, regular_polygon, triangle};
use glam::{UVec2, Vec2, uvec2, vec2};

type Parameters = [f32; MAP_PARAMETERS];

fn vertices(p: &Parameters) -> [Vec2; 3] {
    [0, 2, 4].map(|i| vec2(p[i], p[i + 1]))
}

/// Coordinates and pdf.
pub(super) fn sample(profile: Profile, id: u32, p: &Parameters, u: [u32; 3]) -> [u32; 4] {
    let at = point(profile, id, p, uvec2(u[0], u[1]));
    [at.x, at.y, density(profile, id, p, at), 0.0].map(f32::to_bits)
}

fn point(profile: Profile, id: u32, p: &Parameters, u: UVec2) -> Vec2 {
    let ([a, b, c], sides) = (vertices(p), p[0].to_bits());
    match (profile, id) {
        (Profile::Exact, map::TRIANGLE) => triangle::triangle(a, b, c, u),
        (Profile::Exact, map::REGULAR_POLYGON) => regular_polygon::regular_polygon(sides, u),
        (Profile::Exact, _) => annulus::annulus(p[0], u),
        (Profile::Native, map::TRIANGLE) => native_triangle::native_triangle(a, b, c, u),
        (Profile::Native, map::REGULAR_POLYGON) => {
            native_regular_polygon::native_regular_polygon(sides, u)
        }
        (Profile::Native, _) => native_annulus::native_annulus(p[0], u),
    }
}

fn density(profile: Profile, id: u32, p: &Parameters, at: Vec2) -> f32 {
    let ([a, b, c], sides) = (vertices(p), p[0].to_bits());
    match (profile, id) {
        (Profile::Exact, map::TRIANGLE) => triangle::triangle_pdf(a, b, c, at),
        (Profile::Exact, map::REGULAR_POLYGON) => regular_polygon::regular_polygon_pdf(sides, at),
        (Profile::Exact, _) => annulus::annulus_pdf(p[0], at),
        (Profile::Native, map::TRIANGLE) => native_triangle::native_triangle_pdf(a, b, c, at),
        (Profile::Native, map::REGULAR_POLYGON) => {
            native_regular_polygon::native_regular_polygon_pdf(sides, at)
        }
        (Profile::Native, _) => native_annulus::native_annulus_pdf(p[0], at),
    }
}

/// The pdf.
pub(super) fn pdf(profile: Profile, id: u32, p: &Parameters, [x, y, _]: [f32; 3]) -> f32 {
    density(profile, id, p, vec2(x, y))
}

/// The fractions.
pub(super) fn invert(profile: Profile, id: u32, p: &Parameters, [x, y, _]: [f32; 3]) -> [u32; 3] {
    let ([a, b, c], sides, at) = (vertices(p), p[0].to_bits(), vec2(x, y));
    let u = match (profile, id) {
        (Profile::Exact, map::TRIANGLE) => triangle::triangle_invert(a, b, c, at),
        (Profile::Exact, map::REGULAR_POLYGON) => {
            regular_polygon::regular_polygon_invert(sides, at)
        }
        (Profile::Exact, _) => annulus::annulus_invert(p[0], at),
        (Profile::Native, map::TRIANGLE) => native_triangle::native_triangle_invert(a, b, c, at),
        (Profile::Native, map::REGULAR_POLYGON) => {
            native_regular_polygon::native_regular_polygon_invert(sides, at)
        }
        (Profile::Native, _) => native_annulus::native_annulus_invert(p[0], at),
    };
    [u.x, u.y, 0]
}
