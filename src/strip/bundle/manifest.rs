//! What a bundle consists of, as JSON.

use super::{Bundle, File, table_file};
use crate::report::hexadecimal;
use crate::scene::{Field, LeftOut, Needs, Scene};
use crate::strip::program::{Form, GROUP, Program};
use crate::strip::{Contents, Part};
use serde_json::{Value, json};
use sha2::{Digest, Sha256};

/// The version of the document.
const SCHEMA: u32 = 1;

/// The document of a bundle, before it is itself among the files.
pub(super) fn document(
    scene: &Scene,
    needs: &Needs,
    bundle: &Bundle,
    uniform: Option<&Program>,
) -> Value {
    let program = &bundle.program;
    let tables = program.tables.iter().map(|table| {
        json!({
            "file": table_file(&scene.name, table),
            "name": table.name,
            "binding": table.binding,
            "bytes": 4 * table.words.len(),
            "domain": table.key,
        })
    });
    let parts = bundle.flat.parts.iter();
    json!({
        "schema": SCHEMA,
        "name": scene.name,
        "versions": {
            "corput": env!("CARGO_PKG_VERSION"),
            "glslang": GLSLANG,
            "naga": NAGA,
        },
        "sampler": scene.sampler.value.name(),
        "samples": scene.samples.value,
        "seed": scene.seed,
        "profile": scene.profile.name(),
        "dimensions": needs.dimensions(),
        "entry_point": "main",
        "workgroup": [GROUP, 1, 1],
        "samples_of_an_invocation": program.run,
        "record_words": program.record.words,
        "samples_multiple": program.multiple(),
        "first_multiple": program.aligned,
        "needs_int64": program.form == Form::Eight,
        "record": program.record.fields.iter().map(field).collect::<Vec<_>>(),
        "bindings": {
            "set": 0,
            "samples": 0,
            "parameters": uniform.and_then(Program::parameter_binding),
        },
        "tables": tables.collect::<Vec<_>>(),
        "files": bundle.files.iter().map(file).collect::<Vec<_>>(),
        "kept": parts.filter(|part| part.kept != Contents::default()).map(kept).collect::<Vec<_>>(),
        "left_out": needs.left_out.iter().map(left_out).collect::<Vec<_>>(),
        "spirv_opt": bundle.optimised.as_ref().map(|one| json!({
            "version": one.version,
            "bytes_before": one.bytes_before,
        })),
        "warnings": needs.warnings,
    })
}

/// The crates' versions as Cargo.toml asks for them: which of those a build has is its own.
const GLSLANG: &str = "crate glslang 0.9";
const NAGA: &str = "crate naga 30";

fn field(field: &Field) -> Value {
    json!({
        "domain": field.key,
        "name": field.name,
        "first_word": field.first,
        "values": field.values,
    })
}

fn file(file: &File) -> Value {
    let mut made = json!({
        "name": file.name,
        "bytes": file.bytes.len(),
        "sha256": hexadecimal(&Sha256::digest(&file.bytes)),
    });
    if let Some(target) = file.target {
        made["target"] = json!(target.name());
        made["checked"] = json!(target.checked_by());
        made["promise"] = json!(target.promise());
    }
    made
}

fn kept(part: &Part) -> Value {
    json!({
        "file": part.name,
        "functions": part.kept.functions,
        "table_bytes": part.kept.table_bytes(),
        "functions_left_out": part.left_out.functions.len(),
        "table_bytes_left_out": part.left_out.table_bytes(),
    })
}

fn left_out(one: &LeftOut) -> Value {
    json!({ "part": one.part.name(), "name": one.name, "reason": one.reason })
}
