//! What the exact profile may contain without an allowance.

use ::spirv::{Decoration, ExecutionMode, GlslStd450Op, Op};

/// Decorations that leave every result as it is. Not among them, for one:
/// `RelaxedPrecision` (16 bits may do), `NoUnsignedWrap` (wrapping undefined).
pub(super) fn is_harmless(decoration: Decoration) -> bool {
    use Decoration as D;
    matches!(
        decoration,
        D::SpecId
            | D::Block
            | D::BufferBlock
            | D::RowMajor
            | D::ColMajor
            | D::ArrayStride
            | D::MatrixStride
            | D::BuiltIn
            | D::Flat
            | D::Invariant
            | D::Restrict
            | D::Aliased
            | D::Volatile
            | D::Constant
            | D::Coherent
            | D::NonWritable
            | D::NonReadable
            | D::Uniform
            | D::Location
            | D::Component
            | D::Binding
            | D::DescriptorSet
            | D::Offset
            | D::NoContraction
    )
}

/// Execution modes that say nothing about numbers.
pub(super) fn is_plain(mode: ExecutionMode) -> bool {
    matches!(
        mode,
        ExecutionMode::LocalSize | ExecutionMode::LocalSizeId | ExecutionMode::OriginUpperLeft
    )
}

/// Extended instructions on integers, defined for every input.
pub(super) fn is_integer_extended(instruction: GlslStd450Op) -> bool {
    use GlslStd450Op as G;
    matches!(
        instruction,
        G::FindUMsb
            | G::FindSMsb
            | G::FindILsb
            | G::UMin
            | G::UMax
            | G::UClamp
            | G::SMin
            | G::SMax
            | G::SClamp
            | G::SAbs
            | G::SSign
    )
}

/// Opcodes that compute with integers and bits, the same everywhere. Signed
/// division is not among them: remainders of negative operands are undefined.
pub(super) fn is_integer_arithmetic(op: Op) -> bool {
    use Op as O;
    matches!(
        op,
        O::SNegate
            | O::IAdd
            | O::ISub
            | O::IMul
            | O::UDiv
            | O::UMod
            | O::IAddCarry
            | O::ISubBorrow
            | O::UMulExtended
            | O::SMulExtended
            | O::ShiftLeftLogical
            | O::ShiftRightLogical
            | O::ShiftRightArithmetic
            | O::BitwiseOr
            | O::BitwiseXor
            | O::BitwiseAnd
            | O::Not
            | O::BitFieldInsert
            | O::BitFieldSExtract
            | O::BitFieldUExtract
            | O::BitReverse
            | O::BitCount
            | O::Any
            | O::All
            | O::LogicalEqual
            | O::LogicalNotEqual
            | O::LogicalOr
            | O::LogicalAnd
            | O::LogicalNot
            | O::Select
            | O::IEqual
            | O::INotEqual
            | O::UGreaterThan
            | O::UGreaterThanEqual
            | O::ULessThan
            | O::ULessThanEqual
            | O::SGreaterThan
            | O::SGreaterThanEqual
            | O::SLessThan
            | O::SLessThanEqual
            | O::VectorShuffle
            | O::CompositeExtract
            | O::CompositeInsert
    )
}

/// Opcodes of the exact profile's whitelist, extended instructions and
/// specialization constant operations aside.
pub(super) fn is_exact(op: Op) -> bool {
    // No float compares: a device that flushes denormals takes them for zeros.
    is_integer_arithmetic(op) || is_declaration(op) || is_structure(op)
}

/// Types, constants, decorations, debug information. Some are judged further
/// by their operands.
fn is_declaration(op: Op) -> bool {
    use Op as O;
    matches!(
        op,
        O::Nop
            | O::SourceContinued
            | O::Source
            | O::SourceExtension
            | O::Name
            | O::MemberName
            | O::String
            | O::Line
            | O::NoLine
            | O::ModuleProcessed
            | O::Extension
            | O::ExtInstImport
            | O::MemoryModel
            | O::EntryPoint
            | O::ExecutionMode
            | O::ExecutionModeId
            | O::Capability
            | O::Decorate
            | O::MemberDecorate
            | O::TypeVoid
            | O::TypeBool
            | O::TypeInt
            | O::TypeFloat
            | O::TypeVector
            | O::TypeMatrix
            | O::TypeArray
            | O::TypeRuntimeArray
            | O::TypeStruct
            | O::TypePointer
            | O::TypeFunction
            | O::ConstantTrue
            | O::ConstantFalse
            | O::Constant
            | O::ConstantComposite
            | O::ConstantNull
            | O::SpecConstantTrue
            | O::SpecConstantFalse
            | O::SpecConstant
            | O::SpecConstantComposite
    )
}

/// Control flow, memory, and moves of whole values. Atomics are those whose
/// order does not show in memory; what they return does depend on it.
fn is_structure(op: Op) -> bool {
    use Op as O;
    matches!(
        op,
        O::Function
            | O::FunctionParameter
            | O::FunctionEnd
            | O::FunctionCall
            | O::Variable
            | O::Load
            | O::Store
            | O::CopyMemory
            | O::AccessChain
            | O::InBoundsAccessChain
            | O::ArrayLength
            | O::VectorExtractDynamic
            | O::VectorInsertDynamic
            | O::CompositeConstruct
            | O::CopyObject
            | O::CopyLogical
            | O::Bitcast
            | O::Phi
            | O::LoopMerge
            | O::SelectionMerge
            | O::Label
            | O::Branch
            | O::BranchConditional
            | O::Switch
            | O::Return
            | O::ReturnValue
            | O::Unreachable
            | O::ControlBarrier
            | O::MemoryBarrier
            | O::AtomicIIncrement
            | O::AtomicIDecrement
            | O::AtomicIAdd
            | O::AtomicISub
            | O::AtomicSMin
            | O::AtomicUMin
            | O::AtomicSMax
            | O::AtomicUMax
            | O::AtomicAnd
            | O::AtomicOr
            | O::AtomicXor
    )
}
