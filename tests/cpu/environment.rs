//! Environment maps as distributions: sums that are exact, directions that find their own
//! texel, a pdf that is the density, and maps at the extremes.

#[path = "environment/chance.rs"]
mod chance;
#[path = "environment/extreme.rs"]
mod extreme;
mod significance;
#[path = "environment/support.rs"]
mod support;

use corput::environment::{Environment, Kind, Options};
use corput::glam::{UVec2, uvec2, uvec3};
use corput::reference::envmap::envmap_texel;
use corput::reference::permute::permute_mix as mix;
use support::{Tables, maps};

/// An environment's tables draw only texels with light, in the texel that a lookup of the
/// direction finds, with the pdf that a lookup gives.
fn agree(tables: &Tables, samples: u32) {
    for i in 0..samples {
        let u = support::fractions(i);
        let (direction, pdf) = tables.sample(u);
        let length = direction.as_dvec3().length();
        assert!((length - 1.0).abs() <= f64::powi(2.0, -23), "{direction}");
        assert!(pdf > 0.0 && pdf.is_finite(), "{u:08x?}: {pdf}");
        assert_eq!(pdf, tables.pdf(direction), "{u:08x?} {direction}");
        let texel = envmap_texel(direction, tables.size, &tables.edges);
        assert_eq!(texel, tables.drawn(u), "{u:08x?} {direction}");
        assert!(tables.probability(texel) > 0.0);
    }
}

#[test]
fn directions_find_the_texel_they_were_drawn_in() {
    for (name, width, height, texels) in maps() {
        for kind in [Kind::Hierarchical, Kind::Alias] {
            let tables = Tables::new(width, height, &texels, kind);
            println!("{name} {kind:?}");
            agree(&tables, 1 << 14);
        }
    }
}

#[test]
fn probabilities_sum_to_one_exactly() {
    for (name, width, height, texels) in maps() {
        for kind in [Kind::Hierarchical, Kind::Alias] {
            let tables = Tables::new(width, height, &texels, kind);
            let mut sum = 0u128;
            let mut integral = 0.0;
            for row in 0..tables.size.y {
                for column in 0..tables.size.x {
                    let texel = uvec2(column, row);
                    sum += tables.judge().weight(texel.to_array());
                    integral += f64::from(tables.texel_pdf(texel)) * tables.solid_angle(row);
                }
            }
            assert_eq!(sum, 1 << 64, "{name} {kind:?}");
            // Each pdf is right to 0.6 ULP.
            assert!(
                (integral - 1.0).abs() <= 0.6 * f64::powi(2.0, -23),
                "{name} {kind:?}: {integral}"
            );
        }
    }
}

#[test]
fn the_pdf_is_the_probability_over_the_solid_angle() {
    let mut worst = 0.0f64;
    for (_, width, height, texels) in maps() {
        for kind in [Kind::Hierarchical, Kind::Alias] {
            let tables = Tables::new(width, height, &texels, kind);
            for i in 0..1 << 12 {
                let texel = tables.drawn(support::fractions(i));
                let truth = tables.probability(texel) / tables.solid_angle(texel.y);
                let error = corput::judge::ulp_error(tables.texel_pdf(texel), truth);
                worst = worst.max(error);
            }
        }
    }
    println!("pdf: worst {worst:.3} ULP");
    assert!(worst <= 0.6);
}

#[test]
fn directions_are_where_the_fractions_say() {
    // In f64, from the tables' probabilities: z linear between the row's edges, the
    // azimuth between the column's.
    let mut worst = [0.0f64; 3];
    for (_, width, height, texels) in maps() {
        for kind in [Kind::Hierarchical, Kind::Alias] {
            let tables = Tables::new(width, height, &texels, kind);
            for i in 0..1 << 13 {
                let u = support::fractions(i);
                let truth = tables.judge().sample(u.to_array());
                let (direction, _) = tables.sample(u);
                for axis in 0..3 {
                    let error = (f64::from(direction[axis]) - truth[axis]).abs();
                    worst[axis] = worst[axis].max(error * 16_777_216.0);
                }
            }
        }
    }
    println!("x, y, z: worst {worst:.2?} of 2^-24");
    // z may be one float away from the nearest, which lies in the next row.
    assert!(worst[0] <= 0.6 && worst[1] <= 0.6 && worst[2] <= 1.5);
}

#[test]
fn inverses_give_back_the_fractions() {
    for (name, width, height, texels) in maps() {
        let tables = Tables::new(width, height, &texels, Kind::Hierarchical);
        let mut worst = [0.0f64; 2];
        for i in 0..1 << 13 {
            let u = uvec2(support::fractions(i).x, support::fractions(i).y);
            let (direction, _) = tables.sample(u.extend(0));
            let v = tables.invert(direction);
            let texel = tables.drawn(u.extend(0));
            // In parts of the texel's own range of u, against what 2^-23 is of its extent.
            let ranges = tables.judge().ranges(texel.to_array());
            let [width, height] = ranges.map(|[start, end]| (end - start) as f64);
            let off = |a: u32, b: u32, range: f64| (f64::from(a) - f64::from(b)).abs() / range;
            let down = f64::powi(2.0, -23) / tables.judge().thickness(texel.y).min(0.5);
            let across = f64::powi(2.0, -25) * f64::from(tables.size.x);
            worst[0] = worst[0].max((off(u.x, v.x, height) - 1.0 / height) / down);
            worst[1] = worst[1].max((off(u.y, v.y, width) - 1.0 / width) / across);
        }
        println!("{name}: inverse off by {worst:.3?} of what rounding may leave");
        assert!(worst[0] <= 1.0 && worst[1] <= 1.0);
    }
}

#[test]
fn sizes_are_refused_with_the_limit() {
    let texels = vec![[1.0; 3]; 64];
    let refused = |width, height, kind| {
        let options = Options {
            kind,
            ..Options::default()
        };
        Environment::new(width, height, &texels, options)
            .unwrap_err()
            .to_string()
    };
    assert!(refused(0, 0, Kind::Hierarchical).contains("1 x 1 to 8192 x 4096"));
    assert!(refused(8193, 1, Kind::Hierarchical).contains("8192 x 4096"));
    assert!(refused(1, 4097, Kind::Hierarchical).contains("8192 x 4096"));
    assert!(refused(8, 9, Kind::Hierarchical).contains("64 texels"));
    assert!(refused(8192, 4096, Kind::Alias).contains("64 texels"));
    let large = vec![[1.0; 3]; (1 << 24) + 4096];
    let options = Options {
        kind: Kind::Alias,
        ..Options::default()
    };
    let error = Environment::new(4096, 4097, &large, options).unwrap_err();
    assert!(error.to_string().contains("8192 x 4096"), "{error}");
    let error = Environment::new(4097, 4096, &large, options).unwrap_err();
    assert!(error.to_string().contains("16777216"), "{error}");
}

#[test]
fn tables_are_the_same_twice_and_of_the_stated_length() {
    for (_, width, height, texels) in maps() {
        let tables = Tables::new(width, height, &texels, Kind::Hierarchical);
        let UVec2 { x, y } = tables.size;
        assert_eq!(tables.words.len() as u32, 4 * y + 2 + x * y);
        let again = Tables::new(width, height, &texels, Kind::Hierarchical);
        assert_eq!(tables.words, again.words);
        let alias = Tables::new(width, height, &texels, Kind::Alias);
        assert_eq!(alias.words.len() as u32, 3 * y + 2 + 3 * x * y);
    }
}

#[test]
fn a_broken_pdf_is_caught() {
    // Without 1/solid angle, the pdf integrates to something else.
    let (_, width, height, texels) = maps().swap_remove(0);
    let tables = Tables::new(width, height, &texels, Kind::Hierarchical);
    let mut integral = 0.0;
    for row in 0..tables.size.y {
        for column in 0..tables.size.x {
            integral += tables.probability(uvec2(column, row)) * tables.solid_angle(row);
        }
    }
    assert!((integral - 1.0).abs() > 0.1);
    // A direction that keeps no distance from its texel's edges is found in another one
    // now and then.
    let (_, width, height, texels) = maps().pop().unwrap();
    let tables = Tables::new(width, height, &texels, Kind::Hierarchical);
    let misses = (0..1 << 16).filter(|&i| {
        let u = uvec3(mix(i), mix(!i), 0);
        let [x, y, z, _] = tables.judge().sample(u.to_array()).map(|c| c as f32);
        let found = envmap_texel(corput::glam::vec3(x, y, z), tables.size, &tables.edges);
        found != tables.drawn(u)
    });
    let misses = misses.count();
    println!("rounded without care, {misses} of 65536 miss their texel");
    assert!(misses > 0);
}
