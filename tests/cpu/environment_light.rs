//! The irradiance of real maps by environment sampling, cosine sampling and both, against
//! the exact sum over all texels.

#[path = "../../examples/environment.rs"]
mod example;
mod significance;

use corput::environment::Options;
use corput::image::load_exr;
use example::{Estimate, Light, NORMALS};
use significance::critical;
use std::path::Path;

fn light(name: &str, options: Options) -> Light {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data");
    Light::new(&load_exr(&folder.join(name)).unwrap(), options).unwrap()
}

#[test]
fn three_estimators_agree_with_the_exact_sum() {
    let limit = critical(2 * NORMALS.len() * 3);
    for name in ["sunrise.exr", "studio.exr"] {
        let light = light(name, Options::default());
        for (seed, (axis, normal)) in (0..).zip(NORMALS) {
            let truth = light.truth(normal);
            let found = [
                light.environment(normal, seed),
                light.cosine(normal, seed),
                light.both(normal, seed),
            ];
            for (
                what,
                Estimate {
                    mean,
                    error,
                    variance,
                },
            ) in ["environment", "cosine", "both"].into_iter().zip(found)
            {
                let off = (mean - truth) / error;
                println!(
                    "{name} {axis} {what}: {mean:.6} +- {error:.6}, exact {truth:.6} \
                     ({off:.2} of {limit:.2} deviations); variance of a sample {variance:.6}"
                );
                assert!(off.abs() < limit, "{name} {axis} {what}");
            }
            // Balance is never much worse than the better one with as many samples.
            let better = found[0].variance.min(found[1].variance);
            assert!(found[2].variance < 2.5 * better, "{name} {axis}");
        }
    }
}

#[test]
fn a_biased_estimator_is_seen() {
    // Compensated tables alone never draw the dim part of the map.
    let options = Options {
        compensated: true,
        ..Options::default()
    };
    let light = light("studio.exr", options);
    let limit = critical(1);
    let truth = light.truth([0.0, 0.0, 1.0]);
    let alone = light.environment([0.0, 0.0, 1.0], 5);
    assert!((alone.mean - truth).abs() > 10.0 * limit * alone.error);
    // Beside cosine sampling they are right.
    let both = light.both([0.0, 0.0, 1.0], 5);
    println!(
        "compensated: alone {:.5} +- {:.5}, both {:.5} +- {:.5}, exact {truth:.5}; variance {:.5}",
        alone.mean, alone.error, both.mean, both.error, both.variance
    );
    assert!((both.mean - truth).abs() < limit * both.error);
}
