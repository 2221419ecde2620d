//! Each rule of the layers, broken on purpose.

use super::{faults, header_faults, include_faults};

#[test]
fn upward_and_sideways_imports_are_caught() {
    let roots = vec![("Error".to_owned(), "error".to_owned())];
    let count = |path: &str, text: &str| faults(path, text, &roots).len();
    let good = "use crate::{Error, interface::map};\n/// [`crate::check`]\nuse crate::Error;\n";
    assert_eq!(count("vulkan/buffer.rs", good), 0);
    assert_eq!(count("vulkan/buffer.rs", "use crate::check::Row;"), 1);
    assert_eq!(
        count(
            "vulkan/buffer.rs",
            "let x = crate::reference::bits::find_msb(1);"
        ),
        1
    );
    assert_eq!(
        count(
            "vulkan/buffer.rs",
            "use crate::{\n    Error,\n    spirv::{Op, lint},\n};"
        ),
        1
    );
    assert_eq!(count("vulkan.rs", "use super::bulk::Reference;"), 1);
    assert_eq!(count("kernels/mod.rs", "use crate::bulk::Reference;"), 1);
    assert_eq!(count("error.rs", "use crate::vulkan::Device;"), 1);
    assert_eq!(
        count("tables/mod.rs", "use crate::Error;"),
        1,
        "one level, sideways"
    );
    assert_eq!(count("bulk/mod.rs", "use crate::unheard_of::Thing;"), 1);
    assert_eq!(count("unheard_of/mod.rs", ""), 1);
    assert_eq!(count("main.rs", "use corput::check::run;"), 0);
    assert_eq!(count("reference/bits.rs", "use ash::vk;"), 1);
    assert_eq!(count("reference/bits.rs", "// a hash, a flash"), 0);
    assert_eq!(count("vulkan/buffer.rs", "// holds Halton points"), 1);
}

#[test]
fn impure_headers_are_caught() {
    let bad = [
        "layout(set = 0) buffer B { uint b[]; };",
        "layout (std430) uniform;",
        "#version 450",
        "# extension GL_X : require",
        "uint helper(uint x) { return x; }",
        "uint corputX(uint x) { return x; }",
        "struct Pair { uint a; };",
        "const float PI = 3.0;",
        "float cache;",
        "#define PI 3.0",
        "  # define SQUARE(x) \\\n  ((x) * (x))",
        "void main() {}",
    ];
    for text in bad {
        assert!(!header_faults(text).is_empty(), "{text}");
    }
    let good = "// layout(binding = 0)\n#ifndef CORPUT_X\n#define CORPUT_X\n\
        const uint CORPUT_T[2] = uint[2](1u, 2u);\nstruct CorputPair { uint a; };\n\
        uint corput_x(uint a) { uint b = a; return b; }\n#endif\n";
    assert_eq!(header_faults(good), [""; 0]);
}

#[test]
fn bad_includes_are_caught() {
    let text = |name: &str| {
        Some(match name {
            "corput/a.glsl" => "#include \"corput/b.glsl\"\n".to_owned(),
            "corput/b.glsl" => "  # include <corput/c.glsl>\n".to_owned(),
            "corput/c.glsl" => "#include \"corput/a.glsl\"\n".to_owned(),
            "corput/native/d.glsl" => "#include \"corput/e.glsl\"\n".to_owned(),
            "corput/e.glsl" => "// #include \"corput/a.glsl\"\n".to_owned(),
            "corput/f.glsl" => "#include \"corput/native/d.glsl\"\n".to_owned(),
            "corput/g.glsl" => "#include \"kernels/map.glsl\"\n".to_owned(),
            "corput/h.glsl" => "#include \"corput/none.glsl\"\n".to_owned(),
            _ => return None,
        })
    };
    let count = |name: &str| include_faults(name, &text).len();
    assert_eq!(count("corput/a.glsl"), 1, "a cycle");
    assert_eq!(
        (count("corput/native/d.glsl"), count("corput/e.glsl")),
        (0, 0)
    );
    assert_eq!(count("corput/f.glsl"), 1, "exact on native");
    assert_eq!((count("corput/g.glsl"), count("corput/h.glsl")), (1, 1));
}
