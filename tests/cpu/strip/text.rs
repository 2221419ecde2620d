//! Small texts: what is kept and what is left out.

use corput::strip::{Contents, Flat, flatten};

/// What they begin with.
pub const HEAD: &str = "#version 450\nlayout(local_size_x = 1) in;\n\
                    layout(set = 0, binding = 0) buffer Words { uint words[]; };\n";

/// A shader with these lines, and files that it may include.
pub fn try_flat(
    body: &str,
    files: &[(&str, &str)],
    defines: &[(&str, Option<&str>)],
) -> corput::Result<Flat> {
    let text = format!("{HEAD}{body}");
    flatten(&text, defines, &mut |name| {
        let found = files.iter().find(|(known, _)| *known == name);
        found.map(|(_, text)| (*text).to_owned())
    })
}

fn flat(body: &str) -> Flat {
    try_flat(body, &[], &[]).unwrap_or_else(|error| panic!("{error}\n{body}"))
}

fn compiles(flat: &Flat) -> Vec<u32> {
    corput::compile::to_spirv(&flat.text, &[], &mut |_| None)
        .unwrap_or_else(|error| panic!("{error}\n{}", flat.text))
}

fn main_part(flat: &Flat) -> (&Contents, &Contents) {
    let part = flat
        .parts
        .iter()
        .find(|part| part.name == "main")
        .expect("the shader");
    (&part.kept, &part.left_out)
}

#[test]
fn only_what_main_reaches() {
    let flat = flat(
        "#define TWICE(x) ((x) + (x))\n#define UNUSED 7u\n#define LENGTH 2\n\
         struct Used { uint a; uvec2 b[LENGTH]; };\nstruct Idle { Used used; };\n\
         const uint TABLE[4] = uint[4](1u, 2u, (3u), 4u);\n\
         const uvec3 IDLE_TABLE[2] = uvec3[](uvec3(1u), uvec3(2u));\n\
         const float STEP = 0.5;\n\
         layout(constant_id = 3) const uint CHOICE = 1u;\n\
         layout(constant_id = 4) const uint IDLE_CHOICE = 1u;\n\
         layout(set = 0, binding = 5) readonly buffer Idle5 { uint idle[]; };\n\
         uint later(uint x);\nuint later(uvec2 x) { return x.x; }\n\
         // Says why.\n// In two lines.\n\
         uint deep(Used u) {\n    // Not this.\n    return u.a + TABLE[CHOICE]; /* nor this */\n}\n\
         void idle_function() { idle[0] = deep(Used(1u, uvec2[2](uvec2(0u), uvec2(1u)))); }\n\
         void main() {\n    Used u;\n    u.a = TWICE(later(3u));\n    words[0] = deep(u);\n}\n\
         uint later(uint x) { return x; }\n",
    );
    let (kept, left) = main_part(&flat);
    assert_eq!(kept.functions, ["later", "deep", "main", "later"]);
    assert_eq!(left.functions, ["idle_function"]);
    assert_eq!(
        (&kept.structs[..], &left.structs[..]),
        (&["Used".to_owned()][..], &["Idle".to_owned()][..])
    );
    let names = |list: &Contents| -> Vec<_> {
        list.constants
            .iter()
            .map(|c| (c.name.clone(), c.bytes, c.table))
            .collect()
    };
    assert_eq!(names(kept), [("TABLE".to_owned(), Some(16), true)]);
    assert_eq!(
        names(left),
        [
            ("IDLE_TABLE".to_owned(), Some(24), true),
            ("STEP".to_owned(), Some(4), false)
        ]
    );
    assert_eq!((kept.table_bytes(), left.table_bytes()), (16, 24));
    assert_eq!(kept.macros, ["TWICE", "LENGTH"]);
    assert_eq!(left.macros, ["UNUSED"]);
    assert_eq!(kept.specialization, ["CHOICE"]);
    assert_eq!(left.specialization, ["IDLE_CHOICE"]);
    assert_eq!(
        (&kept.blocks[..], &left.blocks[..]),
        (&["Words".to_owned()][..], &["Idle5".to_owned()][..])
    );
    assert!(
        flat.text
            .contains("// Says why.\n// In two lines.\nuint deep(Used u) {\n    return")
    );
    assert!(
        !flat.text.contains("this") && !flat.text.contains("IDLE"),
        "{}",
        flat.text
    );
    compiles(&flat);
}

#[test]
fn conditions_are_decided() {
    let body = "#define A 3\n#if A * 2 == 6 && defined(A) && !defined B\n#define PICK 1u\n\
                #elif 1 / 0\n#error never\n#else\n#error never\n#endif\n\
                #ifdef B\nuint f() { return 2u; }\n#else\n# if (A << 2) % 5 == 2 || UNKNOWN\n\
                uint f() {\n#if A > 2\n    return PICK;\n#else\n    return 9u;\n#endif\n}\n# endif\n#endif\n\
                #if 0\nthis is ` no GLSL\n#if 1\n#endif\n#endif\n\
                #undef A\n#define A 4u\nvoid main() { words[A] = f(); }\n";
    let first = flat(body);
    assert!(
        first.text.contains("uint f() {\n    return PICK;\n}"),
        "{}",
        first.text
    );
    assert!(
        first.text.contains("#define A 4u") && !first.text.contains("A 3"),
        "{}",
        first.text
    );
    assert!(
        !first.text.contains("#undef") && !first.text.contains("#if"),
        "{}",
        first.text
    );
    compiles(&first);
    let other = body
        .replace("&& !defined B", "")
        .replace("#ifdef B", "#ifdef C");
    let second = try_flat(&other, &[], &[("C", None)]).expect("a shader");
    assert!(
        second.text.contains("uint f() { return 2u; }"),
        "{}",
        second.text
    );
    assert!(!second.text.contains("#define C"), "{}", second.text);
    // A macro that is used before and after it changes stays with both meanings.
    let both = flat(
        "#define A 1u\nuint f() { return A; }\n#undef A\n#define A 2u\n\
         void main() { words[f()] = A; }\n",
    );
    assert!(both.text.contains("#undef A"), "{}", both.text);
    compiles(&both);
}

#[test]
fn names_of_a_function_are_its_own() {
    let flat = flat(
        "uint local() { return 1u; }\nconst uint high = 2u;\nuint low;\nconst uint seen = 3u;\n\
         const uint begun = 4u;\nconst uint within = 5u;\nstruct Made { uint member; };\n\
         const uint member = 6u;\nconst uint[2] LIST = { 1u, 2u };\n\
         uint f(uint high) {\n    uint local = high;\n    const uint[2] low = uint[2](local, 1u);\n\
         \x20   Made made = Made(low[0]);\n    { uint within = 1u; made.member += within; }\n\
         \x20   uint begun = begun + 1u;\n    return made.member + within + begun + seen;\n}\n\
         void main() { words[0] = f(LIST[1]); }\n",
    );
    let (kept, left) = main_part(&flat);
    assert_eq!(kept.functions, ["f", "main"]);
    assert_eq!(left.functions, ["local"]);
    let names: Vec<&str> = kept.constants.iter().map(|c| c.name.as_str()).collect();
    assert_eq!(names, ["seen", "begun", "within", "LIST"]);
    assert_eq!(left.variables, ["low"]);
    compiles(&flat);
}

#[test]
fn forms_of_declarations() {
    let flat = flat(
        "#extension GL_EXT_control_flow_attributes : require\n#pragma optimize(on)\n\
         #define CALL(name) kernel_##name\n#define EMPTY\n#define TYPE(x) Kind##x\n\
         #define LOOP [[dont_unroll]]\n\
         struct KindA { float x; } shared_of_all;\n\
         shared uint pool[4], other_pool[2];\n;\n\
         layout(push_constant) uniform Push { layout(offset = 0) uint first; } push;\n\
         precise float scaled(in highp float x, out float[2] pair) {\n\
         \x20   pair = float[2](x, x * 0.5e-3);\n    precise float y = x * 2.0;\n    return y;\n}\n\
         EMPTY uint CALL(value)(const TYPE(A) a) {\n    uint sum = 0u;\n\
         \x20   LOOP for (uint i = 0u, j = 1u; i < 4u; i++) {\n        sum += i * j;\n    }\n\
         \x20   switch (sum) { case 1u: sum += 2u; break; default: sum ^= 1u; }\n\
         \x20   return sum + floatBitsToUint(a.x);\n}\n\
         uint begun = 7u, idle;\n\
         void main() {\n    float[2] pair;\n    words[0] = CALL(value)(KindA(scaled(1.0, pair)));\n\
         \x20   pool[0] = push.first;\n    barrier();\n    words[1] = pool[0] + begun;\n}\n",
    );
    let (kept, left) = main_part(&flat);
    assert_eq!(kept.functions, ["scaled", "kernel_value", "main"]);
    assert_eq!(kept.variables, ["pool", "other_pool", "begun", "idle"]);
    assert_eq!(kept.structs, ["KindA"]);
    assert!(left.functions.is_empty() && left.macros.is_empty());
    assert!(
        flat.text
            .starts_with("#version 450\n#extension GL_EXT_control_flow_attributes")
    );
    assert!(flat.text.contains("#pragma optimize(on)"));
    compiles(&flat);
}

#[test]
fn includes_by_guards() {
    let files = [
        (
            "a.glsl",
            "// Licence: the licence of a.\n#ifndef A\n#define A\n#include \"b.glsl\"\n\
                    uint a() { return b(); }\nuint idle() { return 0u; }\n#endif\n",
        ),
        (
            "b.glsl",
            "#ifndef B\n#define B\n#include \"a.glsl\"\nuint b() { return WIDTH; }\n#endif\n",
        ),
    ];
    let body = "#include \"b.glsl\"\n#include \"a.glsl\"\nvoid main() { words[0] = b(); }\n";
    let flat = try_flat(body, &files, &[("WIDTH", Some("4u"))]).expect("a shader");
    let names: Vec<&str> = flat.parts.iter().map(|part| part.name.as_str()).collect();
    assert_eq!(names, ["main", "defines", "b.glsl", "a.glsl"]);
    assert_eq!(flat.parts[2].kept.functions, ["b"]);
    assert_eq!(flat.parts[3].left_out.functions, ["a", "idle"]);
    assert!(
        flat.parts
            .iter()
            .all(|part| part.left_out.macros.is_empty()),
        "guards are listed"
    );
    assert_eq!(flat.text.matches("uint b()").count(), 1);
    assert!(flat.text.contains("// From b.glsl.\n"));
    assert!(!flat.text.contains("a.glsl"));
    compiles(&flat);
    let body = body
        .replace("words[0] = b()", "words[0] = a()")
        .replace("#include \"b", "#include \"a");
    // `a` is used before it is declared there, but its file is named with its licence.
    let flat = try_flat(&body, &files, &[("WIDTH", Some("4u"))]).expect("a shader");
    assert!(
        flat.text
            .contains("// From a.glsl. Licence: the licence of a.\n"),
        "{}",
        flat.text
    );
}

#[test]
fn essl_and_line_comments() {
    let text = "#version 310 es\nprecision highp float;\n#ifdef GL_ES\nlayout(local_size_x = 1) in;\n\
                #endif\n// A comment that goes on \\\nuint not_code() { }\n\
                #define LONG(x) ((x) + \\\n    1u) // one\nlayout(binding = 0, std430) buffer B { uint b[]; };\n\
                void main() { b[0] = LONG(2u); }\n";
    let flat = flatten(text, &[], &mut |_| None).expect("a shader");
    assert!(flat.text.contains("precision highp float;"));
    assert_eq!(main_part(&flat).0.functions, ["main"]);
    assert!(
        flat.text.contains("#define LONG(x) ((x) + \\\n    1u)\n"),
        "{}",
        flat.text
    );
    compiles(&flat);
}
