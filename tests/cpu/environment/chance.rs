//! Samples against the pdf: chi-square over the texels, and moments of 1/pdf.

use super::significance::{critical, pearson};
use super::support::{Tables, maps};
use corput::environment::Kind;
use corput::glam::{UVec2, UVec3, uvec2, uvec3};
use corput::reference::envmap::envmap_texel;
use corput::reference::random::philox;

const SAMPLES: u32 = 1 << 20;

/// Independent fractions: statistics must not be of the sequence.
fn random(i: u32, seed: u32) -> UVec3 {
    let word = philox(corput::glam::uvec4(i, 0, 0, 0), uvec2(seed, 0x0e71));
    uvec3(word.x, word.y, word.z)
}

/// The normal deviate of Pearson's statistic over blocks of texels that expect at least 40
/// samples, by texels that the directions meet.
fn deviate(tables: &Tables, seed: u32, sample: impl Fn(UVec3) -> UVec2) -> f64 {
    let UVec2 { x, y } = tables.size;
    let mut counts = vec![0u32; (x * y) as usize];
    for i in 0..SAMPLES {
        let texel = sample(random(i, seed));
        counts[(texel.y * x + texel.x) as usize] += 1;
    }
    let mut chi_square = 0.0;
    let mut cells = 0;
    let (mut count, mut expected) = (0.0, 0.0);
    for index in 0..x * y {
        count += f64::from(counts[index as usize]);
        expected += tables.probability(uvec2(index % x, index / x)) * f64::from(SAMPLES);
        if expected >= 40.0 {
            chi_square += (count - expected) * (count - expected) / expected;
            cells += 1;
            (count, expected) = (0.0, 0.0);
        }
    }
    pearson(chi_square, f64::from((cells - 1).max(1)))
}

fn met(tables: &Tables, u: UVec3) -> UVec2 {
    envmap_texel(tables.sample(u).0, tables.size, &tables.edges)
}

#[cfg(feature = "images")]
fn real() -> Vec<super::support::Map> {
    ["sunrise", "studio"]
        .map(|name| {
            let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data");
            let image = corput::image::load_exr(&folder.join(format!("{name}.exr"))).unwrap();
            (name, image.width, image.height, image.texels)
        })
        .into()
}

#[cfg(not(feature = "images"))]
fn real() -> Vec<super::support::Map> {
    Vec::new()
}

#[test]
fn samples_have_the_density_that_the_pdf_says() {
    let all: Vec<_> = maps().into_iter().chain(real()).collect();
    let limit = critical(2 * all.len());
    for (seed, (name, width, height, texels)) in (0..).zip(&all) {
        for kind in [Kind::Hierarchical, Kind::Alias] {
            let tables = Tables::new(*width, *height, texels, kind);
            if tables.size.x * tables.size.y == 1 {
                continue;
            }
            let found = deviate(&tables, 2 * seed + (kind as u32), |u| met(&tables, u));
            println!("{name} {kind:?}: {found:.2} of {limit:.2}");
            assert!(found < limit, "{name} {kind:?}");
        }
    }
}

#[test]
fn a_wrong_density_is_rejected() {
    let (_, width, height, texels) = maps().swap_remove(0);
    let limit = critical(24);
    for kind in [Kind::Hierarchical, Kind::Alias] {
        let tables = Tables::new(width, height, &texels, kind);
        // One column aside, as an off-by-one entry would have it.
        let found = deviate(&tables, 77, |u| {
            let texel = met(&tables, u);
            uvec2((texel.x + 1) % tables.size.x, texel.y)
        });
        assert!(found > 2.0 * limit, "{found}");
        // Rows drawn without their solid angle: uniform over the polar angle.
        let flat = deviate(&tables, 78, |u| {
            let row = (u64::from(u.x) * u64::from(height)) >> 32;
            uvec2(met(&tables, u).x, row as u32)
        });
        assert!(flat > 2.0 * limit, "{flat}");
    }
    // An alias table whose entries are off by one.
    let mut tables = Tables::new(width, height, &texels, Kind::Alias);
    let honest = Tables::new(width, height, &texels, Kind::Alias);
    let first = 3 * height as usize + 2;
    for other in tables.words[first + 1..].iter_mut().step_by(3) {
        *other = (*other + 1) % (width * height);
    }
    let found = deviate(&honest, 79, |u| met(&tables, u));
    assert!(found > 2.0 * limit, "{found}");
}

#[test]
fn the_mean_of_one_over_the_pdf_is_the_sphere() {
    let sphere = 4.0 * std::f64::consts::PI;
    let limit = critical(12);
    for (name, width, height, texels) in maps().into_iter().chain(real()) {
        let bounded = texels.iter().all(|t| t[0] > 1e-3);
        if !bounded {
            continue;
        }
        for kind in [Kind::Hierarchical, Kind::Alias] {
            let tables = Tables::new(width, height, &texels, kind);
            let (mut sum, mut square) = (0.0, 0.0);
            for i in 0..SAMPLES {
                let weight = 1.0 / f64::from(tables.sample(random(i, 99 + kind as u32)).1);
                sum += weight;
                square += weight * weight;
            }
            let n = f64::from(SAMPLES);
            let mean = sum / n;
            let error = ((square / n - mean * mean).max(0.0) / n).sqrt();
            println!("{name} {kind:?}: {mean:.5} +- {error:.5}");
            assert!(
                (mean - sphere).abs() <= limit * error + 1e-6 * sphere,
                "{name}"
            );
        }
    }
}
