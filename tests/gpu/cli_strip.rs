//! `corput strip` and `corput bench --scene` as their user meets them.

mod support;

use std::fs;
use std::path::Path;
use std::process::{Command, Output};
use support::skips;

fn corput(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_corput"))
        .args(arguments)
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .output()
        .expect("corput runs")
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

fn succeeds(arguments: &[&str]) -> String {
    let run = corput(arguments);
    assert_eq!(run.status.code(), Some(0), "{}", text(&run.stderr));
    text(&run.stdout)
}

/// The files of a folder, sorted.
fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).unwrap();
    let mut names: Vec<String> = entries
        .map(|entry| entry.unwrap().file_name().to_string_lossy().into_owned())
        .collect();
    names.sort();
    names
}

const SKY: &str = "tests/data/scenes/diffuse_sky.toml";

#[test]
fn a_scene_is_written_for_every_target() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("new/out");
    let path = out.to_str().unwrap();
    let all = "glsl,spirv,wgsl,hlsl,msl,c,rust,godot";
    let said = succeeds(&["strip", SKY, "--out", path, "--target", all]);
    assert_eq!(
        names(&out),
        [
            "diffuse_sky.environment.bin",
            "diffuse_sky.glsl",
            "diffuse_sky.godot.glsl",
            "diffuse_sky.h",
            "diffuse_sky.hlsl",
            "diffuse_sky.msl",
            "diffuse_sky.rs",
            "diffuse_sky.spv",
            "diffuse_sky.wgsl",
            "manifest.json"
        ]
    );
    for part in [
        "SPIR-V bytes",
        "bound resources",
        "wrote 10 files",
        "read again and validated",
    ] {
        assert!(said.contains(part), "{part} is not in:\n{said}");
    }
    let godot = fs::read_to_string(out.join("diffuse_sky.godot.glsl")).unwrap();
    assert!(godot.starts_with("#[compute]\n#version 450\n"));
    // Once more into the same folder: the same bytes.
    let before = fs::read(out.join("manifest.json")).unwrap();
    succeeds(&["strip", SKY, "--out", path, "--target", all]);
    assert_eq!(fs::read(out.join("manifest.json")).unwrap(), before);
}

#[test]
fn points_need_no_scene() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().to_str().unwrap();
    let points = ["strip", "--sampler", "halton", "--dims", "3"];
    let written = ["--map", "cosine-hemisphere", "--out", path];
    succeeds(&[&points[..], &written].concat());
    let header = fs::read_to_string(folder.path().join("halton_cosine_hemisphere.h")).unwrap();
    for part in ["RECORD_WORDS 5u", "WORD_X2 4u", "SAMPLES_MOST 1024u"] {
        assert!(header.contains(part), "{part} is not in:\n{header}");
    }
    let said = succeeds(&["strip", "--sampler", "sobol", "--json"]);
    let document: serde_json::Value = serde_json::from_str(&said).unwrap();
    assert_eq!(document["stripped"]["bound_resources"], 1);
    assert!(document["speeds"].is_null());
}

#[test]
fn the_report_says_what_was_left_out_and_timed() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("out/report.html");
    let report = path.to_str().unwrap();
    succeeds(&[
        "strip",
        "tests/data/scenes/diffuse_quad.toml",
        "--report",
        report,
    ]);
    let page = fs::read_to_string(&path).unwrap();
    for part in [
        "diffuse_quad: what its kernel leaves out",
        "<td>SPIR-V bytes</td>",
        "light.0",
        "there is no phase function",
    ] {
        assert!(page.contains(part), "{part}");
    }
    assert!(!page.contains("<script") && !page.contains("http://"));
    assert_eq!(page.contains("million samples a second"), !skips());
}

#[test]
fn scenes_are_measured_against_the_stock_kernels() {
    if skips() {
        return;
    }
    let scene = "tests/data/scenes/diffuse_quad.toml";
    let said = succeeds(&["bench", "--scene", scene, "--json"]);
    let document: serde_json::Value = serde_json::from_str(&said).unwrap();
    let speeds = &document["scenes"][0]["speeds"];
    for side in ["full", "stripped"] {
        assert!(
            speeds[side]["median_s"].as_f64().is_some_and(|s| s > 0.0),
            "{speeds}"
        );
    }
}

#[test]
fn what_cannot_be_is_refused_and_nothing_written() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("out");
    let path = out.to_str().unwrap();
    let broken = folder.path().join("broken.toml");
    fs::write(&broken, "[camera]\nlense = 1\n").unwrap();
    let broken = broken.to_str().unwrap();
    for (arguments, words) in [
        (
            &["strip", SKY, "--target", "glls"][..],
            "did you mean `glsl`",
        ),
        (
            &["strip", SKY, "--sampler", "sobol"],
            "--sampler beside a scene",
        ),
        (&["strip"], "it takes a scene, or a sampler"),
        (&["strip", broken], "line 2, column 1: unknown key `lense`"),
        (&["strip", "--sampler", "sobl"], "did you mean `sobol`"),
        (
            &["strip", "--sampler", "sobol", "--dims", "1025"],
            "at most 1024",
        ),
        (
            &["strip", SKY, "--device", "no such device"],
            "no such device",
        ),
        (&["strip", "--sampler", "sobol", "--dims", "99999"], "99999"),
        (
            &["strip", "--sampler", "sobol", "--samples", "4294967297"],
            "4294967297",
        ),
        (
            &[
                "strip",
                "--sampler",
                "sobol",
                "--dims",
                "1",
                "--map",
                "cone",
                "--param",
                "theta_max=0.1",
            ],
            "more dimensions",
        ),
        (
            &["strip", "--sampler", "sobol", "--map", "environment"],
            "named by a scene",
        ),
        (
            &["strip", "--sampler", "sobol", "--param", "h=1"],
            "only maps have parameters",
        ),
        (
            &["bench", "--scene", "tests/data/scenes/none.toml"],
            "none.toml",
        ),
    ] {
        let mut all = arguments.to_vec();
        if arguments[0] == "strip" {
            all.extend(["--out", path]);
        }
        let run = corput(&all);
        let said = text(&run.stderr);
        assert_eq!(run.status.code(), Some(2), "{arguments:?}: {said}");
        assert!(said.contains(words), "{arguments:?}: {said}");
        assert!(!out.exists(), "{arguments:?} wrote something");
    }
}

#[test]
fn a_name_that_is_taken_leaves_all_as_it_was() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path();
    // The module's name is that of a folder.
    fs::create_dir(out.join("diffuse_sky.spv")).unwrap();
    fs::write(out.join("diffuse_sky.glsl"), "mine").unwrap();
    let run = corput(&["strip", SKY, "--out", out.to_str().unwrap()]);
    assert_eq!(run.status.code(), Some(2), "{}", text(&run.stderr));
    assert_eq!(names(out), ["diffuse_sky.glsl", "diffuse_sky.spv"]);
    assert_eq!(
        fs::read_to_string(out.join("diffuse_sky.glsl")).unwrap(),
        "mine"
    );
}
