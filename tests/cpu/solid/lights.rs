//! Lights: spheres and disks.

use super::tools::{Truth, doubles, grid, random, relative, truth, turn_distance, unit};
use corput::glam::{Vec3, uvec2, vec3};
use corput::judge::{lights as judge, ulp_error};
use corput::reference::disk_light::*;
use corput::reference::native::disk_light as native_disk;
use corput::reference::native::sphere_light as native_sphere;
use corput::reference::sphere_light::*;

/// Centres and radii: ordinary, far, near, around the receiver, on its surface.
const SPHERES: [[f32; 4]; 9] = [
    [1.0, 2.0, 3.0, 1.0],
    [0.0, 0.0, 1.0, 1e-3],
    [0.0, 0.0, -1e4, 1.0],
    [3.0, 4.0, 12.0, 1e-2],
    [0.0, 0.0, 1.0, 0.999_999_9],
    [0.0, 3.0, 4.0, 5.0],
    [0.1, 0.2, 0.3, 5.0],
    [0.0, 0.0, 0.0, 1.0],
    [1e-3, -1e-3, -1.0, 0.3],
];

/// Centres, normals, radii.
const DISKS: [[f32; 7]; 6] = [
    [0.0, 0.0, 2.0, 0.0, 0.0, 1.0, 1.0],
    [0.0, 0.0, 1.0, 0.0, 0.0, -1.0, 1e-4],
    [1.0, 2.0, 3.0, 1.0, 0.0, -0.3, 10.0],
    [1.0, 0.0, 1e-2, 0.0, 0.0, 1.0, 0.5],
    [3.0, 4.0, 12.0, 1e-3, 0.0, -1.0, 0.1],
    [-5.0, 1.0, 2.0, 3.0, 2.0, 1.0, 0.5],
];

fn sphere([x, y, z, r]: [f32; 4]) -> SphereLight {
    sphere_light_prepare(vec3(x, y, z), r)
}

fn disk(p: [f32; 7]) -> DiskLight {
    disk_light_prepare(vec3(p[0], p[1], p[2]), vec3(p[3], p[4], p[5]), p[6])
}

/// The worst error of a coordinate in ULP, those below `floor` counted in its ULP.
fn ulps(got: Vec3, truth: [f64; 3], floor: f64) -> f64 {
    let all = got.to_array().into_iter().zip(truth);
    all.map(|(got, truth)| {
        let magnitude = truth.abs().max(floor);
        let exponent = (magnitude.to_bits() >> 52) as i32 - 1023;
        (f64::from(got) - truth).abs() / f64::powi(2.0, exponent - 23)
    })
    .fold(0.0, f64::max)
}

/// Directions and pdf of three coordinates and a pdf that follow each other.
fn grouped(all: &[Truth]) -> impl Iterator<Item = (&Truth, [f64; 3])> {
    all.chunks(4).map(|t| {
        assert_eq!(t[0].quantity, "pdf");
        (&t[0], [t[1].value, t[2].value, t[3].value])
    })
}

fn floats<const N: usize>(t: &Truth) -> [f32; N] {
    std::array::from_fn(|i| t.parameters[i] as f32)
}

#[test]
fn extreme_lights() {
    for (t, direction) in grouped(&truth("sphere-light")) {
        let p: [f32; 4] = floats(t);
        let got = sphere_light(sphere(p), t.u);
        let input = format!("sphere-light {p:?}, u = {}", t.u);
        assert!(
            ulps(got, direction, 2f64.powi(-5)) < 0.7,
            "{input}: {got} {direction:?}"
        );
    }
    for (t, direction) in grouped(&truth("disk-light")) {
        let p: [f32; 7] = floats(t);
        let light = disk(p);
        let got = disk_light(light, t.u);
        let input = format!("disk-light {p:?}, u = {}", t.u);
        let error = relative(got.pdf.into(), t.value);
        assert!(error < 1e-7, "{input}: {} {}", got.pdf, t.value);
        let ulps = ulps(got.direction, direction, 0.5);
        assert!(
            ulps < 0.7,
            "{input}: {} {direction:?}: {ulps}",
            got.direction
        );
        let again = disk_light_pdf(light, got.direction);
        assert!(
            relative(again.into(), t.value) < 1e-2,
            "{input}: {again} {}",
            t.value
        );
    }
}

#[test]
fn samples_are_those_of_the_judge() {
    for p in SPHERES {
        let light = sphere(p);
        let center = doubles(vec3(p[0], p[1], p[2]));
        for u in random(3000).chain(grid().into_iter().step_by(37)) {
            let got = sphere_light(light, u);
            let (truth, pdf) = judge::sphere_light(center, p[3].into(), u.to_array());
            let error = ulps(got, truth, 2f64.powi(-5));
            assert!(error < 0.7, "{p:?} {u}: {got} {truth:?}: {error}");
            let ours = sphere_light_pdf(light, got);
            assert!(ulp_error(ours, pdf) < 0.6, "{p:?} {u}: {ours} {pdf}");
        }
    }
    for p in DISKS {
        let light = disk(p);
        let (center, normal) = (
            doubles(vec3(p[0], p[1], p[2])),
            doubles(vec3(p[3], p[4], p[5])),
        );
        for u in random(3000).chain(grid().into_iter().step_by(37)) {
            let got = disk_light(light, u);
            let (truth, pdf) = judge::disk_light(center, normal, p[6].into(), u.to_array());
            // The rounding of the unit disk's point, over the distance.
            let plane = normal
                .iter()
                .zip(center)
                .map(|(n, c)| n * c)
                .sum::<f64>()
                .abs()
                / normal.iter().map(|n| n * n).sum::<f64>().sqrt();
            let distance = (pdf * std::f64::consts::PI * f64::from(p[6]).powi(2) * plane).cbrt();
            let bound = 1.0 + 2.0 * f64::from(p[6]) / distance;
            let error = ulps(got.direction, truth, 0.25);
            assert!(
                error < bound,
                "{p:?} {u}: {} {truth:?}: {error}",
                got.direction
            );
            assert!(
                ulp_error(got.pdf, pdf) < bound,
                "{p:?} {u}: {} {pdf}",
                got.pdf
            );
            let ours = disk_light_pdf(light, got.direction);
            assert!(relative(ours.into(), pdf) < 1e-3, "{p:?} {u}: {ours} {pdf}");
        }
    }
}

#[test]
fn edges_bound_the_pdf() {
    let light = sphere([0.0, 0.0, 2.0, 1.0]);
    let at = |theta: f32| sphere_light_pdf(light, vec3(theta.sin(), 0.0, theta.cos()));
    let edge = std::f32::consts::FRAC_PI_6;
    assert!(at(edge - 1e-6) > 0.0 && at(edge + 2e-6) == 0.0);
    assert_eq!(sphere_light_pdf(light, -Vec3::Z), 0.0);
    let light = disk([0.0, 0.0, 2.0, 0.0, 0.0, 1.0, 1.0]);
    let at = |x: f32| disk_light_pdf(light, vec3(x, 0.0, 2.0).normalize());
    assert!(at(0.999_999) > 0.0 && at(1.000_01) == 0.0);
    assert_eq!(disk_light_pdf(light, -Vec3::Z), 0.0);
}

#[test]
fn inverses_return_the_fractions() {
    for p in SPHERES {
        let light = sphere(p);
        // The rounding of a direction, as a part of the half angle; around the axis z the
        // coordinates of a small one have all their digits.
        let wide = if p[0] == 0.0 {
            1.0
        } else {
            (p[3] / vec3(p[0], p[1], p[2]).length()).min(1.0)
        };
        for u in random(3000) {
            let v = sphere_light_invert(light, sphere_light(light, u));
            let far = (unit(u.x) * (1.0 - unit(u.x))).sqrt() * f64::from(wide);
            let error = (unit(u.x) - unit(v.x)).abs() * f64::from(wide);
            assert!(error < 1e-6, "{p:?} {u}: {v}");
            assert!(turn_distance(u.y, v.y) * far < 1e-6, "{p:?} {u}: {v}");
        }
    }
    for p in DISKS {
        let light = disk(p);
        for u in random(3000) {
            let d = disk_light(light, u).direction;
            let back = disk_light(light, disk_light_invert(light, d)).direction;
            assert!((d - back).length() < 1e-6, "{p:?} {u}: {d} {back}");
        }
    }
}

/// One over the pdf has the mean of the solid angle, that of the disk's being known on its
/// axis: 2 pi (1 - cos).
#[test]
fn disks_have_their_solid_angle() {
    let light = disk([0.0, 0.0, 2.0, 0.0, 0.0, 1.0, 1.0]);
    let total = 1 << 16;
    let mean = random(total)
        .map(|u| 1.0 / f64::from(disk_light(light, u).pdf))
        .sum::<f64>()
        / f64::from(total);
    let truth = std::f64::consts::TAU * (1.0 - 2.0 / 5f64.sqrt());
    assert!(
        (mean / truth - 1.0).abs() < 5.0 * 0.12 / f64::from(total).sqrt(),
        "{mean} {truth}"
    );
    // Without the cosine, or the distance, it is not.
    let without = random(total).map(|u| {
        1.0 / f64::from(disk_light(light, u).pdf) / f64::from(disk_light(light, u).direction.z)
    });
    let mean = without.sum::<f64>() / f64::from(total);
    assert!((mean / truth - 1.0).abs() > 0.03, "{mean} {truth}");
}

#[test]
fn degenerate_lights_give_what_the_headers_say() {
    let odd = [0.0, -0.0, 1.0, -1.0, 1e-45, 1e38, f32::INFINITY, f32::NAN];
    let u = uvec2(1 << 30, 1 << 29);
    for i in 0..8 * 8 * 8 * 8 {
        let x = [odd[i % 8], odd[i / 8 % 8], odd[i / 64 % 8], odd[i / 512]];
        let light = sphere(x);
        let d = sphere_light(light, u);
        assert!(
            d.is_finite() && sphere_light_pdf(light, d).is_finite(),
            "{x:?}: {d}"
        );
        let _ = sphere_light_invert(light, d);
        let light = disk([x[0], x[1], x[2], x[1], x[3], x[0], x[3]]);
        let d = disk_light(light, u);
        assert!(d.direction.is_finite() && d.pdf.is_finite(), "{x:?}: {d:?}");
        assert!(disk_light_pdf(light, d.direction).is_finite(), "{x:?}");
        let _ = disk_light_invert(light, d.direction);
    }
    for r in [0.0, -1.0] {
        let light = sphere([0.0, 3.0, 4.0, r]);
        assert!((sphere_light(light, u) - vec3(0.0, 0.6, 0.8)).length() < 1e-7);
        assert_eq!(sphere_light_pdf(light, sphere_light(light, u)), 0.0);
    }
    for p in [
        [1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0],
        [1.0, 1.0, 1.0, 0.0, 0.0, 1.0, 0.0],
        [1.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0],
    ] {
        let d = disk_light(disk(p), u);
        assert_eq!(
            (d.pdf, disk_light_pdf(disk(p), d.direction)),
            (0.0, 0.0),
            "{p:?}"
        );
    }
}

#[test]
fn the_native_profile_is_as_right() {
    for p in SPHERES {
        let light = native_sphere::native_sphere_light_prepare(vec3(p[0], p[1], p[2]), p[3]);
        for u in random(2000) {
            let got = native_sphere::native_sphere_light(light, u);
            let exact = sphere_light(sphere(p), u);
            assert!((got - exact).length() < 2e-6, "{p:?} {u}: {got} {exact}");
            let ratio = native_sphere::native_sphere_light_pdf(light, got)
                / sphere_light_pdf(sphere(p), exact);
            assert!((ratio - 1.0).abs() < 3e-3, "{p:?} {u}: {ratio}");
        }
    }
    for p in DISKS {
        let light = native_disk::native_disk_light_prepare(
            vec3(p[0], p[1], p[2]),
            vec3(p[3], p[4], p[5]),
            p[6],
        );
        for u in random(2000) {
            let got = native_disk::native_disk_light(light, u);
            let exact = disk_light(disk(p), u);
            assert!(
                (got.direction - exact.direction).length() < 2e-6,
                "{p:?} {u}"
            );
            assert!((got.pdf / exact.pdf - 1.0).abs() < 1e-5, "{p:?} {u}");
            let ratio = native_disk::native_disk_light_pdf(light, got.direction) / exact.pdf;
            assert!((ratio - 1.0).abs() < 2e-3, "{p:?} {u}: {ratio}");
        }
    }
}
