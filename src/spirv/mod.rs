//! Compiled shaders as words: read, decorated, judged.
//!
//! `build.rs` compiles each kernel, passes it through
//! [`decorate_no_contraction`] (the compiler's `precise` does not reach
//! functions that are called), then through [`lint`] with the policy of its
//! profile. A module of the exact profile that could differ between two
//! conformant drivers never gets into the crate.
//!
//! This module imports nothing else of the crate, so that `build.rs` can
//! include it by path. It is no validator: it assumes what `spirv-val` checks,
//! and gives an error or a wrong verdict, but never a panic, on words that
//! are not valid SPIR-V. Lint what the compiler emits: an optimiser inlines,
//! and names are what the policy goes by.

mod decorate;
mod facts;
mod instruction;
mod lint;
mod names;
mod parse;
mod policy;
mod prune;
mod whitelist;

pub use decorate::{decorate_no_contraction, is_float_arithmetic, remove_no_contraction};
pub use facts::{ModuleFacts, describe};
pub use instruction::Instruction;
pub use lint::{LintReport, Tier, Violation, lint};
pub use names::drop_local_names;
pub use parse::{Decorated, EntryPoint, Function, Module};
pub use policy::{Allowance, AllowanceKind, Policy, exact_policy, native_policy};
pub use prune::prune;

/// `Result` of reading a module.
pub type Result<T> = std::result::Result<T, Error>;

/// Why words are not a module that can be judged. `at` counts words from the
/// start of the module.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// Too short for a header.
    #[error(
        "a SPIR-V module has a header of 5 words; {words} were given: compile the shader again"
    )]
    NoHeader {
        /// Words given.
        words: usize,
    },
    /// Another magic number.
    #[error("word 0 is {found:#010x}; SPIR-V begins with 0x07230203 in the byte order of this machine: give a SPIR-V file{}", if *found == 0x0302_2307 { ", with its bytes swapped" } else { "" })]
    Magic {
        /// Word 0.
        found: u32,
    },
    /// An instruction that claims zero words.
    #[error("the instruction at word {at} has length 0; the least is 1: compile the shader again")]
    ZeroLength {
        /// Where it begins.
        at: usize,
    },
    /// An instruction that runs past the end.
    #[error(
        "the instruction at word {at} claims {claims} words; {left} are left: the file is cut short"
    )]
    Truncated {
        /// Where it begins.
        at: usize,
        /// Its own length.
        claims: usize,
        /// Words to the end of the module.
        left: usize,
    },
    /// An instruction shorter than its opcode needs.
    #[error(
        "the instruction at word {at} (opcode {opcode}) lacks operand {operand}: compile the shader again"
    )]
    MissingOperand {
        /// Where it begins.
        at: usize,
        /// Its opcode's number.
        opcode: u16,
        /// The operand's place; the first is 1.
        operand: usize,
    },
    /// A literal string that is not UTF-8 or does not end.
    #[error(
        "the string in the instruction at word {at} has no end or is not UTF-8: compile the shader again"
    )]
    Text {
        /// Where the instruction begins.
        at: usize,
    },
    /// A function inside a function, or an end without a beginning.
    #[error("functions are not paired at word {at}: compile the shader again")]
    FunctionNesting {
        /// Where the instruction begins.
        at: usize,
    },
    /// A module that ends within a function.
    #[error("the module ends inside function %{id}: the file is cut short")]
    OpenFunction {
        /// The function's id.
        id: u32,
    },
    /// A module without an entry point.
    #[error("the module has no entry point: give a complete shader, not a library")]
    NoEntryPoint,
    /// An entry point or a call that leads to no function of the module.
    #[error(
        "the instruction at word {at} names function %{id}, which the module lacks: the file is cut short"
    )]
    UnknownFunction {
        /// Where the instruction begins.
        at: usize,
        /// The id it names.
        id: u32,
    },
    /// An extended instruction of a set that was not imported.
    #[error(
        "the instruction at word {at} uses extended instruction set %{id}, which is not imported: compile the shader again"
    )]
    UnknownSet {
        /// Where the instruction begins.
        at: usize,
        /// The set's id.
        id: u32,
    },
}
