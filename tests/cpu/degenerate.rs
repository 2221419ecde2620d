//! Extreme cases in which the common formula has no value at all: parallel vectors, figures
//! without an area, pictures without light or with texels that are no number, delta
//! distributions.

mod extreme;

use corput::bulk::map_sample;
use corput::catalog::{Map, Mapping, Profile};
use corput::environment::{Environment, Options};
use corput::glam::{UVec2, Vec3, vec3};
use corput::reference::mis::{mis_balance, mis_power};
use corput::reference::real::{real, real_float};
use corput::reference::real_angle::angle;
use corput::reference::spherical_rectangle::{
    spherical_rectangle, spherical_rectangle_pdf, spherical_rectangle_prepare,
};
use extreme::extreme;
use std::f32::consts::PI;

const ULP: f64 = 1.0 / (1 << 23) as f64;

/// The error relative to the truth.
fn relative(got: f64, truth: f64) -> f64 {
    let error = ((got - truth) / truth).abs();
    if error.is_nan() { f64::INFINITY } else { error }
}

#[test]
fn extreme_angles_between_nearly_parallel_vectors() {
    for theta in [1e-2f32, 1e-3, 1e-4, 1e-6] {
        let (x, z) = (theta.sin(), theta.cos());
        let truth = f64::from(x).atan2(f64::from(z));
        let naive = relative(z.acos().into(), truth);
        let turns = f64::from(real_float(angle(real(x), real(z))));
        let ours = relative(turns * std::f64::consts::TAU, truth);
        let input = format!("angle of {theta:e} between unit vectors");
        extreme(15, &input, naive, ours, ULP);
    }
}

/// A coordinate of Urena, Fajardo and King 2013, steps 3 to 5, of a rectangle with corners
/// (x0, y0) and (x1, y1) at this height below 0, which should be between x0 and x1.
fn urena([x0, x1]: [f32; 2], [y0, y1]: [f32; 2], z: f32, u: f32) -> f32 {
    let height = |y: f32| y / (y * y + z * z).sqrt();
    let width = |x: f32| x / (x * x + z * z).sqrt();
    let [n0, n1, n2, n3] = [-height(y0), width(x1), height(y1), -width(x0)];
    let [g0, g1, g2, g3] = [-n0 * n1, -n1 * n2, -n2 * n3, -n3 * n0].map(f32::acos);
    let k = 2.0 * PI - g2 - g3;
    let a = u * (g0 + g1 - k) + k;
    let f = (a.cos() * n0 - n2) / a.sin();
    let c = f.signum() / (f * f + n0 * n0).sqrt();
    -(c * z) / (1.0 - c * c).max(0.0).sqrt()
}

#[test]
fn extreme_rectangles_in_a_plane_with_the_origin() {
    // With a height it is right, so that its failure is that of the case.
    let right = urena([1.0, 2.0], [1.0, 2.0], -1.0, 0.5);
    assert!((1.0..2.0).contains(&right), "{right}");
    let naive = urena([1.0, 2.0], [1.0, 2.0], 0.0, 0.5);
    let naive = if (1.0..=2.0).contains(&naive) {
        0.0
    } else {
        f64::INFINITY
    };
    let seen = spherical_rectangle_prepare(vec3(1.0, 1.0, 0.0), Vec3::X, Vec3::Y);
    let d = spherical_rectangle(seen, UVec2::splat(1 << 31));
    let ours = (d - Vec3::Z).length() + spherical_rectangle_pdf(seen, d);
    extreme(
        28,
        "spherical-rectangle in a plane with the origin: +z, pdf 0",
        naive,
        ours.into(),
        0.0,
    );
}

/// Samples of an environment of these texels, two columns wide.
fn drawn(texels: &[[f32; 3]]) -> Vec<[u32; 4]> {
    let map = Map::from_name("environment").expect("a map");
    let height = texels.len() as u32 / 2;
    let made = Environment::new(2, height, texels, Options::default()).expect("a picture");
    let mapping = Mapping::with_values(map, &[])
        .and_then(|mapping| mapping.with_environment(made))
        .expect("its tables");
    let fractions = (0..1024u32).map(|i| [i << 22, i.reverse_bits(), 0]);
    fractions
        .map(|u| map_sample(&mapping, Profile::Exact, u))
        .collect()
}

/// The density of the first texel by floats: its share of the sum.
fn share(texels: &[[f32; 3]]) -> f32 {
    texels[0][0] / texels.iter().map(|texel| texel[0]).sum::<f32>()
}

#[test]
fn extreme_pictures_without_light() {
    let black = [[0.0; 3]; 8];
    let naive = relative(share(&black).into(), 0.125);
    let truth = 0.25 / std::f64::consts::PI;
    let ours = drawn(&black)
        .into_iter()
        .map(|s| relative(f32::from_bits(s[3]).into(), truth))
        .fold(0.0, f64::max);
    extreme(
        36,
        "environment without light: uniform, pdf",
        naive,
        ours,
        ULP,
    );
}

#[test]
fn extreme_texels_that_are_no_number() {
    for (name, texel) in [
        ("NaN", f32::NAN),
        ("inf", f32::INFINITY),
        ("-1", -1.0),
        ("denormal", 1e-40),
    ] {
        let mut texels = [[1.0f32; 3]; 8];
        texels[5] = [0.0; 3];
        let (clean, truth) = (drawn(&texels), share(&texels));
        texels[5] = [texel; 3];
        let naive = relative(share(&texels).into(), truth.into());
        let differ = drawn(&texels)
            .iter()
            .zip(&clean)
            .filter(|(a, b)| a != b)
            .count();
        let input = format!("environment with a texel of {name}: samples that differ by it");
        extreme(37, &input, naive, differ as f64 / clean.len() as f64, 0.0);
    }
}

#[test]
fn extreme_delta_distributions() {
    let delta = f32::INFINITY;
    for (name, naive, got, truth) in [
        (
            "balance",
            delta / (delta + 1.0),
            mis_balance(1, delta, 1, 1.0),
            1.0,
        ),
        (
            "power",
            delta * delta / (delta * delta + 1.0),
            mis_power(1, delta, 1, 1.0),
            1.0,
        ),
        (
            "balance",
            delta / (delta + delta),
            mis_balance(1, delta, 1, delta),
            0.5,
        ),
    ] {
        let other = if truth == 1.0 { "1" } else { "inf" };
        let input = format!("{name} heuristic of pdfs inf (a delta) and {other}");
        extreme(
            41,
            &input,
            relative(naive.into(), truth),
            relative(got.into(), truth),
            0.0,
        );
    }
}
