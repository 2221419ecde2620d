//! Scenes, samplers and maps in every language, and compilers that take the files.

use super::corpus::{Case, every_map, files, samplers};
use super::{scene, stripped, tool};
use corput::catalog::Profile;
use corput::compile::{to_spirv, to_spirv_lean};
use corput::scene::Scene;
use corput::spirv::describe;
use corput::strip::program::{Options, Parameters, program};
use corput::strip::{BundleOptions, TARGETS, Target, bundle};
use glslang::{
    Compiler, CompilerOptions, Shader, ShaderInput, ShaderSource, ShaderStage, SourceLanguage,
    SpirvVersion, Target::Vulkan, VulkanVersion,
};
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

/// The compiler reads kernels with the declarations of an earlier version, which are fewer: the
/// modules are those of the version that they name.
#[test]
fn the_lean_compiler_makes_the_same_modules() {
    let maps = [Profile::Exact, Profile::Native]
        .into_iter()
        .flat_map(every_map);
    let mut count = 0;
    for Case { name, needs } in files().into_iter().chain(maps) {
        for parameters in [Parameters::Push, Parameters::Uniform] {
            let options = Options {
                parameters,
                ..Options::default()
            };
            let program = program(&name, &needs, options).unwrap();
            let text = program
                .flat(parameters == Parameters::Uniform)
                .unwrap()
                .text;
            let lean = to_spirv_lean(&text).unwrap();
            let whole = to_spirv(&text, &[], &mut |_| None).unwrap();
            assert!(lean == whole, "{name}, {parameters:?}");
            count += 1;
        }
    }
    assert!(count > 100, "{count}");
    // What a later version has is not guessed at.
    let later = "#version 460\nlayout(local_size_x = 1) in;\n\
        void main() { if (anyInvocation(true)) return; }\n";
    assert!(to_spirv(later, &[], &mut |_| None).is_ok());
    assert!(to_spirv_lean(later).is_err());
    assert!(
        to_spirv_lean("void main() {}\n")
            .unwrap_err()
            .contains("#version")
    );
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
    for Case { name, .. } in files() {
        let (scene, needs) = scene(&name);
        for file in &stripped(&scene, &needs).files {
            std::fs::write(at(&file.name), &file.bytes).unwrap();
        }
        run(
            "spirv-val",
            &["--target-env", "vulkan1.1", &format!("{name}.spv")],
        );
        for int64 in [false, true] {
            let options = BundleOptions {
                cpu: true,
                int64,
                ..BundleOptions::default()
            };
            let of_cpus = bundle(&scene, &needs, &[Target::Spirv], options).unwrap();
            let bytes: Vec<u8> = of_cpus
                .spirv
                .iter()
                .flat_map(|word| word.to_le_bytes())
                .collect();
            std::fs::write(at("cpu.spv"), bytes).unwrap();
            run("spirv-val", &["--target-env", "vulkan1.1", "cpu.spv"]);
        }
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

/// HLSL as glslang's front end reads it, to SPIR-V.
fn hlsl(text: &str) -> Result<Vec<u32>, String> {
    let compiler = Compiler::acquire().expect("glslang starts");
    let source = ShaderSource::from(text);
    let options = CompilerOptions {
        source_language: SourceLanguage::HLSL,
        target: Vulkan {
            version: VulkanVersion::Vulkan1_1,
            spirv_version: SpirvVersion::SPIRV1_3,
        },
        ..CompilerOptions::default()
    };
    let none: Option<&[(&str, Option<&str>)]> = None;
    ShaderInput::new(&source, ShaderStage::Compute, &options, none, None)
        .and_then(|input| {
            let mut shader = Shader::new(compiler, input);
            shader.entry_point("main");
            shader.source_entry_point("main");
            shader.parse()
        })
        .and_then(|shader| shader.compile())
        .map_err(|error| error.to_string())
}

/// The text with arrays that begin unset where they begin as zeros: `(T[N])0` is HLSL, but none
/// that glslang reads.
fn without_zeros(text: &str) -> String {
    let line = |line: &str| match line.split_once(" = (") {
        Some((declared, value)) if value.ends_with("])0;") => format!("{declared};\n"),
        _ => format!("{line}\n"),
    };
    text.lines().map(line).collect()
}

#[test]
fn a_front_end_takes_the_hlsl() {
    let mut zeros = 0;
    for Case { name, .. } in files() {
        let (scene, needs) = scene(&name);
        let made = bundle(&scene, &needs, &[Target::Hlsl], BundleOptions::default()).unwrap();
        let text = String::from_utf8(made.files[0].bytes.clone()).unwrap();
        let read = without_zeros(&text);
        zeros += usize::from(read != text);
        let words = hlsl(&read).unwrap_or_else(|error| panic!("{name}: {error}"));
        assert!(describe(&words).is_ok(), "{name}");
        let broken = read.replacen("uint", "uimt", 1);
        assert!(hlsl(&broken).is_err(), "{name}");
    }
    assert_eq!(zeros, 1);
}
