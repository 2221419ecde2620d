//! A module without the names that serve a debugger alone.

use std::collections::HashSet;

use ::spirv::{Decoration, Op};

use super::{Instruction, Module, Result};

/// The module less the names of what lies in functions, of members of structures that are no
/// block of a buffer or of constants, and of the language's extensions. Names of functions, by
/// which [`lint`](super::lint()) goes, and of what an engine binds stay. A third of a small
/// module's words are names.
pub fn drop_local_names(words: &[u32]) -> Result<Vec<u32>> {
    let module = Module::parse(words)?;
    let decorations = module.decorations();
    let blocks: HashSet<u32> = decorations
        .filter(|row| {
            matches!(
                row.decoration,
                Some(Decoration::Block | Decoration::BufferBlock)
            )
        })
        .map(|row| row.target)
        .collect();
    let Some(first) = module.functions().first() else {
        return Ok(words.to_vec());
    };
    let functions: HashSet<u32> = module.functions().iter().map(|one| one.id).collect();
    let (declared, _) = module.instructions().split_at(first.body.start);
    let known: HashSet<u32> = declared
        .iter()
        .filter_map(declares)
        .chain(functions)
        .collect();
    let serves = |one: &Instruction| {
        let target = one.words.get(1);
        match one.op() {
            Some(Op::SourceExtension) => false,
            Some(Op::Name) => target.is_some_and(|id| known.contains(id)),
            Some(Op::MemberName) => target.is_some_and(|id| blocks.contains(id)),
            _ => true,
        }
    };
    let head = declared.first().map_or(words.len(), |one| one.at);
    let mut kept = words[..head].to_vec();
    for one in module.instructions().iter().filter(|one| serves(one)) {
        kept.extend(one.words);
    }
    Ok(kept)
}

/// The id that a declaration outside functions gives a meaning.
fn declares(one: &Instruction) -> Option<u32> {
    match one.op()? {
        Op::Variable => one.words.get(2).copied(),
        Op::TypeStruct => one.words.get(1).copied(),
        _ => None,
    }
}
