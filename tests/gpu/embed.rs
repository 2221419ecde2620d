//! The examples of engines, run: stripped scenes over ash, wgpu and in C++, and headers in a
//! shader of someone else's. Each is shown to notice what is broken.

#[allow(dead_code, reason = "its main is the example's own")]
#[path = "../../examples/ash_engine.rs"]
mod ash_engine;
#[allow(dead_code, reason = "its main is the example's own")]
#[path = "../../examples/chunks.rs"]
mod chunks;
#[path = "embed/constants.rs"]
mod constants;
#[path = "embed/cpp.rs"]
mod cpp;
#[path = "embed/include_only.rs"]
mod include_only;
#[allow(dead_code, reason = "its main is the example's own")]
#[path = "../../examples/own_buffer.rs"]
mod own_buffer;
#[path = "embed/programs.rs"]
mod programs;
mod support;
#[allow(dead_code, reason = "its main is the example's own")]
#[path = "../../examples/wgpu_engine.rs"]
mod wgpu_engine;

use corput::bulk::SceneReference;
use corput::scene::Needs;
use corput::strip::program::{Options, Parameters, Sampler, program};
use corput::strip::{Bundle, BundleOptions, Target, bundle};
use programs::{Drivers, Ended, example};
use std::path::{Path, PathBuf};
use support::{at_once, on_each_device, skips};

/// Scenes that every driver compiles in seconds: with a table, without, and with two.
const SMALL: [&str; 3] = ["diffuse_sky.toml", "depth_of_field.toml", "fog.toml"];

/// Those that SwiftShader takes minutes and gigabytes to compile run on lavapipe alone. All of
/// these are of the exact profile: the native one has not the same bits everywhere.
const LARGE: [&str; 4] = [
    "diffuse_quad.toml",
    "motion_blur.toml",
    "layered.toml",
    "many_lights.toml",
];

fn scene(name: &str) -> PathBuf {
    let scenes = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/scenes");
    scenes.join(name)
}

fn stripped(path: &Path, targets: &[Target]) -> Bundle {
    let scene = corput::scene::read(path).unwrap();
    let needs = Needs::of(&scene).unwrap();
    bundle(&scene, &needs, targets, BundleOptions::default()).unwrap()
}

/// A factor of the hash of `sobol:owen-hash`.
const FACTOR: u32 = 0x3d20_adea;

/// The module with one bit of a constant flipped.
fn flipped(module: &[u32]) -> Vec<u32> {
    let mut words = module.to_vec();
    let found = words.iter().position(|word| *word == FACTOR);
    words[found.expect("the factor")] ^= 4;
    words
}

fn write_words(path: &Path, words: &[u32]) {
    let bytes: Vec<u8> = words.iter().flat_map(|word| word.to_le_bytes()).collect();
    std::fs::write(path, bytes).unwrap();
}

/// The sky with another seed: what it draws has the same form, and other words.
fn other_seed() -> Bundle {
    let mut other = corput::scene::read(&scene("diffuse_sky.toml")).unwrap();
    other.seed += 1;
    let needs = Needs::of(&other).unwrap();
    let targets = [Target::Wgsl, Target::Spirv];
    bundle(&other, &needs, &targets, BundleOptions::default()).unwrap()
}

/// That a run ended with this code and said this.
fn ended(run: &Ended, code: i32, part: &str) {
    let Ended { code: got, said } = run;
    assert!(*got == Some(code) && said.contains(part), "{got:?}\n{said}");
}

const EQUAL: &str = ": 0 of ";

/// A sky among so many lights that one is searched for in a table.
fn two_tables(desk: &Path) -> PathBuf {
    let path = desk.join("two_tables.toml");
    let sky = scene("../sunrise.exr");
    let mut text = format!("samples = 300\n[environment]\nmap = {sky:?}\n");
    for power in 1..=20 {
        text += &format!("[[light]]\nkind = \"point\"\npower = {power}\n");
    }
    std::fs::write(&path, text).unwrap();
    assert_eq!(stripped(&path, &[]).program.tables.len(), 2);
    path
}

/// That an example draws the words of the reference, wherever it finds something to run on.
fn draws_the_reference(name: &str) {
    if skips() {
        return;
    }
    let desk = tempfile::tempdir().unwrap();
    let mut runs = vec![(two_tables(desk.path()), Drivers::All)];
    runs.extend(SMALL.map(|name| (scene(name), Drivers::All)));
    let devices = support::instance(&support::turn()).devices().unwrap();
    if devices
        .iter()
        .any(|device| device.name.contains("llvmpipe"))
    {
        runs.extend(LARGE.map(|name| (scene(name), Drivers::Lavapipe)));
    } else {
        eprintln!("SKIPPED: without lavapipe {name} does not draw {LARGE:?}");
    }
    at_once(&runs, |(path, drivers)| {
        let run = example(name, &[path], *drivers);
        if !run.is_skipped() {
            ended(&run, 0, EQUAL);
        }
    });
}

#[test]
fn an_ash_engine_draws_the_words_of_the_reference() {
    draws_the_reference("ash_engine");
}

#[test]
fn a_wgpu_engine_draws_the_words_of_the_reference() {
    draws_the_reference("wgpu_engine");
}

#[test]
fn an_ash_engine_notices_what_is_broken() {
    if skips() {
        return;
    }
    let desk = tempfile::tempdir().unwrap();
    let (sky, module) = (scene("diffuse_sky.toml"), desk.path().join("module.spv"));
    let own = stripped(&sky, &[]);
    for (words, code) in [
        (own.spirv.clone(), 0),
        (flipped(&own.spirv), 1),
        (other_seed().spirv, 1),
    ] {
        write_words(&module, &words);
        ended(
            &example("ash_engine", &[&sky, &module], Drivers::All),
            code,
            " words differ",
        );
    }
    std::fs::write(&module, "no module").unwrap();
    ended(
        &example("ash_engine", &[&sky, &module], Drivers::All),
        2,
        "ash_engine: ",
    );
    let none = desk.path().join("none.toml");
    ended(
        &example("ash_engine", &[&none], Drivers::All),
        2,
        "none.toml",
    );
}

#[test]
fn a_wgpu_engine_notices_what_is_broken() {
    if skips() {
        return;
    }
    let desk = tempfile::tempdir().unwrap();
    let (sky, shader) = (scene("diffuse_sky.toml"), desk.path().join("shader.wgsl"));
    let wgsl = |bundle: &Bundle| String::from_utf8(bundle.files[0].bytes.clone()).unwrap();
    let own = wgsl(&stripped(&sky, &[Target::Wgsl]));
    let factor = format!("{FACTOR}u");
    assert!(own.contains(&factor));
    let flipped = own.replace(&factor, &format!("{}u", FACTOR ^ 4));
    let other = wgsl(&other_seed());
    for (text, code, part) in [
        (own.as_str(), 0, EQUAL),
        (&flipped, 1, " words differ"),
        (&other, 1, " words differ"),
        ("fn main() { no; }", 2, "wgpu_engine: "),
    ] {
        std::fs::write(&shader, text).unwrap();
        let run = example("wgpu_engine", &[&sky, &shader], Drivers::All);
        if run.is_skipped() {
            return;
        }
        ended(&run, code, part);
    }
}

/// Points in bulk: their words are compared by the examples themselves, on every device.
#[test]
fn the_examples_of_bulk_points_agree_with_the_cpu() {
    if skips() {
        return;
    }
    let devices = support::instance(&support::turn()).devices().unwrap().len();
    for name in ["chunks", "own_buffer"] {
        let run = example(name, &[], Drivers::All);
        ended(&run, 0, "equal: true");
        assert_eq!(run.said.matches("equal: true").count(), devices);
    }
}

#[test]
fn the_text_for_godot_draws_the_words_of_the_reference() {
    let path = scene("diffuse_sky.toml");
    let own = stripped(&path, &[Target::Godot]);
    let text = String::from_utf8(own.files[0].bytes.clone()).unwrap();
    // Godot's own line says what the file is; without it this is GLSL.
    let glsl = text.strip_prefix("#[compute]\n").unwrap();
    let needs = Needs::of(&corput::scene::read(&path).unwrap()).unwrap();
    let options = Options {
        parameters: Parameters::Uniform,
        cpu: false,
        int64: false,
    };
    let program = program("diffuse_sky", &needs, options).unwrap();
    let words = program.spirv(glsl).unwrap();
    let reference = SceneReference::new(&needs).unwrap();
    on_each_device(|device| {
        let sampler = Sampler::new(device, &program, &words).unwrap();
        let made = sampler.run(5, 100).unwrap();
        let mut expected = vec![0; made.len()];
        reference.fill(5, &mut expected);
        assert_eq!(made, expected);
        reference.fill(6, &mut expected);
        assert_ne!(made, expected);
    });
}
