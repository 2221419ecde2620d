//! Spherical rectangles.

use super::tools::{doubles, excess, grid, integrated, random, unit, vectors};
use corput::glam::{Vec3, uvec2};
use corput::judge::{spherical_triangle as judge, ulp_error};
use corput::reference::native::spherical_rectangle as native;
use corput::reference::spherical_rectangle::*;

/// Ordinary rectangles, and small, wide, thin and near ones.
const RECTANGLES: [[f32; 9]; 8] = [
    [-0.5, -0.5, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0],
    [0.0, 0.0, 1.0, 3e-3, 0.0, 0.0, 0.0, 3e-3, 0.0],
    [0.0, 0.0, 1.0, 1e-5, 0.0, 0.0, 0.0, 1e-5, 0.0],
    [0.3, -0.2, 1.0, 0.01, 0.0, 0.0, 0.0, 0.2, 0.0],
    [-1.0, -1.0, 1e-3, 2.0, 0.0, 0.0, 0.0, 3.0, 0.0],
    [0.1, 0.2, 1e-2, 2.0, 0.0, 0.0, 0.0, 3.0, 0.0],
    [3.0, 1.0, 2.0, 0.5, 0.0, -0.5, 0.0, 7.0, 0.0],
    [-1.0, -2.0, -3.0, 0.0, 3.0, 0.0, 7.0, 0.0, 0.0],
];

/// Rectangles far longer than they are near.
const LONG: [[f32; 9]; 3] = [
    [0.5, 1.0, 0.0, 0.5, 0.0, -1.0, 0.0, -1e3, 0.0],
    [0.5, 1.0, 0.0, 0.5, 0.0, -1.0, 0.0, -1e6, 0.0],
    [-3e4, -2e5, 1.0, 6e4, 0.0, 0.0, 0.0, 2e5, 0.0],
];

fn prepared(p: [f32; 9]) -> SphericalRectangle {
    let [corner, x, y] = vectors(p);
    spherical_rectangle_prepare(corner, x, y)
}

/// The longest side of the rectangle on the unit sphere.
fn size(p: [f32; 9]) -> f64 {
    let [o, x, y] = vectors(p).map(Vec3::as_dvec3);
    let chord = |v: corput::glam::DVec3| (v.normalize() - o.normalize()).length();
    chord(o + x).max(chord(o + y)).max(chord(o + x + y))
}

#[test]
fn samples_are_those_of_the_judge() {
    for p in RECTANGLES.into_iter().chain(LONG) {
        let (rectangle, sides, size) = (prepared(p), vectors(p).map(doubles), size(p));
        let area = judge::rectangle_solid_angle(sides);
        let mut worst = 0f64;
        for u in random(3000).chain(grid().into_iter().step_by(37)) {
            let got = spherical_rectangle(rectangle, u);
            let error = excess(got, judge::spherical_rectangle(sides, u.to_array()), size);
            worst = worst.max(error);
            let pdf = spherical_rectangle_pdf(rectangle, got);
            assert!(ulp_error(pdf, 1.0 / area) < 0.6, "{p:?} {u}: {pdf} {area}");
        }
        println!("{p:?}: {worst:.1e}");
        assert!(worst < 4e-8, "{p:?}: {worst:e}");
    }
}

#[test]
fn the_pdf_integrates_to_one() {
    for p in RECTANGLES {
        let [o, x, y] = vectors(p).map(Vec3::as_dvec3);
        let corners = [o, o + x, o + x + y, o + y].map(|v| v.to_array());
        let area = integrated([corners[0], corners[1], corners[2]], 40)
            + integrated([corners[2], corners[3], corners[0]], 40);
        let rectangle = prepared(p);
        let middle = spherical_rectangle(rectangle, uvec2(1 << 31, 1 << 31));
        let one = f64::from(spherical_rectangle_pdf(rectangle, middle)) * area;
        assert!((one - 1.0).abs() < 1e-6, "{p:?}: {one}");
    }
}

#[test]
fn inverses_return_the_fractions() {
    for (i, p) in RECTANGLES.into_iter().enumerate() {
        let (rectangle, size) = (prepared(p), size(p));
        let thin = judge::rectangle_solid_angle(vectors(p).map(doubles)) / size;
        let mut worst = [0f64; 2];
        for u in random(3000) {
            let v = spherical_rectangle_invert(rectangle, spherical_rectangle(rectangle, u));
            // The rounding of a direction is this much of the rectangle, but around +z.
            let scale = if [1, 2].contains(&i) {
                1.0
            } else {
                thin.min(1.0)
            };
            worst[0] = worst[0].max((unit(u.x) - unit(v.x)).abs() * unit(u.y).sqrt() * scale);
            worst[1] = worst[1].max((unit(u.y) - unit(v.y)).abs() * scale);
        }
        println!("{p:?}: {worst:?}");
        assert!(worst[0] < 2e-6 && worst[1] < 2e-6, "{p:?}: {worst:?}");
    }
}

#[test]
fn degenerate_rectangles_give_what_the_header_says() {
    let flat = [
        [0.0; 9],
        // The origin in the plane, outside: z0 = 0 of Urena et al.
        [1.0, 1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0],
        [1.0, 1.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0],
    ];
    for p in flat {
        let rectangle = prepared(p);
        let [corner, x, y] = vectors(p);
        let other = native::native_spherical_rectangle_prepare(corner, x, y);
        for u in [uvec2(0, 0), uvec2(1 << 31, 77)] {
            assert_eq!(spherical_rectangle(rectangle, u), Vec3::Z);
            assert_eq!(spherical_rectangle_pdf(rectangle, Vec3::Z), 0.0);
            assert_eq!(spherical_rectangle_invert(rectangle, Vec3::Z), uvec2(0, 0));
            assert_eq!(native::native_spherical_rectangle(other, u), Vec3::Z);
            assert_eq!(native::native_spherical_rectangle_pdf(other, Vec3::Z), 0.0);
        }
    }
}

#[test]
fn the_native_profile_is_as_right() {
    for p in RECTANGLES {
        let [corner, x, y] = vectors(p);
        let exact = prepared(p);
        let rectangle = native::native_spherical_rectangle_prepare(corner, x, y);
        let (mut worst, mut worst_pdf) = (0f32, 0f32);
        for u in random(2000) {
            let got = native::native_spherical_rectangle(rectangle, u);
            let truth = spherical_rectangle(exact, u);
            worst = worst.max((got - truth).length());
            let pdf = native::native_spherical_rectangle_pdf(rectangle, got);
            worst_pdf = worst_pdf.max((pdf / spherical_rectangle_pdf(exact, truth) - 1.0).abs());
        }
        println!("{p:?}: {worst:e} {worst_pdf:e}");
        assert!(
            worst < 2e-5 && worst_pdf < 2e-4,
            "{p:?}: {worst:e} {worst_pdf:e}"
        );
    }
}
