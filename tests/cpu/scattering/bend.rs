//! Reflection and refraction: Snell's law, and Jacobians by finite differences in `f64`.

use corput::glam::{DVec3, Vec3, vec3};
use corput::reference::permute::permute_mix as mix;
use corput::reference::reflect::{reflect, refract};

fn unit(i: u32) -> f32 {
    (mix(i) >> 8) as f32 / 16_777_216.0 * 2.0 - 1.0
}

/// A direction near +z, and a normal within sight of it.
fn pairs() -> impl Iterator<Item = (Vec3, Vec3)> {
    (0..2000).map(|i| {
        let w = vec3(unit(6 * i), unit(6 * i + 1), 1.0).normalize();
        let h = vec3(0.7 * unit(6 * i + 2), 0.7 * unit(6 * i + 3), 1.0).normalize();
        (w, if i % 3 == 0 { -h } else { h })
    })
}

fn reflected(w: DVec3, h: DVec3) -> DVec3 {
    2.0 * w.dot(h) * h - w
}

/// Walter et al. 2007, eq. 40, with the square root of the right number.
fn refracted(w: DVec3, h: DVec3, eta: f64) -> DVec3 {
    let (c, r) = (w.dot(h), 1.0 / eta);
    let k = r * c - c.signum() * (1.0 + r * r * (c * c - 1.0)).sqrt();
    k * h - r * w
}

/// Solid angle of normals per solid angle of directions, by central differences.
fn jacobian(h: DVec3, direction: impl Fn(DVec3) -> DVec3) -> f64 {
    let side = h.any_orthonormal_vector();
    let other = h.cross(side);
    let step = 1e-5;
    let column = |t: DVec3| {
        let at = |sign: f64| direction((h + sign * step * t).normalize());
        (at(1.0) - at(-1.0)) / (2.0 * step)
    };
    1.0 / column(side).cross(column(other)).length()
}

/// The worst errors of direction and Jacobian, for a Jacobian times `factor`.
fn worst(eta: Option<f32>, factor: f64) -> (f64, f64) {
    let mut worst = (0f64, 0f64);
    for (w, h) in pairs() {
        let (o, n) = (w.as_dvec3().normalize(), h.as_dvec3().normalize());
        let (bent, truth, change) = match eta {
            None => (
                reflect(w, h),
                reflected(o, n),
                jacobian(n, |n| reflected(o, n)),
            ),
            Some(eta) => {
                let index = f64::from(eta);
                (
                    refract(w, h, eta),
                    refracted(o, n, index),
                    jacobian(n, |n| refracted(o, n, index)),
                )
            }
        };
        let sine = o.cross(n).length();
        // Near total reflection the Jacobian's own differences are not small.
        if o.dot(n).abs() < 0.05 || eta.is_some_and(|eta| sine > 0.95 * f64::from(eta)) {
            continue;
        }
        worst.0 = worst.0.max((bent.direction.as_dvec3() - truth).length());
        worst.1 = worst
            .1
            .max((factor * f64::from(bent.jacobian) / change - 1.0).abs());
    }
    worst
}

#[test]
fn directions_and_jacobians_are_those_of_finite_differences() {
    for eta in [None, Some(1.5), Some(1.0 / 1.5), Some(1.001), Some(2.4)] {
        let (direction, change) = worst(eta, 1.0);
        println!("{eta:?}: direction {direction:.1e}, Jacobian {change:.1e}");
        assert!(direction < 1.2e-7, "{eta:?}: {direction:e}");
        assert!(change < 1e-6, "{eta:?}: {change:e}");
    }
}

#[test]
fn a_jacobian_without_its_factor_is_seen() {
    assert!(worst(None, 4.0).1 > 1.0);
    assert!(worst(Some(1.5), 1.0 / 2.25).1 > 0.1);
}

#[test]
fn total_reflection_begins_at_the_critical_angle() {
    for i in 1..1000 {
        let sine = i as f32 / 1000.0;
        let w = vec3(sine, 0.0, (1.0 - sine * sine).sqrt());
        let exact = f64::from(w.x) / w.as_dvec3().length();
        let bent = refract(w, Vec3::Z, 0.7);
        if (exact - f64::from(0.7f32)).abs() > 1e-7 {
            assert_eq!(bent.jacobian == 0.0, exact > f64::from(0.7f32), "{w}");
        }
    }
}
