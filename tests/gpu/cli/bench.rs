//! `corput bench`, but for scenes.

use super::refused::assert_refused;
use super::{Desk, on_one_device, skips};
use corput::bench::{Machine, scaling, scaling_json};
use serde_json::{Value, json};

/// What a command prints, as JSON.
fn document(desk: &Desk, line: &str) -> Value {
    serde_json::from_str(&desk.say(line)).expect("JSON")
}

/// Runs `bench ONLY --against` a baseline whose times are those of `measured` times `factor`.
fn against(desk: &Desk, line: &str, measured: &Value, factor: f64) -> super::Run {
    let mut before = measured.clone();
    for job in before["jobs"].as_array_mut().expect("jobs") {
        for time in ["median_s", "deviation_s"] {
            job[time] = json!(job[time].as_f64().expect("a time") * factor);
        }
    }
    std::fs::write(desk.path("before.json"), before.to_string()).expect("written");
    desk.run(&format!("{line} --against before.json"))
}

#[test]
fn a_device_is_measured_and_compared_with_before() {
    if skips() {
        return;
    }
    let desk = Desk::new();
    // Where there is a choice, the device that is a hundred times as fast.
    let listed = desk.say("devices");
    let line = match listed.contains("llvmpipe") {
        true => "bench --only hammersley --device llvmpipe",
        false => "bench --only hammersley",
    };
    let said = document(&desk, &format!("{line} --json"));
    assert_eq!(said["schema"], "corput-bench/1");
    assert_eq!(said["command"], format!("corput {line} --json"));
    let jobs = said["jobs"].as_array().expect("jobs");
    assert_eq!(jobs.len(), 1);
    let job = &jobs[0];
    assert_eq!(
        (&job["name"], &job["bytes"]),
        (&json!("Hammersley d=2"), &json!(1 << 27))
    );
    for time in ["cold_s", "median_s", "fill_s", "times_fill", "points_per_s"] {
        assert!(job[time].as_f64().is_some_and(|x| x > 0.0), "{time}: {job}");
    }
    // A hundred times as fast, or as slow, is no noise.
    let slow = against(&desk, line, &said, 0.01);
    slow.expect(1, &["1 of 1 jobs are slower"]);
    let table = String::from_utf8(slow.stdout).expect("text");
    assert!(
        table.contains("slower") && table.contains("x fill"),
        "{table}"
    );
    let fast = against(&desk, &format!("{line} --json"), &said, 100.0);
    fast.expect(0, &[]);
    let fast: Value = serde_json::from_slice(&fast.stdout).expect("JSON");
    assert_eq!(fast["changes"][0]["verdict"], "faster");
}

#[test]
fn a_device_is_measured_over_more_and_more_words() {
    on_one_device(|device| {
        let scales = scaling(device, 17..=19).unwrap();
        let words: Vec<u64> = scales.iter().map(|scale| scale.words).collect();
        assert_eq!(words, [1 << 17, 1 << 18, 1 << 19]);
        assert!(
            scales
                .iter()
                .all(|scale| scale.median_s > 0.0 && scale.fill_s > 0.0),
            "{scales:?}"
        );
        let machine = Machine {
            device: device.info().name.clone(),
            threads: 1,
            command: String::new(),
        };
        let document = scaling_json(&machine, &scales);
        assert_eq!(document["sizes"].as_array().map(Vec::len), Some(3));
        let fills = document["sizes"][0]["times_fill"].as_f64();
        assert_eq!(fills, Some(scales[0].median_s / scales[0].fill_s));
        assert!(scaling(device, 25..=40).is_err());
    });
    let desk = Desk::new();
    desk.run("bench --scaling --only sobol")
        .expect(2, &["cannot be used with"]);
}

#[test]
fn the_cpu_is_measured_without_a_device() {
    let desk = Desk::new();
    let line = "bench --device cpu --only hammersley --json";
    let said = document(&desk, line);
    assert!(
        said["device"]
            .as_str()
            .is_some_and(|d| d.starts_with("cpu"))
    );
    assert_eq!(said["jobs"][0]["kernel"], "");
    assert_eq!(said["jobs"][0]["goal"]["times_fill_at_most"], 1.3);
    // Another device's times are compared, with a warning.
    let mut before = said.clone();
    before["device"] = json!("another");
    let run = against(
        &desk,
        "bench --device cpu --only hammersley",
        &before,
        100.0,
    );
    run.expect(0, &["of another device: another"]);
    desk.run("bench --device cpu --only r2 --against before.json")
        .expect(2, &["before.json", "none of the jobs"]);
}

#[test]
fn what_cannot_be_measured_is_refused() {
    assert_refused(
        "bench --device cpu --only hamersley",
        &["unknown job `hamersley`", "did you mean `hammersley`?"],
    );
    assert_refused(
        "bench --device cpu --against before.json",
        &["before.json", "corput bench --json"],
    );
    assert_refused(
        "bench --scene a.toml --only halton",
        &["cannot be used with", "--only"],
    );
}

/// Small, and on the CPU: what is measured is told, and nothing stays in the folder.
#[test]
fn files_are_measured_beside_a_plain_write() {
    let desk = Desk::new();
    let line = "bench --files new/f --size 1048576 --device cpu";
    let said: Value = document(&desk, &format!("{line} --json"));
    assert_eq!(said["schema"], "corput-files/1");
    let (large, few) = (&said["large"], &said["few"]);
    assert_eq!(large["bytes"], 4096 + (1 << 20));
    for (of, key, rounds) in [
        (large, "seconds", 3),
        (large, "plain_write_seconds", 3),
        (few, "seconds", 9),
    ] {
        let times = of[key].as_array().unwrap();
        assert_eq!(times.len(), rounds);
        assert!(times.iter().all(|time| time.as_f64().unwrap() > 0.0));
    }
    let [made, plain] =
        ["median_s", "plain_write_median_s"].map(|key| large[key].as_f64().unwrap());
    let ratio = large["x_plain_write"].as_f64().unwrap();
    assert!((ratio - made / plain).abs() < 1e-9 * ratio);
    assert_eq!(large["goal_reached"], ratio <= 1.3);
    assert_eq!(std::fs::read_dir(desk.path("new/f")).unwrap().count(), 0);
    let told = desk.say(line);
    assert!(told.contains("x plain write"), "{told}");
    // What fails is told, and leaves nothing either.
    desk.run("bench --files other --size 64 --device none-such")
        .expect(if skips() { 3 } else { 2 }, &[]);
    desk.run("bench --files other --size 68719476752 --device cpu")
        .expect(2, &["4294967297"]);
    assert!(!desk.path("other").exists());
    assert_eq!(std::fs::read_dir(desk.path("new/f")).unwrap().count(), 0);
    desk.run("bench --size 64").expect(2, &["--files"]);
    desk.run("bench --files new/f --scaling")
        .expect(2, &["--scaling"]);
}
