//! The GLSL headers in other people's shaders: alone, twice, in pairs, among a host's own
//! names, as GLSL 4.50 and ESSL 3.10, and through naga to WGSL, HLSL and MSL.

#[path = "headers/portable.rs"]
mod portable;
mod source;

use corput::compile::to_spirv;
use corput::headers;
use source::files;

/// The languages: a name and how a shader begins.
const LANGUAGES: [(&str, &str); 2] = [
    ("GLSL 4.50", "#version 450\n"),
    (
        "ESSL 3.10",
        "#version 310 es\nprecision highp float;\nprecision highp int;\n",
    ),
];

/// Hooks: the header that needs it, the macro, a definition.
const HOOKS: [(&str, &str, &str); 11] = [
    (
        "corput/halton.glsl",
        "CORPUT_PRIME",
        "#define CORPUT_PRIME(d) (2u + (d))\n",
    ),
    (
        "corput/halton_scrambled.glsl",
        "CORPUT_PRIME",
        "#define CORPUT_PRIME(d) (2u + (d))\n",
    ),
    (
        "corput/domain_sobol.glsl",
        "CORPUT_SOBOL_DIRECTION",
        "#define CORPUT_SOBOL_DIRECTION(d, b) ((d) ^ (b))\n",
    ),
    (
        "corput/domain_halton.glsl",
        "CORPUT_PRIME",
        "#define CORPUT_PRIME(d) (2u + (d))\n",
    ),
    (
        "corput/sobol.glsl",
        "CORPUT_SOBOL_DIRECTION",
        "#define CORPUT_SOBOL_DIRECTION(d, b) ((d) ^ (b))\n",
    ),
    (
        "corput/envmap.glsl",
        "CORPUT_ENVMAP_EDGE",
        "#define CORPUT_ENVMAP_EDGE(i) (0x3f800000u - (i))\n",
    ),
    (
        "corput/blue_noise.glsl",
        "CORPUT_BLUE_NOISE",
        "#define CORPUT_BLUE_NOISE(x, y) ((x) + 16u * (y))\n",
    ),
    (
        "corput/discrete.glsl",
        "CORPUT_DISCRETE",
        "#define CORPUT_DISCRETE(i) ((i) * 0x9e3779b9u)\n",
    ),
    (
        "corput/native/environment.glsl",
        "CORPUT_DISCRETE",
        "#define CORPUT_DISCRETE(i) ((i) * 0x9e3779b9u)\n",
    ),
    (
        "corput/environment.glsl",
        "CORPUT_DISCRETE",
        "#define CORPUT_DISCRETE(i) ((i) * 0x9e3779b9u)\n",
    ),
    (
        "corput/irradiance.glsl",
        "CORPUT_DISCRETE",
        "#define CORPUT_DISCRETE(i) ((i) * 0x9e3779b9u)\n",
    ),
];

/// A host's own names as functions and constants.
const HOST_FUNCTIONS: &str = "const float PI = 3.0;\n\
    uint hash(uint x) { return x * 3u; }\n\
    float random(vec2 p) { return p.x + PI; }\n\
    float saturate(float x) { return clamp(x, 0.0, 1.0); }\n\
    uint mulhi(uint a, uint b) { return a * b; }\n\
    struct Frame { vec3 tangent; };\n";

/// A host's own names as macros.
const HOST_MACROS: &str = "#define PI 3.14159265\n#define TAU (2.0 * PI)\n\
    #define hash(x) ((x) * 3u)\n#define random(p) fract((p).x)\n\
    #define saturate(x) clamp((x), 0.0, 1.0)\n#define EPSILON 1e-6\n#define M_PI PI\n";

/// Definitions of every hook.
fn hooks() -> String {
    HOOKS.iter().map(|(_, _, definition)| *definition).collect()
}

fn include(name: &str) -> String {
    format!("#include \"{name}\"\n")
}

/// Compiles a shader's body in one language; the compiler's log if it refuses.
fn compile(begin: &str, body: &str, defines: &[(&str, &str)]) -> Result<Vec<u32>, String> {
    let lines = "#extension GL_GOOGLE_include_directive : require\n";
    let (version, rest) = begin.split_once('\n').expect("a version line");
    let text =
        format!("{version}\n{lines}{rest}layout(local_size_x = 1) in;\n{body}\nvoid main() {{}}\n");
    to_spirv(&text, defines, &mut |name| {
        let found = headers().iter().find(|(known, _)| *known == name);
        found.map(|(_, text)| (*text).to_owned())
    })
}

/// Demands that a body compiles in both languages, in the fast and the portable form.
fn demand(body: &str) {
    for (language, begin) in LANGUAGES {
        for defines in [&[][..], &[("CORPUT_PORTABLE", "1")][..]] {
            if let Err(log) = compile(begin, body, defines) {
                panic!("{language} {defines:?}: {log}\n{body}");
            }
        }
    }
}

#[test]
fn headers_are_the_files_of_the_folder() {
    let listed: Vec<&str> = headers().iter().map(|(name, _)| *name).collect();
    let found = files("shaders/corput", &[".glsl"]);
    let mut found: Vec<String> = found.iter().map(|name| format!("corput/{name}")).collect();
    found.sort();
    assert_eq!(listed, found);
    for (name, text) in headers() {
        assert_eq!(*text, source::read(&format!("shaders/{name}")), "{name}");
    }
}

#[test]
fn alone_and_twice() {
    for (name, _) in headers() {
        demand(&(hooks() + &include(name)));
        demand(&(hooks() + &include(name) + &include(name)));
    }
}

/// In both orders, so that each header stands before and after each other: what one
/// leaves defined, or lacks, shows as it would in pairs, in time that is linear.
#[test]
fn all_at_once_both_ways() {
    let all: Vec<String> = headers().iter().map(|(name, _)| include(name)).collect();
    let reversed: Vec<String> = all.iter().rev().cloned().collect();
    demand(&(hooks() + &all.concat()));
    demand(&(hooks() + &reversed.concat()));
}

#[test]
fn among_a_hosts_own_names() {
    for (name, _) in headers() {
        for host in [HOST_FUNCTIONS, HOST_MACROS] {
            demand(&(hooks() + host + &include(name)));
            demand(&(hooks() + &include(name) + host));
        }
    }
}

#[test]
fn a_missing_hook_is_named() {
    for (name, hook, definition) in HOOKS {
        for (language, begin) in LANGUAGES {
            let log = compile(begin, &include(name), &[]).expect_err("the hook is missing");
            let named = log.contains("#error") && log.contains(&format!("define {hook} "));
            assert!(named, "{language} {name}: {log}");
        }
        demand(&(definition.to_owned() + &include(name)));
    }
    // No other header needs a hook.
    for (name, _) in headers() {
        if HOOKS.iter().all(|(other, _, _)| other != name) {
            demand(&include(name));
        }
    }
}

#[test]
fn broken_headers_are_caught() {
    let bad = |body: &str| {
        LANGUAGES
            .iter()
            .all(|(_, begin)| compile(begin, body, &[]).is_err())
    };
    assert!(
        bad("uint hash(uint x) { return x; }\nuint hash(uint x) { return x; }"),
        "two of a name"
    );
    assert!(
        bad(&(HOST_FUNCTIONS.to_owned() + "const float PI = 3.14;")),
        "a host's name"
    );
    assert!(
        bad(&(HOST_MACROS.to_owned() + "const float PI = 3.14;")),
        "a host's macro"
    );
    assert!(
        bad("uint corput_bad() { return 1.0; }"),
        "a type error in a function not called"
    );
    assert!(bad("#include \"corput/none.glsl\""), "a missing include");
    // What one language alone refuses.
    let only_es = "float corput_bad(float x) { precise float y = x; return y; }";
    assert!(compile(LANGUAGES[0].1, only_es, &[]).is_ok());
    assert!(compile(LANGUAGES[1].1, only_es, &[]).is_err());
}
