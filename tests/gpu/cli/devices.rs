//! `devices`, `check`, `headers` and `demo`, and the choice of a device.

use super::parse::npy;
use super::{Desk, Run, repository, skips};
use serde_json::Value;

/// A run of a machine without a driver.
fn bare(desk: &Desk, line: &str) -> Run {
    let mut command = desk.command(line);
    command
        .env("VK_DRIVER_FILES", "/nonexistent.json")
        .env("VK_ICD_FILENAMES", "/nonexistent.json")
        .env_remove("CORPUT_DEVICE")
        .env_remove("CORPUT_VALIDATION");
    Run::of(line, command)
}

#[test]
fn devices_are_listed_with_what_the_probe_found() {
    if skips() {
        return;
    }
    let desk = Desk::new();
    let said: Value = serde_json::from_str(&desk.say("devices --json")).unwrap();
    let devices = said["devices"].as_array().unwrap();
    let text = desk.say("devices");
    assert!(!devices.is_empty());
    for (i, device) in devices.iter().enumerate() {
        assert_eq!(device["index"], i);
        assert!(device["limits"]["max_storage_buffer_range"].as_u64() >= Some(1 << 27));
        assert!(device["probe"]["tier_i"].is_boolean(), "{device:#}");
        assert!(device["probe"]["contracts"].is_boolean());
        assert!(device["driver"]["version"].is_u64() || device["driver"]["version"].is_string());
        let name = device["name"].as_str().unwrap();
        assert!(text.contains(&format!("{i}: {name}")), "{text}");
    }
    assert_eq!(text.matches("probe of").count(), devices.len());
}

#[test]
fn the_environment_chooses_where_no_argument_does() {
    let desk = Desk::new();
    let line = "generate halton --count 10 --out p.raw";
    let with = |device: &str, line: &str| {
        let mut command = desk.command(line);
        command.env("CORPUT_DEVICE", device);
        Run::of(line, command)
    };
    let used = || {
        let said: Value = serde_json::from_slice(&desk.bytes("p.raw.json")).unwrap();
        said["device"].as_str().unwrap().to_owned()
    };
    with("cpu", line).expect(0, &[]);
    assert_eq!(used(), "cpu");
    if skips() {
        return;
    }
    let unknown = with("no such device", line);
    unknown.expect(2, &["unknown device `no such device`", "present: 0: `"]);
    with("99", "check --only vdc").expect(2, &["unknown device `99`", "0: `"]);
    with("no such device", &format!("{line} --device 0")).expect(0, &[]);
    let by_index = used();
    assert_ne!(by_index, "cpu");
    with("0", line).expect(0, &[]);
    assert_eq!(used(), by_index);
    // Any part of its name will do, unless other devices have it, too.
    let name = by_index.split(" (").next().unwrap();
    let named = with(&name.to_uppercase(), line);
    assert!(named.code == Some(0) || named.stderr.contains("it fits"));
}

#[test]
fn no_driver_is_said_with_how_to_get_one() {
    let desk = Desk::new();
    for line in [
        "devices",
        "devices --json",
        "generate halton --count 10 --device 0 --out p.npy",
        "generate halton --count 10 --map cone --param theta_max=1 --profile native --out p.npy",
        "check",
        "bench",
        "accuracy",
    ] {
        let run = bare(&desk, line);
        run.expect(3, &["no Vulkan device", "install", "--device cpu"]);
        assert_eq!(run.stdout, b"");
    }
    assert!(desk.names().is_empty());
    let line = "generate halton --count 10 --out p.npy";
    bare(&desk, &format!("{line} --device cpu")).expect(0, &[]);
    let asked = desk.bytes("p.npy");
    npy(&asked).assert_is("<f4", 10, 2);
    // Where nobody asks for a device, the CPU gives the same bytes, and says so.
    let told = ["the CPU does the work", "no Vulkan device"];
    bare(&desk, line).expect(0, &told);
    assert!(desk.bytes("p.npy") == asked);
    for line in [
        "generate blue-noise-mask --size 8 --out m.png",
        "estimate --integrand disk-step --sampler sobol --count 64",
        "verify p.npy",
    ] {
        bare(&desk, line).expect(0, &told);
    }
    bare(&desk, "headers --out h").expect(0, &[]);
}

#[test]
fn check_finds_no_mismatch() {
    if skips() {
        return;
    }
    let desk = Desk::new();
    let said: Value = serde_json::from_str(&desk.say("check --json --only cone")).unwrap();
    assert_eq!(said["failures"], 0);
    let rows = said["rows"].as_array().unwrap();
    assert!(!rows.is_empty());
    for row in rows {
        let [name, kernel] = ["name", "kernel"].map(|key| row[key].as_str().unwrap());
        assert!(name.contains("cone") || kernel.contains("cone"));
        // The native profile promises bounds, not bits.
        let bits = row["profile"] == "exact";
        let mismatches = if bits { Value::from(0) } else { Value::Null };
        assert_eq!(row["mismatches"], mismatches, "{name}");
        assert_eq!(row["verdict"], "passed", "{name}");
        assert!(row["compared"].as_u64() > Some(0), "{name}");
    }
    let text = desk.say("check --only radical_inverse");
    assert!(text.contains("\n0 of ") || text.contains("0 of "), "{text}");
    assert!(
        text.lines()
            .last()
            .unwrap()
            .contains("differ from the CPU's")
    );
}

#[test]
fn headers_become_files() {
    let desk = Desk::new();
    let said = desk.say("headers --out new/folder");
    assert_eq!(said.lines().count(), 1);
    let headers = corput::headers();
    assert!(headers.len() > 5 && said.starts_with(&headers.len().to_string()));
    for (name, text) in headers {
        let path = format!("new/folder/{name}");
        assert_eq!(desk.bytes(&path), text.as_bytes(), "{name}");
    }
    let made = std::fs::read_dir(desk.path("new/folder/corput")).unwrap();
    let top = headers
        .iter()
        .filter(|(name, _)| name.matches('/').count() == 1);
    assert_eq!(
        made.filter(|entry| entry.as_ref().unwrap().path().is_file())
            .count(),
        top.count()
    );
    // Twice is as good as once.
    assert_eq!(desk.say("headers --out new/folder"), said);
}

#[test]
fn the_demonstration_ends_with_everything_equal() {
    if skips() {
        return;
    }
    let desk = Desk::new();
    let map = repository("tests/data/sunrise.exr");
    let said = desk.say(&format!("demo --env {} --out made", map.display()));
    let last = said.lines().last().unwrap();
    assert!(
        last.starts_with("equal to the CPU bit for bit on "),
        "{last}"
    );
    assert!(
        last.ends_with(": 33554432 of 33554432 points and directions, 66 of 66 irradiance sums"),
        "{last}"
    );
    let mut names: Vec<_> = std::fs::read_dir(desk.path("made"))
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    assert_eq!(
        names,
        [
            "irradiance.csv",
            "irradiance.png",
            "irradiance.svg",
            "points.npy",
            "points.npy.json",
            "points.png",
            "points.svg"
        ]
    );
    npy(&desk.bytes("made/points.npy")).assert_is("<f4", 1 << 24, 2);
    for plot in ["points", "irradiance"] {
        assert!(
            desk.bytes(&format!("made/{plot}.png"))
                .starts_with(b"\x89PNG\r\n\x1a\n")
        );
        let svg = String::from_utf8(desk.bytes(&format!("made/{plot}.svg"))).unwrap();
        assert!(svg.contains("<svg") && svg.trim_end().ends_with("</svg>"));
    }
    let table = String::from_utf8(desk.bytes("made/irradiance.csv")).unwrap();
    let mut rows = table
        .lines()
        .map(|line| line.split(',').collect::<Vec<_>>());
    let header = rows.next().unwrap();
    let at = |name: &str| header.iter().position(|known| *known == name).unwrap();
    let rows: Vec<_> = rows.collect();
    assert_eq!(rows.len(), 66);
    let mut printed = said.lines();
    for (i, row) in rows.iter().enumerate() {
        assert_eq!(
            row[at("axis")],
            ["+x", "-x", "+y", "-y", "+z", "-z"][i / 11]
        );
        assert_eq!(row[at("count")], (1024 << (i % 11)).to_string());
        assert_eq!(row[at("equal_to_cpu")], "true");
        let error: f64 = row[at("relative_error")].parse().unwrap();
        assert!(error.is_finite() && error >= 0.0);
        // At 2^20 points the sun's few texels are hit often enough.
        assert!(i % 11 < 10 || error < 0.05, "{row:?}");
        assert!(row[at("device_ms")].parse::<f64>().unwrap() > 0.0);
        assert!(
            printed.any(|line| line.contains(row[at("axis")]) && line.contains(row[at("count")]))
        );
    }
}
