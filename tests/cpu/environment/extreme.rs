//! Maps at the extremes: black, one hot texel, texels that are no light, all alike.

use super::support::{Tables, fractions};
use corput::environment::{Counts, Environment, Kind, Options, Repairs, Weight, repair};
use corput::glam::uvec2;

fn build(width: u32, height: u32, texels: &[[f32; 3]], options: Options) -> Environment {
    Environment::new(width, height, texels, options).unwrap()
}

const KINDS: [Kind; 2] = [Kind::Hierarchical, Kind::Alias];

fn of(kind: Kind) -> Options {
    Options {
        kind,
        ..Options::default()
    }
}

#[test]
fn a_black_map_is_the_uniform_sphere() {
    for kind in KINDS {
        let environment = build(64, 32, &[[0.0; 3]; 2048], of(kind));
        let counts = environment.counts();
        assert!(counts.black);
        assert_eq!((counts.dark, counts.dark_rows), (2048, 32));
        let tables = Tables::of(&environment);
        let pdf = 1.0 / (4.0 * std::f64::consts::PI);
        let mut sum = [0.0; 3];
        for i in 0..1 << 14 {
            let (direction, found) = tables.sample(fractions(i));
            assert!(corput::judge::ulp_error(found, pdf) <= 0.6);
            assert_eq!(tables.pdf(direction), found);
            for (sum, x) in sum.iter_mut().zip(direction.to_array()) {
                *sum += f64::from(x) / 16384.0;
            }
        }
        // Each mean has a deviation of sqrt(1/3) / 128; the first 512 points are no random
        // ones, but balanced.
        assert!(sum.iter().all(|m| m.abs() < 0.025), "{sum:?}");
    }
}

#[test]
fn one_hot_texel_takes_almost_all_and_leaves_the_rest_possible() {
    for kind in KINDS {
        let (width, height) = (512, 256);
        let mut texels = vec![[1.0; 3]; 512 * 256];
        texels[100 * 512 + 37] = [1e9; 3];
        let environment = build(width, height, &texels, of(kind));
        assert_eq!(environment.counts(), &Counts::default());
        let tables = Tables::of(&environment);
        let hot = tables.probability(uvec2(37, 100));
        // The row's solid angle against the mean one.
        let share = tables.solid_angle(100) * 131_072.0 / (4.0 * std::f64::consts::PI);
        let truth = 1e9 * share / (1e9 * share + 131_072.0);
        // Each texel's weight is raised by up to 1 of 2^32.
        assert!(
            (hot - truth).abs() < 1.4e5 / f64::powi(2.0, 32),
            "{hot} {truth}"
        );
        let every = (0..height)
            .all(|row| (0..width).all(|column| tables.texel_pdf(uvec2(column, row)) > 0.0));
        assert!(every, "{kind:?}");
    }
}

#[test]
fn a_hot_texel_alone_is_always_drawn() {
    for kind in KINDS {
        for place in [0, 37, 2047] {
            let mut texels = vec![[0.0; 3]; 2048];
            texels[place] = [1e9; 3];
            let environment = build(64, 32, &texels, of(kind));
            assert_eq!(environment.counts().dark, 2047);
            assert_eq!(environment.counts().dark_rows, 31);
            let tables = Tables::of(&environment);
            let texel = uvec2(place as u32 % 64, place as u32 / 64);
            let truth = 1.0 / tables.solid_angle(texel.y);
            for i in 0..4096 {
                let (direction, pdf) = tables.sample(fractions(i));
                assert_eq!(tables.drawn(fractions(i)), texel);
                assert!(corput::judge::ulp_error(pdf, truth) <= 0.6);
                assert_eq!(tables.pdf(direction), pdf);
            }
        }
    }
}

#[test]
fn texels_that_are_no_light_weigh_nothing_and_are_counted() {
    let denormal = f32::from_bits(1);
    let mut texels = vec![[1.0; 3]; 32];
    texels[1] = [f32::NAN, 1.0, 1.0];
    texels[2] = [f32::INFINITY; 3];
    texels[3] = [f32::NEG_INFINITY, f32::NAN, 0.0];
    texels[4] = [-1.0, 0.0, 0.0];
    texels[5] = [denormal, 0.0, 0.0];
    texels[6] = [-denormal, -0.0, 0.0];
    texels[7] = [-0.0; 3];
    let expected = Repairs {
        nan: 2,
        infinite: 2,
        negative: 2,
        denormal: 1,
    };
    for kind in KINDS {
        let environment = build(8, 4, &texels, of(kind));
        assert_eq!(environment.counts().repairs, expected);
        // The second texel keeps two channels.
        assert_eq!(environment.counts().dark, 6);
        let tables = Tables::of(&environment);
        for column in 2..8 {
            assert_eq!(tables.texel_pdf(uvec2(column, 0)), 0.0);
        }
        let mut repaired = texels.clone();
        assert_eq!(repair(&mut repaired), expected);
        assert_eq!(repaired[1], [0.0, 1.0, 1.0]);
        let again = build(8, 4, &repaired, of(kind));
        assert_eq!(again.words(), environment.words());
        assert!(again.counts().repairs.is_empty());
        // Nothing but such texels is a black map.
        let nothing = build(2, 1, &[[f32::NAN; 3], [f32::NEG_INFINITY; 3]], of(kind));
        assert!(nothing.counts().black);
    }
}

#[test]
fn light_over_all_floats_stays_possible() {
    let texels: Vec<[f32; 3]> = (0..64)
        .map(|i| [f32::MIN_POSITIVE * f32::powi(16.0, i); 3])
        .map(|t| t.map(|l| l.min(f32::MAX)))
        .collect();
    for kind in KINDS {
        let environment = build(8, 8, &texels, of(kind));
        assert_eq!(environment.counts().dark, 0);
        assert!(environment.counts().raised > 0);
        let tables = Tables::of(&environment);
        for row in 0..8 {
            for column in 0..8 {
                assert!(tables.texel_pdf(uvec2(column, row)) > 0.0);
            }
        }
    }
}

#[test]
fn the_largest_channel_may_be_the_weight() {
    let texels = [[4.0, 0.0, 0.0], [0.0, 0.0, 4.0]];
    for (weight, ratio) in [(Weight::Max, 1.0), (Weight::Luminance, 0.2126 / 0.0722)] {
        let options = Options {
            weight,
            ..Options::default()
        };
        let tables = Tables::of(&build(2, 1, &texels, options));
        let found = tables.probability(uvec2(0, 0)) / tables.probability(uvec2(1, 0));
        assert!((found - ratio).abs() < 1e-7, "{found}");
    }
}

#[test]
fn compensation_subtracts_the_mean() {
    let options = Options {
        compensated: true,
        ..Options::default()
    };
    // Two rows of equal solid angle: the mean is 2, and 1 and 3 remain of 3 and 5.
    let texels = [[0.0; 3], [3.0; 3], [5.0; 3], [0.0; 3]];
    for kind in KINDS {
        let environment = build(2, 2, &texels, Options { kind, ..options });
        assert_eq!(environment.counts().dark, 2);
        let tables = Tables::of(&environment);
        assert!((tables.probability(uvec2(1, 0)) - 0.25).abs() < 1e-9);
        assert!((tables.probability(uvec2(0, 1)) - 0.75).abs() < 1e-9);
        // All alike: nothing is above the mean, not even by rounding.
        let alike = vec![[0.1; 3]; 64 * 32];
        let environment = build(64, 32, &alike, Options { kind, ..options });
        assert!(environment.counts().uncompensated);
        assert_eq!(environment.words(), build(64, 32, &alike, of(kind)).words());
        // And black stays black.
        assert!(
            build(2, 1, &[[0.0; 3]; 2], Options { kind, ..options })
                .counts()
                .black
        );
    }
}

#[test]
fn floats_of_a_cdf_lose_what_integers_keep() {
    // Row 35 of the catalogue: one texel of 1e9 among 2^25, in the row that it shares with
    // 8191 texels of 1. A CDF of floats stalls behind it.
    let mut weights = vec![1u64 << 20; 8192];
    weights[10] = 1_000_000_000 << 20;
    let words = corput::environment::cdf_table(&weights).unwrap();
    let steps = words[1..].windows(2).filter(|w| w[0] == w[1]).count();
    assert_eq!(steps, 0);
    let mut sum = 0.0f32;
    let mut stalled = 0;
    for &w in &weights {
        let before = sum;
        sum += (w >> 20) as f32;
        stalled += u32::from(sum == before);
    }
    println!("of 8192 steps of the CDF, floats lose {stalled}, integers {steps}");
    assert!(stalled > 8000);
}
