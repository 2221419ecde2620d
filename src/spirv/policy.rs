//! What a module may contain: lists, and the functions that may do more.
//!
//! The exact policy is a whitelist, so an opcode that nobody has thought of
//! is refused. To let a function use a float operation, add one row to
//! [`ALLOWANCES`].

use AllowanceKind::{ExactFloat, Seed, TierF};

/// Why a function may use native float operations.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AllowanceKind {
    /// Every result is exactly representable, and a test tries all inputs.
    ExactFloat,
    /// The result is a first guess that integers correct, whatever its error
    /// within what Vulkan permits.
    Seed,
    /// Float + - *, no intermediate denormal: exact where the device rounds to
    /// nearest even. It puts the module into [`Tier::Float`](super::Tier).
    TierF,
}

/// Leave for one function to use opcodes that are not on the whitelist.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Allowance {
    /// The function's name, without parameter types: every overload.
    pub function: &'static str,
    /// Why it may.
    pub kind: AllowanceKind,
    /// The opcodes, as [`Module::opcode_name`](super::Module::opcode_name)
    /// writes them: `FMul`, `GLSL.std.450 Sqrt`.
    pub opcodes: &'static [&'static str],
    /// What keeps the function's bits the same everywhere.
    pub reason: &'static str,
}

const fn allow(
    function: &'static str,
    kind: AllowanceKind,
    opcodes: &'static [&'static str],
    reason: &'static str,
) -> Allowance {
    Allowance {
        function,
        kind,
        opcodes,
        reason,
    }
}

/// The functions of the exact profile that use floats, one row each.
#[rustfmt::skip]
const ALLOWANCES: &[Allowance] = &[
    allow("corput_unit_floor", ExactFloat, &["ConvertUToF", "FMul"], "24 bits times a power of two"),
    allow("corput_unit_ceil", ExactFloat, &["ConvertUToF", "FMul"], "24 bits times a power of two"),
    allow("corput_seed_sqrt", Seed, &["ConvertUToF", "GLSL.std.450 Sqrt", "FMul", "ConvertFToU"], "corrected by the residual in integers"),
    allow("corput_seed_divide", Seed, &["ConvertUToF", "FDiv", "FMul", "ConvertFToU"], "corrected by the residual in integers"),
    allow("corput_seed_quotient", Seed, &["ConvertUToF", "FDiv", "FMul", "ConvertFToU"], "corrected by the residual in integers"),
    allow("corput_seed_step", Seed, &["ConvertSToF", "ConvertUToF", "FDiv", "ConvertFToS", "GLSL.std.450 Floor"], "corrected by the residual in integers"),
    allow("corput_frame", TierF, ADD_SUB_MUL, "no intermediate is denormal"),
    allow("corput_frame_combine", TierF, ADD_SUB_MUL, "no intermediate is denormal"),
];

/// What tier F may do.
const ADD_SUB_MUL: &[&str] = &["FAdd", "FSub", "FMul"];

/// The rules that [`lint`](super::lint) applies.
#[derive(Clone, Debug)]
pub struct Policy {
    /// Whether the module must give the same bits everywhere: whitelists,
    /// `NoContraction` and names are then demanded.
    pub(super) exact: bool,
    /// Whether integers may have 64 bits, for devices that have them.
    pub(super) wide: bool,
    /// The functions that may do more than the whitelist.
    pub(super) allowances: Vec<Allowance>,
}

/// The policy of the exact profile: a whitelist, and the crate's allowances.
#[must_use]
pub fn exact_policy() -> Policy {
    Policy {
        exact: true,
        wide: false,
        allowances: ALLOWANCES.to_vec(),
    }
}

/// The policy of the native profile: all of core GLSL, but 32-bit types only
/// and no capability or extension beyond what every device has.
#[must_use]
pub fn native_policy() -> Policy {
    Policy {
        exact: false,
        wide: false,
        allowances: Vec::new(),
    }
}

impl Policy {
    /// This policy with one more allowance.
    #[must_use]
    pub fn with(mut self, allowance: Allowance) -> Self {
        self.allowances.push(allowance);
        self
    }

    /// This policy for devices that have integers of 64 bits.
    #[must_use]
    pub fn wide(mut self) -> Self {
        self.wide = true;
        self
    }

    /// The allowances, in order.
    #[must_use]
    pub fn allowances(&self) -> &[Allowance] {
        &self.allowances
    }

    pub(super) fn allows(&self, function: &str, opcode: &str) -> bool {
        self.of(function).any(|row| row.opcodes.contains(&opcode))
    }

    pub(super) fn of(&self, function: &str) -> impl Iterator<Item = &Allowance> {
        self.allowances
            .iter()
            .filter(move |row| row.function == function)
    }
}
