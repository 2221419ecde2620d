//! The mutants: mistakes that a port, a refactoring or a compiler could make.

mod discrete;
mod elementary;
mod estimate;
mod foundation;
mod line;
mod scattering;
mod sequences;
mod sets;
mod solid;

use super::harness::Edit;
use super::harness::Target;

/// What must kill a mutant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Killer {
    /// The linter refuses the module.
    Linter,
    /// Words differ from the reference's.
    Mismatch,
    /// The error exceeds the row's bound.
    Judge,
}

/// A named mistake.
pub struct Mutant {
    /// What is wrong.
    pub name: &'static str,
    /// The edit.
    pub edit: Edit<'static>,
    /// Where it must show.
    pub target: Target,
    /// By what.
    pub killer: Killer,
}

const fn mutant(
    name: &'static str,
    killer: Killer,
    target: Target,
    file: &'static str,
    find: &'static str,
    replace: &'static str,
) -> Mutant {
    Mutant {
        name,
        edit: Edit {
            file,
            find,
            replace,
            times: 1,
        },
        target,
        killer,
    }
}

const fn twice(mut mutant: Mutant) -> Mutant {
    mutant.edit.times = 2;
    mutant
}

/// Every mutant.
pub fn mutants() -> impl Iterator<Item = &'static Mutant> {
    [
        discrete::MUTANTS,
        elementary::MUTANTS,
        estimate::MUTANTS,
        foundation::MUTANTS,
        scattering::MUTANTS,
        line::MUTANTS,
        sequences::MUTANTS,
        sets::MUTANTS,
        solid::MUTANTS,
    ]
    .into_iter()
    .flatten()
}
