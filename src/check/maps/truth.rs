//! The judge's sample of a map.

use crate::catalog::{Group, Mapping};
use crate::interface::{MAP_PARAMETERS, map};
use crate::judge;
use crate::judge::environment::EnvironmentTables;

/// Coordinates of the sample and then its pdf, in `f64`; `None` where no judge knows.
#[must_use]
pub fn truth(mapping: &Mapping, u: [u32; 3]) -> Option<[f64; 4]> {
    let id = mapping.map().id;
    match mapping.map().group {
        Group::Hemisphere => Some(hemisphere(id, [u[0], u[1]])),
        Group::Planar => Some(planar(id, mapping.parameters(), [u[0], u[1]])),
        Group::Spherical => spherical(id, mapping.parameters(), [u[0], u[1]]),
        Group::Lobe => Some(judge::spherical::cosine_power(
            mapping.parameters()[0].into(),
            [u[0], u[1]],
        )),
        Group::Line
        | Group::Normal
        | Group::Filter
        | Group::GaussianFilter
        | Group::WindowFilter
        | Group::MitchellFilter => line(id, mapping.parameters(), [u[0], u[1]]),
        Group::Environment => environment(mapping, u),
        Group::Phase | Group::Ggx | Group::GgxCap | Group::Beckmann => {
            scattering(id, mapping.parameters(), [u[0], u[1]])
        }
    }
}

fn environment(mapping: &Mapping, u: [u32; 3]) -> Option<[f64; 4]> {
    let [width, height, ..] = mapping.words();
    let tables = EnvironmentTables {
        width,
        height,
        alias: mapping.map().id == map::ENVIRONMENT_ALIAS,
        words: mapping.tables().first()?,
    };
    Some(tables.sample(u))
}

fn planar(id: u32, p: &[f32; MAP_PARAMETERS], u: [u32; 2]) -> [f64; 4] {
    let vertex = |i: usize| [p[i], p[i + 1]].map(f64::from);
    let [x, y, pdf] = match id {
        map::TRIANGLE => judge::planar::triangle([vertex(0), vertex(2), vertex(4)], u),
        map::REGULAR_POLYGON => judge::planar::regular_polygon(p[0].to_bits(), u),
        _ => judge::planar::annulus(p[0], u),
    };
    [x, y, pdf, 0.0]
}

fn spherical(id: u32, p: &[f32; MAP_PARAMETERS], u: [u32; 2]) -> Option<[f64; 4]> {
    let uniform = |[x, y, z]: [f64; 3], solid_angle: f64| Some([x, y, z, 1.0 / solid_angle]);
    let vector = |i: usize| [p[i], p[i + 1], p[i + 2]].map(f64::from);
    let vectors = || [vector(0), vector(3), vector(6)];
    match id {
        map::UNIFORM_SPHERE => uniform(
            judge::spherical::uniform_sphere(u),
            4.0 * std::f64::consts::PI,
        ),
        map::CONE => uniform(
            judge::spherical::cone(p[0], u),
            judge::spherical::cone_solid_angle(p[0]),
        ),
        map::SPHERICAL_TRIANGLE => {
            let [a, b, c] = vectors();
            let solid_angle = judge::spherical_triangle::solid_angle(a, b, c);
            uniform(
                judge::spherical_triangle::spherical_triangle([a, b, c], u),
                solid_angle,
            )
        }
        map::SPHERICAL_RECTANGLE => uniform(
            judge::spherical_triangle::spherical_rectangle(vectors(), u),
            judge::spherical_triangle::rectangle_solid_angle(vectors()),
        ),
        map::SPHERE_LIGHT => {
            let ([x, y, z], pdf) = judge::lights::sphere_light(vector(0), p[3].into(), u);
            Some([x, y, z, pdf])
        }
        map::DISK_LIGHT => {
            let ([x, y, z], pdf) = judge::lights::disk_light(vector(0), vector(3), p[6].into(), u);
            Some([x, y, z, pdf])
        }
        _ => None,
    }
}

fn line(id: u32, p: &[f32; MAP_PARAMETERS], u: [u32; 2]) -> Option<[f64; 4]> {
    let (first, second) = (f64::from(p[0]), f64::from(p[1]));
    let one = |[x, pdf]: [f64; 2]| Some([x, pdf, 0.0, 0.0]);
    let two = |[x, y, pdf]: [f64; 3]| Some([x, y, pdf, 0.0]);
    // Both coordinates are alike, and independent.
    let product = |of: &dyn Fn(u32) -> [f64; 2]| {
        let ([x, p], [y, q]) = (of(u[0]), of(u[1]));
        two([x, y, p * q])
    };
    match id {
        map::EXPONENTIAL => one(judge::line::exponential(first, u[0])),
        map::GAUSSIAN => one(judge::line::gaussian(first, u[0])),
        map::NORMAL_PAIR => product(&|u| judge::line::gaussian(first, u)),
        map::BOX_MULLER => two(judge::line::box_muller(first, u)),
        map::FILTER_BOX => product(&|u| judge::line::filter_box(first, u)),
        map::FILTER_TENT => product(&|u| judge::line::filter_tent(first, u)),
        map::FILTER_BLACKMAN_HARRIS => product(&|u| judge::line::filter_blackman_harris(first, u)),
        map::FILTER_MITCHELL => {
            // The shares of the parts are rounded to fractions, which the samples start from.
            let shares = [p[3], p[4]].map(f32::to_bits);
            let c = f64::from(p[2]);
            product(&|u| judge::line::filter_mitchell([first, second, c], shares, u))
        }
        map::FILTER_GAUSSIAN => product(&|u| judge::line::filter_gaussian(first, second, u)),
        _ => None,
    }
}

/// A cap's normal nearly perpendicular to the view is a small sum of large vectors, whose pdf
/// has few digits: there nothing is asked.
const PERPENDICULAR: f64 = 1.0 / 64.0;

fn scattering(id: u32, p: &[f32; MAP_PARAMETERS], u: [u32; 2]) -> Option<[f64; 4]> {
    let (alpha, wo) = ([p[0], p[1]], [p[2], p[3], p[4]]);
    let capped = |lobe: judge::Ggx| {
        let sample = lobe.vndf_cap(u);
        let [x, y, z, _] = sample;
        (lobe.sphere_cosine([x, y, z]) >= PERPENDICULAR).then_some(sample)
    };
    match id {
        map::HENYEY_GREENSTEIN => Some(judge::henyey_greenstein(p[0], p[1] > 0.0, u)),
        map::GGX_VNDF => Some(judge::Ggx::new(alpha, wo).vndf(u)),
        map::GGX_VNDF_NORMAL => Some(judge::Ggx::new(alpha, wo).normal(u)),
        map::GGX_VNDF_CAP => capped(judge::Ggx::new(alpha, wo)),
        map::GGX_VNDF_BOUNDED => capped(judge::Ggx::bounded(alpha, wo)),
        map::BECKMANN_NORMAL => Some(judge::beckmann_normal(alpha, u)),
        map::BECKMANN => Some(judge::beckmann(alpha, wo, u)),
        _ => None,
    }
}

fn hemisphere(id: u32, u: [u32; 2]) -> [f64; 4] {
    let over_pi = std::f64::consts::FRAC_1_PI;
    let planar = |p: [f64; 2]| [p[0], p[1], over_pi, 0.0];
    let spatial = |d: [f64; 3], pdf: f64| [d[0], d[1], d[2], pdf];
    let lambert = |d: [f64; 3]| spatial(d, d[2] * over_pi);
    match id {
        map::CONCENTRIC_DISK => planar(judge::concentric_disk(u)),
        map::POLAR_DISK => planar(judge::polar_disk(u)),
        map::UNIFORM_HEMISPHERE => spatial(judge::uniform_hemisphere(u), 0.5 * over_pi),
        map::COSINE_HEMISPHERE => lambert(judge::cosine_hemisphere(u)),
        _ => lambert(judge::cosine_hemisphere_polar(u)),
    }
}
