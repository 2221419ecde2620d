//! Spherical triangles.

use super::significance::{critical, deviate};
use super::tools::{doubles, excess, grid, integrated, random, relative, truth, unit, vectors};
use corput::glam::{UVec2, Vec3, uvec2, vec3};
use corput::judge::spherical_triangle as judge;
use corput::judge::ulp_error;
use corput::reference::native::spherical_triangle as native;
use corput::reference::spherical_triangle::*;

/// Ordinary triangles, and small, wide, thin and long ones, in either order.
const TRIANGLES: [[f32; 9]; 14] = [
    [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0],
    [1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 1.0, 0.0],
    [0.0, 0.0, 1.0, 1e-5, 0.0, 1.0, 0.0, 1e-5, 1.0],
    [1e-5, 0.0, 1.0, 0.0, 1e-5, 1.0, -1e-5, -1e-5, 1.0],
    [0.3, 0.4, 0.8, 0.31, 0.4, 0.8, 0.3, 0.41, 0.8],
    [3.0, 4.0, 8.0, 0.03, 0.05, 0.08, 30.0, 47.0, 85.0],
    [
        1.0,
        0.0,
        1e-4,
        -0.5,
        0.866_025_4,
        1e-4,
        -0.5,
        -0.866_025_4,
        1e-4,
    ],
    [1.0, 0.0, 0.3, -0.5, 0.9, 0.2, -0.5, -0.9, 0.1],
    [1.0, 0.2, 0.1, 1.001, 0.2, 0.1, -1.0, 0.3, 0.2],
    [1.0, 0.2, 0.1, -1.0, 0.3, 0.2, 1.001, 0.2, 0.1],
    [-1.0, 0.3, 0.2, 1.0, 0.2, 0.1, 1.001, 0.2, 0.1],
    [100.0, 0.3, 1.0, 1.0, 0.3, 1.0, 1.0, 0.31, 1.0],
    [-7.0, 1.0, 1.0, 1e-3, 2e-3, 4e-3, 900.0, -30.0, 800.0],
    [1.0, 0.0, 1e-5, -1.0, 0.1, 1e-5, -1.0, -0.1, 1e-5],
];

/// Vertices nearly opposite to each other, and far from alike in their distance.
const UNEQUAL: [[f32; 9]; 8] = [
    [1.0, 2.0, 0.5, 3e4, -1e4, 2e4, -0.01, 0.02, 0.01],
    [100.0, 1.0, 3.0, -1e-3, 2e-5, -1e-5, 1.0, 50.0, -7.0],
    [1.0, 0.0, 1e-3, -1e5, 2.0, 30.0, 0.3, 1.0, 0.2],
    [0.3, 1.0, 0.2, 1.0, 0.0, 1e-3, -1e5, 2.0, 30.0],
    [-1e5, 2.0, 30.0, 0.3, 1.0, 0.2, 1.0, 0.0, 1e-3],
    [1.0, 0.2, 0.1, -1e3, -200.0, -100.1, 0.1, 0.2, -0.3],
    [0.1, 0.2, -0.3, 1.0, 0.2, 0.1, -1e3, -200.0, -100.1],
    [
        -0.733, 0.0, 0.468, -960.0, -54.0, -293.0, -7.64e-4, -4.27e-4, 8.9e-5,
    ],
];

fn prepared(p: [f32; 9]) -> SphericalTriangle {
    let [a, b, c] = vectors(p);
    spherical_triangle_prepare(a, b, c)
}

fn vertices(p: [f32; 9]) -> [[f64; 3]; 3] {
    vectors(p).map(doubles)
}

/// Girard's theorem in floats, the common formula.
fn girard(p: [f32; 9]) -> f32 {
    let [a, b, c] = vectors(p).map(Vec3::normalize);
    let normals = [a.cross(b), b.cross(c), c.cross(a)].map(Vec3::normalize);
    let angle = |i: usize, j: usize| (-normals[i].dot(normals[j])).clamp(-1.0, 1.0).acos();
    angle(0, 1) + angle(1, 2) + angle(2, 0) - std::f32::consts::PI
}

/// The chord of the longest side.
fn size(p: [f32; 9]) -> f64 {
    let [a, b, c] = vectors(p).map(|v| v.as_dvec3().normalize());
    (a - b).length().max((b - c).length()).max((c - a).length())
}

#[test]
fn extreme_triangles() {
    let all = truth("spherical-triangle");
    for (i, t) in all.iter().enumerate() {
        let mut p = [0.0; 9];
        for (to, from) in p.iter_mut().zip(&t.parameters) {
            *to = *from as f32;
        }
        let triangle = prepared(p);
        let input = format!("spherical-triangle {p:?}");
        if t.quantity == "x" {
            let value = [t.value, all[i + 1].value, all[i + 2].value];
            let got = spherical_triangle(triangle, t.u);
            let error = excess(got, value, size(p));
            assert!(error < 4e-8, "{input} {}: {got}, {value:?}: {error:e}", t.u);
            // The pdf of its own samples, whatever their rounding.
            let pdf = f64::from(spherical_triangle_pdf(triangle, got));
            let area = f64::from(spherical_triangle_solid_angle(triangle));
            assert!((pdf * area - 1.0).abs() < 1e-6, "{input} {}: {pdf}", t.u);
        }
    }
}

#[test]
fn samples_are_those_of_the_judge() {
    for p in TRIANGLES.into_iter().chain(UNEQUAL) {
        let (triangle, vertices, size) = (prepared(p), vertices(p), size(p));
        let mut worst = 0f64;
        for u in random(3000).chain(grid().into_iter().step_by(37)) {
            let got = spherical_triangle(triangle, u);
            let error = excess(got, judge::spherical_triangle(vertices, u.to_array()), size);
            worst = worst.max(error);
            let area = judge::solid_angle(vertices[0], vertices[1], vertices[2]);
            let pdf = spherical_triangle_pdf(triangle, got);
            assert!(ulp_error(pdf, 1.0 / area) < 0.6, "{p:?} {u}: {pdf} {area}");
        }
        println!("{p:?}: {worst:.1e}");
        assert!(worst < 4e-8, "{p:?}: {worst:e}");
    }
}

#[test]
fn the_pdf_integrates_to_one() {
    for p in TRIANGLES {
        // Vertices at one distance, as a far one costs the quadrature many halvings.
        let area = integrated(
            vertices(p).map(|v| {
                let length = v.iter().map(|x| x * x).sum::<f64>().sqrt();
                v.map(|x| x / length)
            }),
            40,
        );
        let pdf = f64::from(spherical_triangle_pdf(
            prepared(p),
            spherical_triangle(prepared(p), uvec2(1 << 31, 1 << 31)),
        ));
        println!("{p:?}: {:e}", pdf * area - 1.0);
        assert!((pdf * area - 1.0).abs() < 1e-6, "{p:?}: {}", pdf * area);
        // Girard's area and a factor of two are no such pdf.
        assert!((2.0 * pdf * area - 1.0).abs() > 1e-5);
    }
    let p = TRIANGLES[2];
    assert!(relative(girard(p).into(), 5e-11) > 0.1);
}

#[test]
fn the_edges_bound_the_pdf() {
    let octant = prepared(TRIANGLES[0]);
    for out in [
        vec3(-0.5, 0.6, 0.624_5),
        vec3(0.577, 0.577, -0.577),
        vec3(-0.577, -0.577, -0.577),
        vec3(-1e-6, 0.7, 0.714),
    ] {
        assert_eq!(spherical_triangle_pdf(octant, out), 0.0, "{out}");
    }
    let small = prepared(TRIANGLES[2]);
    assert_eq!(spherical_triangle_pdf(small, vec3(-1e-11, 5e-6, 1.0)), 0.0);
    assert!(spherical_triangle_pdf(small, vec3(1e-11, 5e-6, 1.0)) > 0.0);
    assert_eq!(
        spherical_triangle_pdf(small, vec3(5.001e-6, 5e-6, 1.0)),
        0.0
    );
}

#[test]
fn inverses_return_the_fractions() {
    for (i, p) in TRIANGLES.into_iter().enumerate() {
        let (triangle, size) = (prepared(p), size(p));
        let thin = judge::solid_angle(vertices(p)[0], vertices(p)[1], vertices(p)[2]) / size;
        let mut worst = [0f64; 2];
        for u in random(3000) {
            let d = spherical_triangle(triangle, u);
            let v = spherical_triangle_invert(triangle, d);
            // The rounding of a direction is this much of the triangle, but around +z.
            let scale = if [2, 3].contains(&i) {
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

/// Counts of samples in cells of equal probability by the judge's inverse, and their deviate.
fn deviation(p: [f32; 9], sample: impl Fn(UVec2) -> Vec3) -> f64 {
    let vertices = vertices(p);
    let mut counts = vec![0; 32 * 32];
    let total = 1_000_000;
    for u in random(total) {
        let [x, y] = judge::spherical_triangle_invert(vertices, doubles(sample(u)));
        let cell = |x: f64| ((x * 32.0) as usize).min(31);
        counts[cell(x) * 32 + cell(y)] += 1;
    }
    deviate(&counts, f64::from(total) / 1024.0)
}

#[test]
fn samples_have_the_density() {
    let all = [0, 2, 4, 6, 7, 8, 11, 12];
    for i in all {
        let p = TRIANGLES[i];
        let triangle = prepared(p);
        let z = deviation(p, |u| spherical_triangle(triangle, u));
        println!("{p:?}: {z:.2}");
        assert!(z < critical(all.len()), "{p:?}: {z}");
    }
    // Uniform on the plane triangle, without the Jacobian.
    let z = deviation(TRIANGLES[7], |u| {
        let [a, b, c] = vectors(TRIANGLES[7]);
        let (root, y) = (unit(u.x).sqrt() as f32, unit(u.y) as f32);
        (a * (1.0 - root) + b * (root * (1.0 - y)) + c * (root * y)).normalize()
    });
    assert!(z > 100.0, "{z}");
}

#[test]
fn degenerate_triangles_give_what_the_header_says() {
    let (inf, nan) = (f32::INFINITY, f32::NAN);
    let flat = [
        [0.0; 9],
        [1.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 0.0, 0.0],
        [0.0, 0.0, 1.0, 1.0, 0.0, 1.0, 2.0, 0.0, 1.0],
        [0.0, 0.0, 0.0, 1.0, 0.0, 1.0, 2.0, 1.0, 1.0],
        // Opposite vertices, whose products are too far apart for 64 bits.
        [-1e6, 1e-6, 1e-12, 1e6, -1e-6, -1e-12, -1e-12, -1e-7, 0.5],
    ];
    for p in flat {
        let triangle = prepared(p);
        assert_eq!(spherical_triangle_solid_angle(triangle), 0.0);
        for u in [uvec2(0, 0), uvec2(1 << 31, 77)] {
            assert_eq!(spherical_triangle(triangle, u), Vec3::Z);
            assert_eq!(spherical_triangle_pdf(triangle, Vec3::Z), 0.0);
            assert_eq!(spherical_triangle_invert(triangle, Vec3::Z), uvec2(0, 0));
        }
        let [a, b, c] = vectors(p);
        let triangle = native::native_spherical_triangle_prepare(a, b, c);
        assert_eq!(
            native::native_spherical_triangle(triangle, uvec2(9, 9)),
            Vec3::Z
        );
        assert_eq!(
            native::native_spherical_triangle_pdf(triangle, Vec3::Z),
            0.0
        );
    }
    // The origin within the triangle: the hemisphere towards a x b.
    let around = [1.0, 0.0, 0.0, -0.5, 0.875, 0.0, -0.5, -0.875, 0.0];
    let triangle = prepared(around);
    assert!(
        ulp_error(
            spherical_triangle_solid_angle(triangle),
            std::f64::consts::TAU
        ) < 1.0
    );
    for u in grid() {
        let d = spherical_triangle(triangle, u);
        assert!((d.length() - 1.0).abs() < 1e-6 && d.z >= -1e-7, "{u}: {d}");
        assert!(spherical_triangle_pdf(triangle, d) > 0.0, "{u}: {d}");
    }
    let odd = [0.0, 1.0, -1.0, 1e-45, 1e38, inf, nan];
    for i in 0..7 * 7 * 7 * 7 {
        let x = [odd[i % 7], odd[i / 7 % 7], odd[i / 49 % 7], odd[i / 343]];
        let p = [x[0], x[1], 1.0, x[2], x[3], x[0], x[1], x[2], -x[3]];
        let triangle = prepared(p);
        let d = spherical_triangle(triangle, uvec2(1 << 31, 1 << 30));
        assert!(d.is_finite(), "{p:?}: {d}");
        assert!(spherical_triangle_pdf(triangle, d).is_finite(), "{p:?}");
        assert!(
            spherical_triangle_solid_angle(triangle).is_finite(),
            "{p:?}"
        );
        let _ = spherical_triangle_invert(triangle, vec3(x[0], x[1], x[2]));
    }
}

#[test]
fn the_native_profile_is_as_right() {
    for p in TRIANGLES {
        let [a, b, c] = vectors(p);
        let (exact, triangle) = (
            prepared(p),
            native::native_spherical_triangle_prepare(a, b, c),
        );
        let mut worst = 0f32;
        let mut worst_pdf = 0f32;
        for u in random(2000) {
            let (got, truth) = (
                native::native_spherical_triangle(triangle, u),
                spherical_triangle(exact, u),
            );
            worst = worst.max((got - truth).length());
            let pdf = native::native_spherical_triangle_pdf(triangle, got)
                / spherical_triangle_pdf(exact, truth);
            worst_pdf = worst_pdf.max((pdf - 1.0).abs());
        }
        println!("{p:?}: {worst:e} {worst_pdf:e}");
        assert!(
            worst < 2e-5 && worst_pdf < 2e-4,
            "{p:?}: {worst:e} {worst_pdf:e}"
        );
    }
}
