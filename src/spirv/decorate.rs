//! `NoContraction` on every float operation, and off one of them.
//!
//! The compiler's `precise` marks operations of the function it stands in and
//! not those of functions called there, so a driver may still fuse or reorder
//! these. Decorating the compiled words leaves no gap.

use ::spirv::{Decoration, GlslStd450Op, Op};

use super::parse::GLSL_STD_450;
use super::{Instruction, Module, Result};

/// Whether `op` is one of SPIR-V's arithmetic instructions on floats: the
/// targets that the specification gives `NoContraction`. Conversions and
/// compares are not among them.
#[must_use]
pub fn is_float_arithmetic(op: Op) -> bool {
    matches!(
        op,
        Op::FNegate
            | Op::FAdd
            | Op::FSub
            | Op::FMul
            | Op::FDiv
            | Op::FRem
            | Op::FMod
            | Op::VectorTimesScalar
            | Op::MatrixTimesScalar
            | Op::VectorTimesMatrix
            | Op::MatrixTimesVector
            | Op::MatrixTimesMatrix
            | Op::OuterProduct
            | Op::Dot
    )
}

/// Decorates every float arithmetic result that lacks `NoContraction`. Of the
/// extended instructions only `Fma` takes it: GLSL.std.450 says so for no
/// other. A second pass changes nothing.
pub fn decorate_no_contraction(words: &[u32]) -> Result<Vec<u32>> {
    let module = Module::parse(words)?;
    let mut decorated = module.decorated(Decoration::NoContraction);
    let mut added = Vec::new();
    for instruction in module.instructions() {
        if takes_no_contraction(&module, instruction)? {
            let id = instruction.operand(2)?;
            if decorated.insert(id) {
                added.extend([
                    3 << 16 | Op::Decorate as u32,
                    id,
                    Decoration::NoContraction as u32,
                ]);
            }
        }
    }
    // The annotations end where the first type, constant or function begins.
    let declarations = module
        .instructions()
        .iter()
        .find(|instruction| !is_preamble(instruction));
    let (preamble, rest) = words.split_at(declarations.map_or(words.len(), |first| first.at));
    Ok([preamble, &added, rest].concat())
}

/// The module without its `nth` `NoContraction`, counted from 0 in module
/// order; `None` if it has no such decoration. Tests remove each in turn and
/// expect the linter to see it.
#[must_use]
pub fn remove_no_contraction(words: &[u32], nth: usize) -> Option<Vec<u32>> {
    let module = Module::parse(words).ok()?;
    let mut decorations = module.instructions().iter().filter(|instruction| {
        instruction.op() == Some(Op::Decorate)
            && instruction.operands_from(2) == [Decoration::NoContraction as u32]
    });
    let removed = decorations.nth(nth)?;
    Some(
        [
            &words[..removed.at],
            &words[removed.at + removed.words.len()..],
        ]
        .concat(),
    )
}

fn takes_no_contraction(module: &Module, instruction: &Instruction) -> Result<bool> {
    match instruction.op() {
        Some(Op::ExtInst) => {
            Ok(module.extended(instruction)? == (GLSL_STD_450, GlslStd450Op::Fma as u32))
        }
        Some(op) => Ok(is_float_arithmetic(op)),
        None => Ok(false),
    }
}

/// Whether an instruction belongs before types, constants and functions.
fn is_preamble(instruction: &Instruction) -> bool {
    matches!(
        instruction.op(),
        Some(
            Op::Capability
                | Op::Extension
                | Op::ExtInstImport
                | Op::MemoryModel
                | Op::EntryPoint
                | Op::ExecutionMode
                | Op::ExecutionModeId
                | Op::String
                | Op::Source
                | Op::SourceContinued
                | Op::SourceExtension
                | Op::Name
                | Op::MemberName
                | Op::ModuleProcessed
                | Op::Decorate
                | Op::DecorateId
                | Op::DecorateString
                | Op::MemberDecorate
                | Op::MemberDecorateString
                | Op::DecorationGroup
                | Op::GroupDecorate
                | Op::GroupMemberDecorate
        )
    )
}
