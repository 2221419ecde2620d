//! What a module holds, for reports.

use std::collections::BTreeSet;

use ::spirv::{Capability, Decoration, Op};

use super::{Module, Result};

/// What a module holds.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ModuleFacts {
    /// Names of its functions in module order, one for each overload; an id
    /// (`%7`) where there is no name.
    pub functions: Vec<String>,
    /// Instructions, all sections together.
    pub instructions: usize,
    /// Size in bytes.
    pub bytes: usize,
    /// Capabilities by name, in module order.
    pub capabilities: Vec<String>,
    /// Descriptors as (set, binding), ascending.
    pub bindings: Vec<(u32, u32)>,
    /// Ids of the specialization constants, ascending.
    pub spec_ids: Vec<u32>,
}

/// Sums up a module.
pub fn describe(words: &[u32]) -> Result<ModuleFacts> {
    let module = Module::parse(words)?;
    let mut capabilities = Vec::new();
    for instruction in module
        .instructions()
        .iter()
        .filter(|row| row.op() == Some(Op::Capability))
    {
        let number = instruction.operand(1)?;
        capabilities.push(
            Capability::from_u32(number)
                .map_or_else(|| number.to_string(), |name| format!("{name:?}")),
        );
    }
    let mut bindings = BTreeSet::new();
    let mut spec_ids = BTreeSet::new();
    for row in module.decorations() {
        match (row.decoration, row.literals) {
            (Some(Decoration::SpecId), [id, ..]) => {
                spec_ids.insert(*id);
            }
            (Some(Decoration::Binding), [binding, ..]) => {
                let set = module.decorations().find(|other| {
                    other.target == row.target
                        && other.decoration == Some(Decoration::DescriptorSet)
                });
                bindings.insert((
                    set.and_then(|set| set.literals.first())
                        .map_or(0, |set| *set),
                    *binding,
                ));
            }
            _ => {}
        }
    }
    Ok(ModuleFacts {
        functions: module
            .functions()
            .iter()
            .map(super::Function::label)
            .collect(),
        instructions: module.instructions().len(),
        bytes: size_of_val(words),
        capabilities,
        bindings: bindings.into_iter().collect(),
        spec_ids: spec_ids.into_iter().collect(),
    })
}
