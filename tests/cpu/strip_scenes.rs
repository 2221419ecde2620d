//! Stripped scenes: what is absent is absent, sizes stay within budgets, and the files are what
//! the manifest says.

#[path = "../gpu/program/corpus.rs"]
mod corpus;

use corpus::{Case, files, samplers};
use corput::catalog::{Profile, SEQUENCES, Sampler, Sequence, maps};
use corput::kernels::spirv;
use corput::scene::{Draw, Needs, Scene, parse, read};
use corput::spirv::{describe, drop_local_names};
use corput::strip::{Bundle, BundleOptions, TARGETS, Target, bundle, measure};
use corput::variant::{Work, general};
use serde_json::Value;
use sha2::{Digest, Sha256};
use std::path::Path;
use std::process::Command;

/// Bytes that a scene's module may have: what it has, and a twentieth more.
const BUDGETS: &[(&str, usize)] = &[
    ("depth_of_field", 55_000),
    ("diffuse_quad", 22_500),
    ("diffuse_sky", 55_600),
    ("everything", 170_900),
    ("fog", 69_800),
    ("glossy_sphere", 143_800),
    ("lantern", 97_900),
    ("layered", 127_100),
    ("many_lights", 145_400),
    ("motion_blur", 94_000),
    ("studio", 111_700),
    ("studio_sky", 157_800),
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

fn functions(words: &[u32]) -> Vec<String> {
    let facts = describe(words).unwrap();
    // glslang adds the types of parameters after a bracket.
    let plain = |name: &String| name.split('(').next().unwrap_or(name).to_owned();
    facts.functions.iter().map(plain).collect()
}

/// Names of functions that only this sequence's columns call.
fn own_functions(sequence: Sequence) -> &'static [&'static str] {
    match sequence {
        Sequence::RandomFast => &["corput_random_fast"],
        Sequence::Pcg32 => &["corput_pcg32_value"],
        Sequence::Stratified => &["corput_stratified"],
        Sequence::LatinHypercube => &["corput_latin_hypercube"],
        Sequence::MultiJittered => &["corput_cmj"],
        Sequence::Hammersley => &["corput_hammersley_value"],
        Sequence::Sobol => &["corput_owen_hash_reversed"],
        Sequence::Pmj02 => &["corput_pmj02_scramble"],
        Sequence::Lattice => &["corput_lattice"],
        Sequence::Korobov => &["corput_korobov"],
        Sequence::R2 => &["corput_additive"],
        // Strata and nets are jittered by random numbers, Hammersley's set has radical inverses.
        _ => &[],
    }
}

/// What a module has that its scene does not need.
fn superfluous(needs: &Needs, words: &[u32]) -> Vec<String> {
    let found = functions(words);
    let mut wrong = Vec::new();
    for map in maps() {
        let name = map.name.replace('-', "_");
        let drawn = needs.domains.iter().filter_map(|one| one.draw.mapping());
        // Bounded caps are caps of another lobe.
        let is_this = |other: &str| {
            other == map.name || (other == "ggx-vndf-bounded" && map.name == "ggx-vndf-cap")
        };
        // These are parts of others: a cosine-weighted direction lies over the disk.
        let within = [
            "concentric-disk",
            "polar-disk",
            "uniform-sphere",
            "cone",
            "exponential",
            "spherical-triangle",
            "gaussian",
            "beckmann-normal",
            "box-muller",
            "normal-pair",
        ];
        let mut drawn = drawn.map(|mapping| mapping.map().name);
        if within.contains(&map.name) || drawn.any(is_this) {
            continue;
        }
        let names = [format!("corput_{name}"), format!("corput_native_{name}")];
        wrong.extend(found.iter().filter(|one| names.contains(one)).cloned());
    }
    for sequence in SEQUENCES
        .iter()
        .filter(|one| **one != needs.request.sequence)
    {
        let own = own_functions(*sequence);
        let own = own.iter().map(ToString::to_string);
        wrong.extend(own.filter(|name| found.contains(name)));
    }
    let native = needs.request.profile == Profile::Native;
    if !native {
        let foreign = found
            .iter()
            .filter(|name| name.starts_with("corput_native_"));
        wrong.extend(foreign.cloned());
    }
    let facts = measure(words).unwrap();
    if facts.table_bytes > 0 {
        wrong.push(format!("{} bytes of tables", facts.table_bytes));
    }
    if facts.specialization > 0 {
        wrong.push(format!("{} specialization constants", facts.specialization));
    }
    let environment = |draw: &Draw| {
        draw.mapping()
            .is_some_and(|one| one.map().name.starts_with("environment"))
    };
    let many = |draw: &Draw| matches!(draw, Draw::Choice(weights) if weights.len() > 16);
    let tables = needs
        .domains
        .iter()
        .filter(|one| environment(&one.draw) || many(&one.draw));
    if facts.resources.len() > 1 + tables.count() {
        wrong.push(format!("{:?} are bound", facts.resources));
    }
    wrong
}

#[test]
fn what_is_absent_is_absent() {
    let cases = files();
    assert!(cases.len() >= 12);
    for Case { name, .. } in &cases {
        let (scene, needs) = scene(name);
        let made = stripped(&scene, &needs);
        let wrong = superfluous(&needs, &made.spirv);
        assert_eq!(wrong, Vec::<String>::new(), "{name}");
    }
    // The general kernel, with all that a scene's kernel has not.
    let (_, quad) = scene("diffuse_quad");
    let stock = corput::kernels::spirv("generate_digits").unwrap();
    let wrong = superfluous(&quad, &stock).join(", ");
    assert!(wrong.contains("specialization constants"), "{wrong}");
    for (sampler, word) in [
        ("lattice", "corput_lattice"),
        ("cmj", "corput_cmj"),
        ("r2", "corput_additive"),
    ] {
        let case = samplers()
            .into_iter()
            .find(|case| case.name.starts_with(sampler))
            .unwrap();
        let made = stripped(&Scene::new("points").unwrap(), &case.needs);
        let wrong = superfluous(&quad, &made.spirv);
        assert!(wrong.iter().any(|one| one == word), "{sampler}: {wrong:?}");
    }
    // Each of these is found where it is: the needs of one scene, the module of another.
    for (other, word) in [
        ("glossy_sphere", "corput_ggx_vndf"),
        ("everything", "corput_native_ggx_vndf_cap"),
        ("diffuse_sky", "are bound"),
        ("fog", "corput_henyey_greenstein"),
    ] {
        let (scene, needs) = scene(other);
        let wrong = superfluous(&quad, &stripped(&scene, &needs).spirv);
        assert!(
            wrong.iter().any(|one| one.contains(word)),
            "{other}: {wrong:?}"
        );
    }
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
            bytes > budget * 8 / 10,
            "{name} has {bytes} bytes: lower its budget of {budget}"
        );
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
        let general = general(&Work {
            columns: &needs.request.columns,
            first: 0,
            points: needs.request.count,
            fractions: true,
            map: None,
            native: false,
            cpu: false,
            int64: false,
        });
        let general = spirv(general.kernel.name).unwrap();
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

/// A program on PATH; it is said aloud where there is none.
fn tool(name: &str) -> bool {
    let there = Command::new(name).arg("--version").output().is_ok();
    if !there {
        eprintln!("SKIPPED: no {name} on PATH");
    }
    there
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
