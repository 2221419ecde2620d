//! Examples as programs of their own: drivers end with the process, and exit codes count.

use crate::support::validates;
use crate::{ash_engine, chunks, own_buffer, wgpu_engine};
use std::path::{Path, PathBuf};
use std::process::Command;

/// How a program ended.
pub struct Ended {
    pub code: Option<i32>,
    /// What it wrote, to both streams.
    pub said: String,
}

impl Ended {
    /// Whether it found nothing to run on, which is passed on aloud.
    pub fn is_skipped(&self) -> bool {
        let skipped = self.said.lines().find(|line| line.contains("SKIPPED"));
        if let Some(line) = skipped {
            eprintln!("{line}");
        }
        skipped.is_some()
    }
}

/// Runs a program to its end under the validation layer, whose messages fail the test.
pub fn ended(command: &mut Command) -> Ended {
    if validates() {
        command
            .env("VK_INSTANCE_LAYERS", "VK_LAYER_KHRONOS_validation")
            .env(
                "VK_LAYER_ENABLES",
                "VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT",
            );
    }
    let output = command.output().expect("a program that starts");
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    let said = text(&output.stdout) + &text(&output.stderr);
    for sign in ["VUID-", "SYNC-HAZARD"] {
        assert!(!said.contains(sign), "{said}");
    }
    let code = output.status.code();
    Ended { code, said }
}

/// Whose devices an example sees.
#[derive(Clone, Copy)]
pub enum Drivers {
    All,
    Lavapipe,
}

/// Separates the words of [`CALL`].
const BETWEEN: char = '\n';

/// Names an example and its arguments to a child.
const CALL: &str = "CORPUT_TEST_EXAMPLE";

/// Runs an example: what `cargo test` has built of it, or where that is missing or older than
/// its source, its functions in a child of this test.
pub fn example(name: &str, arguments: &[&Path], drivers: Drivers) -> Ended {
    let mut command = match built(name) {
        Some(program) => {
            let mut command = Command::new(program);
            command.args(arguments);
            command
        }
        None => in_a_child(name, arguments),
    };
    if let Drivers::Lavapipe = drivers {
        // The loader's own filter, by the names of manifests.
        command.env("VK_LOADER_DRIVERS_SELECT", "*lvp*");
    }
    ended(&mut command)
}

fn in_a_child(name: &str, arguments: &[&Path]) -> Command {
    let words = arguments.iter().map(|path| path.to_str().expect("UTF-8"));
    let call: Vec<&str> = std::iter::once(name).chain(words).collect();
    let mut command = Command::new(std::env::current_exe().expect("this test's path"));
    command
        .args(["--exact", "programs::child", "--ignored", "--nocapture"])
        .env(CALL, call.join(&BETWEEN.to_string()));
    command
}

/// The program of an example, beside the folder of the tests' programs.
fn built(name: &str) -> Option<PathBuf> {
    let test = std::env::current_exe().ok()?;
    let folder = test.parent()?.parent()?.join("examples");
    let program = folder.join(format!("{name}{}", std::env::consts::EXE_SUFFIX));
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("examples/{name}.rs"));
    let time = |path: &Path| path.metadata().and_then(|data| data.modified()).ok();
    (time(&program)? > time(&source)?).then_some(program)
}

#[test]
#[ignore = "run by example(), in a process of its own"]
fn child() {
    let Ok(call) = std::env::var(CALL) else {
        return;
    };
    let words: Vec<String> = call.split(BETWEEN).map(str::to_owned).collect();
    let (name, arguments) = words.split_first().expect("a name");
    let equal = match name.as_str() {
        "ash_engine" => ash_engine::run(arguments),
        "chunks" => chunks::run(arguments),
        "own_buffer" => own_buffer::run(arguments),
        "wgpu_engine" => wgpu_engine::run(arguments),
        other => panic!("no example {other}"),
    };
    let code = match equal {
        Ok(equal) => i32::from(!equal),
        Err(error) => {
            eprintln!("{name}: {error}");
            2
        }
    };
    std::process::exit(code);
}
