//! The sphere and cones.

use super::tools::{grid, truth, turn_distance, unit};
use corput::glam::{UVec2, Vec3, uvec2, vec3};
use corput::judge::{spherical, ulp_error};
use corput::reference::cone::{cone, cone_invert, cone_pdf};
use corput::reference::native::cone as native;
use corput::reference::native::sphere as native_sphere;
use corput::reference::sphere::{uniform_sphere, uniform_sphere_invert, uniform_sphere_pdf};

/// Heights of cones: ordinary ones, and both ends.
const HEIGHTS: [f32; 10] = [
    5e-37,
    5e-13,
    5e-9,
    5e-7,
    1e-3,
    0.3,
    1.0,
    1.7,
    1.999_999_9,
    2.0,
];

/// The worst error of a coordinate over the grid, in ULP.
fn worst(sample: impl Fn(UVec2) -> Vec3, judge: impl Fn([u32; 2]) -> [f64; 3]) -> [f64; 3] {
    let mut worst = [0f64; 3];
    for u in grid() {
        let (got, truth) = (sample(u).to_array(), judge(u.to_array()));
        for i in 0..3 {
            worst[i] = worst[i].max(ulp_error(got[i], truth[i]));
        }
    }
    worst
}

#[test]
fn coordinates_are_within_a_ulp() {
    let sphere = worst(uniform_sphere, spherical::uniform_sphere);
    assert!(sphere.iter().all(|&e| e <= 0.6), "sphere {sphere:?}");
    for h in HEIGHTS {
        let cone = worst(|u| cone(h, u), |u| spherical::cone(h, u));
        println!("{h:e} {cone:?}");
        assert!(cone.iter().all(|&e| e <= 0.6), "cone {h:e} {cone:?}");
    }
}

#[test]
fn the_widest_cone_is_the_sphere() {
    for u in grid() {
        let (cone, sphere) = (cone(2.0, u), uniform_sphere(u));
        assert!((cone - sphere).length() < 2e-7, "{u}: {cone} {sphere}");
        assert_eq!(cone_pdf(2.0, sphere), uniform_sphere_pdf());
    }
}

#[test]
fn densities_are_the_reciprocal_of_the_solid_angle() {
    for h in HEIGHTS {
        for u in grid() {
            let pdf = cone_pdf(h, cone(h, u));
            let truth = 1.0 / spherical::cone_solid_angle(h);
            assert!(ulp_error(pdf, truth) < 0.51, "{h:e} {u}: {pdf:e} {truth:e}");
        }
    }
    let off = |d: Vec3| cone_pdf(0.3, d);
    assert_eq!(off(vec3(0.8, 0.0, 0.6)), 0.0);
    assert_eq!(off(vec3(0.0, 0.0, -1.0)), 0.0);
}

/// Errors of the inverse of a sample: in the first fraction, relative to its distance from
/// the ends, and in the second where the direction is off the axis.
fn round_trip(u: UVec2, v: UVec2) -> [f64; 2] {
    [(unit(u.x) - unit(v.x)).abs(), turn_distance(u.y, v.y)]
}

#[test]
fn inverses_return_the_fractions() {
    for u in grid().into_iter().filter(|u| u.x != 0) {
        let [x, y] = round_trip(u, uniform_sphere_invert(uniform_sphere(u)));
        let near = unit(u.x).min(1.0 - unit(u.x));
        let last = 1.0 / f64::from(u32::MAX);
        assert!(x <= 2f64.powi(-22) * near + last, "sphere {u}: {x:e}");
        assert!(y <= 2f64.powi(-24), "sphere {u}: {y:e}");
        for h in HEIGHTS {
            let [x, y] = round_trip(u, cone_invert(h, cone(h, u)));
            assert!(x <= 2f64.powi(-22), "cone {h:e} {u}: {x:e}");
            assert!(y <= 2f64.powi(-24), "cone {h:e} {u}: {y:e}");
        }
    }
}

#[test]
fn degenerate_input_gives_what_the_headers_say() {
    let pole = Vec3::Z;
    let bad = [-1.0, 0.0, -0.0, f32::NEG_INFINITY, f32::from_bits(1)];
    for h in bad {
        for u in [uvec2(0, 0), uvec2(1 << 31, 5), uvec2(u32::MAX, u32::MAX)] {
            assert_eq!(cone(h, u), pole);
            assert_eq!(native::native_cone(h.max(0.0), u).z, 1.0);
            assert_eq!(cone_pdf(h, pole), 0.0);
        }
    }
    let wide = [2.0, 3.0, f32::INFINITY, f32::NAN];
    for h in wide {
        assert_eq!(cone(h, uvec2(7, 9)), cone(2.0, uvec2(7, 9)));
    }
    let odd = [0.0, -0.0, 1e-45, 1e38, f32::INFINITY, f32::NAN, -1.0];
    for h in odd.into_iter().chain(bad).chain(wide) {
        for x in odd {
            for z in odd {
                let d = vec3(x, 1.0, z);
                let _ = (uniform_sphere_invert(d), cone_invert(h, d));
                assert!(cone_pdf(h, d).is_finite());
                assert!(native::native_cone_pdf(h, d).is_finite());
            }
        }
        for u in grid() {
            assert!(cone(h, u).is_finite() && native::native_cone(h, u).is_finite());
        }
    }
}

#[test]
fn the_poles_of_the_sphere_and_its_equator_are_exact() {
    for t in truth("uniform-sphere").iter().filter(|t| t.value == 0.0) {
        let d = uniform_sphere(t.u);
        assert_eq!(if t.quantity == "x" { d.x } else { d.z }, 0.0, "{t:?}");
    }
}

#[test]
fn the_native_profile_is_as_right() {
    for u in grid() {
        let got = native_sphere::native_uniform_sphere(u);
        assert!((got - uniform_sphere(u)).length() < 1e-6, "{u}");
        for h in HEIGHTS.into_iter().filter(|&h| h > 1e-36) {
            let (got, exact) = (native::native_cone(h, u), cone(h, u));
            // Relative to the radius of the cone: a thin one is as exact.
            let error = (got - exact).truncate().length() / h.min(1.0).sqrt();
            assert!(error < 1e-6, "{h:e} {u}: {got} {exact}");
            assert!((got.z - exact.z).abs() < 1e-6, "{h:e} {u}: {got} {exact}");
            let error = native::native_cone_pdf(h, got) / cone_pdf(h, exact) - 1.0;
            assert!(error.abs() < 1e-6, "{h:e} {u}: {error}");
        }
    }
}
