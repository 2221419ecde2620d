//! Each rule of the mirror, broken on purpose.

use super::source::{includes, read};
use super::{FIELDS, comment_faults, differences, stray_imports};

#[test]
fn broken_twins_are_caught() {
    let header = "struct CorputPair { uint a; vec2 b; };\n\
        // corput_no(uint x) {\nuint corput_one(uint a, bool b) {\n if (b) { return a; }\n return 0u;\n}\n\
        #define CORPUT_TWO(x) \\\n  two(x)\nuvec2 corput_two(CorputPair p) { return uvec2(0u); }\n";
    let twin = "pub struct Pair {\n    /// A.\n    pub a: u32,\n    pub b: Vec2,\n}\n\
        pub fn one(mut a: u32, b: bool) -> u32 {\n    a\n}\nfn private() {}\n\
        #[inline]\npub fn two(p: Pair) -> UVec2 {\n    UVec2::ZERO\n}\n";
    assert_eq!(differences(header, twin), [""; 0]);
    let edits = [
        ("pub fn one", "fn one"),
        ("pub fn one", "pub fn first"),
        ("fn private", "pub fn private"),
        (", b: bool", ""),
        (", b: bool", ", c: bool"),
        ("b: bool", "b: u32"),
        ("-> UVec2", "-> Vec2"),
        ("pub b: Vec2", "pub b: Vec3"),
        ("struct Pair", "struct Couple"),
    ];
    for (from, to) in edits {
        assert_eq!(
            differences(header, &twin.replacen(from, to, 1)).len(),
            1,
            "{from} -> {to}"
        );
    }
    let swapped = header
        .replace("corput_one", "corput_x")
        .replace("corput_two", "corput_one");
    assert!(!differences(&swapped, twin).is_empty());
}

#[test]
fn broken_comments_and_imports_are_caught() {
    let good = read("shaders/corput/halton.glsl");
    assert_eq!(comment_faults("halton", &good), [""; 0]);
    assert_eq!(comment_faults("sobol", &good).len(), 3);
    for field in FIELDS {
        let bad = good.replacen(&format!("// {field}:"), "//", 1);
        assert!(!comment_faults("halton", &bad).is_empty(), "{field}");
    }
    for (from, to) in [
        ("// what:", "// cost:"),
        ("hooks:  CORPUT_PRIME(d)", "hooks:  none"),
        ("#ifndef CORPUT_PRIME", "#ifndef CORPUT_OTHER"),
        ("#define CORPUT_HALTON_GLSL", ""),
    ] {
        assert!(
            !comment_faults("halton", &good.replacen(from, to, 1)).is_empty(),
            "{from}"
        );
    }
    assert_eq!(includes(&good), ["corput/radical_inverse.glsl"]);
    let twin = "use crate::reference::disk::polar_disk;\nuse crate::reference::bits::find_msb;\n\
        use crate::vulkan::Device;\n";
    assert_eq!(stray_imports("halton", twin), ["disk", "vulkan"]);
    assert_eq!(
        stray_imports("primes", "use crate::tables::PRIMES;"),
        [""; 0]
    );
    assert_eq!(
        stray_imports("bits", "use crate::tables::PRIMES;"),
        ["tables"]
    );
}
