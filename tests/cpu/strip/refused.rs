//! Texts that are not understood: errors with their lines, and no panics.

use super::text::{HEAD, try_flat};
use corput::Error;
use corput::strip::{Contents, flatten};

#[test]
fn what_is_not_understood_is_refused() {
    let end = "void main() {}\n";
    for (body, line, words) in [
        ("#include \"none.glsl\"\n", 4, "no include `none.glsl`"),
        ("#include <a.glsl>\n", 4, "an include without a name"),
        (
            "#include \"self.glsl\"\n",
            1,
            "includes nest deeper than 64",
        ),
        (
            "#if UNKNOWN\n#endif\n",
            4,
            "`UNKNOWN` is no macro at that point",
        ),
        ("#if 1 +\n#endif\n", 4, "cut short"),
        ("#if (1\n#endif\n", 4, "does not close"),
        ("#if 1 2\n#endif\n", 4, "`2` is not expected"),
        ("#if 1 / 0\n#endif\n", 4, "division by 0"),
        ("#if 1 << 32\n#endif\n", 4, "shift by 32"),
        ("#if defined\n#endif\n", 4, "`defined` without a name"),
        (
            "#ifdef VULKAN\n#endif\n",
            4,
            "`VULKAN` is a macro of compilers",
        ),
        (
            "#if __VERSION__ > 400\n#endif\n",
            4,
            "`__VERSION__` is a macro of compilers",
        ),
        ("#if 1\n", 4, "a condition does not end"),
        ("\n#endif\n", 5, "`#endif` has no `#if`"),
        ("#else\n", 4, "`#else` has no `#if`"),
        ("#if 0\n#else\n#else\n#endif\n", 6, "`#else` has no `#if`"),
        ("#error do this\n", 4, "it says #error do this"),
        ("#line 7\n", 4, "`#line` is not understood"),
        ("#pragma once\n", 4, "`#pragma once` is no GLSL"),
        ("#version 460\n", 4, "wrong place"),
        ("#define\n", 4, "a macro without a name"),
        ("#define A(1) 2\n", 4, "a parameter is no name"),
        ("#define A(x 2\n", 4, "a parameter is no name"),
        ("#define A 1\n#define A 2\n", 5, "`A` is defined anew"),
        ("#define A(x) #x\nA(b);\n", 5, "a macro makes a string"),
        (
            "#define A(x) x##+\nuint A(b);\n",
            5,
            "pastes what is no name",
        ),
        (
            "#define A(x) x##b\nuint A();\n",
            5,
            "pastes an empty argument",
        ),
        ("#define A(x, y) x\nuint A(b);\n", 5, "takes 2 arguments"),
        (
            "#define A(x) x\nuint A(\n#define B\nb);\n",
            5,
            "do not end before the next directive",
        ),
        (
            "#define A(x) x\nuint f() { return A\n#define B\n(1u); }\n",
            5,
            "between a macro and its",
        ),
        ("#define A uint x; uint\nA y;\n", 5, "several declarations"),
        (
            "uint f() {\n#define B 1u\nreturn B; }\n",
            4,
            "within a declaration",
        ),
        ("uint x = @;\n", 4, "`@` is no GLSL"),
        ("uint x = \"a\";\n", 4, "`\"a\"` is no GLSL"),
        ("uint xé;\n", 4, "`é` is no GLSL"),
        ("/* open\n", 4, "a comment that does not end"),
        ("uint lo\\\nng;\n", 4, "goes on after a backslash"),
        ("uint f() {\n", 4, "a declaration does not end"),
        ("uint f() ]\n", 4, "`]` closes nothing"),
        ("uint f(;)\n", 5, "a function whose head"),
        (
            "Words { uint x; } words2;\n",
            4,
            "neither buffer nor uniform",
        ),
        ("uint x y;\n", 4, "not understood"),
        ("1.0;\n", 4, "not understood"),
        ("uint f() + 1;\n", 4, "not understood"),
    ] {
        let files = [("self.glsl", "#include \"self.glsl\"\n")];
        let error = try_flat(&format!("{body}{end}"), &files, &[]).map(|flat| flat.text);
        match &error {
            Err(error @ Error::Glsl { line: found, .. }) => {
                assert!(error.to_string().contains(words), "{body}{error}");
                assert_eq!(*found, line, "{body}{error}");
                assert_eq!(error.exit_code(), 2);
            }
            other => panic!("{body}{other:?}"),
        }
    }
    let none = |text: &str, defines: &[(&str, Option<&str>)]| {
        flatten(text, defines, &mut |_| None)
            .expect_err("refused")
            .to_string()
    };
    assert!(none("void main() {}\n", &[]).contains("no `#version`"));
    assert!(none("#version 450\nvoid other() {}\n", &[]).contains("no function `main`"));
    assert!(none("#version 450\nvoid main();\n", &[]).contains("no function `main`"));
    assert!(none("#version 450\nvoid main() {}\n", &[("A\nB", None)]).contains("not one name"));
}

#[test]
fn broken_texts_are_errors_and_no_panics() {
    let body = "#define F(a, b) a##s[0] + (b)\n#if defined(X) || (3 << 2) % 5 == 2\n/* c */\n#endif\n\
                struct S { uint a; vec2 b[2]; } s; const uint T[2] = uint[2](1u, 2u);\n\
                layout(constant_id = 1) const int K = -1; // d\nuint f(S s) { return F(word, T[0]); }\n\
                void main() { for (uint i = 0u; i < 4u; i++) { words[i] = f(s); } }\n#undef F\n";
    let mut state = 1u32;
    let mut random = |below: usize| {
        state = state.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
        (state >> 8) as usize % below
    };
    let (mut good, mut bad) = (0, 0);
    for _ in 0..20_000 {
        let mut text: Vec<char> = format!("{HEAD}{body}").chars().collect();
        for _ in 0..=random(3) {
            let (from, to) = (random(text.len()), random(text.len()));
            match random(4) {
                0 => text.truncate(from),
                1 => drop(text.remove(from)),
                2 => text.swap(from, to),
                _ => text.insert(from, text[to]),
            }
            text.push('\n');
        }
        let text: String = text.into_iter().collect();
        match flatten(&text, &[], &mut |_| None) {
            Ok(flat) => {
                // What is flat stays as it is.
                let again = flatten(&flat.text, &[], &mut |_| None).expect("flat text is read");
                assert_eq!(again.parts[0].left_out, Contents::default(), "{text}");
                let _ = corput::strip::bake(&flat.text, &[(1, 2)]);
                good += 1;
            }
            Err(_) => bad += 1,
        }
    }
    assert!(good > 1000 && bad > 1000, "{good} {bad}");
}
