//! examples/cpp_engine, where a C++ compiler and Vulkan's headers are.

use crate::programs::{Ended, ended};
use crate::support::skips;
use crate::{flipped, scene, stripped, write_words};
use corput::bulk::SceneReference;
use corput::scene::Needs;
use corput::strip::Target;
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::Command;

fn compiler() -> Command {
    Command::new(std::env::var_os("CXX").unwrap_or_else(|| OsString::from("c++")))
}

/// Whether a program over Vulkan can be built; said aloud where not.
fn can_build(desk: &Path) -> bool {
    let source = desk.join("probe.cpp");
    let text = "#include <vulkan/vulkan.h>\nint main() { return vkCreateInstance == nullptr; }\n";
    std::fs::write(&source, text).unwrap();
    let built = compiler()
        .args(["-std=c++17", "-o"])
        .arg(desk.join("probe"))
        .arg(&source)
        .arg("-lvulkan")
        .output();
    let can = built.is_ok_and(|output| output.status.success());
    if !can {
        eprintln!("SKIPPED: examples/cpp_engine needs a C++ compiler and libvulkan-dev");
    }
    can
}

/// The example's checksum: FNV-1a of words.
fn checksum(words: &[u32]) -> u64 {
    let step = |sum: u64, word: &u32| (sum ^ u64::from(*word)).wrapping_mul(0x0100_0000_01b3);
    words.iter().fold(0xcbf2_9ce4_8422_2325, step)
}

fn expected() -> String {
    let needs = Needs::of(&corput::scene::read(&scene("diffuse_sky.toml")).unwrap()).unwrap();
    let reference = SceneReference::new(&needs).unwrap();
    let words = u64::from(reference.record().words) * needs.request.count;
    let mut samples = vec![0; words as usize];
    reference.fill(0, &mut samples);
    format!("{:016x} ", checksum(&samples))
}

/// The lines that the program printed, one a device, without what layers say.
fn sums(run: &Ended, count: usize) -> Vec<String> {
    assert_eq!(run.code, Some(0), "{}", run.said);
    let is_sum = |line: &&str| line.split(' ').next().is_some_and(|word| word.len() == 16);
    let sums: Vec<String> = run.said.lines().filter(is_sum).map(str::to_owned).collect();
    assert!(sums.len() >= count, "{}", run.said);
    sums
}

#[test]
fn a_cpp_engine_draws_the_words_of_the_reference() {
    let desk = tempfile::tempdir().unwrap();
    if skips() || !can_build(desk.path()) {
        return;
    }
    // As `corput strip` writes it.
    let out = desk.path().join("out");
    std::fs::create_dir(&out).unwrap();
    let bundle = stripped(&scene("diffuse_sky.toml"), &[Target::Spirv, Target::C]);
    for file in &bundle.files {
        std::fs::write(out.join(&file.name), &file.bytes).unwrap();
    }
    let program: PathBuf = desk.path().join("cpp_engine");
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let built = compiler()
        .args([
            "-std=c++17",
            "-O2",
            "-Wall",
            "-Wextra",
            "-Werror",
            "-Wno-missing-field-initializers",
            "-I",
        ])
        .arg(&out)
        .arg(root.join("examples/cpp_engine/main.cpp"))
        .arg("-o")
        .arg(&program)
        .arg("-lvulkan")
        .output()
        .unwrap();
    let log = String::from_utf8_lossy(&built.stderr);
    assert!(built.status.success(), "{log}");

    let expected = expected();
    let run = || ended(Command::new(&program).arg(&out));
    let equal = sums(&run(), 1);
    assert!(
        equal.iter().all(|sum| sum.starts_with(&expected)),
        "{expected}: {equal:?}"
    );

    let module = out.join("diffuse_sky.spv");
    write_words(&module, &flipped(&bundle.spirv));
    let differ = sums(&run(), 1);
    assert!(
        differ.iter().all(|sum| !sum.starts_with(&expected)),
        "{differ:?}"
    );
    write_words(&module, &bundle.spirv[1..]);
    let refused = run();
    assert!(
        refused.code == Some(1) && refused.said.contains("of another module"),
        "{}",
        refused.said
    );
    std::fs::remove_file(&module).unwrap();
    let refused = run();
    assert!(
        refused.code == Some(1) && refused.said.contains("cannot read"),
        "{}",
        refused.said
    );
}
