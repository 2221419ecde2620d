//! Stripped scenes: what is absent is absent, sizes stay within budgets, and the files are what
//! the manifest says.

#[path = "strip_scenes/absent.rs"]
mod absent;
#[path = "../gpu/program/corpus.rs"]
mod corpus;
#[path = "strip_scenes/languages.rs"]
mod languages;

use corpus::{Case, files};
use corput::bench::scene::{rows, sizes, stock_points};
use corput::catalog::Sampler;
use corput::compile::to_spirv_lean;
use corput::kernels::spirv;
use corput::scene::{Needs, Scene, parse, read};
use corput::spirv::{describe, drop_local_names, exact_policy, lint};
use corput::strip::program::{Form, Options, program};
use corput::strip::{Bundle, BundleOptions, TARGETS, Target, bundle};
use serde_json::Value;
use sha2::{Digest, Sha256};
use std::path::Path;
use std::process::Command;
use std::time::Instant;

/// Bytes that a scene's module may have: what it has, and a twentieth more at most.
const BUDGETS: &[(&str, usize)] = &[
    ("depth_of_field", 54_900),
    ("diffuse_quad", 22_600),
    ("diffuse_sky", 55_600),
    ("everything", 156_800),
    ("fog", 68_100),
    ("glossy_sphere", 143_800),
    ("lantern", 97_600),
    ("layered", 127_100),
    ("many_lights", 145_400),
    ("motion_blur", 94_000),
    ("studio", 111_000),
    ("studio_sky", 155_500),
];

fn scene(name: &str) -> (Scene, Needs) {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/scenes");
    let path = ["toml", "gltf", "glb"]
        .map(|ending| folder.join(format!("{name}.{ending}")))
        .into_iter()
        .find(|path| path.exists())
        .unwrap();
    let scene = read(&path).unwrap();
    let needs = Needs::of(&scene).unwrap();
    (scene, needs)
}

fn stripped(scene: &Scene, needs: &Needs) -> Bundle {
    bundle(scene, needs, &TARGETS, BundleOptions::default())
        .unwrap_or_else(|error| panic!("{}: {error}", scene.name))
}

#[test]
fn modules_are_within_their_budgets() {
    for Case { name, .. } in files() {
        let (scene, needs) = scene(&name);
        let bytes = 4 * stripped(&scene, &needs).spirv.len();
        let budget = BUDGETS.iter().find(|(known, _)| *known == name);
        let (_, budget) = budget.unwrap_or_else(|| panic!("{name} has no budget"));
        assert!(
            bytes <= *budget,
            "{name} has {bytes} bytes, more than {budget}"
        );
        assert!(
            bytes * 21 / 20 + 100 > *budget,
            "{name} has {bytes} bytes: lower its budget of {budget}"
        );
    }
}

/// `scripts/scene-tables` writes the page; its sizes and causes are those of today.
#[test]
fn the_page_of_scenes_is_of_these_modules() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/docs/scenes.md");
    let page = std::fs::read_to_string(path).unwrap();
    let spaced = |line: &str| line.split_whitespace().collect::<Vec<_>>().join(" ");
    for Case { name, .. } in files() {
        let part = page.split(&format!("\n## `{name}`\n")).nth(1);
        let part = part.unwrap_or_else(|| panic!("{name} is not in docs/scenes.md"));
        let lines: Vec<String> = part
            .lines()
            .take_while(|line| !line.starts_with("## "))
            .map(spaced)
            .collect();
        let (scene, needs) = scene(&name);
        let made = stripped(&scene, &needs);
        let sizes = sizes(&needs, &made.program, &made.spirv).unwrap();
        for row in rows(&sizes) {
            let row = spaced(&row.join(" "));
            assert!(
                lines.contains(&row),
                "{name}: `{row}` is not in docs/scenes.md"
            );
        }
        for domain in &needs.domains {
            // The table wraps long ones.
            let cause = domain.cause.to_string();
            let cause = cause.split(' ').take(3).collect::<Vec<_>>().join(" ");
            let told = |line: &&String| line.starts_with(&domain.key) && line.contains(&cause);
            assert!(
                lines.iter().any(|line| told(&line)),
                "{name}: {} because of {cause}",
                domain.key
            );
        }
    }
}

/// Warm: the compiler's own declarations are read once a process. The goal is 10 ms; what is
/// asserted leaves room for busy machines.
#[test]
fn compiling_takes_little_time() {
    for sampler in ["sobol", "halton"] {
        let mut scene = Scene::new("points").unwrap();
        scene.sampler.value = Sampler::parse(sampler).unwrap();
        let needs = Needs::of_points(&scene, 2, None).unwrap();
        let program = program("points", &needs, Options::default()).unwrap();
        let text = program.flat(false).unwrap().text;
        let times = (0..9).map(|_| {
            let start = Instant::now();
            assert!(to_spirv_lean(&text).unwrap().len() > 500);
            start.elapsed().as_secs_f64()
        });
        let best = times.fold(f64::INFINITY, f64::min);
        println!("{sampler}: {:.1} ms", 1e3 * best);
        assert!(best < 0.05, "{sampler}: {best} s");
    }
}

/// In every form and for all of their points, where the first two dimensions have no directions in
/// the text.
#[test]
fn sobol_points_are_a_quarter_of_the_general_kernel_in_every_form() {
    for sampler in ["sobol", "sobol:owen-hash"] {
        let mut scene = Scene::new("points").unwrap();
        scene.sampler.value = Sampler::parse(sampler).unwrap();
        scene.samples.value = 1 << 32;
        let needs = Needs::of_points(&scene, 2, None).unwrap();
        let general = spirv(stock_points(&needs).kernel.name).unwrap().len();
        for (cpu, int64, form) in [
            (false, false, Form::Four),
            (true, false, Form::Four),
            (true, true, Form::Eight),
        ] {
            let options = BundleOptions {
                cpu,
                int64,
                ..BundleOptions::default()
            };
            let made = bundle(&scene, &needs, &[Target::Spirv], options).unwrap();
            assert_eq!(made.program.form, form);
            assert_eq!(describe(&made.spirv).unwrap().bindings, [(0, 0)]);
            let words = made.spirv.len();
            assert!(
                4 * words <= general,
                "{sampler} {form:?}: {words} of {general}"
            );
        }
    }
}

/// Bare points against the kernel that chooses bases, nets and scrambles of their family at run
/// time, with its names and without those that a stripped module lacks too.
#[test]
fn bare_points_are_a_quarter_of_the_general_kernel() {
    for (sampler, share) in [("halton", 0.28), ("sobol", 0.25), ("sobol:owen-hash", 0.29)] {
        let mut scene = Scene::new("points").unwrap();
        scene.sampler.value = Sampler::parse(sampler).unwrap();
        scene.samples.value = 1024;
        let needs = Needs::of_points(&scene, 2, None).unwrap();
        let general = spirv(stock_points(&needs).kernel.name).unwrap();
        let bytes = stripped(&scene, &needs).spirv.len();
        assert!(
            4 * bytes <= general.len(),
            "{sampler}: {bytes} of {} words",
            general.len()
        );
        let nameless = drop_local_names(&general).unwrap().len();
        let part = bytes as f64 / nameless as f64;
        assert!(
            part <= share,
            "{sampler}: {bytes} of {nameless} words, {part}"
        );
    }
}

#[test]
fn the_manifest_says_what_is_there() {
    let (scene, needs) = scene("studio_sky");
    let made = stripped(&scene, &needs);
    let names: Vec<&str> = made.files.iter().map(|file| file.name.as_str()).collect();
    assert_eq!(
        names,
        [
            "studio_sky.glsl",
            "studio_sky.spv",
            "studio_sky.godot.glsl",
            "studio_sky.wgsl",
            "studio_sky.hlsl",
            "studio_sky.msl",
            "studio_sky.h",
            "studio_sky.rs",
            "studio_sky.environment.bin",
            "manifest.json"
        ]
    );
    let manifest: Value = serde_json::from_slice(&made.files.last().unwrap().bytes).unwrap();
    let listed = manifest["files"].as_array().unwrap();
    assert_eq!(listed.len(), made.files.len() - 1);
    for (file, said) in made.files.iter().zip(listed) {
        let hash: String = Sha256::digest(&file.bytes)
            .iter()
            .map(|byte| format!("{byte:02x}"))
            .collect();
        assert_eq!(said["sha256"], hash.as_str(), "{}", file.name);
        assert_eq!(said["bytes"], file.bytes.len());
    }
    assert_eq!(manifest["tables"][0]["binding"], 1);
    assert_eq!(manifest["bindings"]["parameters"], 2);
    assert_eq!(manifest["record_words"], made.program.record.words);
    // Strange readers are told that no compiler has seen it, and what is not promised.
    for ending in ["hlsl", "msl"] {
        let file = made
            .files
            .iter()
            .find(|file| file.name.ends_with(ending))
            .unwrap();
        let text = String::from_utf8(file.bytes.clone()).unwrap();
        assert!(text.contains("generated, not compiled here"), "{ending}");
        assert!(text.contains("tier F has no guarantee"), "{ending}");
    }
    // Runs are as long in every language.
    let options = BundleOptions {
        cpu: true,
        ..BundleOptions::default()
    };
    let (quad, quad_needs) = self::scene("diffuse_quad");
    for options in [options, BundleOptions::default()] {
        let made = bundle(&quad, &quad_needs, &TARGETS, options).unwrap();
        let run = format!("begin = i * {}u;", made.program.run);
        let godot = made
            .files
            .iter()
            .find(|file| file.name.ends_with("godot.glsl"))
            .unwrap();
        assert!(
            String::from_utf8_lossy(&godot.bytes).contains(&run),
            "{run}"
        );
    }
    let again = stripped(&scene, &needs);
    assert_eq!(made.files, again.files, "the same scene, other bytes");
}

/// Version of a crate in Cargo.lock.
fn locked(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("Cargo.lock");
    let lock: toml::Table = std::fs::read_to_string(path).unwrap().parse().unwrap();
    let packages = lock["package"].as_array().unwrap();
    let mut found = packages
        .iter()
        .filter(|one| one["name"].as_str() == Some(name));
    let version = found.next().unwrap()["version"].as_str().unwrap();
    assert!(found.next().is_none(), "two versions of {name}");
    version.to_owned()
}

#[test]
fn the_manifest_has_the_versions_that_are_built() {
    let (scene, needs) = scene("diffuse_quad");
    let made = bundle(&scene, &needs, &[], BundleOptions::default()).unwrap();
    let manifest: Value = serde_json::from_slice(&made.files.last().unwrap().bytes).unwrap();
    for name in ["glslang", "naga"] {
        let said = manifest["versions"][name].as_str().unwrap();
        let version = said.strip_prefix(&format!("crate {name} ")).unwrap();
        // Cargo takes any that agrees in the first number, or in two after a 0.
        let locked = locked(name);
        assert!(
            locked.starts_with(&format!("{version}.")),
            "{said}: {locked}"
        );
        let parts = version.split('.').count();
        assert_eq!(
            parts,
            if version.starts_with("0.") { 2 } else { 1 },
            "{said}"
        );
    }
}

/// A program on PATH; it is said aloud where there is none.
fn tool(name: &str) -> bool {
    let there = Command::new(name).arg("--version").output().is_ok();
    if !there {
        eprintln!("SKIPPED: no {name} on PATH");
    }
    there
}

#[test]
fn the_optimiser_is_recorded_and_its_module_linted() {
    if !tool("spirv-opt") {
        return;
    }
    let (scene, needs) = scene("diffuse_quad");
    let plain = stripped(&scene, &needs);
    let options = BundleOptions {
        spirv_opt: true,
        ..BundleOptions::default()
    };
    let made = bundle(&scene, &needs, &[Target::Spirv], options).unwrap();
    let manifest: Value = serde_json::from_slice(&made.files.last().unwrap().bytes).unwrap();
    assert_eq!(manifest["spirv_opt"]["bytes_before"], 4 * plain.spirv.len());
    assert!(
        manifest["spirv_opt"]["version"]
            .as_str()
            .is_some_and(|v| !v.is_empty())
    );
    assert_ne!(made.spirv, plain.spirv);
    assert!(describe(&made.spirv).is_ok());
    // The file, its entry and what was linted are the module after the optimiser.
    let report = lint(&made.spirv, &exact_policy()).unwrap();
    assert!(report.is_clean(), "{:?}", report.violations);
    let bytes: Vec<u8> = made.spirv.iter().flat_map(|w| w.to_le_bytes()).collect();
    assert_eq!(made.files[0].bytes, bytes);
    let entry = &manifest["files"][0];
    assert_eq!(entry["checked"], "compiled by glslang, linted");
    assert_eq!(entry["bytes"], bytes.len());
    let hash: String = Sha256::digest(&bytes)
        .iter()
        .map(|byte| format!("{byte:02x}"))
        .collect();
    assert_eq!(entry["sha256"], hash);
}

#[test]
fn two_environments_are_refused() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/scenes");
    let text = "[environment]\nmap = \"../sunrise.exr\"\n";
    let mut scene = parse(text, &folder.join("made.toml")).unwrap();
    let mut second = scene.lights[0].clone();
    second.name = "second".to_owned();
    scene.lights.push(second);
    let needs = Needs::of(&scene).unwrap();
    let refused = bundle(&scene, &needs, &TARGETS, BundleOptions::default());
    let words = refused.unwrap_err().to_string();
    assert!(words.contains("two environments"), "{words}");
}
