//! Integrals: each pdf over its directions is 1, and sampling weights give the albedo that
//! quadrature gives.

use super::lobes::{ALPHAS, GGX, Kind, Lobe, RESTS, VIEWS};
use super::significance::critical;
use corput::glam::{DVec3, Vec3, uvec2, vec2, vec3};
use corput::reference::ggx::{ggx_g1, ggx_g2};
use corput::reference::ggx_lobe::{ggx_prepare, ggx_weight};
use corput::reference::ggx_vndf_bounded::ggx_vndf_bounded_prepare;
use corput::reference::permute::permute_mix as mix;
use std::f64::consts::{PI, TAU};

/// Simpson's rule, halved until the halves agree.
fn adaptive(f: &dyn Fn(f64) -> f64, a: f64, b: f64, tolerance: f64) -> f64 {
    fn step(
        f: &dyn Fn(f64) -> f64,
        a: f64,
        b: f64,
        ends: [f64; 3],
        whole: f64,
        t: f64,
        deep: u32,
    ) -> f64 {
        let m = 0.5 * (a + b);
        let (l, r) = (f(0.5 * (a + m)), f(0.5 * (m + b)));
        let left = (m - a) / 6.0 * (ends[0] + 4.0 * l + ends[1]);
        let right = (b - m) / 6.0 * (ends[1] + 4.0 * r + ends[2]);
        if deep == 0 || (left + right - whole).abs() < 15.0 * t {
            return left + right;
        }
        step(f, a, m, [ends[0], l, ends[1]], left, 0.5 * t, deep - 1)
            + step(f, m, b, [ends[1], r, ends[2]], right, 0.5 * t, deep - 1)
    }
    let ends = [f(a), f(0.5 * (a + b)), f(b)];
    let whole = (b - a) / 6.0 * (ends[0] + 4.0 * ends[1] + ends[2]);
    step(f, a, b, ends, whole, tolerance, 30)
}

fn stretched(alpha: [f32; 2], v: DVec3) -> DVec3 {
    DVec3::new(f64::from(alpha[0]) * v.x, f64::from(alpha[1]) * v.y, v.z)
}

/// The integral of the judge's pdf, times `factor`, over normals or reflected directions, in
/// coordinates that follow the lobe: the unit sphere's directions V' around V, where the
/// normals bisect them.
fn integral(lobe: &Lobe, jacobian: impl Fn(f64) -> f64) -> f64 {
    let judge = lobe.judge();
    let o = Vec3::from(lobe.wo).as_dvec3().normalize();
    let view = stretched(lobe.alpha, o).normalize();
    let area = f64::from(lobe.alpha[0]) * f64::from(lobe.alpha[1]);
    let inner = |theta: f64, phi: f64| {
        // Polar coordinates around V: the normal, whose angle to V is half of theta.
        let side = view.any_orthonormal_vector();
        let other = view.cross(side);
        let n = (0.5 * theta).cos() * view
            + (0.5 * theta).sin() * (phi.cos() * side + phi.sin() * other);
        if n.z <= 0.0 {
            return 0.0;
        }
        let s = stretched(lobe.alpha, n);
        let h = s.normalize();
        // Solid angle: of h per n, and of n per half theta and phi.
        let per_normal = area / s.length().powi(3) * (0.5 * theta).sin() * 0.5;
        if lobe.kind == Kind::Normal {
            return judge.normal_pdf(h.to_array()) * per_normal;
        }
        let wi = 2.0 * o.dot(h) * h - o;
        judge.pdf(wi.to_array()) * jacobian(o.dot(h)) * per_normal
    };
    // Beyond this angle the normals point below the plane.
    let side = view.any_orthonormal_vector();
    let other = view.cross(side);
    let ends = |phi: f64| {
        let rise = phi.cos() * side.z + phi.sin() * other.z;
        match (rise < 0.0, view.z < 0.0) {
            (true, true) => [0.0, 0.0],
            (true, false) => [0.0, 2.0 * (view.z / -rise).atan()],
            (false, true) => [2.0 * (-view.z / rise).atan(), PI],
            (false, false) => [0.0, PI],
        }
    };
    let outer = |phi: f64| {
        let steps = 32;
        let [begin, end] = ends(phi);
        let width = (end - begin) / f64::from(steps);
        // Gauss's rule of five points on each piece.
        const NODES: [(f64, f64); 5] = [
            (0.0, 0.568_888_888_888_888_9),
            (0.538_469_310_105_683_1, 0.478_628_670_499_366_47),
            (-0.538_469_310_105_683_1, 0.478_628_670_499_366_47),
            (0.906_179_845_938_664, 0.236_926_885_056_189_08),
            (-0.906_179_845_938_664, 0.236_926_885_056_189_08),
        ];
        (0..steps)
            .flat_map(|k| NODES.map(|(x, w)| (f64::from(k) + 0.5 + 0.5 * x, w)))
            .map(|(at, w)| 0.5 * width * w * inner(begin + at * width, phi))
            .sum::<f64>()
    };
    // In quarters, at whose ends isotropic lobes have their kinks.
    (0..4)
        .map(|k| {
            let (a, b) = (f64::from(k) * TAU / 4.0, f64::from(k + 1) * TAU / 4.0);
            adaptive(&outer, a, b, 1e-8)
        })
        .sum()
}

#[test]
fn pdfs_of_ggx_integrate_to_one() {
    for kind in GGX.into_iter().filter(|kind| *kind != Kind::Bounded) {
        for alpha in ALPHAS {
            for wo in VIEWS {
                let lobe = Lobe::ggx(kind, alpha, wo);
                let total = integral(&lobe, |cosine| 4.0 * cosine);
                println!("{lobe:?}: {:.1e}", total - 1.0);
                assert!((total - 1.0).abs() < 1e-5, "{lobe:?}: {total}");
            }
        }
    }
    // Seen from below, where few normals show.
    let below = Lobe::ggx(Kind::Vndf, [0.5; 2], [0.8, 0.0, -0.6]);
    let total = integral(&below, |cosine| 4.0 * cosine);
    assert!((total - 1.0).abs() < 1e-5, "{total}");
}

/// A bounded pdf jumps at its rim: the midpoints of a fine grid.
#[test]
fn pdfs_of_bounded_caps_integrate_to_one() {
    for alpha in [[1.0, 1.0], [0.3, 0.3], [0.1, 0.5], [1e-2, 1e-2]] {
        for wo in VIEWS {
            let lobe = Lobe::ggx(Kind::Bounded, alpha, wo);
            let judge = lobe.judge();
            let o = Vec3::from(wo).as_dvec3().normalize();
            let view = stretched(alpha, o).normalize();
            let area = f64::from(alpha[0]) * f64::from(alpha[1]);
            let (rows, columns) = (2000, 64);
            let mut total = 0.0;
            for i in 0..rows {
                let z = 2.0 * (f64::from(i) + 0.5) / f64::from(rows) - 1.0;
                for j in 0..columns {
                    let phi = TAU * (f64::from(j) + 0.5) / f64::from(columns);
                    let radius = (1.0 - z * z).sqrt();
                    let n = view + DVec3::new(radius * phi.cos(), radius * phi.sin(), z);
                    let (unit, s) = (n.normalize(), stretched(alpha, n.normalize()));
                    if n.z <= 0.0 {
                        continue;
                    }
                    let h = s.normalize();
                    let wi = 2.0 * o.dot(h) * h - o;
                    total += judge.pdf(wi.to_array()) * 4.0 * o.dot(h) * area
                        / s.length().powi(3)
                        / (4.0 * view.dot(unit));
                }
            }
            total *= 2.0 * TAU / f64::from(rows * columns);
            println!("{lobe:?}: {:.1e}", total - 1.0);
            // One row of the grid is a two thousandth.
            assert!((total - 1.0).abs() < 1.5e-3, "{lobe:?}: {total}");
        }
    }
}

#[test]
fn pdfs_of_phase_functions_integrate_to_one_and_have_their_mean() {
    for rest in RESTS {
        for backward in [false, true] {
            let lobe = Lobe::henyey_greenstein(rest, backward);
            // 1 - |z| = rest^2 (e^t - 1), which spreads the lobe.
            let scale = f64::from(rest).powi(2);
            let weigh = |power: i32, t: f64| {
                let versine = scale * t.exp_m1();
                let radius = (versine * (2.0 - versine)).max(0.0).sqrt();
                let z = if backward {
                    versine - 1.0
                } else {
                    1.0 - versine
                };
                let pdf = lobe.pdf(vec3(radius as f32, 0.0, z as f32));
                TAU * f64::from(pdf) * z.powi(power) * scale * t.exp()
            };
            let end = (2.0 / scale).ln_1p();
            let total = adaptive(&|t| weigh(0, t), 0.0, end, 1e-7);
            let mean = adaptive(&|t| weigh(1, t), 0.0, end, 1e-7);
            let g = (1.0 - f64::from(rest)) * if backward { -1.0 } else { 1.0 };
            // The same mean by sampling, at the midpoints of a million intervals.
            let count = 1 << 20;
            let sampled = (0..count)
                .map(|i| f64::from(lobe.sample(uvec2((i << 12) + 2048, 0)).direction.z))
                .sum::<f64>()
                / f64::from(count);
            println!(
                "{rest} {backward}: {:.1e} {:.1e} {:.1e}",
                total - 1.0,
                mean - g,
                sampled - g
            );
            assert!((total - 1.0).abs() < 2e-6, "{lobe:?}: {total}");
            assert!((mean - g).abs() < 2e-6, "{lobe:?}: {mean}");
            assert!((sampled - g).abs() < 2e-6, "{lobe:?}: {sampled}");
        }
    }
}

/// A factor of 2, and the pdf of normals taken for that of directions, are seen.
#[test]
fn wrong_pdfs_do_not_integrate_to_one() {
    let lobe = Lobe::ggx(Kind::Vndf, [0.3; 2], VIEWS[1]);
    assert!((integral(&lobe, |cosine| 2.0 * cosine) - 1.0).abs() > 0.4);
    assert!((integral(&lobe, |_| 1.0) - 1.0).abs() > 0.1);
}

/// The albedo of a white microsurface without multiple scattering, by midpoints over the
/// hemisphere: D G2 / (4 cos) with everything by tangents.
fn albedo(alpha: f64, wo: DVec3) -> f64 {
    let lambda = |w: DVec3| {
        let tan = (w.x * w.x + w.y * w.y) / (w.z * w.z);
        0.5 * ((1.0 + alpha * alpha * tan).sqrt() - 1.0)
    };
    let (rows, columns) = (1000, 1000);
    let mut total = 0.0;
    for i in 0..rows {
        let z = (f64::from(i) + 0.5) / f64::from(rows);
        let radius = (1.0 - z * z).sqrt();
        for j in 0..columns {
            let phi = TAU * (f64::from(j) + 0.5) / f64::from(columns);
            let wi = DVec3::new(radius * phi.cos(), radius * phi.sin(), z);
            let h = (wi + wo).normalize();
            let tan = (1.0 - h.z * h.z) / (h.z * h.z);
            let d = 1.0 / (PI * (alpha * h.z * h.z * (1.0 + tan / (alpha * alpha))).powi(2));
            total += d / (1.0 + lambda(wi) + lambda(wo)) / (4.0 * wo.z);
        }
    }
    total * TAU / f64::from(rows * columns)
}

/// Mean and standard error of the weights of samples.
fn sampled(lobe: &Lobe, count: u32) -> (f64, f64) {
    let (alpha, wo) = (vec2(lobe.alpha[0], lobe.alpha[1]), Vec3::from(lobe.wo));
    let g = match lobe.kind {
        Kind::Bounded => ggx_vndf_bounded_prepare(alpha, wo),
        _ => ggx_prepare(alpha, wo),
    };
    let (mut sum, mut squares) = (0.0, 0.0);
    for i in 0..count {
        let u = uvec2(mix(2 * i), mix(2 * i + 1));
        let weight = f64::from(ggx_weight(g, lobe.sample(u).direction));
        sum += weight;
        squares += weight * weight;
    }
    let n = f64::from(count);
    let mean = sum / n;
    (mean, ((squares / n - mean * mean) / n).sqrt())
}

#[test]
fn sampling_weights_give_the_albedo_of_quadrature() {
    let limit = critical(18);
    for alpha in [0.2f32, 0.5, 1.0] {
        for wo in [VIEWS[0], VIEWS[1]] {
            let truth = albedo(alpha.into(), Vec3::from(wo).as_dvec3().normalize());
            let mut errors = Vec::new();
            for kind in [Kind::Vndf, Kind::Cap, Kind::Bounded] {
                let (mean, error) = sampled(&Lobe::ggx(kind, [alpha; 2], wo), 1 << 18);
                let away = (mean - truth).abs() / error;
                println!(
                    "{kind:?} {alpha} {wo:?}: {mean:.5}, not {truth:.5}: {away:.2} of {limit:.2}"
                );
                assert!(away < limit, "{kind:?} {alpha} {wo:?}: {mean} {truth}");
                assert!(mean < 1.0 && truth < 1.0 + 1e-5);
                errors.push(error);
            }
            // Bounded sampling wastes less.
            assert!(errors[2] <= errors[1] * 1.01, "{errors:?}");
        }
    }
    // Another roughness is seen.
    let truth = albedo(0.55, Vec3::from(VIEWS[1]).as_dvec3());
    let (mean, error) = sampled(&Lobe::ggx(Kind::Cap, [0.5; 2], VIEWS[1]), 1 << 18);
    assert!((mean - truth).abs() > limit * error);
}

/// Weights are G2 / G1, and no more than 1.
#[test]
fn weights_are_those_of_smith() {
    for alpha in ALPHAS {
        for wo in VIEWS {
            let lobe = Lobe::ggx(Kind::Cap, alpha, wo);
            let (a, o) = (vec2(alpha[0], alpha[1]), Vec3::from(wo));
            let g = ggx_prepare(a, o);
            for i in 0..2000 {
                let wi = lobe.sample(uvec2(mix(2 * i), mix(2 * i + 1))).direction;
                let weight = f64::from(ggx_weight(g, wi));
                assert!((0.0..=1.0).contains(&weight), "{lobe:?} {wi}");
                let truth = lobe.judge().weight(wi.to_array().map(f64::from));
                assert!(
                    (weight - truth).abs() <= 1e-7 * truth,
                    "{lobe:?} {wi}: {weight} {truth}"
                );
                let ratio = f64::from(ggx_g2(a, o, wi)) / f64::from(ggx_g1(a, o));
                assert!((weight - ratio).abs() <= 3e-7 * weight, "{lobe:?} {wi}");
            }
        }
    }
}

/// Seen along the normal, each half of the directions is as likely; and bounded caps leave
/// fewer below the horizon, none where the lobe is round.
#[test]
fn halves_are_even_and_bounds_hold() {
    let count = 1 << 17;
    let limit = critical(12);
    for kind in GGX {
        for alpha in [[1.0, 1.0], [0.1, 0.5]] {
            let lobe = Lobe::ggx(kind, alpha, VIEWS[0]);
            for axis in 0..2 {
                let positive = (0..count)
                    .filter(|&i| {
                        lobe.sample(uvec2(mix(2 * i), mix(2 * i + 1))).direction[axis] > 0.0
                    })
                    .count() as f64;
                let away = (2.0 * positive - f64::from(count)).abs() / f64::from(count).sqrt();
                assert!(away < limit, "{lobe:?}: {away}");
            }
        }
    }
    for alpha in ALPHAS {
        for wo in VIEWS {
            let below = |kind| {
                let lobe = Lobe::ggx(kind, alpha, wo);
                (0..1u32 << 15)
                    .filter(|&i| lobe.sample(uvec2(mix(2 * i), mix(2 * i + 1))).direction.z < 0.0)
                    .count()
            };
            let (bounded, all) = (below(Kind::Bounded), below(Kind::Cap));
            println!("{alpha:?} {wo:?}: {bounded} below, of {all}");
            assert!(bounded <= all);
            if wo == VIEWS[0] && alpha[0] == alpha[1] {
                assert_eq!(bounded, 0, "{alpha:?}");
            }
        }
    }
}
