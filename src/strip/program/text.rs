//! The GLSL of a scene's kernel, part by part.

use super::literal::{indented, real, word};
use super::{Form, GROUP, Parameters, Program, SAMPLES, choice, columns, maps};
use crate::Result;
use crate::scene::{Choice, Domain, Draw, Field, Needs, Span};
use std::fmt::Write;

/// The name of the buffer of an environment.
pub(super) const ENVIRONMENT: &str = "environment";

/// The source with includes. Writing to a String cannot fail, so results of it are dropped.
pub(super) fn source(program: &Program, needs: &Needs) -> Result<String> {
    let columns: Vec<columns::Code> = needs
        .request
        .columns
        .iter()
        .enumerate()
        .map(|(number, column)| columns::code(column, number, program.run, program.samples))
        .collect();
    let mut includes: Vec<&str> = Vec::new();
    for column in &columns {
        includes.extend(column.includes);
    }
    let units: Vec<&str> = columns.iter().map(|column| column.unit.as_str()).collect();
    let mut text = declarations(program, needs, includes, &units, &cursor(&columns))?;
    if program.form == Form::Four {
        text += &sample(program, needs, &columns);
    }
    text += &main(program, needs, &columns);
    Ok(text)
}

/// What comes before the sample: the interface, headers, what coordinates need, and a function
/// `draw_NAME` for each domain. `units` make floats of each coordinate's fractions.
pub(super) fn declarations(
    program: &Program,
    needs: &Needs,
    includes: Vec<&str>,
    units: &[&str],
    coordinates: &str,
) -> Result<String> {
    let mut includes: Vec<String> = includes.into_iter().map(str::to_owned).collect();
    let mut functions = String::new();
    for (domain, field) in needs.domains.iter().zip(&program.record.fields) {
        let _ = writeln!(
            functions,
            "// {}: {}; {}.",
            comment(&domain.key),
            field.values.join(", "),
            comment(&domain.cause.to_string())
        );
        let name = format!("draw_{}", field.name);
        match &domain.draw {
            Draw::Between(ends) => {
                let unit = units.get(domain.first as usize).copied().unwrap_or("");
                let span = Span::new(*ends)?;
                includes.extend(span.map(|_| "corput/real.glsl".to_owned()));
                functions += &between(&name, span, unit);
            }
            Draw::Choice(weights) => {
                let table = format!("choice_{}", field.name);
                functions += &choice::function(&name, &Choice::new(weights)?, &table);
            }
            Draw::Map(mapping) => {
                let code = maps::code(mapping, program.profile);
                includes.push(code.include);
                let taken = vector(mapping.map().dimensions);
                let kind = vector(field.values.len() as u32);
                let body = indented(&code.body, 4);
                let _ = write!(functions, "{kind} {name}({taken} u) {{\n{body}}}\n");
            }
        }
        functions.push('\n');
    }
    includes.sort_unstable();
    includes.dedup();

    let mut text = head(program);
    for name in includes {
        let _ = writeln!(text, "#include \"{name}\"");
    }
    let _ = write!(text, "\n{coordinates}\n{functions}");
    Ok(text)
}

/// A text without what would end a comment's line.
fn comment(text: &str) -> String {
    let plain = |c: char| if c.is_ascii_graphic() { c } else { ' ' };
    text.chars()
        .map(plain)
        .collect::<String>()
        .replace('\\', "/")
}

fn vector(words: u32) -> &'static str {
    match words {
        0 | 1 => "uint",
        2 => "uvec2",
        3 => "uvec3",
        _ => "uvec4",
    }
}

/// What comes before the includes.
fn head(program: &Program) -> String {
    let (element, integers) = match program.form {
        Form::Words => ("uint", ""),
        Form::Four => ("uvec4", ""),
        Form::Eight => (
            "u64vec4",
            "#extension GL_EXT_shader_explicit_arithmetic_types_int64 : require\n",
        ),
    };
    let mut text = format!(
        "#version 450\n#extension GL_EXT_control_flow_attributes : require\n{integers}\
         // Samples of {}: records of {} words, {} samples at most.\n\
         // Made by corput {}, {}.\n\
         layout(local_size_x = {GROUP}) in;\n",
        comment(&program.name),
        program.record.words,
        program.samples,
        env!("CARGO_PKG_VERSION"),
        env!("CARGO_PKG_LICENSE"),
    );
    // Languages with their parameters in uniforms know no buffers that are only written.
    let access = match program.parameters {
        Parameters::Push => "writeonly ",
        Parameters::Uniform => "",
    };
    let _ = writeln!(
        text,
        "layout(std430, set = 0, binding = {SAMPLES}) {access}buffer Samples {{ {element} samples[]; }};"
    );
    for (number, table) in program.tables.iter().enumerate() {
        let _ = writeln!(
            text,
            "layout(std430, set = 0, binding = {}) readonly buffer Table{number} {{ uint {}[]; }};",
            table.binding, table.name
        );
    }
    let block = match program.parameter_binding() {
        Some(binding) if program.parameters == Parameters::Uniform => {
            format!("layout(std140, set = 0, binding = {binding}) uniform Parameters")
        }
        _ => "layout(push_constant) uniform Push".to_owned(),
    };
    let _ = write!(
        text,
        "{block} {{\n    // Index of the first sample.\n    uint first;\n    \
         // Samples to make.\n    uint count;\n}} push;\n\n"
    );
    if program.tables.iter().any(|table| table.name == ENVIRONMENT) {
        let _ = writeln!(text, "#define CORPUT_DISCRETE(i) {ENVIRONMENT}[i]");
    }
    text
}

/// What coordinates need besides the index, and where consecutive samples stand.
fn cursor(columns: &[columns::Code]) -> String {
    let mut text = String::new();
    for column in columns {
        text += &column.globals;
    }
    text += "\n// Where a run of samples stands.\nstruct Cursor {\n    uint n;\n";
    for (kind, name, _) in columns.iter().flat_map(|column| &column.members) {
        let _ = writeln!(text, "    {kind} {name};");
    }
    text += "};\n";
    text
}

/// The statements that begin a run at index n.
fn begin(columns: &[columns::Code]) -> String {
    let mut text = "Cursor c = Cursor(n".to_owned();
    for (_, _, value) in columns.iter().flat_map(|column| &column.members) {
        let _ = write!(text, ",\n    {value}");
    }
    text += ");\n";
    text
}

/// The statements that go on to the next sample.
fn next(columns: &[columns::Code]) -> String {
    let steps = columns.iter().filter(|column| !column.next.is_empty());
    let steps: String = steps.map(|column| format!("{}\n", column.next)).collect();
    format!("c.n += 1u;\n{steps}")
}

fn between(name: &str, span: Option<Span>, unit: &str) -> String {
    let body = match span {
        None => format!("return floatBitsToUint({unit});\n"),
        Some(Span { low, high, width }) => format!(
            "const CorputReal low = {};\nconst CorputReal high = {};\n\
             const CorputReal width = {};\n\
             CorputReal part = corput_real_multiply(width, corput_real_uint(u, -32));\n\
             return floatBitsToUint(corput_real_float(corput_real_min(corput_real_add(low, part), high)));\n",
            real(low),
            real(high),
            real(width)
        ),
    };
    format!("uint {name}(uint u) {{\n{}}}\n", indented(&body, 4))
}

/// The call that draws a domain from fractions `u0` and on.
fn call(domain: &Domain, field: &Field) -> String {
    let taken: Vec<String> = domain.range().map(|number| format!("u{number}")).collect();
    let taken = match &taken[..] {
        [one] => one.clone(),
        all => format!("{}({})", vector(all.len() as u32), all.join(", ")),
    };
    format!("draw_{}({taken})", field.name)
}

/// The statements that make them.
fn fractions(needs: &Needs, columns: &[columns::Code]) -> String {
    let numbers = 0..needs.dimensions() as usize;
    let one = |(number, column): (usize, &columns::Code)| {
        format!("uint u{number} = {};\n", column.fraction)
    };
    numbers.zip(columns).map(one).collect()
}

/// All domains of a sample, of kernels that store four at a time.
fn sample(program: &Program, needs: &Needs, columns: &[columns::Code]) -> String {
    let mut text = "struct Sample {\n".to_owned();
    for field in &program.record.fields {
        let kind = vector(field.values.len() as u32);
        let _ = writeln!(text, "    {kind} {};", field.name);
    }
    let fractions = indented(&fractions(needs, columns), 4);
    let calls = needs.domains.iter().zip(&program.record.fields);
    let calls: Vec<String> = calls.map(|(domain, field)| call(domain, field)).collect();
    let _ = write!(
        text,
        "}};\n\nSample sample_at(Cursor c) {{\n{fractions}    return Sample(\n        {});\n}}\n\n",
        calls.join(",\n        ")
    );
    text
}

/// The words of a field in a variable, in order.
fn words(field: &Field, variable: &str) -> Vec<String> {
    match field.values.len() {
        1 => vec![variable.to_owned()],
        count => {
            let axes = ["x", "y", "z", "w"].into_iter().take(count);
            axes.map(|axis| format!("{variable}.{axis}")).collect()
        }
    }
}

/// The beginning of `main`: the number `i` of the invocation, and the index `n` of its first
/// sample.
pub(super) fn invocation(program: &Program) -> String {
    let run = word(program.run);
    format!(
        "void main() {{\n\
         \x20   // More groups than one axis holds are dispatched in two.\n\
         \x20   uint group = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;\n\
         \x20   uint i = group * {GROUP}u + gl_LocalInvocationID.x;\n\
         \x20   if (i >= push.count / {run} + min(push.count % {run}, 1u)) {{\n        return;\n    }}\n\
         \x20   uint begin = i * {run};\n\
         \x20   uint n = push.first + begin;\n"
    )
}

fn main(program: &Program, needs: &Needs, columns: &[columns::Code]) -> String {
    let run = word(program.run);
    let stride = program.record.words;
    let mut text = invocation(program);
    text += &indented(&begin(columns), 4);
    let count = format!("    uint count = min({run}, push.count - begin);\n");
    if program.form == Form::Four {
        let four = four(program, columns);
        let at = word(program.run / 4 * stride);
        let _ = writeln!(text, "    uint at = i * {at};");
        if program.run == 4 {
            text += &indented(&four, 4);
        } else {
            let _ = write!(
                text,
                "{count}    [[dont_unroll]] for (uint k = 0u; k < count; k += 4u) {{\n{}\
                 \x20       at += {stride}u;\n    }}\n",
                indented(&four, 8)
            );
        }
        text += "}\n";
        return text;
    }
    text += &count;
    let _ = write!(
        text,
        "    uint at = begin * {stride}u;\n    [[dont_unroll]] for (uint k = 0u; k < count; k++) {{\n{}",
        indented(&fractions(needs, columns), 8)
    );
    // Each is stored at once: some compilers take very long where many values live long.
    for (domain, field) in needs.domains.iter().zip(&program.record.fields) {
        let (name, kind) = (&field.name, vector(field.values.len() as u32));
        let _ = writeln!(text, "        {kind} {name} = {};", call(domain, field));
        for (at, word) in (field.first..).zip(words(field, name)) {
            let _ = writeln!(text, "        samples[at + {at}u] = {word};");
        }
    }
    let _ = write!(
        text,
        "        at += {stride}u;\n{}    }}\n}}\n",
        indented(&next(columns), 8)
    );
    text
}

/// The statements that store four records, of kernels that do so.
fn four(program: &Program, columns: &[columns::Code]) -> String {
    let stride = program.record.words;
    // A loop, and no four copies: of what follows a branch some drivers make two. Arrays of
    // four are what others unroll such a loop for.
    let parts = stride.div_ceil(4);
    let arrays: Vec<String> = (0..parts).map(|part| format!("w{part}[4]")).collect();
    let mut text = format!(
        "uvec4 {};\nfor (uint j = 0u; j < 4u; j++) {{\n    Sample s = sample_at(c);\n{}",
        arrays.join(", "),
        indented(&next(columns), 4)
    );
    let fields = program.record.fields.iter();
    let mut all: Vec<String> = fields
        .flat_map(|field| words(field, &format!("s.{}", field.name)))
        .collect();
    all.resize(4 * parts as usize, "0u".to_owned());
    for (part, four) in all.chunks(4).enumerate() {
        let _ = writeln!(text, "    w{part}[j] = uvec4({});", four.join(", "));
    }
    text += "}\n";
    let axes = ["x", "y", "z", "w"];
    let word = |at: u32| {
        let (record, at) = (at / stride, at % stride);
        let axis = axes.get(at as usize % 4).copied().unwrap_or("x");
        format!("w{}[{record}].{axis}", at / 4)
    };
    for row in 0..stride {
        let four: Vec<String> = (4 * row..4 * row + 4).map(word).collect();
        let _ = writeln!(text, "samples[at + {row}u] = uvec4({});", four.join(", "));
    }
    text
}
