//! The smallest shader that does the same: one file of what `main` reaches.
//!
//! [`flatten`] puts a shader's includes in place, decides its conditions, and keeps the
//! declarations that `main` leads to. No name and no expression changes, so neither do results.
//! [`bake`] makes plain constants of its specialization constants. [`measure`] counts what a compiled module has, [`host`] writes its interface for C, C++ and
//! Rust, and `translate`, with the feature `strip`, writes it in other shading languages.
//!
//! ```
//! let shader = "#version 450\n#include \"corput/sobol_directions.glsl\"\n\
//!     #include \"corput/unit.glsl\"\n\
//!     layout(set = 0, binding = 0) buffer Words { float words[]; };\n\
//!     void main() { words[0] = corput_unit_floor(7u); }\n";
//! let mut lookup = |name: &str| {
//!     let found = corput::headers().iter().find(|(known, _)| *known == name);
//!     found.map(|(_, text)| (*text).to_owned())
//! };
//! let flat = corput::strip::flatten(shader, &[], &mut lookup)?;
//! assert!(!flat.text.contains("CORPUT_SOBOL_DIRECTIONS"));
//! assert_eq!(flat.parts[1].left_out.table_bytes(), 4 * 2048);
//! # Ok::<(), corput::Error>(())
//! ```

mod bake;
#[cfg(all(feature = "gpu", feature = "scenes", feature = "strip"))]
mod bundle;
mod classify;
mod condition;
mod fault;
mod flat;
mod group;
pub mod host;
mod item;
mod lex;
mod macros;
mod measure;
mod preprocess;
mod print;
#[cfg(feature = "scenes")]
pub mod program;
mod reach;
#[cfg(feature = "strip")]
mod translate;
mod words;

pub use bake::bake;
#[cfg(all(feature = "gpu", feature = "scenes", feature = "strip"))]
pub use bundle::{Bundle, BundleOptions, File, Optimised, TARGETS, Target, bundle};
pub use flat::{Constant, Contents, Flat, Part};
pub use measure::{Measure, measure};
#[cfg(feature = "strip")]
pub use translate::{About, Shader, Translations, Translator, translate};

use crate::Result;
use fault::{Fault, refuse};

/// Looks up the text of an include by its name.
pub type Lookup<'a> = dyn FnMut(&str) -> Option<String> + 'a;

/// The name of the shader itself.
const MAIN: &str = "main";

/// The name of the macros from outside.
const OUTSIDE: &str = "defines";

/// One file with what a shader's `main` reaches. `defines` are macros as a compiler's `-D` gives
/// them; `lookup` gives the text of includes, each at most once.
///
/// Function-like macros and macros of values stay where kept declarations use them; conditions
/// are decided. What cannot be decided is an error and no guess: macros that only a compiler
/// knows (`GL_*`, `VULKAN`), includes in angle brackets, `#line`, text that is no GLSL.
///
/// Time is linear in the text: some milliseconds for the largest kernel of this crate.
///
/// # Errors
/// File, line and what is not understood there; a missing include; no `main`.
pub fn flatten(main: &str, defines: &[(&str, Option<&str>)], lookup: &mut Lookup) -> Result<Flat> {
    let mut preprocessor = preprocess::Preprocessor::new(lookup);
    let shader = preprocessor.add(MAIN, main.to_owned())?;
    let mut lines = String::new();
    for (name, value) in defines {
        let value = value.unwrap_or("");
        // Each is its line, and nothing of another's.
        let name_ends = name.contains(char::is_whitespace) || name.contains("/*");
        if name_ends || value.contains(['\n', '\\']) || value.contains("/*") {
            let problem = format!("the macro `{name}` is not one name and one line");
            return Err(refuse(
                OUTSIDE,
                0,
                problem,
                "give a name, and a value in one line",
            ));
        }
        lines += format!("#define {name} {value}").trim_end();
        lines.push('\n');
    }
    if !lines.is_empty() {
        let outside = preprocessor.add(OUTSIDE, lines)?;
        preprocessor.read(outside)?;
    }
    preprocessor.read(shader)?;
    preprocessor.expand()?;
    let text = preprocessor.text;
    if text.version.is_empty() {
        return Err(refuse(
            MAIN,
            0,
            "no `#version`",
            "begin with `#version 450`",
        ));
    }
    let items = item::split(&text)?;
    let Some(reached) = reach::reached(&text, &items) else {
        return Err(refuse(
            MAIN,
            0,
            "no function `main`",
            "give a complete shader",
        ));
    };
    let kept = print::Kept::new(&text, &items, reached);
    Ok(Flat {
        text: print::print(&text, &items, &kept),
        parts: flat::parts(&text, &items, &kept),
    })
}
