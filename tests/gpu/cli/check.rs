//! `corput check` for continuous integration: hashes, time limits, JUnit.

use super::{Desk, skips};
use corput::card::SCHEMA;
use serde_json::Value;
use std::fs;

fn document(desk: &Desk, line: &str) -> Value {
    serde_json::from_str(&desk.say(line)).unwrap()
}

/// Words that choose the faster of the drivers of tests, where it is here.
fn fast(desk: &Desk) -> &'static str {
    match desk.say("devices").contains("llvmpipe") {
        true => "--device llvmpipe",
        false => "",
    }
}

#[test]
fn documents_are_compared_by_their_hashes() {
    if skips() {
        return;
    }
    let desk = Desk::new();
    let mut one = document(&desk, "check --only radical_inverse --json");
    let rows = one["rows"].as_array().unwrap();
    assert!(
        rows.iter()
            .all(|row| row["sha256"].as_str().is_some_and(|hash| hash.len() == 64))
    );
    let count = rows.len();
    std::fs::write(desk.path("a.json"), one.to_string()).unwrap();
    let again = document(&desk, "check --only radical_inverse --json");
    std::fs::write(desk.path("b.json"), again.to_string()).unwrap();
    let said = document(&desk, "check --compare a.json b.json --json");
    assert_eq!(said["equal"], count);
    // One word of one result is another hash.
    one["rows"][0]["sha256"] = "0".repeat(64).into();
    std::fs::write(desk.path("c.json"), one.to_string()).unwrap();
    let run = desk.run("check --compare a.json c.json");
    run.expect(1, &["1 exact rows differ", "0 are in one"]);
    let text = String::from_utf8(run.stdout).unwrap();
    assert!(text.contains("differs      radical_inverse"), "{text}");
    // A row that is not there is not equal.
    one["rows"].as_array_mut().unwrap().pop();
    std::fs::write(desk.path("c.json"), one.to_string()).unwrap();
    desk.run("check --compare a.json c.json").expect(1, &[]);
    // Documents without any compare nothing.
    one["rows"].as_array_mut().unwrap().clear();
    std::fs::write(desk.path("c.json"), one.to_string()).unwrap();
    desk.run("check --compare c.json c.json")
        .expect(2, &["c.json", "no row of the exact profile"]);
    std::fs::write(desk.path("c.json"), "{}").unwrap();
    desk.run("check --compare a.json c.json")
        .expect(2, &["c.json", "no rows"]);
    desk.run("check --compare a.json none.json")
        .expect(2, &["none.json"]);
}

#[test]
fn a_short_time_leaves_rows_out_and_says_so() {
    if skips() {
        return;
    }
    let desk = Desk::new();
    let said = document(&desk, "check --seconds 2 --json --junit j.xml");
    let (rows, left) = (&said["rows"], &said["left_out"]);
    let (rows, left) = (
        rows.as_array().unwrap().len(),
        left.as_array().unwrap().len(),
    );
    assert!(rows > 0 && left > 100, "{rows} {left}");
    let xml = String::from_utf8(desk.bytes("j.xml")).unwrap();
    assert_eq!(xml.matches("<testcase ").count(), rows + left);
    assert_eq!(xml.matches("<skipped ").count(), left);
    assert!(
        xml.contains(&format!("tests=\"{}\" failures=\"0\"", rows + left)),
        "{xml}"
    );
    desk.run("check --seconds 0")
        .expect(2, &["--seconds 0", "no row began"]);
    desk.run("check --seconds -3").expect(2, &["-3"]);
    desk.run("check --seconds nan")
        .expect(2, &["--seconds NaN", "from 0"]);
    desk.run("check --seconds x").expect(2, &["x"]);
}

#[test]
fn a_card_says_who_what_and_what_not() {
    if skips() {
        return;
    }
    let desk = Desk::new();
    let line = "check --only uniform_hemisphere --report card --json";
    let said = document(&desk, line);
    let kept: Value = serde_json::from_slice(&desk.bytes("card/report.json")).unwrap();
    assert_eq!(said, kept);
    assert_eq!(said["schema"], SCHEMA);
    assert_eq!(said["command"], format!("corput {line}"));
    assert_eq!(said["fingerprint"].as_str().map(str::len), Some(64));
    let kernels = said["kernels"].as_array().unwrap();
    assert!(kernels.len() > 50);
    assert!(
        kernels
            .iter()
            .all(|one| one["violations"] == Value::Array(Vec::new()))
    );
    assert!(!said["not_proved"].as_array().unwrap().is_empty());
    let page = String::from_utf8(desk.bytes("card/report.html")).unwrap();
    for part in [
        said["fingerprint"].as_str().unwrap(),
        "Not proved",
        "uniform_hemisphere",
        "Every row passed",
    ] {
        assert!(page.contains(part), "{part}");
    }
    for part in ["<script", "http:", "https:"] {
        assert!(!page.contains(part), "{part}");
    }
    assert!(desk.bytes("card/junit.xml").starts_with(b"<?xml"));
}

#[test]
fn a_report_that_cannot_be_written_is_refused_before_work() {
    let desk = Desk::new();
    desk.run("check --junit none/j.xml")
        .expect(2, &["none/j.xml"]);
    for name in ["report.json", "report.html"] {
        fs::create_dir_all(desk.path(&format!("{name}.d/{name}"))).unwrap();
        let line = format!("check --report {name}.d");
        desk.run(&line).expect(2, &[name]);
    }
}

/// Both in one folder, which is not there before; `junit.xml` is the same file twice.
#[test]
fn a_report_and_a_junit_file_may_share_a_new_folder() {
    if skips() {
        return;
    }
    let desk = Desk::new();
    let line = "check --only unit_stratum --report out --junit out";
    for name in ["junit.xml", "other.xml"] {
        desk.run(&format!("{line}/{name}")).expect(0, &[]);
        assert!(desk.bytes(&format!("out/{name}")).starts_with(b"<?xml"));
    }
    let mut names: Vec<_> = fs::read_dir(desk.path("out")).unwrap().collect();
    names.sort_by_key(|entry| entry.as_ref().unwrap().file_name());
    let names: Vec<_> = names
        .into_iter()
        .map(|entry| entry.unwrap().file_name())
        .collect();
    assert_eq!(
        names,
        ["junit.xml", "other.xml", "report.html", "report.json"]
    );
}

#[test]
fn extreme_cases_are_one_document() {
    if skips() {
        return;
    }
    let desk = Desk::new();
    // Each device has its own test of all of them.
    let fast = fast(&desk);
    let found = document(&desk, &format!("check --extreme --json {fast}"));
    assert_eq!(found["schema"], corput::extreme::SCHEMA);
    let rows = found["rows"].as_array().unwrap();
    let counts = &found["counts"];
    assert_eq!(counts["rows"], rows.len());
    assert_eq!(counts["failed"], 0);
    let device = rows.iter().filter(|row| row.get("device").is_some());
    assert_eq!(counts["on_device"], device.count());
    let host = rows.iter().filter(|row| row["subject"] == "host");
    assert_eq!(counts["on_host_alone"], host.count());
    let refused = rows.iter().filter(|row| row["verdict"] == "refused");
    assert_eq!(counts["refused"], refused.count());
    // A part, none, and all as JUnit.
    let line = format!("check --extreme --seconds 0.001 --json {fast}");
    let part = document(&desk, &line);
    let (some, left) = (&part["rows"], &part["left_out"]);
    let [some, left] = [some, left].map(|list| list.as_array().unwrap().len());
    assert!(some > 0 && left > 0);
    assert_eq!(some + left, rows.len());
    desk.run("check --extreme --seconds 0")
        .expect(2, &["no row began"]);
    desk.run("check --extreme --device cpu --junit j.xml")
        .expect(0, &[]);
    let xml = String::from_utf8(desk.bytes("j.xml")).unwrap();
    let cases = format!("tests=\"{}\" failures=\"0\"", rows.len());
    assert!(xml.contains(&cases), "{xml}");
    desk.run("check --extreme --device cpu --seconds 1")
        .expect(2, &["--seconds", "on the CPU"]);
    // The CPU alone has the same errors of its own.
    let alone = document(&desk, "check --extreme --device cpu --json");
    assert_eq!(alone["device"], "cpu");
    assert_eq!(alone["counts"]["on_device"], 0);
    assert_eq!(alone["counts"]["failed"], 0);
    for (one, other) in rows.iter().zip(alone["rows"].as_array().unwrap()) {
        assert_eq!(one["cpu"], other["cpu"]);
    }
}

/// The first of two rows, by which the other's time is spent.
#[test]
fn an_exhaustive_check_is_bounded_and_told() {
    if skips() {
        return;
    }
    let desk = Desk::new();
    let line = "check --exhaustive --only korobov,";
    desk.run(line).expect(2, &["korobov,"]);
    desk.run("check --exhaustive --only multiply --seconds 0")
        .expect(2, &["no row began"]);
    let fast = fast(&desk);
    let line = "check --exhaustive --only multiply --seconds 0.001 --json --junit j.xml";
    let run = desk.run(&format!("{line} {fast}"));
    run.expect(0, &[]);
    let said: Value = serde_json::from_slice(&run.stdout).unwrap();
    let left = said["left_out"].as_array().unwrap().len();
    assert!(left > 0);
    assert_eq!(said["rows"].as_array().unwrap().len(), 1);
    assert_eq!(said["rows"][0]["hash"], "equal");
    let xml = String::from_utf8(desk.bytes("j.xml")).unwrap();
    let cases = format!(
        "tests=\"{}\" failures=\"0\" errors=\"0\" skipped=\"{left}\"",
        left + 1
    );
    assert!(xml.contains(&cases), "{xml}");
}

/// The steps of the README's workflow in an engine that has this repository as a submodule: the
/// script and the manifest are where they say, and the last step, bounded, leaves what is uploaded.
#[test]
#[cfg(unix)]
fn the_workflow_of_the_readme_runs() {
    use std::process::Command;
    if skips() {
        return;
    }
    let root = env!("CARGO_MANIFEST_DIR");
    let readme = fs::read_to_string(format!("{root}/README.md")).unwrap();
    let workflow = readme.split("```yaml").nth(1).unwrap();
    let workflow = workflow.split("```").next().unwrap();
    let steps: Vec<&str> = workflow
        .lines()
        .filter_map(|line| line.split_once("- run: "))
        .map(|(_, step)| step.split(" #").next().unwrap().trim_end())
        .collect();
    let [setup, build, check] = steps.as_slice() else {
        panic!("{steps:?}");
    };
    let desk = Desk::new();
    fs::create_dir(desk.path("extern")).unwrap();
    std::os::unix::fs::symlink(root, desk.path("extern/corput")).unwrap();
    let shell = |line: &str| {
        let mut command = Command::new("bash");
        let run = command.args(["-euc", line]).current_dir(desk.path("."));
        let output = run.output().expect("it runs");
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "`{line}`: {said}");
        String::from_utf8(output.stdout).unwrap()
    };
    // What it installs is there where this runs: its words are read, not followed.
    let script = setup.split(' ').nth(1).unwrap();
    shell(&format!("bash -n {script}"));
    let told = format!(". scripts/{}", setup.split_once("scripts/").unwrap().1);
    let text = fs::read_to_string(desk.path(script)).unwrap();
    assert!(text.contains(&told), "{told}");
    // What cargo would build there is here already.
    let (cargo, manifest) = build.split_once(" --manifest-path ").unwrap();
    assert_eq!(cargo, "cargo build --release");
    assert!(desk.path(manifest).is_file(), "{manifest}");
    let built = manifest.replace("Cargo.toml", "target/release/corput");
    let check = check
        .strip_prefix(&built)
        .unwrap_or_else(|| panic!("{check}"));
    shell(&format!(
        "{}{check} --seconds 3",
        env!("CARGO_BIN_EXE_corput")
    ));
    let upload = workflow.split("path: ").nth(1).unwrap();
    let folder = upload.split([' ', '}']).next().unwrap();
    for name in ["report.html", "report.json", "junit.xml"] {
        assert!(desk.path(folder).join(name).is_file(), "{name}");
    }
    let xml = desk.bytes("junit.xml");
    assert!(xml.starts_with(b"<?xml"));
}
