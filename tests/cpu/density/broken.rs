//! Broken maps and densities, which the tests of the sound ones must refuse.

use super::chi::{deviations, integrates, limit, masses};
use super::laws::{Case, case, cases};
use corput::glam::DVec3;

const SAMPLES: u32 = 100_000;

/// The deviates of both kinds of cells for a broken map; the sound one passes.
fn broken(case: &Case, sample: impl Fn([u32; 2]) -> DVec3) -> [f64; 2] {
    let masses = masses(case, &|_| 1.0);
    let sound = deviations(case, &masses, SAMPLES, 99, &|u| case.sample(u));
    let limit = limit(&cases());
    assert!(sound.iter().all(|z| *z < limit), "sound: {sound:?}");
    let found = deviations(case, &masses, SAMPLES, 99, &sample);
    println!("{}: {found:.1?} of {limit:.2}", case.name());
    found
}

fn refused(case: &Case, sample: impl Fn([u32; 2]) -> DVec3) {
    let limit = limit(&cases());
    let found = broken(case, sample);
    assert!(found.iter().all(|z| *z > limit), "{found:?}");
}

/// A pdf that is so many times what it should be: by its integral, and by the counts of the
/// sound samples.
fn factor_refused(case: &Case, factor: impl Fn(DVec3) -> f64) {
    assert!(integrates(masses(case, &|_| 1.0).iter().sum()));
    let masses = masses(case, &factor);
    let total: f64 = masses.iter().sum();
    let [_, found] = deviations(case, &masses, SAMPLES, 99, &|u| case.sample(u));
    println!("{}: integral {total:e}, {found:.1}", case.name());
    assert!(!integrates(total), "{total}");
    assert!(found > limit(&cases()), "{found}");
}

#[test]
fn a_factor_of_the_pdf_is_refused() {
    for (name, values) in [
        ("uniform-sphere", &[][..]),
        ("cone", &[1e-4]),
        ("henyey-greenstein", &[0.999_999]),
        ("filter-mitchell", &[2.0, 0.0, 0.5]),
        ("gaussian", &[1.0]),
    ] {
        factor_refused(&case(name, values), |_| 1.05);
    }
}

/// Directions with the pdf of their normals, 4 wo.h times theirs.
#[test]
fn a_pdf_without_the_jacobian_of_reflection_is_refused() {
    for name in ["ggx-vndf", "ggx-vndf-cap", "beckmann"] {
        let wo = DVec3::new(0.8, 0.0, 0.6);
        let case = case(name, &[0.3, 0.0, wo.x, wo.y, wo.z]);
        factor_refused(&case, |x| 4.0 * wo.dot((wo + x).normalize()).abs());
    }
}

/// The excess of the angles by floats, which for small triangles is their rounding.
#[test]
fn girards_area_is_refused() {
    let values = [0.3, 0.4, 0.8, 0.31, 0.4, 0.8, 0.3, 0.41, 0.8];
    let case = case("spherical-triangle", &values);
    let [a, b, c] = [0, 3, 6].map(|i| DVec3::from_slice(&values[i..]).normalize().as_vec3());
    let angle = |p: corput::glam::Vec3, q, r| p.cross(q).angle_between(p.cross(r));
    let excess = angle(a, b, c) + angle(b, c, a) + angle(c, a, b) - std::f32::consts::PI;
    let area = case.law.pdf(DVec3::Z).recip();
    println!("{excess:e} for {area:e}");
    // Its integral is off by the error of the area; too little for counts.
    let total: f64 = masses(&case, &|_| area / f64::from(excess)).iter().sum();
    assert!(!integrates(total), "{total}");
}

/// A radius that is the fraction and not its root.
#[test]
fn a_map_without_its_jacobian_is_refused() {
    refused(&case("polar-disk", &[]), |u| {
        let p = case("polar-disk", &[]).sample(u);
        p * p.length()
    });
    let cone = case("cone", &[1e-4]);
    refused(&cone, |u| {
        let d = cone.sample(u);
        let narrow = d.truncate() * (d.truncate().length() / 1e-4);
        narrow.extend((1.0 - narrow.length_squared()).sqrt())
    });
}

#[test]
fn half_a_domain_is_refused() {
    for (name, values) in [
        ("uniform-sphere", &[][..]),
        ("triangle", &[0.0, 0.0, 1.0, 0.0, 0.0, 1.0]),
        ("exponential", &[1.0]),
        ("filter-blackman-harris", &[2.0]),
        ("ggx-vndf-bounded", &[0.1, 0.5, -0.48, 0.6, 0.64]),
    ] {
        let case = case(name, values);
        refused(&case, |[a, b]| case.sample([a >> 1, b]));
        // Both coordinates follow their distribution, but not together.
        if !case.line() {
            refused(&case, |[a, _]| case.sample([a, a]));
        }
    }
}
