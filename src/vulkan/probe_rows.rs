//! The probe's operations, and what IEEE arithmetic makes of them.

use super::probe::ProbeGroup as Group;

/// An operation of `shaders/kernels/probe.comp`; the value is its number there.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u32)]
pub(super) enum Op {
    Add = 0,
    Subtract = 1,
    Multiply = 2,
    MultiplyAdd = 3,
    MultiplySubtract = 4,
    SubtractProduct = 5,
    SumError = 6,
    Negate = 7,
    Choose = 8,
    FromUnsigned = 9,
    FromSigned = 10,
    FromFraction = 11,
    ToUnsigned = 12,
    ToSigned = 13,
    ShiftLeft = 14,
    ShiftRight = 15,
    ShiftRightSigned = 16,
    Less = 17,
    Floor = 18,
}

/// One operation on given operands.
#[derive(Clone, Copy, Debug)]
pub(super) struct Row {
    pub(super) group: Group,
    pub(super) op: Op,
    pub(super) operands: [u32; 3],
}

/// How a result is rounded to 32 bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Mode {
    NearestEven,
    TowardZero,
}

impl Row {
    /// The result's bits under IEEE 754, denormals kept.
    pub(super) fn expected(&self, mode: Mode) -> u32 {
        let [a, b, c] = self.operands;
        let [x, y, z] = self.operands.map(|bits| f64::from(f32::from_bits(bits)));
        // The sum or product of two f32 is exact in f64, or (for sums of very
        // different magnitude) close enough to round the same way.
        let round = |exact: f64| round(exact, mode);
        let float = |value: f64| f64::from(f32::from_bits(round(value)));
        match self.op {
            Op::Add => round(x + y),
            Op::Subtract => round(x - y),
            Op::Multiply => round(x * y),
            Op::MultiplyAdd => round(float(x * y) + z),
            Op::MultiplySubtract => round(float(x * y) - z),
            Op::SubtractProduct => round(z - float(x * y)),
            Op::SumError => round(y - float(float(x + y) - x)),
            Op::Negate => a ^ 0x8000_0000,
            Op::Choose => {
                if c != 0 {
                    a
                } else {
                    b
                }
            }
            Op::FromUnsigned => round(f64::from(a)),
            Op::FromSigned => round(f64::from(a as i32)),
            Op::FromFraction => round(f64::from(a >> 8)),
            Op::ToUnsigned => x as u32,
            Op::ToSigned => x as i32 as u32,
            Op::ShiftLeft => a.wrapping_shl(b),
            Op::ShiftRight => a.wrapping_shr(b),
            Op::ShiftRightSigned => (a as i32).wrapping_shr(b) as u32,
            Op::Less => u32::from(x < y),
            Op::Floor => round(x.floor()),
        }
    }

    /// The operation and its operands, in words.
    pub(super) fn name(&self) -> String {
        let [a, b, c] = self.operands;
        let [x, y, z] = self.operands.map(f32::from_bits);
        match self.op {
            Op::Add => format!("{x:e} + {y:e}"),
            Op::Subtract => format!("{x:e} - {y:e}"),
            Op::Multiply => format!("{x:e} * {y:e}"),
            Op::MultiplyAdd => format!("{x:e} * {y:e} + {z:e}"),
            Op::MultiplySubtract => format!("{x:e} * {y:e} - {z:e}"),
            Op::SubtractProduct => format!("{z:e} - {x:e} * {y:e}"),
            Op::SumError => format!("{y:e} - (({x:e} + {y:e}) - {x:e})"),
            Op::Negate => format!("-({x:e})"),
            Op::Choose => format!("{} ? 0x{a:08x} : 0x{b:08x}, as floats", c != 0),
            Op::FromUnsigned => format!("float({a}u)"),
            Op::FromSigned => format!("float({})", a as i32),
            Op::FromFraction => format!("float(0x{a:08x} >> 8)"),
            Op::ToUnsigned => format!("uint({x:e})"),
            Op::ToSigned => format!("int({x:e})"),
            Op::ShiftLeft => format!("0x{a:08x} << {b}"),
            Op::ShiftRight => format!("0x{a:08x} >> {b}"),
            Op::ShiftRightSigned => format!("int(0x{a:08x}) >> {b}"),
            Op::Less => format!("{x:e} < {y:e}"),
            Op::Floor => format!("floor({x:e})"),
        }
    }
}

/// Rounds a value, exact in f64, to the bits of an f32.
fn round(exact: f64, mode: Mode) -> u32 {
    let nearest = exact as f32;
    let up = f64::from(nearest).abs() > exact.abs();
    // One less in the bits is one step toward zero; infinity becomes the largest.
    let toward_zero = mode == Mode::TowardZero && up;
    nearest.to_bits() - u32::from(toward_zero)
}
