//! `corput strip` and `corput bench --scene` as their user meets them.

mod desk;
mod support;

use desk::{Desk, Run, repository};
use std::fs;
use support::skips;

fn scene(name: &str) -> String {
    let path = repository("tests/data/scenes").join(name);
    path.display().to_string()
}

fn sky() -> String {
    scene("diffuse_sky.toml")
}

/// The files of a folder on the desk, sorted.
fn names(desk: &Desk, folder: &str) -> Vec<String> {
    let entries = fs::read_dir(desk.path(folder)).unwrap();
    let mut names: Vec<String> = entries
        .map(|entry| entry.unwrap().file_name().to_string_lossy().into_owned())
        .collect();
    names.sort();
    names
}

fn text(desk: &Desk, name: &str) -> String {
    String::from_utf8(desk.bytes(name)).unwrap()
}

#[test]
fn a_scene_is_written_for_every_target() {
    let desk = Desk::new();
    let all = "glsl,spirv,wgsl,hlsl,msl,c,rust,godot";
    let line = format!("strip {} --out new/out --target {all}", sky());
    let said = desk.say(&line);
    assert_eq!(
        names(&desk, "new/out"),
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
    let godot = text(&desk, "new/out/diffuse_sky.godot.glsl");
    assert!(godot.starts_with("#[compute]\n#version 450\n"));
    // Once more into the same folder: the same bytes.
    let before = desk.bytes("new/out/manifest.json");
    desk.say(&line);
    assert_eq!(desk.bytes("new/out/manifest.json"), before);
}

#[test]
fn points_need_no_scene() {
    let desk = Desk::new();
    desk.say("strip --sampler halton --dims 3 --map cosine-hemisphere --out .");
    let header = text(&desk, "halton_cosine_hemisphere.h");
    for part in ["RECORD_WORDS 5u", "WORD_X2 4u", "SAMPLES_MOST 1024u"] {
        assert!(header.contains(part), "{part} is not in:\n{header}");
    }
    let said = desk.say("strip --sampler sobol --json");
    let document: serde_json::Value = serde_json::from_str(&said).unwrap();
    assert_eq!(document["stripped"]["bound_resources"], 1);
    assert!(document["speeds"].is_null());
}

#[test]
fn points_for_cpus_are_stored_eight_words_at_a_time() {
    let desk = Desk::new();
    desk.say("strip --sampler sobol --cpu --int64 --out .");
    assert!(text(&desk, "sobol.glsl").contains("u64vec4 samples[]"));
    let header = text(&desk, "sobol.h");
    for part in [
        "RUN 16u",
        "SAMPLES_MULTIPLE 16u",
        "FIRST_MULTIPLE 16u",
        "NEEDS_INT64 1u",
    ] {
        assert!(header.contains(part), "{part} is not in:\n{header}");
    }
    let manifest = desk.bytes("manifest.json");
    let manifest: serde_json::Value = serde_json::from_slice(&manifest).unwrap();
    assert_eq!(manifest["samples_multiple"], 16);
    assert_eq!(manifest["first_multiple"], 16);
    assert_eq!(manifest["needs_int64"], true);
    // Scenes with maps stay as they are.
    let scene = scene("diffuse_quad.toml");
    desk.say(&format!("strip {scene} --cpu --out four"));
    desk.say(&format!("strip {scene} --cpu --int64 --out eight"));
    assert_eq!(
        desk.bytes("four/diffuse_quad.spv"),
        desk.bytes("eight/diffuse_quad.spv")
    );
}

#[test]
fn the_report_says_what_was_left_out_and_timed() {
    let desk = Desk::new();
    let quad = scene("diffuse_quad.toml");
    desk.ask(&format!("strip {quad} --report out/report.html"));
    let page = text(&desk, "out/report.html");
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
    let quad = scene("diffuse_quad.toml");
    let desk = Desk::new();
    let said = desk.ask(&format!("bench --scene {quad} --json"));
    let document: serde_json::Value = serde_json::from_str(&said).unwrap();
    // The module that is measured is the one that is written, for GPUs or for CPUs.
    let written = ["", "--cpu"].map(|option| {
        desk.say(&format!("strip {quad} {option} --target spirv --out out"));
        desk.bytes("out/diffuse_quad.spv").len() as u64
    });
    let measured = &document["scenes"][0]["stripped"]["spirv_bytes"];
    let measured = measured.as_u64().unwrap();
    assert!(written.contains(&measured), "{measured} of {written:?}");
    let speeds = &document["scenes"][0]["speeds"];
    for side in ["full", "stripped"] {
        assert!(
            speeds[side]["median_s"].as_f64().is_some_and(|s| s > 0.0),
            "{speeds}"
        );
        // A direction and its pdf a sample; of the stock kernels its point too.
        let samples = speeds[side]["samples"].as_u64().unwrap();
        let words = if side == "full" { 6 } else { 4 };
        assert_eq!(speeds[side]["bytes"], 4 * words * samples, "{speeds}");
    }
    let compiled = speeds["compile_s"].as_f64().unwrap();
    assert_eq!(speeds["compile_goal_reached"], compiled <= 0.01);
}

#[test]
fn what_cannot_be_is_refused_and_nothing_written() {
    let desk = Desk::new();
    fs::write(desk.path("broken.toml"), "[camera]\nlense = 1\n").unwrap();
    let sky = sky();
    for (line, words) in [
        (format!("strip {sky} --target glls"), "did you mean `glsl`"),
        (
            format!("strip {sky} --sampler sobol"),
            "--sampler beside a scene",
        ),
        ("strip".to_owned(), "it takes a scene, or a sampler"),
        (
            "strip broken.toml".to_owned(),
            "line 2, column 1: unknown key `lense`",
        ),
        ("strip --sampler sobl".to_owned(), "did you mean `sobol`"),
        (
            "strip --sampler sobol --dims 1025".to_owned(),
            "at most 1024",
        ),
        (format!("strip {sky} --device none"), "none"),
        ("strip --sampler sobol --dims 99999".to_owned(), "99999"),
        (
            "strip --sampler sobol --samples 4294967297".to_owned(),
            "4294967297",
        ),
        (
            "strip --sampler sobol --dims 1 --map cone --param theta_max=0.1".to_owned(),
            "more dimensions",
        ),
        (
            "strip --sampler sobol --map environment".to_owned(),
            "named by a scene",
        ),
        (
            "strip --sampler sobol --param h=1".to_owned(),
            "only maps have parameters",
        ),
        (format!("strip {sky} --int64"), "--cpu"),
        // Their runs are of 48 and of 24.
        (
            "strip --sampler halton --dims 5 --cpu --int64 --target spirv,wgsl".to_owned(),
            "strip it twice",
        ),
        ("bench --scene none.toml".to_owned(), "none.toml"),
    ] {
        let out = if line.starts_with("strip") {
            " --out out"
        } else {
            ""
        };
        desk.run(&format!("{line}{out}")).expect(2, &[words]);
        assert_eq!(desk.names(), ["broken.toml"], "{line} wrote something");
    }
}

#[test]
fn a_name_that_is_taken_leaves_all_as_it_was() {
    let desk = Desk::new();
    // The module's name is that of a folder.
    fs::create_dir(desk.path("diffuse_sky.spv")).unwrap();
    fs::write(desk.path("diffuse_sky.glsl"), "mine").unwrap();
    let line = format!("strip {} --out .", sky());
    desk.run(&line).expect(2, &["diffuse_sky.spv"]);
    assert_eq!(desk.names(), ["diffuse_sky.glsl", "diffuse_sky.spv"]);
    assert_eq!(text(&desk, "diffuse_sky.glsl"), "mine");
}

/// A program that stands on PATH for the optimiser: it says its version, and otherwise does
/// this.
#[cfg(unix)]
fn optimiser(desk: &Desk, does: &str) -> std::ffi::OsString {
    use std::os::unix::fs::PermissionsExt;
    let path = desk.path("bin/spirv-opt");
    fs::create_dir_all(desk.path("bin")).unwrap();
    let text = format!("#!/bin/sh\n[ \"$1\" = --version ] && echo made-up 1 && exit\n{does}\n");
    fs::write(&path, text).unwrap();
    fs::set_permissions(&path, fs::Permissions::from_mode(0o755)).unwrap();
    let known = std::env::var_os("PATH").unwrap_or_default();
    let folders = std::iter::once(desk.path("bin")).chain(std::env::split_paths(&known));
    std::env::join_paths(folders).unwrap()
}

#[cfg(unix)]
#[test]
fn what_an_optimiser_makes_is_linted_again() {
    let desk = Desk::new();
    // A root of the device's own outside the functions that may have one.
    let native = "#version 450\nlayout(local_size_x = 64) in;\n\
        layout(std430, set = 0, binding = 0) buffer Samples { float samples[]; };\n\
        void main() { samples[0] = sqrt(samples[1]); }\n";
    let words = corput::compile::to_spirv(native, &[], &mut |_| None).unwrap();
    let bytes: Vec<u8> = words.iter().flat_map(|word| word.to_le_bytes()).collect();
    fs::write(desk.path("native.spv"), bytes).unwrap();
    let line = format!(
        "strip {} --target spirv --spirv-opt --out out",
        scene("diffuse_quad.toml")
    );
    let run = |does: &str| {
        let path = optimiser(&desk, does);
        let mut command = desk.command(&line);
        command.env("PATH", path);
        Run::of(&line, command)
    };
    for (does, words) in [
        (
            "cat >/dev/null; cat native.spv",
            &["after it the linter refuses it", "Sqrt"][..],
        ),
        ("cat >/dev/null; printf four", &["after it"]),
        (
            "cat >/dev/null; echo no >&2; exit 1",
            &["spirv-opt failed: no"],
        ),
    ] {
        run(does).expect(2, words);
        assert!(!desk.path("out").exists(), "{does}");
    }
    // The same module is fit.
    run("cat").expect(0, &[]);
    let manifest: serde_json::Value =
        serde_json::from_slice(&desk.bytes("out/manifest.json")).unwrap();
    assert_eq!(manifest["spirv_opt"]["version"], "made-up 1");
    let bytes = desk.bytes("out/diffuse_quad.spv").len();
    assert_eq!(manifest["spirv_opt"]["bytes_before"], bytes);
}

/// The stock modules, and those of points with their constants; nothing of what is refused.
#[test]
fn stock_modules_are_written() {
    let desk = Desk::new();
    let said = desk.say("modules --out all/of");
    assert!(said.contains("modules.json"), "{said}");
    let found = names(&desk, "all/of");
    assert!(found.len() > 50 && found.contains(&"generate.spv".to_owned()));
    desk.say("modules --sampler sobol --dims 12 --count 100 --out few");
    assert_eq!(
        names(&desk, "few"),
        ["columns.bin", "constants.json", "generate_net.spv"]
    );
    let said = text(&desk, "few/constants.json");
    assert!(said.contains("\"DIMENSIONS\"") && said.contains("\"sampler\": \"sobol\""));
    for (line, word) in [
        ("--sampler haltn", "did you mean `halton`"),
        ("--sampler halton --dims 0", "0"),
        ("--sampler halton --count 0", "0"),
        ("--sampler halton --count 4294967297", "4294967297"),
        ("--dims 2", "--sampler"),
    ] {
        desk.run(&format!("modules {line} --out none"))
            .expect(2, &[word]);
        assert!(!desk.path("none").exists(), "{line}");
    }
}
