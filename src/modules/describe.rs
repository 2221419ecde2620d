//! What an engine must know of a module, as JSON.

use crate::interface::{Binding, Element, Kernel};
use crate::kernels::spirv;
use crate::report::hexadecimal;
use crate::spirv::describe;
use crate::{Error, Result};
use serde_json::{Value, json};
use sha2::{Digest, Sha256};

/// The version of the documents; it changes when a reader of the old one would fail.
pub const SCHEMA: &str = "corput-modules/1";

/// A module: file and hash, entry point, workgroup, buffers of set 0, push constants and
/// specialization constants with their defaults.
///
/// # Errors
/// None, if the stock kernels are as built.
pub fn description(kernel: &Kernel) -> Result<Value> {
    let words = spirv(kernel.name)?;
    let bytes: Vec<u8> = words.iter().flat_map(|word| word.to_le_bytes()).collect();
    let facts = describe(&words).map_err(|error| Error::Shader {
        shader: kernel.name.into(),
        problem: error.to_string(),
    })?;
    let push = kernel.push.iter().map(|member| {
        json!({ "name": member.name, "offset": member.offset, "type": "uint", "doc": member.doc.trim() })
    });
    let constants = kernel.specialization().into_iter();
    Ok(json!({
        "name": kernel.name,
        "file": format!("{}.spv", kernel.name),
        "bytes": bytes.len(),
        "sha256": hexadecimal(&Sha256::digest(&bytes)),
        "entry_point": "main",
        "capabilities": facts.capabilities,
        "local_size": kernel.local_size,
        "push_constants": push.collect::<Vec<_>>(),
        "bindings": kernel.bindings.iter().map(binding).collect::<Vec<_>>(),
        "constants": constants
            .map(|(id, name, default)| json!({ "id": id, "name": name, "default": default }))
            .collect::<Vec<_>>(),
    }))
}

fn binding(binding: &Binding) -> Value {
    let (element, is_uniform) = match binding.element {
        Element::Uint => ("uint", false),
        Element::Uvec4 => ("uvec4", false),
        Element::U64vec4 => ("u64vec4", false),
        Element::Rows(_) => ("uvec4", true),
    };
    json!({
        "set": 0,
        "binding": binding.binding,
        "name": binding.name,
        "kind": if is_uniform { "uniform buffer" } else { "storage buffer" },
        "element": element,
        "bytes": binding.uniform(),
        "read_only": binding.input,
    })
}
