//! The optimiser of SPIR-V Tools, when it is asked for.

use crate::compile::check;
use crate::interface::Profile;
use crate::{Error, Result};
use std::io::Write;
use std::process::{Command, Stdio};

/// The program, found on PATH.
const PROGRAM: &str = "spirv-opt";

/// Its passes for exact modules. None inlines: what a function is named for is what the linter
/// allows it, and inlined into `main` a seed of a square root is just a square root.
const PASSES: &[&str] = &[
    "--eliminate-dead-branches",
    "--eliminate-local-single-block",
    "--eliminate-local-single-store",
    "--scalar-replacement=0",
    "--ssa-rewrite",
    "--ccp",
    "--simplify-instructions",
    "--local-redundancy-elimination",
    "--eliminate-dead-branches",
    "--eliminate-dead-code-aggressive",
    "--eliminate-dead-functions",
    "--eliminate-dead-const",
    "--merge-blocks",
];

/// A module after `spirv-opt`, of the native profile by its `-O`, decorated and linted again, and
/// the line that names the program's version.
pub(super) fn optimise(name: &str, words: &[u32], profile: Profile) -> Result<(Vec<u32>, String)> {
    let failed = |limit: String| Error::Arguments {
        asked: format!("--spirv-opt for {name}"),
        limit,
        remedy: "install SPIR-V Tools (Debian: spirv-tools), or do without --spirv-opt".to_owned(),
    };
    let passes = match profile {
        Profile::Native => &["-O"],
        _ => PASSES,
    };
    let not_there = |error: std::io::Error| failed(format!("{PROGRAM}: {error}"));
    let version = Command::new(PROGRAM)
        .arg("--version")
        .output()
        .map_err(not_there)?;
    // Some versions say it on one, some on the other.
    let said = [version.stdout, version.stderr].concat();
    let said = String::from_utf8_lossy(&said);
    let version = said.lines().next().unwrap_or("").trim().to_owned();
    let mut child = Command::new(PROGRAM)
        .arg("--target-env=vulkan1.1")
        .args(passes)
        .args(["-", "-o", "-"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .map_err(not_there)?;
    let bytes: Vec<u8> = words.iter().flat_map(|word| word.to_le_bytes()).collect();
    let input = child.stdin.take();
    // It reads all before it writes; a thread keeps that from mattering.
    let writer =
        std::thread::spawn(move || input.map_or(Ok(()), |mut input| input.write_all(&bytes)));
    let output = child.wait_with_output().map_err(not_there)?;
    let written = writer.join().is_ok_and(|result| result.is_ok());
    if !output.status.success() || !written || output.stdout.len() % 4 != 0 {
        let said = String::from_utf8_lossy(&output.stderr);
        return Err(failed(format!("{PROGRAM} failed: {}", said.trim())));
    }
    let words: Vec<u32> = output
        .stdout
        .chunks_exact(4)
        .map(|word| u32::from_le_bytes([word[0], word[1], word[2], word[3]]))
        .collect();
    let checked =
        check(&words, profile).map_err(|problem| failed(format!("after it {problem}")))?;
    Ok((checked, version))
}
