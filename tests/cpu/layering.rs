//! Imports point down: modules by level in Rust, no cycles among the headers, and a
//! public shader folder without bindings, versions or names of its host.

#[path = "layering/broken.rs"]
mod broken;
mod source;

use source::{files, first_name, glsl, includes, reached, read, split_commas, without_comments};
use std::collections::BTreeSet;

/// The levels of the design, lowest first. `lib.rs` only declares modules.
const LEVELS: [&[&str]; 10] = [
    &["interface", "tables", "error"],
    &[
        "reference",
        "judge",
        "blue_noise",
        "environment",
        "estimate",
        "irradiance",
        "spirv",
        "vulkan",
        "stats",
    ],
    &["image"],
    &["catalog", "variant", "report", "picture", "plot", "compile"],
    &["scene"],
    &["kernels", "bulk", "strip"],
    &["check"],
    &[
        "accuracy",
        "bench",
        "demo",
        "converge",
        "exhaustive",
        "extreme",
        "modules",
        "vectors",
    ],
    &["card"],
    &["cli"],
];

/// Imports within one level: (module, module it uses).
const SIDEWAYS: &[(&str, &str)] = &[("plot", "report")];

/// Words that a module must not name, comments and all: (module, word).
const UNSPEAKABLE: &[(&str, &[&str])] = &[
    ("reference", &["ash", "glslang"]),
    (
        "vulkan",
        &[
            "halton",
            "sobol",
            "hammersley",
            "radical",
            "hemisphere",
            "corput_",
        ],
    ),
];

fn level(module: &str) -> Option<usize> {
    LEVELS.iter().position(|modules| modules.contains(&module))
}

/// The module of a file of `src`; `main.rs` is the root of `cli`.
fn module(path: &str) -> &str {
    let first = path.split('/').next().unwrap_or("");
    match first.strip_suffix(".rs").unwrap_or(first) {
        "main" => "cli",
        other => other,
    }
}

/// What `pub use MODULE::...` in `lib.rs` puts at the root: (name, module).
fn root_names(lib: &str) -> Vec<(String, String)> {
    let code = without_comments(lib);
    let mut found = Vec::new();
    for item in code.split("pub use ").skip(1) {
        let item = item.split(';').next().unwrap_or("");
        let Some((module, names)) = item.split_once("::") else {
            continue;
        };
        for name in split_commas(names.trim_matches(['{', '}'])) {
            found.push((name.trim().to_owned(), module.trim().to_owned()));
        }
    }
    found
}

/// Modules that a file uses, by `crate::`, by `corput::` in the binary, and by `super::`
/// out of a module at the top.
fn uses(text: &str, roots: &[(String, String)]) -> BTreeSet<String> {
    let code = without_comments(text);
    let mut found = BTreeSet::new();
    for prefix in ["crate::", "corput::", "super::"] {
        for (at, _) in code.match_indices(prefix) {
            let rest = code[at + prefix.len()..].trim_start();
            let list = match rest.strip_prefix('{') {
                Some(_) => split_commas(braced(rest)),
                None => vec![rest.to_owned()],
            };
            for item in list {
                let name = first_name(item.trim());
                let at_root = roots.iter().find(|(root, _)| *root == name);
                let module = at_root.map_or(name, |(_, module)| module.clone());
                // `super::` mostly names what lies beside the file, in its own module.
                if prefix != "super::" || (level(&module).is_some() && item.contains("::")) {
                    found.insert(module);
                }
            }
        }
    }
    found
}

/// What lies within the brace that opens a text.
fn braced(text: &str) -> &str {
    let mut depth = 0;
    for (at, c) in text.char_indices() {
        depth += i32::from(c == '{') - i32::from(c == '}');
        if depth == 0 {
            return &text[1..at];
        }
    }
    text
}

/// Edges of a file that do not point down, and names that its module must not use.
fn faults(path: &str, text: &str, roots: &[(String, String)]) -> Vec<String> {
    let own = module(path);
    let Some(at) = level(own) else {
        return vec![format!(
            "{path}: module `{own}` is on no level: put it into LEVELS"
        )];
    };
    let mut found = Vec::new();
    for used in uses(text, roots) {
        match level(&used) {
            _ if used == own || SIDEWAYS.contains(&(own, used.as_str())) => {}
            // The crate's glam, and the list of headers, are nobody's module.
            None if ["glam", "headers"].contains(&used.as_str()) => {}
            None => found.push(format!("{path}: `{used}` is on no level")),
            Some(below) if below < at => {}
            Some(above) => found.push(format!("{path}: L{at} {own} uses L{above} {used}")),
        }
    }
    for (module, list) in UNSPEAKABLE {
        for word in list.iter().filter(|_| *module == own) {
            let lower = text.to_lowercase();
            // `ash` is a word of its own, the others also in longer names.
            let named = match *word {
                "ash" => source::words(&lower).any(|w| w == "ash"),
                word => lower.contains(word),
            };
            if named {
                found.push(format!("{path}: {own} names `{word}`"));
            }
        }
    }
    found
}

/// What a public header must not hold.
fn header_faults(text: &str) -> Vec<String> {
    let mut found = Vec::new();
    let code = without_comments(text);
    for line in code.lines() {
        let line: String = line.split_whitespace().collect();
        if line.contains("layout(")
            || line.starts_with("#version")
            || line.starts_with("#extension")
        {
            found.push(line);
        }
    }
    let banned = [
        "buffer",
        "uniform",
        "shared",
        "binding",
        "gl_GlobalInvocationID",
        "main",
    ];
    found.extend(
        source::words(&code)
            .filter(|w| banned.contains(w))
            .map(str::to_owned),
    );
    let declared = glsl(text);
    let mut demand = |names: Vec<String>, prefix: &str| {
        found.extend(names.into_iter().filter(|name| !name.starts_with(prefix)));
    };
    demand(
        declared.functions.into_iter().map(|f| f.name).collect(),
        "corput_",
    );
    demand(
        declared.structs.into_iter().map(|s| s.name).collect(),
        "Corput",
    );
    demand(declared.globals, "CORPUT_");
    demand(declared.macros, "CORPUT_");
    found
}

fn shader(include: &str) -> Option<String> {
    std::fs::read_to_string(source::root("shaders").join(include)).ok()
}

/// Includes of a header that leave the folder, do not exist, lead back to it, or take an
/// exact header down to the native profile.
fn include_faults(name: &str, text: &dyn Fn(&str) -> Option<String>) -> Vec<String> {
    let below = reached(name, text);
    let bad = |other: &String| {
        !other.starts_with("corput/")
            || text(other).is_none()
            || other == name
            || (other.starts_with("corput/native/") && !name.starts_with("corput/native/"))
    };
    below.into_iter().filter(bad).collect()
}

#[test]
fn rust_imports_point_down() {
    let roots = root_names(&read("src/lib.rs"));
    assert!(
        roots.contains(&("Error".to_owned(), "error".to_owned())),
        "{roots:?}"
    );
    let mut found = Vec::new();
    let mut edges = 0;
    for path in files("src", &[".rs"])
        .iter()
        .filter(|path| *path != "lib.rs")
    {
        let text = read(&format!("src/{path}"));
        edges += uses(&text, &roots).len();
        found.extend(faults(path, &text, &roots));
    }
    assert!(edges > 80, "only {edges} imports were read");
    assert!(found.is_empty(), "{found:#?}");
}

#[test]
fn the_root_only_declares() {
    let code = without_comments(&read("src/lib.rs"));
    let functions: Vec<&str> = code.matches("fn ").collect();
    assert_eq!(
        functions.len(),
        1,
        "lib.rs holds headers() and nothing else that works"
    );
    for (_, module) in root_names(&read("src/lib.rs")) {
        assert_eq!(
            level(&module),
            Some(0),
            "lib.rs gives out names of {module}"
        );
    }
}

#[test]
fn public_shaders_are_pure() {
    let names = files("shaders/corput", &[".glsl"]);
    assert!(names.len() >= 16);
    assert_eq!(
        names,
        files("shaders/corput", &[""]),
        "other files among the headers"
    );
    for name in names {
        let found = header_faults(&read(&format!("shaders/corput/{name}")));
        assert!(found.is_empty(), "{name}: {found:?}");
        let found = include_faults(&format!("corput/{name}"), &shader);
        assert!(found.is_empty(), "{name} includes {found:?}");
    }
}

#[test]
fn only_kernels_have_bindings() {
    for name in files("shaders", &[""]) {
        let layout = without_comments(&read(&format!("shaders/{name}"))).contains("layout(");
        assert!(
            !layout || name.starts_with("kernels/"),
            "{name} declares a layout"
        );
        for include in includes(&read(&format!("shaders/{name}"))) {
            let known = shader(&include).is_some() && include.starts_with("corput/");
            let beside = shader(&format!("kernels/{include}")).is_some();
            let known = known || beside || include == "interface.glsl";
            assert!(known, "{name} includes {include}");
        }
    }
}
