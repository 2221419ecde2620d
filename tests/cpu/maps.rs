//! What holds for every map of the catalogue, whatever its distribution.

use corput::bulk::{map_invert, map_pdf, map_sample};
use corput::catalog::{Mapping, Profile, maps};
use corput::check::{examples, fractions, mix, truth};
use std::collections::BTreeSet;

fn mappings() -> Vec<Mapping> {
    let all = maps().flat_map(|map| examples(map).unwrap_or_else(|error| panic!("{error}")));
    all.collect()
}

fn label(mapping: &Mapping) -> String {
    format!("{} {:?}", mapping.map().name, mapping.values())
}

/// Fractions for the map's dimensions; the others are 0, as kernels have them.
fn cut(mapping: &Mapping, mut u: [u32; 3]) -> [u32; 3] {
    u[mapping.map().dimensions as usize..].fill(0);
    u
}

fn coordinates(mapping: &Mapping, words: [u32; 4]) -> [u32; 3] {
    let mut s = [words[0], words[1], words[2]];
    s[mapping.map().coordinates as usize..].fill(0);
    s
}

#[test]
fn names_and_numbers_are_distinct_and_examples_in_their_domains() {
    let names: BTreeSet<_> = maps().map(|map| map.name).collect();
    let ids: BTreeSet<_> = maps().map(|map| map.id).collect();
    let count = maps().count();
    assert_eq!((names.len(), ids.len()), (count, count));
    for map in maps() {
        assert!(!map.examples.is_empty(), "{}", map.name);
        assert!(map.ulp > 0.0 && map.pdf_ulp > 0.0 && map.native > 0.0 && map.native_pdf > 0.0);
        for parameter in map.parameters {
            let default = parameter.default.map_or(parameter.size, <[f64]>::len);
            assert_eq!(default, parameter.size, "{} {}", map.name, parameter.name);
        }
    }
    assert!(!mappings().is_empty());
}

#[test]
fn parameters_that_no_map_can_take_are_refused() {
    for map in maps() {
        let Some(example) = map.examples.first() else {
            continue;
        };
        for i in 0..example.len() {
            let mut values = example.to_vec();
            values[i] = f64::NAN;
            let refused = Mapping::with_values(map, &values).map_err(|error| error.to_string());
            let message = refused
                .err()
                .unwrap_or_else(|| panic!("{} takes NaN", map.name));
            assert!(message.contains(map.name), "{message}");
        }
        let mut values = example.to_vec();
        values.push(0.0);
        assert!(Mapping::with_values(map, &values).is_err(), "{}", map.name);
        assert!(
            Mapping::new(map, &[("no-such", &[1.0])]).is_err(),
            "{}",
            map.name
        );
    }
}

/// The pdf is one over the area that the map makes of the unit of area: by central
/// differences of the judge's sample, in `f64`. The judge's pdf is thereby that of its own
/// samples, and `corput check` holds both profiles to the judge.
#[test]
fn pdf_times_jacobian_is_one() {
    let mut worst: f64 = 0.0;
    for mapping in mappings() {
        let map = mapping.map();
        let mut tried = 0;
        for i in 0..4096 {
            let u = cut(&mapping, [mix(3 * i), mix(3 * i + 1), mix(3 * i + 2)]);
            let Some((pdf, density)) = densities(&mapping, u) else {
                continue;
            };
            tried += 1;
            let error = (density / pdf - 1.0).abs();
            worst = worst.max(error);
            assert!(
                error < 2e-4,
                "{} at {u:08x?}: pdf {pdf}, but samples have density {density}",
                label(&mapping)
            );
        }
        println!("{}: {tried} points", label(&mapping));
        assert!(tried > 256 || map.dimensions == 3, "{}", label(&mapping));
    }
    println!("worst {worst:.1e}");
}

/// A pdf that is wrong by a percent is seen.
#[test]
fn a_wrong_pdf_is_seen() {
    for mapping in mappings() {
        let u = cut(&mapping, [0x5a5a_1234, 0x3b3b_4321, 0]);
        if let Some((pdf, density)) = densities(&mapping, u) {
            let error = (density / (1.01 * pdf) - 1.0).abs();
            assert!(error > 2e-4, "{}", label(&mapping));
        }
    }
}

/// The judge's pdf, and the density that its samples have: `None` where it does not know
/// the map, and at the edges and seams of the unit square and of piecewise maps.
fn densities(mapping: &Mapping, u: [u32; 3]) -> Option<(f64, f64)> {
    let map = mapping.map();
    let (dimensions, width) = (map.dimensions as usize, map.coordinates as usize);
    if dimensions > 2 || dimensions > width {
        return None;
    }
    let (near, far) = (
        difference(mapping, u, 1 << 10)?,
        difference(mapping, u, 1 << 12)?,
    );
    // Where the two steps differ, a seam lies between them, or the map bends too much.
    if (near / far - 1.0).abs() > 1e-5 {
        return None;
    }
    let pdf = truth(mapping, u)?[width];
    (pdf > 0.0).then_some((pdf, 1.0 / near))
}

/// The length or area of the image of a step of 2^-32 `step` to both sides, per unit.
fn difference(mapping: &Mapping, u: [u32; 3], step: u32) -> Option<f64> {
    let map = mapping.map();
    let width = map.coordinates as usize;
    let mut columns = Vec::new();
    for i in 0..map.dimensions as usize {
        let (mut low, mut high) = (u, u);
        low[i] = u[i].checked_sub(step)?;
        high[i] = u[i].checked_add(step)?;
        let (low, high) = (truth(mapping, low)?, truth(mapping, high)?);
        let scale = f64::from(step) * 2.0 / 4_294_967_296.0;
        let mut column = [0.0; 3];
        for k in 0..width {
            column[k] = (high[k] - low[k]) / scale;
        }
        columns.push(column);
    }
    let dot = |a: &[f64; 3], b: &[f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    Some(match &columns[..] {
        [a] => dot(a, a).sqrt(),
        [a, b] => {
            let cross = [
                a[1] * b[2] - a[2] * b[1],
                a[2] * b[0] - a[0] * b[2],
                a[0] * b[1] - a[1] * b[0],
            ];
            dot(&cross, &cross).sqrt()
        }
        _ => return None,
    })
}

/// Samples are finite, their pdf positive or zero, and both profiles take strange
/// coordinates without a NaN in the pdf.
#[test]
fn nothing_is_ever_nan() {
    let strange = [
        0.0,
        -0.0,
        1.0,
        -1.0,
        1e-40,
        1e-20,
        f32::MAX,
        f32::INFINITY,
        f32::NAN,
    ];
    for mapping in mappings() {
        let width = mapping.map().coordinates as usize;
        for u in fractions() {
            let words = map_sample(&mapping, Profile::Exact, cut(&mapping, u));
            let all = words.map(f32::from_bits);
            assert!(
                all[..=width].iter().all(|x| x.is_finite()) && all[width] >= 0.0,
                "{} at {u:08x?}: {all:?}",
                label(&mapping)
            );
        }
        for i in 0..729 {
            let s = [strange[i % 9], strange[i / 9 % 9], strange[i / 81]].map(f32::to_bits);
            let pdf = f32::from_bits(map_pdf(&mapping, Profile::Exact, s));
            assert!(
                pdf.is_finite() && pdf >= 0.0,
                "{} at {s:08x?}: {pdf}",
                label(&mapping)
            );
            let _ = map_invert(&mapping, Profile::Exact, s);
        }
    }
}

/// The inverse gives the fractions back, or, where a direction has lost some of them (the
/// angle at a pole), others that lead to the same sample, or nearest to it.
#[test]
fn the_inverse_leads_back() {
    const NEAR: f64 = 1.0 / (1 << 20) as f64;
    for mapping in mappings() {
        // A direction does not tell three fractions.
        if mapping.map().dimensions == 3 && mapping.map().coordinates == 3 {
            continue;
        }
        let (mut lost, mut worst) = (Vec::new(), 0f64);
        for u in fractions() {
            let u = cut(&mapping, u);
            let s = coordinates(&mapping, map_sample(&mapping, Profile::Exact, u));
            let v = cut(&mapping, map_invert(&mapping, Profile::Exact, s));
            let back = coordinates(&mapping, map_sample(&mapping, Profile::Exact, v));
            let error = turns(u, v).min(distance(s, back));
            worst = worst.max(error);
            if error > NEAR && error > grain(&mapping, v, back) {
                lost.push((u, v, error));
            }
        }
        println!(
            "{}: worst {worst:.1e}, {} lost",
            label(&mapping),
            lost.len()
        );
        assert!(
            lost.is_empty(),
            "{}: {:x?}",
            label(&mapping),
            &lost[..lost.len().min(3)]
        );
    }
}

/// How far the samples of the fractions next to v are from its own: no inverse is finer.
fn grain(mapping: &Mapping, v: [u32; 3], back: [u32; 3]) -> f64 {
    let beside = |x: u32| {
        let u = cut(mapping, [x, v[1], v[2]]);
        distance(
            back,
            coordinates(mapping, map_sample(mapping, Profile::Exact, u)),
        )
    };
    beside(v[0].saturating_sub(1)).max(beside(v[0].saturating_add(1)))
}

/// The largest difference of two fractions, modulo one.
fn turns(u: [u32; 3], v: [u32; 3]) -> f64 {
    let differences = u.iter().zip(v).map(|(&a, b)| {
        let difference = a.wrapping_sub(b);
        f64::from(difference.min(difference.wrapping_neg())) / 4_294_967_296.0
    });
    differences.fold(0.0, f64::max)
}

/// The distance of two samples, relative to the length of the first.
fn distance(s: [u32; 3], t: [u32; 3]) -> f64 {
    let norm = |p: [f64; 3]| p.iter().map(|x| x * x).sum::<f64>().sqrt();
    let (p, q) = (s.map(wide), t.map(wide));
    norm([p[0] - q[0], p[1] - q[1], p[2] - q[2]]) / norm(p).max(f64::MIN_POSITIVE)
}

fn wide(word: u32) -> f64 {
    f64::from(f32::from_bits(word))
}

/// Coordinates that no sample has, and some that are nearly one's.
const STRANGE: [f32; 20] = [
    0.0,
    -0.0,
    1e-45,
    1e-38,
    1e-30,
    1e-10,
    -1e-10,
    6e-8,
    -0.3,
    0.6,
    0.8,
    1.0,
    -1.0,
    2.0,
    1e20,
    -1e20,
    f32::MAX,
    f32::INFINITY,
    f32::NEG_INFINITY,
    f32::NAN,
];

#[test]
fn a_pdf_is_never_nan_nor_negative() {
    for mapping in mappings() {
        for profile in [Profile::Exact, Profile::Native] {
            for i in 0..20 * 20 * 20 {
                let at = [i % 20, i / 20 % 20, i / 400].map(|k| STRANGE[k]);
                let pdf = f32::from_bits(map_pdf(&mapping, profile, at.map(f32::to_bits)));
                assert!(pdf >= 0.0, "{} {profile:?} {at:?}: {pdf}", label(&mapping));
                // An infinite coordinate may have an infinite cosine.
                let bounded = pdf.is_finite() || at.iter().any(|x| !x.is_finite());
                assert!(bounded, "{} {profile:?} {at:?}: {pdf}", label(&mapping));
                let _ = map_invert(&mapping, profile, at.map(f32::to_bits));
            }
        }
    }
}

/// Views along the surface, where half of the normals are perpendicular to them.
#[test]
fn a_sample_is_finite_at_the_horizon() {
    for map in maps() {
        let (Some(wo), Some(alpha)) = (
            map.parameters.iter().position(|one| one.name == "wo"),
            map.parameters.iter().position(|one| one.name == "alpha"),
        ) else {
            continue;
        };
        assert!((alpha, wo) == (0, 2));
        for alpha in [1e-6, 0.5, 1e3] {
            let mapping =
                Mapping::with_values(map, &[alpha, 0.0, 1.0, 0.0, 0.0]).expect("in domain");
            for profile in [Profile::Exact, Profile::Native] {
                for u in fractions() {
                    let words = map_sample(&mapping, profile, u).map(f32::from_bits);
                    assert!(
                        words.iter().all(|x| x.is_finite()),
                        "{} {profile:?} {u:x?}: {words:?}",
                        label(&mapping)
                    );
                }
            }
        }
    }
}
