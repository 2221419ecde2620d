//! Every GLSL header has its Rust twin: the same functions and structs in the same
//! order with the same parameters, the same imports, and a header comment in full.

#[path = "mirror/broken.rs"]
mod broken;
mod source;

use source::{Declarations, Function, files, glsl, reached, read, rust, words};
use std::collections::BTreeSet;

/// Those of the estimators of irradiance.
const IRRADIANCE: &[(&str, &str)] = &[
    ("UVec2", "size"),
    ("u32", "axis"),
    ("UVec2", "u"),
    ("&[f32]", "edges"),
    ("&[u32]", "words"),
];

/// Parameters that differ because a hook macro of the header is a parameter of the twin:
/// (function without prefix, parameters of the twin).
const HOOKS: &[(&str, &[(&str, &str)])] = &[
    // CORPUT_PRIME(dimension) is called by the shader, by the caller of the twin.
    ("halton", &[("u32", "n"), ("u32", "prime")]),
    ("halton_faure", &[("u32", "n"), ("u32", "prime")]),
    (
        "halton_permuted",
        &[("u32", "n"), ("u32", "prime"), ("u32", "seed")],
    ),
    (
        "halton_owen",
        &[("u32", "n"), ("u32", "prime"), ("u32", "seed")],
    ),
    (
        "halton_started",
        &[("u32", "n"), ("u32", "prime"), ("u32", "seed")],
    ),
    // CORPUT_SOBOL_DIRECTION(dimension, bit) reads what the twin gets as an array.
    ("sobol", &[("u32", "n"), ("&[u32]", "directions")]),
    (
        "draw_sobol",
        &[("Domain", "domain"), ("&[u32]", "directions")],
    ),
    (
        "draw_sobol_owen",
        &[("Domain", "domain"), ("&[u32]", "directions")],
    ),
    ("draw_halton", &[("Domain", "domain"), ("UVec4", "primes")]),
    (
        "draw_halton_permuted",
        &[("Domain", "domain"), ("UVec4", "primes")],
    ),
    (
        "draw_halton_started",
        &[("Domain", "domain"), ("UVec4", "primes")],
    ),
    // CORPUT_BLUE_NOISE(x, y) reads what the twins get as a slice.
    (
        "blue_noise_rank",
        &[("UVec2", "pixel"), ("UVec2", "size"), ("&[u32]", "ranks")],
    ),
    (
        "blue_noise",
        &[("UVec2", "pixel"), ("UVec2", "size"), ("&[u32]", "ranks")],
    ),
    (
        "blue_noise_frame",
        &[
            ("UVec2", "pixel"),
            ("u32", "frame"),
            ("UVec3", "size"),
            ("&[u32]", "ranks"),
        ],
    ),
    // CORPUT_ENVMAP_EDGE(i) reads what the twin gets as a slice.
    (
        "envmap_texel",
        &[
            ("Vec3", "direction"),
            ("UVec2", "size"),
            ("&[f32]", "edges"),
        ],
    ),
    // CORPUT_DISCRETE(i) reads what the twins get as a slice.
    (
        "cdf_lower",
        &[("u32", "first"), ("u32", "index"), ("&[u32]", "words")],
    ),
    (
        "cdf_weight",
        &[("u32", "first"), ("u32", "index"), ("&[u32]", "words")],
    ),
    (
        "cdf",
        &[("u32", "first"), ("u32", "u"), ("&[u32]", "words")],
    ),
    (
        "cdf_invert",
        &[
            ("u32", "first"),
            ("u32", "index"),
            ("u32", "rest"),
            ("&[u32]", "words"),
        ],
    ),
    (
        "alias_index",
        &[
            ("u32", "first"),
            ("u32", "count"),
            ("u32", "u"),
            ("&[u32]", "words"),
        ],
    ),
    (
        "alias_rest",
        &[
            ("u32", "first"),
            ("u32", "count"),
            ("UVec2", "u"),
            ("&[u32]", "words"),
        ],
    ),
    (
        "alias_weight",
        &[("u32", "first"), ("u32", "index"), ("&[u32]", "words")],
    ),
    (
        "environment_cap",
        &[("UVec2", "size"), ("u32", "row"), ("&[u32]", "words")],
    ),
    (
        "environment_z",
        &[
            ("UVec2", "size"),
            ("u32", "row"),
            ("f32", "z"),
            ("&[u32]", "words"),
        ],
    ),
    (
        "environment_direction",
        &[
            ("UVec2", "size"),
            ("UVec2", "texel"),
            ("UVec2", "place"),
            ("&[u32]", "words"),
        ],
    ),
    (
        "environment_density",
        &[
            ("UVec2", "size"),
            ("u32", "row"),
            ("Real", "probability"),
            ("&[u32]", "words"),
        ],
    ),
    (
        "environment_texel_pdf",
        &[("UVec2", "size"), ("UVec2", "texel"), ("&[u32]", "words")],
    ),
    (
        "environment",
        &[("UVec2", "size"), ("UVec2", "u"), ("&[u32]", "words")],
    ),
    (
        "environment_pdf",
        &[
            ("UVec2", "size"),
            ("Vec3", "direction"),
            ("&[f32]", "edges"),
            ("&[u32]", "words"),
        ],
    ),
    (
        "environment_place",
        &[
            ("UVec2", "size"),
            ("Vec3", "direction"),
            ("UVec2", "texel"),
            ("&[u32]", "words"),
        ],
    ),
    (
        "environment_invert",
        &[
            ("UVec2", "size"),
            ("Vec3", "direction"),
            ("&[f32]", "edges"),
            ("&[u32]", "words"),
        ],
    ),
    (
        "environment_alias_texel_pdf",
        &[("UVec2", "size"), ("UVec2", "texel"), ("&[u32]", "words")],
    ),
    (
        "environment_alias",
        &[("UVec2", "size"), ("UVec3", "u"), ("&[u32]", "words")],
    ),
    (
        "environment_alias_pdf",
        &[
            ("UVec2", "size"),
            ("Vec3", "direction"),
            ("&[f32]", "edges"),
            ("&[u32]", "words"),
        ],
    ),
    (
        "irradiance_light",
        &[("UVec2", "size"), ("UVec2", "texel"), ("&[u32]", "words")],
    ),
    ("irradiance_uniform", IRRADIANCE),
    ("irradiance_cosine", IRRADIANCE),
    ("irradiance_environment", IRRADIANCE),
    (
        "irradiance_mis",
        &[
            ("UVec2", "size"),
            ("u32", "axis"),
            ("UVec3", "u"),
            ("&[f32]", "edges"),
            ("&[u32]", "words"),
        ],
    ),
    (
        "native_environment_direction",
        &[
            ("UVec2", "size"),
            ("UVec2", "texel"),
            ("UVec2", "place"),
            ("&[u32]", "words"),
        ],
    ),
    (
        "native_environment_density",
        &[
            ("UVec2", "size"),
            ("u32", "row"),
            ("f32", "probability"),
            ("&[u32]", "words"),
        ],
    ),
    (
        "native_environment_texel_pdf",
        &[("UVec2", "size"), ("UVec2", "texel"), ("&[u32]", "words")],
    ),
    (
        "native_environment",
        &[("UVec2", "size"), ("UVec2", "u"), ("&[u32]", "words")],
    ),
    (
        "native_environment_pdf",
        &[
            ("UVec2", "size"),
            ("Vec3", "direction"),
            ("&[f32]", "edges"),
            ("&[u32]", "words"),
        ],
    ),
    (
        "native_environment_invert",
        &[
            ("UVec2", "size"),
            ("Vec3", "direction"),
            ("&[f32]", "edges"),
            ("&[u32]", "words"),
        ],
    ),
    (
        "native_environment_alias_texel_pdf",
        &[("UVec2", "size"), ("UVec2", "texel"), ("&[u32]", "words")],
    ),
    (
        "native_environment_alias",
        &[("UVec2", "size"), ("UVec3", "u"), ("&[u32]", "words")],
    ),
    (
        "native_environment_alias_pdf",
        &[
            ("UVec2", "size"),
            ("Vec3", "direction"),
            ("&[f32]", "edges"),
            ("&[u32]", "words"),
        ],
    ),
];

/// Modules that a twin may use besides those of its header's includes.
const IMPORTS: &[(&str, &str)] = &[
    // Each header's array is generated from a table; tests/cpu/tables.rs compares.
    ("primes", "tables"),
    ("sobol_directions", "tables"),
    ("lattice_vector", "tables"),
];

/// Fields of a header comment, in order; others may stand between them.
const FIELDS: [&str; 6] = ["what", "source", "domain", "cost", "hooks", "mirror"];

/// `corput/native/disk.glsl` for `native/disk`.
fn include_name(name: &str) -> String {
    format!("corput/{name}.glsl")
}

fn header(include: &str) -> Option<String> {
    std::fs::read_to_string(source::root("shaders").join(include)).ok()
}

/// Both folders' files without folder and ending.
fn names() -> (BTreeSet<String>, BTreeSet<String>) {
    let stem = |name: String| name.rsplit_once('.').map(|(stem, _)| stem.to_owned());
    let headers = files("shaders/corput", &[".glsl"])
        .into_iter()
        .filter_map(stem);
    let twins = files("src/reference", &[".rs"])
        .into_iter()
        .filter_map(stem);
    (
        headers.collect(),
        twins
            .filter(|name| name.rsplit('/').next() != Some("mod"))
            .collect(),
    )
}

/// The Rust type of a GLSL type.
fn rust_type(glsl: &str) -> String {
    let known = [
        ("uint", "u32"),
        ("int", "i32"),
        ("float", "f32"),
        ("bool", "bool"),
        ("void", "()"),
    ];
    if let Some((_, rust)) = known.iter().find(|(name, _)| *name == glsl) {
        (*rust).to_owned()
    } else if let Some(name) = glsl.strip_prefix("Corput") {
        name.to_owned()
    } else if let Some(size) = glsl.strip_prefix("uvec") {
        format!("UVec{size}")
    } else {
        glsl.replace("vec", "Vec")
    }
}

fn rust_variables(list: &[(String, String)]) -> Vec<(String, String)> {
    let renamed = |(kind, name): &(String, String)| (rust_type(kind), name.clone());
    list.iter().map(renamed).collect()
}

/// What the twin of these declarations must be.
fn expected(header: &Declarations) -> Declarations {
    let mut found = Declarations::default();
    for function in &header.functions {
        let name = function
            .name
            .strip_prefix("corput_")
            .unwrap_or(&function.name);
        let hook = HOOKS.iter().find(|(known, _)| *known == name);
        let parameters = hook.map_or_else(
            || rust_variables(&function.parameters),
            |(_, list)| {
                list.iter()
                    .map(|(a, b)| ((*a).into(), (*b).into()))
                    .collect()
            },
        );
        found.functions.push(Function {
            name: name.to_owned(),
            result: rust_type(&function.result),
            parameters,
        });
    }
    for each in &header.structs {
        found.structs.push(source::Struct {
            name: rust_type(&each.name),
            members: rust_variables(&each.members),
        });
    }
    found
}

/// What differs between a header and its twin.
fn differences(header: &str, twin: &str) -> Vec<String> {
    let (wanted, found) = (expected(&glsl(header)), rust(twin));
    let mut list = Vec::new();
    for i in 0..wanted.functions.len().max(found.functions.len()) {
        let (a, b) = (wanted.functions.get(i), found.functions.get(i));
        if a != b {
            list.push(format!("function {i}: header {a:?}, twin {b:?}"));
            break;
        }
    }
    if wanted.structs != found.structs {
        list.push(format!(
            "structs: header {:?}, twin {:?}",
            wanted.structs, found.structs
        ));
    }
    list
}

/// What the comment of a header lacks.
fn comment_faults(name: &str, text: &str) -> Vec<String> {
    let mut faults = Vec::new();
    let lines: Vec<&str> = text.lines().collect();
    let end = lines
        .iter()
        .position(|line| !line.starts_with("//"))
        .unwrap_or(lines.len());
    let comment = lines[..end].join("\n");
    let at: Vec<_> = FIELDS
        .iter()
        .map(|field| comment.find(&format!("// {field}:")))
        .collect();
    for (field, at) in FIELDS.iter().zip(&at) {
        if at.is_none() {
            faults.push(format!("no `{field}:`"));
        }
    }
    if !at.is_sorted() {
        faults.push(format!("fields out of order: {at:?}"));
    }
    if !comment.ends_with(&format!("// mirror: src/reference/{name}.rs")) {
        faults.push("`mirror:` is not the last line, or names another file".to_owned());
    }
    let guard = format!("CORPUT_{}_GLSL", name.replace('/', "_").to_uppercase());
    if lines.get(end) != Some(&format!("#ifndef {guard}").as_str())
        || lines.get(end + 1) != Some(&format!("#define {guard}").as_str())
        || lines.last() != Some(&"#endif")
    {
        faults.push(format!("no guard {guard} around the whole"));
    }
    // A hook is a macro that the header tests and that is not its guard.
    let tested = lines
        .iter()
        .filter_map(|line| line.strip_prefix("#ifndef "));
    let tested: BTreeSet<&str> = tested.filter(|name| *name != guard).collect();
    let hooks = comment.split("// hooks:").nth(1).unwrap_or("");
    let hooks = hooks.split("// mirror:").next().unwrap_or("");
    let named: BTreeSet<&str> = words(hooks).filter(|w| w.starts_with("CORPUT_")).collect();
    if named != tested || (tested.is_empty() && hooks.trim() != "none.") {
        faults.push(format!(
            "`hooks:` names {named:?}, the code tests {tested:?}"
        ));
    }
    faults
}

/// Modules of the crate that a twin uses: `fixed`, `native/disk`, `tables`.
fn twin_imports(twin: &str) -> BTreeSet<String> {
    let code = source::without_comments(twin);
    let mut found = BTreeSet::new();
    for part in code.split("crate::").skip(1) {
        let path: Vec<String> = part.split("::").map(source::first_name).collect();
        let path: Vec<&str> = path.iter().map(String::as_str).collect();
        found.insert(match path[..] {
            ["reference", "native", name, ..] => format!("native/{name}"),
            ["reference", name, ..] => name.to_owned(),
            [name, ..] => name.to_owned(),
            [] => String::new(),
        });
    }
    if code.contains("super::") {
        found.insert("super".to_owned());
    }
    found
}

/// Modules that a twin uses although its header does not include theirs.
fn stray_imports(name: &str, twin: &str) -> Vec<String> {
    let below = reached(&include_name(name), &header);
    let allowed = |module: &String| {
        below.contains(&include_name(module)) || IMPORTS.contains(&(name, module.as_str()))
    };
    twin_imports(twin)
        .into_iter()
        .filter(|module| !allowed(module))
        .collect()
}

#[test]
fn every_header_has_a_twin_and_every_twin_a_header() {
    let (headers, twins) = names();
    assert!(headers.len() >= 16, "{headers:?}");
    assert_eq!(headers, twins);
}

#[test]
fn twins_have_the_same_functions_and_structs_in_the_same_order() {
    for name in names().0 {
        let header = read(&format!("shaders/corput/{name}.glsl"));
        let found = differences(&header, &read(&format!("src/reference/{name}.rs")));
        assert!(found.is_empty(), "{name}: {found:#?}");
        assert!(
            !glsl(&header).functions.is_empty(),
            "{name}: no function was read"
        );
    }
}

#[test]
fn headers_open_with_every_field() {
    for name in names().0 {
        let faults = comment_faults(&name, &read(&format!("shaders/corput/{name}.glsl")));
        assert!(faults.is_empty(), "{name}: {faults:#?}");
        let twin = read(&format!("src/reference/{name}.rs"));
        let line = format!("//! Mirror: `shaders/corput/{name}.glsl`.\n");
        assert!(twin.contains(&line), "{name}.rs lacks `{line}`");
    }
}

#[test]
fn twins_import_what_their_headers_include() {
    for name in names().0 {
        let stray = stray_imports(&name, &read(&format!("src/reference/{name}.rs")));
        assert!(
            stray.is_empty(),
            "{name}.rs uses {stray:?}, {name}.glsl does not"
        );
    }
}

#[test]
fn exceptions_are_needed() {
    let (names, _) = names();
    let all = || {
        names
            .iter()
            .map(|name| glsl(&read(&format!("shaders/corput/{name}.glsl"))))
    };
    for (name, list) in HOOKS {
        let mut functions = all().flat_map(|file| file.functions);
        let found = functions
            .find(|f| f.name == format!("corput_{name}"))
            .expect(name);
        let plain = rust_variables(&found.parameters);
        assert!(
            plain
                .iter()
                .map(|(a, b)| (a.as_str(), b.as_str()))
                .ne(list.iter().copied())
        );
    }
    for (name, module) in IMPORTS {
        let twin = read(&format!("src/reference/{name}.rs"));
        assert!(twin_imports(&twin).contains(*module), "{name}: {module}");
    }
}
