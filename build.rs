//! Lists the GLSL headers, and compiles, decorates and lints the stock kernels.
//!
//! A shader error, a missing include and a linter's violation are build errors.

use std::path::{Path, PathBuf};
use std::{env, fmt::Write, fs};

#[cfg(feature = "gpu")]
#[allow(dead_code, unused_imports, reason = "the crate uses the rest")]
#[path = "src/interface/mod.rs"]
mod interface;

#[cfg(feature = "gpu")]
#[allow(dead_code, unused_imports, reason = "the crate uses the rest")]
#[path = "src/spirv/mod.rs"]
mod spirv;

#[cfg(feature = "gpu")]
#[allow(dead_code, reason = "the crate uses the rest")]
#[path = "src/compile/mod.rs"]
mod compile;

type Result<T> = std::result::Result<T, String>;

fn main() {
    if let Err(error) = run() {
        eprintln!("corput: {error}");
        std::process::exit(1);
    }
}

fn run() -> Result<()> {
    let variable = |name| env::var(name).map_err(|error| format!("{name}: {error}"));
    let root = PathBuf::from(variable("CARGO_MANIFEST_DIR")?);
    let out = PathBuf::from(variable("OUT_DIR")?);
    // The folder itself is watched, so that a new header is seen.
    println!("cargo::rerun-if-changed=shaders");
    println!("cargo::rerun-if-changed=build.rs");
    headers(&root.join("shaders"), &out)?;
    #[cfg(feature = "gpu")]
    kernels(&root.join("shaders"), &out)?;
    Ok(())
}

fn write(path: &Path, bytes: &[u8]) -> Result<()> {
    fs::write(path, bytes).map_err(|error| format!("{}: {error}", path.display()))
}

/// Every file of `shaders/corput`, by its include name.
fn headers(shaders: &Path, out: &Path) -> Result<()> {
    let mut names = Vec::new();
    for folder in ["corput", "corput/native"] {
        let path = shaders.join(folder);
        for entry in fs::read_dir(&path).map_err(|error| format!("{}: {error}", path.display()))? {
            let entry = entry.map_err(|error| error.to_string())?;
            let name = entry.file_name().to_string_lossy().into_owned();
            if name.ends_with(".glsl") {
                names.push(format!("{folder}/{name}"));
            }
        }
    }
    names.sort();
    let mut text = String::from("&[\n");
    for name in names {
        let path = shaders.join(&name);
        writeln!(
            text,
            "    ({name:?}, include_str!({:?})),",
            path.display().to_string()
        )
        .map_err(|error| error.to_string())?;
    }
    text.push_str("]\n");
    write(&out.join("headers.rs"), text.as_bytes())
}

/// Compiles each row of the table to `OUT_DIR/NAME.spv`.
#[cfg(feature = "gpu")]
fn kernels(shaders: &Path, out: &Path) -> Result<()> {
    let mut text = String::from("&[\n");
    for kernel in interface::KERNELS {
        let path = shaders.join("kernels").join(kernel.source);
        let source =
            fs::read_to_string(&path).map_err(|error| format!("{}: {error}", path.display()))?;
        let mut lookup = |name: &str| {
            let folder = if name.starts_with("corput/") {
                shaders.to_owned()
            } else {
                shaders.join("kernels")
            };
            fs::read_to_string(folder.join(name)).ok()
        };
        let words = compile::kernel(kernel, &source, &mut lookup)
            .map_err(|error| format!("{} ({}): {error}", path.display(), kernel.name))?;
        let bytes: Vec<u8> = words.iter().flat_map(|word| word.to_le_bytes()).collect();
        write(&out.join(format!("{}.spv", kernel.name)), &bytes)?;
        writeln!(
            text,
            "    ({:?}, include_bytes!(concat!(env!(\"OUT_DIR\"), \"/{}.spv\"))),",
            kernel.name, kernel.name
        )
        .map_err(|error| error.to_string())?;
    }
    text.push_str("]\n");
    write(&out.join("kernels.rs"), text.as_bytes())
}
