//! Plane figures: triangle, regular polygon, annulus.

use super::tools::{grid, random, relative, turn_distance, unit};
use corput::glam::{UVec2, Vec2, uvec2, vec2};
use corput::judge::{planar as judge, ulp_error};
use corput::reference::annulus::*;
use corput::reference::native::{annulus as native_annulus, regular_polygon as native_polygon};
use corput::reference::regular_polygon::*;
use corput::reference::triangle::*;

const TRIANGLES: [[f32; 6]; 6] = [
    [0.0, 0.0, 1.0, 0.0, 0.0, 1.0],
    [0.25, 0.5, 0.125, 0.875, 0.75, 0.25],
    [0.0, 0.0, 1e-6, 0.0, 0.0, 1e-6],
    [1.0, 1.0, 1.001, 1.0, 1.0, 1.01],
    [-0.5, -0.5, 0.5, -0.5, 0.0, 0.5],
    [1e6, 0.0, 0.0, 1.0, -1e6, 0.5],
];

const SIDES: [u32; 6] = [3, 4, 5, 12, 1000, 65_536];

const INNER: [f32; 5] = [0.0, 1e-6, 0.5, 0.999, 0.999_999];

fn vertices(p: [f32; 6]) -> [Vec2; 3] {
    [vec2(p[0], p[1]), vec2(p[2], p[3]), vec2(p[4], p[5])]
}

/// The worst error of a coordinate, in ULP of it or of `floor`.
fn ulps(got: Vec2, truth: [f64; 3], floor: f64) -> f64 {
    let all = got.to_array().into_iter().zip(truth);
    all.map(|(got, truth)| {
        if truth.abs() >= floor || floor == 0.0 {
            return ulp_error(got, truth);
        }
        let exponent = (floor.to_bits() >> 52) as i32 - 1023;
        (f64::from(got) - truth).abs() / f64::powi(2.0, exponent - 23)
    })
    .fold(0.0, f64::max)
}

fn fractions() -> impl Iterator<Item = UVec2> {
    random(5000).chain(grid().into_iter().step_by(17))
}

#[test]
fn weights_sum_exactly() {
    for u in grid() {
        let w = triangle_weights(u);
        let sum = u64::from(w.x) + u64::from(w.y) + u64::from(w.z);
        assert_eq!(sum, 1 << 31, "{u}: {w}");
    }
}

#[test]
fn points_are_those_of_the_judge() {
    for p in TRIANGLES {
        let [a, b, c] = vertices(p);
        let corners = [a, b, c].map(|v| v.to_array().map(f64::from));
        // What cancels is relative to the largest vertex.
        let size = p.iter().map(|x| f64::from(x.abs())).fold(0.0, f64::max);
        for u in fractions() {
            let got = triangle(a, b, c, u);
            let truth = judge::triangle(corners, u.to_array());
            let error = ulps(got, truth, size / 16.0);
            assert!(error < 0.7, "{p:?} {u}: {got} {truth:?}: {error}");
            let pdf = triangle_pdf(a, b, c, got);
            assert!(ulp_error(pdf, truth[2]) < 0.6, "{p:?} {u}: {pdf} {truth:?}");
        }
    }
    for n in SIDES {
        for u in fractions() {
            let got = regular_polygon(n, u);
            let truth = judge::regular_polygon(n, u.to_array());
            let error = ulps(got, truth, 0.0625);
            assert!(error < 0.9, "{n} {u}: {got} {truth:?}: {error}");
            let pdf = regular_polygon_pdf(n, got);
            assert!(ulp_error(pdf, truth[2]) < 0.6, "{n} {u}: {pdf} {truth:?}");
        }
    }
    for i in INNER {
        for u in fractions() {
            let got = annulus(i, u);
            let truth = judge::annulus(i, u.to_array());
            let error = ulps(got, truth, 0.0);
            assert!(error < 0.6, "{i} {u}: {got} {truth:?}: {error}");
            let pdf = annulus_pdf(i, got);
            assert!(ulp_error(pdf, truth[2]) < 0.6, "{i} {u}: {pdf} {truth:?}");
        }
    }
}

#[test]
fn edges_bound_the_pdf() {
    let [a, b, c] = vertices(TRIANGLES[0]);
    for (x, y) in [(-1e-6, 0.5), (0.5, -1e-6), (0.5, 0.500_002), (2.0, 2.0)] {
        assert_eq!(triangle_pdf(a, b, c, vec2(x, y)), 0.0, "{x} {y}");
        assert_eq!(triangle_pdf(a, c, b, vec2(x, y)), 0.0, "{x} {y}");
    }
    assert_eq!(triangle_pdf(a, c, b, vec2(0.25, 0.25)), 2.0);
    assert_eq!(regular_polygon_pdf(4, vec2(0.501, 0.501)), 0.0);
    assert_eq!(regular_polygon_pdf(4, vec2(0.499, 0.499)), 0.5);
    assert_eq!(annulus_pdf(0.5, vec2(0.4999, 0.0)), 0.0);
    assert_eq!(annulus_pdf(0.5, vec2(0.0, 1.0001)), 0.0);
    assert!(
        relative(
            annulus_pdf(0.5, vec2(0.0, 0.7)).into(),
            4.0 / (3.0 * std::f64::consts::PI)
        ) < 1e-7
    );
}

#[test]
fn inverses_return_the_fractions() {
    for u in random(20_000) {
        for p in &TRIANGLES[..5] {
            let [a, b, c] = vertices(*p);
            let v = triangle_invert(a, b, c, triangle(a, b, c, u));
            // The rounding of the points is up to 2^-14 of the smaller triangles.
            let scale = if p[0] == 1.0 { 1e-3 } else { 1.0 };
            let error = (unit(u.x) - unit(v.x))
                .abs()
                .max((unit(u.y) - unit(v.y)).abs());
            assert!(error * scale < 1e-6, "{p:?} {u}: {v}");
        }
        for n in SIDES {
            let v = regular_polygon_invert(n, regular_polygon(n, u));
            assert!(
                turn_distance(u.x, v.x) * unit(u.y).sqrt() < 5e-7,
                "{n} {u}: {v}"
            );
            assert!((unit(u.y) - unit(v.y)).abs() < 5e-7, "{n} {u}: {v}");
        }
        // The centre has no angle.
        for i in INNER.into_iter().filter(|&i| i > 0.0 || u.x != 0) {
            let v = annulus_invert(i, annulus(i, u));
            let width = 1.0 - f64::from(i).powi(2);
            assert!((unit(u.x) - unit(v.x)).abs() * width < 3e-7, "{i} {u}: {v}");
            assert!(turn_distance(u.y, v.y) < 6e-8, "{i} {u}: {v}");
        }
    }
}

#[test]
fn degenerate_input_gives_what_the_headers_say() {
    let odd = [0.0, 1.0, -1.0, 1e-45, 1e38, f32::INFINITY, f32::NAN];
    for i in 0..7 * 7 * 7 {
        let [x, y, z] = [odd[i % 7], odd[i / 7 % 7], odd[i / 49]];
        let (a, b, c) = (vec2(x, y), vec2(z, x), vec2(y, z));
        let p = triangle(a, b, c, uvec2(1 << 31, 1 << 30));
        assert!(
            p.is_finite() && triangle_pdf(a, b, c, p).is_finite(),
            "{a} {b} {c}"
        );
        let _ = triangle_invert(a, b, c, vec2(x, z));
        for n in [0, 1, 2, 3, u32::MAX] {
            assert!(regular_polygon_pdf(n, a).is_finite());
            let _ = regular_polygon_invert(n, a);
            assert!(native_polygon::native_regular_polygon_pdf(n, a).is_finite());
        }
        assert!(annulus(x, uvec2(1 << 31, 5)).is_finite());
        assert!(annulus_pdf(x, b).is_finite());
        let _ = annulus_invert(x, b);
    }
    let line = [vec2(0.0, 0.0), vec2(1.0, 1.0), vec2(2.0, 2.0)];
    assert_eq!(triangle_pdf(line[0], line[1], line[2], line[1]), 0.0);
    assert_eq!(
        triangle_invert(line[0], line[1], line[2], line[1]),
        uvec2(0, 0)
    );
    assert_eq!(
        regular_polygon(2, uvec2(5, 7)),
        regular_polygon(3, uvec2(5, 7))
    );
    assert_eq!(annulus_pdf(1.0, vec2(1.0, 0.0)), 0.0);
    assert_eq!(annulus(-3.0, uvec2(5, 7)), annulus(0.0, uvec2(5, 7)));
    assert_eq!(annulus(7.0, uvec2(0, 0)), vec2(1.0, 0.0));
}

#[test]
fn the_native_profile_is_as_right() {
    for u in random(5000) {
        for n in SIDES {
            let got = native_polygon::native_regular_polygon(n, u);
            assert!(
                (got - regular_polygon(n, u)).length() < 2e-6,
                "{n} {u}: {got}"
            );
            let ratio = native_polygon::native_regular_polygon_pdf(n, got)
                / regular_polygon_pdf(n, regular_polygon(n, u));
            assert!((ratio - 1.0).abs() < 1e-5, "{n} {u}: {ratio}");
        }
        for i in INNER {
            let got = native_annulus::native_annulus(i, u);
            assert!((got - annulus(i, u)).length() < 2e-6, "{i} {u}: {got}");
        }
    }
}
