//! Generated headers and modules: compilers take them, and they say what the module says.

use super::facts::reflected;
use super::kernels::row;
use corput::interface::KERNELS;
use corput::kernels::spirv;
use corput::strip::host::{Field, Interface, c_header, rust_module};
use std::fmt::Write;
use std::io::Write as _;
use std::path::Path;
use std::process::Command;

/// What a module's reflection demands of its header, and of its module of Rust.
fn demands(interface: &Interface, words: &[u32]) -> (String, String) {
    let upper = interface.name.to_ascii_uppercase();
    let kind: String = (interface.name.split('_'))
        .map(|word| word[..1].to_ascii_uppercase() + &word[1..])
        .collect();
    let equal = |name: &str, value: &str| {
        (
            format!("{upper}_{name} == {value}"),
            format!("{name} == {value}"),
        )
    };
    let mut all = vec![equal("SPIRV_WORDS", &words.len().to_string())];
    for fact in reflected(words) {
        let parts: Vec<&str> = fact.split_whitespace().collect();
        match parts[..] {
            ["push", "bytes", bytes] => all.push(equal("PUSH_BYTES", bytes)),
            ["push", name, "at", offset] => all.push((
                format!("offsetof({kind}Push, {name}) == {offset}"),
                format!("core::mem::offset_of!(Push, {name}) == {offset}"),
            )),
            ["buffer", at, name, _, _, "every", stride] => {
                let name = name.trim_end_matches(':').to_ascii_uppercase();
                let (set, binding) = at.split_once('.').expect("set and binding");
                all.push(equal(&format!("SET_{name}"), set));
                all.push(equal(&format!("BINDING_{name}"), binding));
                all.push(equal(&format!("STRIDE_{name}"), stride));
            }
            ["constant", id, name, "=", _] => {
                all.push(equal(
                    &format!("CONSTANT_{}", name.to_ascii_uppercase()),
                    id,
                ));
            }
            ["version", _] => {}
            ["local", "size", ..] => {
                let sizes = parts[2..]
                    .iter()
                    .map(|size| size.trim_matches(['[', ']', ',']));
                for ((axis, at), size) in ["X", "Y", "Z"].iter().zip(0..).zip(sizes) {
                    all.push((
                        format!("{upper}_WORKGROUP_{axis} == {size}"),
                        format!("WORKGROUP[{at}] == {size}"),
                    ));
                }
            }
            _ => panic!("what is `{fact}`?"),
        }
    }
    let (mut c, mut rust) = (String::new(), String::new());
    for (in_c, in_rust) in all {
        let _ = writeln!(c, "static_assert({in_c}, \"\");");
        let _ = writeln!(rust, "const _: () = assert!({in_rust});");
    }
    (c, rust)
}

/// Runs a compiler; None where there is none.
fn compiler(program: &str, arguments: &[&str], file: &Path) -> Option<Result<(), String>> {
    let done = Command::new(program)
        .args(arguments)
        .arg(file)
        .output()
        .ok()?;
    let log = String::from_utf8_lossy(&done.stderr).into_owned();
    Some(if done.status.success() {
        Ok(())
    } else {
        Err(log)
    })
}

const C: (&str, &[&str]) = (
    "cc",
    &[
        "-std=c11",
        "-Wall",
        "-Wextra",
        "-Werror",
        "-pedantic",
        "-fsyntax-only",
        "-x",
        "c",
    ],
);
const CPP: (&str, &[&str]) = (
    "c++",
    &[
        "-std=c++11",
        "-Wall",
        "-Wextra",
        "-Werror",
        "-pedantic",
        "-fsyntax-only",
        "-x",
        "c++",
    ],
);

/// Compiles both with what is demanded of them: the first compiler that refuses, and why.
fn compile(header: &str, module: &str, demands: &(String, String)) -> Result<(), String> {
    let folder = tempfile::tempdir().expect("a folder");
    std::fs::write(folder.path().join("made.h"), header).expect("written");
    // Twice: it guards itself.
    let host = format!(
        "#include \"made.h\"\n#include \"made.h\"\n{}int main(void) {{ return 0; }}\n",
        demands.0
    );
    let source = folder.path().join("host.c");
    std::fs::write(&source, host).expect("written");
    for (program, arguments) in [C, CPP] {
        match compiler(program, arguments, &source) {
            Some(result) => result.map_err(|log| format!("{program}: {log}"))?,
            None => {
                let _ = writeln!(std::io::stderr().lock(), "SKIPPED: no {program}");
            }
        }
    }
    let source = folder.path().join("made.rs");
    std::fs::write(
        &source,
        format!(
            "#![deny(warnings, missing_docs)]\n//! Made.\n{module}{}",
            demands.1
        ),
    )
    .expect("written");
    let out = folder.path().join("libmade.rmeta").display().to_string();
    let arguments = [
        "--edition=2021",
        "--crate-type",
        "lib",
        "--emit=metadata",
        "-o",
        &out,
    ];
    compiler("rustc", &arguments, &source)
        .expect("rustc")
        .map_err(|log| format!("rustc: {log}"))
}

fn made(interface: &Interface) -> (String, String) {
    (
        c_header(interface).expect("a header"),
        rust_module(interface).expect("a module"),
    )
}

#[test]
fn compilers_agree_with_the_modules() {
    let names = [
        "fused_net",
        "map_environment",
        "estimate_pixels",
        "void_and_cluster",
        "probe",
        "pairs",
    ];
    for name in names {
        let words = spirv(name).expect("a module");
        let interface = Interface::of(row(name), &words).expect("a module");
        let (header, module) = made(&interface);
        let demands = demands(&interface, &words);
        compile(&header, &module, &demands)
            .unwrap_or_else(|log| panic!("{name}: {log}\n{header}\n{module}"));
    }
    for kernel in KERNELS {
        let words = spirv(kernel.name).expect("a module");
        made(&Interface::of(kernel, &words).expect("a module"));
    }
}

#[test]
fn a_wrong_interface_does_not_compile() {
    let words = spirv("map_environment").expect("a module");
    let right = Interface::of(row("map_environment"), &words).expect("a module");
    let demands = demands(&right, &words);
    let mut wrong = vec![right.clone(); 8];
    wrong[0].workgroup[1] = 2;
    wrong[1].resources[1].binding += 1;
    wrong[2].resources[0].set = 1;
    wrong[3].resources[2].stride = 16;
    wrong[4].push.swap(0, 1);
    let (a, b) = (wrong[4].push[1].offset, wrong[4].push[0].offset);
    (wrong[4].push[0].offset, wrong[4].push[1].offset) = (a, b);
    wrong[5].push.pop();
    wrong[6].constants[0].id += 1;
    wrong[7].spirv_words += 1;
    for (i, interface) in wrong.iter().enumerate() {
        let (header, module) = made(interface);
        let log = compile(&header, "", &(demands.0.clone(), String::new()))
            .expect_err("C")
            .to_string();
        assert!(log.starts_with("cc"), "mistake {i}: {log}");
        let log = compile("", &module, &(String::new(), demands.1.clone()))
            .expect_err("Rust")
            .to_string();
        assert!(log.starts_with("rustc"), "mistake {i}: {log}");
    }
    // The asserts of the files themselves.
    let (header, module) = made(&right);
    let empty = (String::new(), String::new());
    assert!(compile(&header.replace("uint32_t p1;", "uint64_t p1;"), "", &empty).is_err());
    assert!(compile("", &module.replace("pub p1: u32", "pub p1: u64"), &empty).is_err());
}

#[test]
fn gaps_and_names() {
    let mut interface =
        Interface::of(row("fused"), &spirv("fused").expect("a module")).expect("a module");
    let field = |name: &str, offset| Field {
        name: name.to_owned(),
        offset,
        doc: "one \\\nmore".to_owned(),
    };
    interface.push = vec![field("a", 8), field("b", 12), field("c", 32)];
    let (header, module) = made(&interface);
    let demands = (
        "static_assert(sizeof(FusedPush) == 36 && offsetof(FusedPush, c) == 32, \"\");\n".to_owned(),
        "const _: () = assert!(core::mem::size_of::<Push>() == 36 && core::mem::offset_of!(Push, a) == 8);\n".to_owned(),
    );
    compile(&header, &module, &demands).unwrap_or_else(|log| panic!("{log}\n{header}\n{module}"));
    let refused = |edit: &dyn Fn(&mut Interface), words: &str| {
        let mut interface = interface.clone();
        edit(&mut interface);
        for error in [c_header(&interface), rust_module(&interface)] {
            let error = error.expect_err("refused");
            assert!(error.to_string().contains(words), "{error}");
            assert_eq!(error.exit_code(), 2);
        }
    };
    refused(&|i| i.push[1].name = "class".to_owned(), "the name `class`");
    refused(&|i| i.push[1].name = "1a".to_owned(), "the name `1a`");
    refused(&|i| i.push[1].name = "a__b".to_owned(), "the name `a__b`");
    refused(&|i| i.push[1].name = "A".to_owned(), "the name `A`, twice");
    refused(&|i| i.name = String::new(), "the name ``");
    refused(&|i| i.push[1].offset = 10, "at byte 10");
    refused(&|i| i.push[1].offset = 8, "at byte 8");
    refused(&|i| i.entry_point = "a\"b".to_owned(), "the entry point");
}

#[test]
fn a_smaller_module_has_a_smaller_interface() {
    // Of the tables only the first, and no constants.
    let kernel = row("map_environment");
    let text = "#version 450\nlayout(local_size_x = 64) in;\n\
        layout(std430, set = 0, binding = 0) buffer Buffer0 { uvec4 results[]; };\n\
        layout(std430, set = 0, binding = 2) readonly buffer Buffer2 { uint tables[]; };\n\
        void main() { results[0] = uvec4(tables[1]); }\n";
    let words = corput::compile::to_spirv(text, &[], &mut |_| None).expect("a shader");
    let interface = Interface::of(kernel, &words).expect("a module");
    let names: Vec<&str> = interface
        .resources
        .iter()
        .map(|r| r.name.as_str())
        .collect();
    assert_eq!(names, ["results", "tables"]);
    assert!(interface.constants.is_empty());
    let (header, module) = made(&interface);
    compile(&header, &module, &demands(&interface, &words)).expect("compiled");
    assert!(Interface::of(kernel, &words[1..]).is_err());
}
