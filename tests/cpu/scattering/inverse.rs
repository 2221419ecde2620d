//! Inverses lead back, at the edges too, and the native profile keeps to its bounds.

use super::lobes::{Kind, fractions, lobes};
use corput::bulk::map_sample;
use corput::catalog::{Group, Profile, maps};
use corput::check::{examples, truth};
use corput::glam::{UVec2, uvec2};

/// How far v is from u: in u.x, and in u.y modulo one.
fn apart(u: UVec2, v: UVec2) -> [f64; 2] {
    let turn = u.y.wrapping_sub(v.y);
    [u.x.abs_diff(v.x), turn.min(turn.wrapping_neg())].map(|x| f64::from(x) / 4_294_967_296.0)
}

/// A grid within the square, and its edges.
fn grid() -> impl Iterator<Item = UVec2> {
    (1..64u32).flat_map(|x| (0..64u32).map(move |y| uvec2(x << 26, (y << 26) + 12345)))
}

#[test]
fn inverses_give_the_fractions_back() {
    for lobe in lobes() {
        // Rounding moves a direction by 2^-24, a normal in units of the lobe by that over
        // alpha, and more where the sum of both directions is short.
        let alpha = f64::from(lobe.alpha[0].min(lobe.alpha[1]));
        let mut worst = 0f64;
        for u in grid() {
            let s = lobe.sample(u);
            let [x, y] = apart(u, lobe.invert(s.direction));
            let short = match lobe.kind {
                Kind::HenyeyGreenstein | Kind::Normal => 1.0,
                _ => f64::from((s.direction + corput::glam::Vec3::from(lobe.wo)).length()),
            };
            let bound = match lobe.kind {
                Kind::HenyeyGreenstein => f64::powi(2.0, -22),
                Kind::Normal => f64::powi(2.0, -19) / lobe.cosine(s.direction).max(1e-3),
                _ => f64::powi(2.0, -20) + f64::powi(2.0, -21) / (alpha * short),
            };
            // Near the centre the angle is worth its radius.
            let radius = (f64::from(u.x) / 4_294_967_296.0).sqrt();
            worst = worst.max(x / bound).max(y * radius / bound);
        }
        println!("{lobe:?}: {worst:.2e} of its bound");
        assert!(worst < 1.0, "{lobe:?}: {worst}");
    }
}

/// At the edges fractions may be lost, but what comes back gives the same direction, or one
/// nearer to it than those of the next fractions are.
#[test]
fn at_the_edges_inverses_give_the_same_direction() {
    for lobe in lobes() {
        for u in fractions(500) {
            let d = lobe.sample(u).direction;
            // Rounding may take a normal below the horizon, where no fractions lead.
            let reflects = !matches!(lobe.kind, Kind::HenyeyGreenstein | Kind::Normal);
            if reflects && d.z + lobe.wo[2] < 2e-7 {
                continue;
            }
            let v = lobe.invert(d);
            let back = lobe.sample(v).direction;
            let beside = |x: u32| (lobe.sample(uvec2(x, v.y)).direction - back).length();
            let grain = beside(v.x.saturating_sub(1)).max(beside(v.x.saturating_add(1)));
            let away = (back - d).length();
            assert!(away < grain.max(2e-6), "{lobe:?} {u}: {d} {back}");
        }
    }
}

#[test]
fn the_native_profile_keeps_to_its_bounds() {
    let groups = [Group::Phase, Group::Ggx, Group::GgxCap, Group::Beckmann];
    for map in maps().filter(|map| groups.contains(&map.group)) {
        let (mut coordinate, mut pdf) = (0f64, 0f64);
        for mapping in examples(map).expect("examples in their domains") {
            for u in fractions(4000) {
                let u = [u.x, u.y, 0];
                let Some(truth) = truth(&mapping, u) else {
                    continue;
                };
                let got = map_sample(&mapping, Profile::Native, u)
                    .map(|word| f64::from(f32::from_bits(word)));
                for k in 0..3 {
                    coordinate = coordinate.max((got[k] - truth[k]).abs());
                }
                pdf = pdf.max((got[3] / truth[3] - 1.0).abs());
            }
        }
        println!(
            "{}: {coordinate:.1e} of {}, {pdf:.1e} of {}",
            map.name, map.native, map.native_pdf
        );
        assert!(coordinate < map.native, "{}: {coordinate:e}", map.name);
        assert!(pdf < map.native_pdf, "{}: {pdf:e}", map.name);
    }
}
