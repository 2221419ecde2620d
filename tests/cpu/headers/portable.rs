//! Each header through naga: parsed as GLSL, validated, written as WGSL, HLSL and MSL.

use super::source::{self, Declarations, glsl, includes};
use corput::headers;
use naga::back::{hlsl, msl, wgsl};
use naga::valid::{Capabilities, ValidationFlags, Validator};
use std::fmt::Write;

/// The text of a header with its includes in place, each once: naga takes none.
fn flat(name: &str, done: &mut Vec<String>) -> String {
    if done.iter().any(|known| known == name) {
        return String::new();
    }
    done.push(name.to_owned());
    let found = headers().iter().find(|(known, _)| *known == name);
    let (_, text) = found.unwrap_or_else(|| panic!("no header {name}"));
    let mut flattened = String::new();
    for line in text.lines() {
        match &includes(line)[..] {
            [other] => flattened += &flat(other, done),
            _ => flattened += line,
        }
        flattened.push('\n');
    }
    flattened
}

/// An expression of this type from the words of the buffer.
fn argument(kind: &str, known: &Declarations) -> String {
    match kind {
        "uint" => "data[0]".to_owned(),
        "int" => "int(data[1])".to_owned(),
        "bool" => "(data[2] != 0u)".to_owned(),
        "float" => "uintBitsToFloat(data[3])".to_owned(),
        "uvec2" | "uvec3" | "uvec4" | "vec2" | "vec3" | "vec4" => {
            let part = argument(
                if kind.starts_with('u') {
                    "uint"
                } else {
                    "float"
                },
                known,
            );
            let size = usize::from(kind.as_bytes()[kind.len() - 1] - b'0');
            format!("{kind}({})", vec![part; size].join(", "))
        }
        _ => {
            let found = known.structs.iter().find(|s| s.name == kind);
            let members = &found.unwrap_or_else(|| panic!("no struct {kind}")).members;
            let parts: Vec<String> = members.iter().map(|m| argument(&m.0, known)).collect();
            format!("{kind}({})", parts.join(", "))
        }
    }
}

/// A value of this type as one uint, every part of it used.
fn sink(value: &str, kind: &str, known: &Declarations) -> String {
    match kind {
        "uint" => value.to_owned(),
        "int" => format!("uint({value})"),
        "bool" => format!("({value} ? 1u : 0u)"),
        "float" => format!("floatBitsToUint({value})"),
        _ if kind.contains("vec") => {
            let scalar = if kind.starts_with('u') {
                "uint"
            } else {
                "float"
            };
            let size = usize::from(kind.as_bytes()[kind.len() - 1] - b'0');
            let part = |axis: &str| sink(&format!("{value}.{axis}"), scalar, known);
            let parts: Vec<String> = ["x", "y", "z", "w"][..size]
                .iter()
                .map(|a| part(a))
                .collect();
            parts.join(" + ")
        }
        _ => {
            let found = known.structs.iter().find(|s| s.name == kind);
            let members = &found.unwrap_or_else(|| panic!("no struct {kind}")).members;
            let part = |m: &source::Variable| sink(&format!("{value}.{}", m.1), &m.0, known);
            let parts: Vec<String> = members.iter().map(part).collect();
            parts.join(" + ")
        }
    }
}

/// A compute shader whose main calls every function of a header, and their names.
fn caller(name: &str) -> (String, Vec<String>) {
    let body = flat(name, &mut Vec::new());
    let known = glsl(&body);
    let (_, own) = headers()
        .iter()
        .find(|(other, _)| *other == name)
        .expect("a header");
    let mut calls = String::new();
    let mut names = Vec::new();
    for (i, function) in glsl(own).functions.iter().enumerate() {
        let kinds = function.parameters.iter().map(|p| argument(&p.0, &known));
        let arguments = kinds.collect::<Vec<_>>().join(", ");
        let (kind, at) = (&function.result, i + 4);
        // Writing to a String cannot fail.
        let _ = writeln!(calls, "    {kind} r{i} = {}({arguments});", function.name);
        let _ = writeln!(
            calls,
            "    data[{at}] = {};",
            sink(&format!("r{i}"), kind, &known)
        );
        names.push(function.name.clone());
    }
    let hooks = super::hooks();
    let text = format!(
        "#version 450\n#define CORPUT_PORTABLE 1\nlayout(local_size_x = 1) in;\n\
         layout(std430, set = 0, binding = 0) buffer Data {{ uint data[]; }};\n\
         {hooks}{body}\nvoid main() {{\n{calls}}}\n"
    );
    (text, names)
}

/// The shader in WGSL, HLSL and MSL, or the stage that refused it and its words.
fn translate(text: &str) -> Result<[String; 3], String> {
    let mut validator = Validator::new(ValidationFlags::all(), Capabilities::empty());
    let module = naga::front::glsl::Frontend::default()
        .parse(&naga::ShaderStage::Compute.into(), text)
        .map_err(|error| format!("naga parses: {}", error.emit_to_string(text)))?;
    let info = validator
        .validate(&module)
        .map_err(|error| format!("naga validates: {}", error.emit_to_string(text)))?;
    let wgsl_text = wgsl::write_string(&module, &info, wgsl::WriterFlags::empty())
        .map_err(|error| format!("WGSL: {error}"))?;
    // What was written must be read again.
    let again = naga::front::wgsl::parse_str(&wgsl_text)
        .map_err(|error| format!("WGSL: {}", error.emit_to_string(&wgsl_text)))?;
    validator
        .validate(&again)
        .map_err(|error| format!("WGSL: {}", error.emit_to_string(&wgsl_text)))?;
    let mut hlsl_text = String::new();
    let options = hlsl::Options::default();
    let pipeline = hlsl::PipelineOptions::default();
    hlsl::Writer::new(&mut hlsl_text, &options, &pipeline)
        .write(&module, &info, None)
        .map_err(|error| format!("HLSL: {error}"))?;
    let options = msl::Options {
        // reverse_bits came with Metal 2.1.
        lang_version: (2, 1),
        ..msl::Options::default()
    };
    let (msl_text, _) = msl::write_string(&module, &info, &options, &Default::default())
        .map_err(|error| format!("MSL: {error}"))?;
    Ok([wgsl_text, hlsl_text, msl_text])
}

#[test]
fn naga_translates_every_function() {
    let mut faults = Vec::new();
    for (name, _) in headers() {
        let (text, functions) = caller(name);
        assert!(!functions.is_empty(), "{name}");
        match translate(&text) {
            Err(error) => faults.push(format!("{name}: {error}")),
            Ok(outputs) => {
                for (function, output) in functions
                    .iter()
                    .flat_map(|f| outputs.iter().map(move |o| (f, o)))
                {
                    assert!(
                        output.contains(function.as_str()),
                        "{name}: {function} is lost"
                    );
                }
            }
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn glslang_takes_the_same_callers() {
    for (name, _) in headers() {
        let (text, _) = caller(name);
        if let Err(log) = corput::compile::to_spirv(&text, &[], &mut |_| None) {
            panic!("{name}: {log}");
        }
    }
}

#[test]
fn what_naga_refuses_is_caught() {
    // Without the portable form, and the idioms that bits.glsl and frame.glsl avoid.
    let (fast, _) = caller("corput/fixed.glsl");
    let fast = fast.replace("#define CORPUT_PORTABLE 1\n", "");
    assert!(translate(&fast).is_err(), "umulExtended");
    let (good, _) = caller("corput/bits.glsl");
    assert!(translate(&good).is_ok());
    for (from, to) in [
        ("uint(findMSB(x))", "findMSB(x)"),
        (
            "return bitfieldReverse(x);",
            "precise uint y = x; return y;",
        ),
        ("return bitfieldReverse(x);", "return x"),
        ("return bitfieldReverse(x);", "return 1.0;"),
    ] {
        let bad = good.replacen(from, to, 1);
        assert!(bad != good && translate(&bad).is_err(), "{from} -> {to}");
    }
}
