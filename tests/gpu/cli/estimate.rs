//! `corput integrands` and `corput estimate`.

use super::refused::assert_refused;
use super::{Desk, skips};
use corput::catalog::integrands;
use serde_json::Value;

fn document(desk: &Desk, line: &str) -> Value {
    serde_json::from_str(&desk.say(line)).unwrap_or_else(|error| panic!("{line}: {error}"))
}

#[test]
fn the_list_says_all_of_every_integrand() {
    let desk = Desk::new();
    let text = desk.say("integrands");
    for integrand in integrands() {
        let alone = desk.say(&format!("integrands {}", integrand.name));
        assert!(alone.starts_with(integrand.name) && text.contains(alone.trim_end()));
        for phrase in [integrand.summary, integrand.formula, integrand.source] {
            assert!(alone.contains(phrase), "{}: no `{phrase}`", integrand.name);
        }
        for estimator in integrand.estimators {
            assert!(alone.contains(estimator), "{alone}");
        }
        for parameter in integrand.parameters {
            assert!(alone.contains(&format!("{}=X", parameter.name)), "{alone}");
            assert!(alone.contains(parameter.domain), "{alone}");
        }
    }
    let json = document(&desk, "integrands --json");
    let list = json["integrands"].as_array().expect("a list");
    let names = list.iter().map(|one| one["name"].as_str());
    assert!(names.eq(integrands().map(|one| Some(one.name))));
}

#[test]
fn sums_are_the_same_everywhere() {
    if skips() {
        return;
    }
    let desk = Desk::new();
    for line in [
        "--integrand x-squared --sampler sobol --count 65536",
        "--integrand disk-step --sampler halton --count 20000 --start 123456",
        "--integrand genz-gaussian:d=3,difficulty=2 --sampler random --seed 5 --count 3000",
        "--integrand sobol-g:d=5 --sampler sobol:owen --seed 9 --count 1024",
        "--integrand irradiance:map=tests/data/sunrise.exr,axis=+z --estimator environment --sampler sobol --count 4096",
        "--integrand polygon-irradiance --estimator mis --sampler random --seed 2 --count 65536",
    ] {
        let data = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/data");
        let line = format!("estimate --json {line}").replace("tests/data", data);
        let cpu = document(&desk, &format!("{line} --device cpu"));
        let device = document(&desk, &line);
        for key in [
            "sum",
            "sum_of_squares",
            "mean",
            "variance",
            "scale",
            "count",
        ] {
            assert_eq!(cpu[key], device[key], "{line}: {key}");
            assert!(!cpu[key].is_null(), "{line}: {key}");
        }
        assert!(
            cpu["error"]
                .as_f64()
                .is_some_and(|error| error.abs() < 0.02),
            "{cpu}"
        );
        let random = line.contains("random");
        assert_eq!(cpu["standard_error"].is_null(), !random, "{line}");
    }
}

#[test]
fn pictures_are_the_same_everywhere() {
    let desk = Desk::new();
    let line = "estimate --integrand soft-shadow --estimator light --sampler sobol:owen-hash \
                --seed 4 --pixels 12x8 --count 16";
    let devices: &[&str] = if skips() {
        &["cpu"]
    } else {
        &["cpu", "llvmpipe"]
    };
    for device in devices {
        for ending in ["npy", "png", "exr"] {
            let line = format!("{line} --device {device} --out {device}.{ending}");
            let text = desk.say(&line);
            assert!(
                text.contains("12 x 8, each with a seed of its own"),
                "{text}"
            );
            let file = format!("{device}.{ending}");
            assert_eq!(desk.bytes(&file), desk.bytes(&format!("cpu.{ending}")));
        }
    }
    let npy = desk.bytes("cpu.npy");
    let shape = "'<f4', 'fortran_order': False, 'shape': (8, 12, 3,)";
    assert!(String::from_utf8_lossy(&npy[..200]).contains(shape));
    assert!(desk.bytes("cpu.png").starts_with(b"\x89PNG"));
    // The upper left is dark, the upper right is lit; means and counts stand in the array.
    let values: Vec<f32> = npy[4096..]
        .chunks_exact(4)
        .map(|word| f32::from_le_bytes([word[0], word[1], word[2], word[3]]))
        .collect();
    assert_eq!(values.len(), 8 * 12 * 3);
    assert_eq!(values[..3], [0.0, 0.0, 16.0]);
    assert!((values[33] - 0.1968).abs() < 0.01, "{}", values[33]);
    let json = document(&desk, &format!("{line} --device cpu --json"));
    let pixels = json["pixels"].as_array().expect("pixels");
    assert_eq!((pixels.len(), &json["width"]), (96, &Value::from(12)));
    let means = pixels.iter().map(|one| one["mean"].as_f64());
    let found = values.chunks_exact(3).map(|one| one[0]);
    assert!(means.map(|mean| mean.expect("a mean") as f32).eq(found));
    assert!(json["rms_error"].as_f64().is_some_and(|error| error < 0.01));
}

#[test]
fn an_estimate_says_what_it_is() {
    let desk = Desk::new();
    let line = "estimate --integrand x-squared --count 4 --device cpu --sampler";
    let sobol = desk.say(&format!("{line} sobol"));
    // 0, 1/16, 1/4 and 9/16.
    assert!(sobol.contains("mean            0.21875\n"), "{sobol}");
    assert!(sobol.contains("are not independent\n"), "{sobol}");
    let owen = desk.say(&format!("{line} sobol:owen"));
    assert!(owen.contains("compare several seeds"), "{owen}");
    let random = desk.say(&format!("{line} random"));
    assert!(!random.contains("independent"), "{random}");
    let json = document(&desk, &format!("{line} sobol --json"));
    assert_eq!(json["sum"], (14u128 << 60).to_string());
    assert_eq!(json["sum_of_squares"], (98u128 << 120).to_string());
}

#[test]
fn estimates_that_cannot_be_made() {
    for (arguments, words) in [
        (
            "--integrand x-sqared --sampler sobol --count 8",
            &["did you mean `x-squared`"][..],
        ),
        (
            "--integrand polygon-irradiance --estimator ligth --sampler sobol --count 8",
            &["unknown estimator", "did you mean `light`"],
        ),
        (
            "--integrand x-squared --estimator uniform --sampler sobol --count 8",
            &["it has only one"],
        ),
        (
            "--integrand irradiance --sampler sobol --count 8",
            &["map is not given"],
        ),
        (
            "--integrand x-squared --sampler sobl --count 8",
            &["unknown sampler", "did you mean `sobol`"],
        ),
        (
            "--integrand x-squared --sampler sobol:owne --count 8",
            &["unknown scramble", "`owen`"],
        ),
        (
            "--integrand genz-gaussian:d=8 --sampler pmj02 --count 8",
            &["pmj02", "8 dimensions"],
        ),
        (
            "--integrand genz-gaussian:d=65 --sampler sobol --count 8",
            &["from 1 to 64"],
        ),
        (
            "--integrand genz-gaussian:d=x --sampler sobol --count 8",
            &["`d=x` is no key=number"],
        ),
        (
            "--integrand x-squared --sampler sobol --count 4294967297",
            &["passes 2^32"],
        ),
        (
            "--integrand x-squared --sampler sobol --count 8 --start 4294967290",
            &["passes 2^32"],
        ),
        (
            "--integrand x-squared --sampler sobol --count 0",
            &["least is 1"],
        ),
        (
            "--integrand x-squared --sampler sobol --count -1",
            &["-1 is negative"],
        ),
        ("--integrand x-squared --sampler sobol", &["--count"]),
        (
            "--integrand x-squared --sampler sobol --count 4 --pixels 8x8",
            &["soft-shadow and pixel-edge are pictures"],
        ),
        (
            "--integrand pixel-edge --sampler sobol --count 4 --pixels 8",
            &["8 is no size"],
        ),
        (
            "--integrand pixel-edge --sampler sobol --count 4 --pixels 8x8 --out a.gif",
            &["unknown format of a picture", "npy"],
        ),
        (
            "--integrand pixel-edge --sampler sobol --count 4 --out a.npy",
            &["add --pixels"],
        ),
    ] {
        assert_refused(&format!("estimate {arguments}"), words);
    }
    if !skips() {
        let line = "estimate --integrand product:d=1000 --sampler sobol:owen --count 4";
        assert_refused(line, &["65535 iterations", "owen-hash"]);
    }
    assert_refused("integrands sobl-g", &["did you mean `sobol-g`"]);
}
