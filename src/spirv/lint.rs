//! A module against a policy.

use std::collections::{BTreeMap, BTreeSet, HashSet};
use std::fmt;

use ::spirv::{Capability, Decoration, ExecutionMode, GlslStd450Op, Op};

use super::parse::GLSL_STD_450;
use super::whitelist::{
    is_exact, is_harmless, is_integer_arithmetic, is_integer_extended, is_plain,
};
use super::{AllowanceKind, Function, Instruction, Module, Policy, Result, is_float_arithmetic};

/// Where instructions that lie in no function are reported.
const MODULE: &str = "(module)";

const NAMELESS: &str = "a function without a name handles floats; keep the names (OpName)";
const BARE: &str = "lacks NoContraction, so a driver may fuse or reorder it; decorate the module";
const NATIVE: &str = "the driver's own function has a precision of its own; use the integer form, \
    or name this function as a seed";

/// How far a module's bits are guaranteed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Tier {
    /// The same on every conformant device: tier I.
    Integer,
    /// The same where the device rounds to nearest even: tier F.
    Float,
}

/// One thing that the policy forbids.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Violation {
    /// The function's name without parameter types; its id (`%7`) if it has
    /// none; `(module)` outside functions.
    pub function: String,
    /// The opcode's name: `FMul`, `GLSL.std.450 Sqrt`.
    pub opcode: String,
    /// Why it is forbidden, and what to do.
    pub reason: String,
}

impl fmt::Display for Violation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}: {}", self.function, self.opcode, self.reason)
    }
}

/// What the linter found.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LintReport {
    /// What is forbidden, in module order, the same thing in the same function
    /// once.
    pub violations: Vec<Violation>,
    /// The tier, if there is no violation; none under the native policy, which
    /// guarantees nothing.
    pub tier: Option<Tier>,
    /// The allowances that were needed: opcodes by function. A row of the
    /// table that no kernel needs can go.
    pub used: BTreeMap<String, BTreeSet<String>>,
}

impl LintReport {
    /// Whether the policy forbids nothing of what the module holds.
    #[must_use]
    pub fn is_clean(&self) -> bool {
        self.violations.is_empty()
    }
}

/// Judges a module.
pub fn lint(words: &[u32], policy: &Policy) -> Result<LintReport> {
    let module = Module::parse(words)?;
    let mut linter = Linter {
        policy,
        no_contraction: module.decorated(Decoration::NoContraction),
        module: &module,
        report: LintReport {
            violations: Vec::new(),
            tier: None,
            used: BTreeMap::new(),
        },
    };
    let mut function: Option<&Function> = None;
    let mut functions = module.functions().iter().peekable();
    for (index, instruction) in module.instructions().iter().enumerate() {
        function = functions
            .next_if(|next| next.body.start == index)
            .or(function);
        let inside = function.filter(|function| function.body.contains(&index));
        linter.judge(instruction, inside)?;
    }
    linter.report.tier = policy.exact.then(|| linter.tier());
    Ok(linter.report)
}

struct Linter<'m> {
    policy: &'m Policy,
    module: &'m Module<'m>,
    no_contraction: HashSet<u32>,
    report: LintReport,
}

impl Linter<'_> {
    fn tier(&self) -> Tier {
        let names = self
            .module
            .functions()
            .iter()
            .filter_map(|function| function.name.as_deref());
        let mut kinds = names
            .flat_map(|name| self.policy.of(name))
            .map(|allowance| allowance.kind);
        if kinds.any(|kind| kind == AllowanceKind::TierF) {
            Tier::Float
        } else {
            Tier::Integer
        }
    }

    fn judge(&mut self, instruction: &Instruction, function: Option<&Function>) -> Result<()> {
        let complaint = match instruction.op() {
            None => Some("is an opcode that this build does not know".to_owned()),
            Some(op) => match self.everywhere(op, instruction)? {
                None if self.policy.exact => self.exact(op, instruction, function)?,
                complaint => complaint,
            },
        };
        if let Some(reason) = complaint {
            let opcode = self.module.opcode_name(instruction)?;
            let function = function.map_or_else(|| MODULE.to_owned(), Function::label);
            let violation = Violation {
                function,
                opcode,
                reason,
            };
            if !self.report.violations.contains(&violation) {
                self.report.violations.push(violation);
            }
        }
        Ok(())
    }

    /// The rules of every policy: what not all devices have.
    fn everywhere(&self, op: Op, instruction: &Instruction) -> Result<Option<String>> {
        Ok(match op {
            Op::Capability => {
                let number = instruction.operand(1)?;
                match Capability::from_u32(number) {
                    Some(Capability::Shader | Capability::Matrix) => None,
                    Some(Capability::Int64) if self.policy.wide => None,
                    Some(other) => {
                        Some(format!("{other:?} is not on every device: only Shader is"))
                    }
                    None => Some(format!(
                        "capability {number} is not on every device: only Shader is"
                    )),
                }
            }
            Op::Extension => Some(format!("{} is not on every device", instruction.text(1)?)),
            Op::ExtInstImport => match instruction.text(2)? {
                set if set == GLSL_STD_450 => None,
                set => Some(format!(
                    "{set} is not on every device: only {GLSL_STD_450} is"
                )),
            },
            Op::TypeFloat | Op::TypeInt => match instruction.operand(2)? {
                32 => None,
                64 if op == Op::TypeInt && self.policy.wide => None,
                width => Some(format!(
                    "types of {width} bits are not on every device: use 32"
                )),
            },
            _ => None,
        })
    }

    /// The rules of the exact profile, for one instruction in its function.
    fn exact(
        &mut self,
        op: Op,
        instruction: &Instruction,
        function: Option<&Function>,
    ) -> Result<Option<String>> {
        let refusal = self.refuse(op, instruction)?;
        let Some(function) = function else {
            return Ok(refusal);
        };
        let arithmetic = is_float_arithmetic(op);
        let Some(name) = &function.name else {
            let float = arithmetic || self.module.has_float_result(instruction);
            return Ok(refusal.or_else(|| float.then(|| NAMELESS.to_owned())));
        };
        if refusal.is_some() {
            let opcode = self.module.opcode_name(instruction)?;
            if !self.policy.allows(name, &opcode) {
                return Ok(refusal);
            }
            let used = self.report.used.entry(name.clone()).or_default();
            used.insert(opcode);
        }
        let bare = arithmetic && !self.no_contraction.contains(&instruction.operand(2)?);
        Ok(bare.then(|| BARE.to_owned()))
    }

    /// Why an instruction is not on the whitelist, if it is not.
    fn refuse(&self, op: Op, instruction: &Instruction) -> Result<Option<String>> {
        Ok(match op {
            Op::ExecutionMode | Op::ExecutionModeId => refuse_mode(instruction.operand(2)?),
            Op::Decorate => refuse_decoration(instruction.operand(2)?),
            Op::MemberDecorate => refuse_decoration(instruction.operand(3)?),
            Op::SpecConstantOp => self.refuse_specialized(instruction)?,
            Op::ExtInst => {
                let (set, number) = self.module.extended(instruction)?;
                let on_integers = GlslStd450Op::from_u32(number).is_some_and(is_integer_extended);
                (set != GLSL_STD_450 || !on_integers).then(|| NATIVE.to_owned())
            }
            op if is_exact(op) => None,
            op => Some(why(op).to_owned()),
        })
    }

    fn refuse_specialized(&self, instruction: &Instruction) -> Result<Option<String>> {
        let op = Op::from_u32(instruction.operand(3)?);
        if self.module.has_float_result(instruction) {
            return Ok(Some(
                "a specialization constant made by float arithmetic; pass its bits instead"
                    .to_owned(),
            ));
        }
        Ok(match op {
            Some(op) if is_integer_arithmetic(op) => None,
            Some(op) => Some(format!("{op:?} on specialization constants: {}", why(op))),
            None => Some("an operation that this build does not know".to_owned()),
        })
    }
}

fn refuse_mode(number: u32) -> Option<String> {
    match ExecutionMode::from_u32(number) {
        Some(mode) if is_plain(mode) => None,
        Some(mode) => Some(format!(
            "{mode:?} is not on every device or changes results"
        )),
        None => Some(format!("execution mode {number} is not known")),
    }
}

fn refuse_decoration(number: u32) -> Option<String> {
    match Decoration::from_u32(number) {
        Some(decoration) if is_harmless(decoration) => None,
        Some(decoration) => Some(format!("{decoration:?} may change results")),
        None => Some(format!("decoration {number} is not known")),
    }
}

/// Why an opcode is not on the whitelist.
fn why(op: Op) -> &'static str {
    match op {
        Op::FDiv | Op::FRem | Op::FMod => {
            "float division is not correctly rounded; divide in integers, or name this function as a seed"
        }
        Op::Dot
        | Op::OuterProduct
        | Op::Transpose
        | Op::VectorTimesScalar
        | Op::MatrixTimesScalar
        | Op::VectorTimesMatrix
        | Op::MatrixTimesVector
        | Op::MatrixTimesMatrix => {
            "a driver may sum and fuse in any order; write scalar + and * in a function of tier F"
        }
        Op::SDiv | Op::SRem | Op::SMod => {
            "signed division is not defined for all operands; use unsigned"
        }
        Op::ConvertUToF | Op::ConvertSToF | Op::ConvertFToU | Op::ConvertFToS => {
            "a conversion may round or overflow; move it into a function that is named as exact"
        }
        Op::IsNan | Op::IsInf => "a driver need not keep NaN and infinity; test the bits",
        Op::Undef => "an undefined value; end the function with a return",
        op if is_float_arithmetic(op) => {
            "float arithmetic rounds as each device likes; use integers, or name this function in the policy"
        }
        _ => "is not on the exact profile's list of opcodes",
    }
}
