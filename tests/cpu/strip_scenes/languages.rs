//! Scenes, samplers and maps in every language, and compilers that take the files.

use super::corpus::{Case, every_map, samplers};
use super::{scene, stripped, tool};
use corput::catalog::Profile;
use corput::scene::Scene;
use corput::strip::{BundleOptions, TARGETS, bundle};
use std::process::Command;

#[test]
fn every_sampler_is_expressed_in_every_language() {
    for Case { name, needs } in samplers() {
        let made = bundle(
            &Scene::new("points").unwrap(),
            &needs,
            &TARGETS,
            BundleOptions::default(),
        );
        let made = made.unwrap_or_else(|error| panic!("{name}: {error}"));
        assert!(
            made.files.iter().all(|file| !file.bytes.is_empty()),
            "{name}"
        );
    }
}

#[test]
fn every_map_is_expressed_in_every_language() {
    for profile in [Profile::Exact, Profile::Native] {
        for Case { name, needs } in every_map(profile) {
            let mut scene = Scene::new("map").unwrap();
            scene.profile = profile;
            let made = stripped(&scene, &needs);
            let mut files = made.files.iter();
            assert!(files.all(|file| !file.bytes.is_empty()), "{name}");
        }
    }
}

#[test]
fn compilers_take_the_files() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    let run = |program: &str, arguments: &[&str]| {
        if !tool(program) {
            return;
        }
        let done = Command::new(program)
            .args(arguments)
            .current_dir(folder.path())
            .output()
            .unwrap();
        let said = String::from_utf8_lossy(&done.stderr).into_owned();
        assert!(done.status.success(), "{program} {arguments:?}: {said}");
    };
    for name in ["diffuse_sky", "everything", "lantern"] {
        let (scene, needs) = scene(name);
        for file in &stripped(&scene, &needs).files {
            std::fs::write(at(&file.name), &file.bytes).unwrap();
        }
        run(
            "spirv-val",
            &["--target-env", "vulkan1.1", &format!("{name}.spv")],
        );
        std::fs::write(
            at("main.c"),
            format!("#include \"{name}.h\"\nint main(void) {{ return 0; }}\n"),
        )
        .unwrap();
        run(
            "cc",
            &["-std=c11", "-Wall", "-Werror", "-pedantic", "-c", "main.c"],
        );
        let module = format!("{name}.rs");
        run(
            "rustc",
            &[
                "--crate-type=lib",
                "--edition=2021",
                "-Dwarnings",
                "--crate-name=made",
                &module,
            ],
        );
    }
}
