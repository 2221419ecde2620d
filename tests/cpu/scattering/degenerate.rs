//! What GLSL gets that nothing refuses: no NaN, no infinity, and what the headers say.

use super::lobes::{GGX, Kind, Lobe, fractions};
use corput::glam::{Vec3, uvec2, vec2, vec3};
use corput::reference::beckmann::*;
use corput::reference::ggx::*;
use corput::reference::ggx_lobe::{ggx_prepare, ggx_weight};
use corput::reference::henyey_greenstein::*;
use corput::reference::reflect::{reflect, refract};

/// Numbers that no parameter should be, and some that it may.
const STRANGE: [f32; 14] = [
    0.0,
    -0.0,
    1e-45,
    1e-38,
    -0.3,
    0.3,
    1.0,
    -1.0,
    1e20,
    f32::MAX,
    f32::MIN,
    f32::INFINITY,
    f32::NEG_INFINITY,
    f32::NAN,
];

fn vectors() -> Vec<[f32; 3]> {
    let mut list = Vec::new();
    for x in STRANGE {
        for (y, z) in [
            (0.0, 1.0),
            (0.0, -1.0),
            (0.0, 0.0),
            (x, x),
            (1.0, x),
            (x, -x),
        ] {
            list.push([x, y, z]);
            list.push([0.0, y, x]);
        }
    }
    list
}

fn finite(values: &[f32], what: &dyn Fn() -> String) {
    assert!(
        values.iter().all(|x| x.is_finite()),
        "{}: {values:?}",
        what()
    );
}

#[test]
fn no_parameter_and_no_direction_gives_nan_or_infinity() {
    let edges = [
        uvec2(0, 0),
        uvec2(u32::MAX, u32::MAX),
        uvec2(1 << 31, 3 << 29),
    ];
    for alpha in STRANGE {
        for wo in vectors() {
            for kind in GGX {
                let lobe = Lobe::ggx(kind, [alpha, 0.3], wo);
                for u in edges {
                    let s = lobe.sample(u);
                    let [x, y, z] = s.direction.to_array();
                    finite(&[x, y, z, s.pdf], &|| format!("{lobe:?} {u}"));
                    assert!(
                        s.pdf >= 0.0 && s.direction.length() < 1.000_001,
                        "{lobe:?} {u} {s:?}"
                    );
                    let pdf = lobe.pdf(s.direction);
                    finite(&[pdf], &|| format!("{lobe:?} {s:?}"));
                    let _ = lobe.invert(s.direction);
                }
            }
            let (a, o) = (vec2(alpha, 0.3), Vec3::from(wo));
            let s = beckmann(a, o, edges[2]);
            let [x, y, z] = s.direction.to_array();
            finite(&[x, y, z, s.pdf], &|| format!("beckmann {a} {o}"));
            for d in vectors().into_iter().step_by(7).map(Vec3::from) {
                let g = ggx_prepare(a, o);
                finite(
                    &[
                        ggx_weight(g, d),
                        ggx_distribution(a, d),
                        ggx_lambda(a, d),
                        ggx_g1(a, d),
                        ggx_g2(a, o, d),
                        beckmann_pdf(a, o, d),
                        beckmann_normal_pdf(a, d),
                    ],
                    &|| format!("{a} {o} {d}"),
                );
                for lobe in GGX.map(|kind| Lobe::ggx(kind, [alpha, 0.3], wo)) {
                    finite(&[lobe.pdf(d)], &|| format!("{lobe:?} {d}"));
                    let _ = (lobe.invert(d), beckmann_invert(a, o, d));
                }
                for bent in [reflect(o, d), refract(o, d, alpha)] {
                    let [x, y, z] = bent.direction.to_array();
                    finite(&[x, y, z, bent.jacobian], &|| format!("{o} {d} {alpha}"));
                }
            }
        }
    }
    for g in STRANGE {
        for h in [
            henyey_greenstein_prepare(g),
            henyey_greenstein_complement(g, true),
        ] {
            for u in fractions(0) {
                let s = henyey_greenstein(h, u);
                let [x, y, z] = s.direction.to_array();
                finite(&[x, y, z, s.pdf], &|| format!("{g} {u}"));
            }
            for d in vectors() {
                finite(&[henyey_greenstein_pdf(h, d.into())], &|| {
                    format!("{g} {d:?}")
                });
                let _ = henyey_greenstein_invert(h, d.into());
            }
        }
    }
}

/// What the headers say of degenerate inputs.
#[test]
fn degenerate_inputs_count_as_documented() {
    let top = 1.0 - f32::EPSILON / 2.0;
    for (g, like) in [(1.0, top), (2.0, top), (-1.0, -top), (f32::INFINITY, top)] {
        assert_eq!(
            henyey_greenstein_prepare(g),
            henyey_greenstein_prepare(like)
        );
    }
    assert_eq!(
        henyey_greenstein_complement(0.0, false),
        henyey_greenstein_complement(1e-30, false)
    );
    assert_eq!(
        henyey_greenstein_prepare(0.75),
        henyey_greenstein_complement(0.25, false)
    );
    let oblique = vec3(0.8, 0.0, 0.6);
    let lobe = |alpha: f32, wo| ggx_prepare(vec2(alpha, alpha), wo);
    assert_eq!(lobe(-0.3, oblique), lobe(0.3, oblique));
    assert_eq!(lobe(0.0, oblique), lobe(1e-30, oblique));
    for u in fractions(200) {
        let zero = Lobe::ggx(Kind::Cap, [0.3; 2], [0.0; 3]).sample(u);
        let above = Lobe::ggx(Kind::Cap, [0.3; 2], [0.0, 0.0, 1.0]).sample(u);
        assert!((zero.direction - above.direction).length() < 2e-7, "{u}");
        assert!((zero.pdf / above.pdf - 1.0).abs() < 2e-7, "{u}");
        // A mirror.
        for kind in [Kind::Vndf, Kind::Cap, Kind::Bounded] {
            let s = Lobe::ggx(kind, [0.0; 2], oblique.into()).sample(u);
            let mirror = vec3(-0.8, 0.0, 0.6);
            let grazing = u.x > 0xffff_fff0 || u.x < 16;
            assert!(
                grazing || (s.direction - mirror).length() < 1e-6,
                "{kind:?} {u} {s:?}"
            );
            // Nothing is seen from straight below.
            let s = Lobe::ggx(kind, [0.3; 2], [0.0, 0.0, -1.0]).sample(u);
            assert_eq!((s.direction, s.pdf), (Vec3::Z, 0.0), "{kind:?} {u}");
        }
        // Masking is complete at the horizon and below.
        let (x, y) = (u.x as f32, u.y as f32);
        assert_eq!(ggx_g1(vec2(0.3, 0.3), vec3(x, y, -1.0)), 0.0);
        assert_eq!(ggx_g1(vec2(0.3, 0.3), vec3(x, y, 0.0)), 0.0);
        assert_eq!(ggx_lambda(vec2(0.3, 0.3), vec3(x, y, 0.0)), f32::MAX);
    }
    assert_eq!(reflect(Vec3::X, Vec3::Z).jacobian, f32::MAX);
    assert_eq!(refract(oblique, Vec3::Z, 1.0).jacobian, f32::MAX);
    for (w, eta) in [
        (oblique, 0.79),
        (oblique, -1.5),
        (oblique, 0.0),
        (Vec3::ZERO, 1.5),
    ] {
        let bent = refract(w, Vec3::Z, eta);
        assert_eq!(
            (bent.direction, bent.jacobian),
            (Vec3::ZERO, 0.0),
            "{w} {eta}"
        );
    }
}
