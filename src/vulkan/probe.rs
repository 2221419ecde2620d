//! Start-up probe: what a device's arithmetic really does, whatever it says.

use std::sync::Arc;

use super::buffer::{Access, Buffer};
use super::device::Device;
use super::pipeline::{Pipeline, PipelineDescription};
use super::probe_rows::{Mode, Row};
use super::probe_samples;
use crate::error::Result;

/// Invocations in a group of `shaders/kernels/probe.comp`.
const GROUP: u64 = 64;

/// How results are rounded.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rounding {
    /// To the nearest, ties to even: what tier F needs.
    NearestEven,
    /// Toward zero.
    TowardZero,
    /// Neither, in one sample at least.
    Other,
}

/// What becomes of denormals.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Denormals {
    /// They are kept.
    Preserved,
    /// They become zero.
    Flushed,
    /// Some are kept, or something else happens.
    Mixed,
}

/// What a sample is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ProbeGroup {
    /// Rounding of `+` and `-`.
    Add,
    /// Rounding of `*`.
    Multiply,
    /// Rounding of integers to floats.
    Convert,
    /// `a * b + c` rounds twice.
    Contraction,
    /// `(a + b) - a` is not simplified.
    Reassociation,
    /// Denormal operands.
    DenormalsIn,
    /// Denormal results.
    DenormalsOut,
    /// The sign of zero.
    SignedZero,
    /// The bits of NaNs and denormals that are moved as floats.
    Payload,
    /// Arithmetic with infinities and NaNs.
    Infinity,
    /// Results beyond the largest float.
    Overflow,
    /// Conversions without rounding, and truncation.
    Exact,
    /// Integer shifts.
    Shift,
}

/// One operation on the device, and what IEEE 754 makes of it (nearest even,
/// denormals kept). What is not as expected need not be wrong: Vulkan leaves
/// much open.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ProbeSample {
    /// What it is about.
    pub group: ProbeGroup,
    /// The operation and its operands.
    pub name: String,
    /// The device's bits.
    pub got: u32,
    /// The expected bits; where they are a NaN, any NaN will do, except in
    /// [`ProbeGroup::Payload`].
    pub expected: u32,
}

impl ProbeSample {
    /// Whether the device did as expected.
    #[must_use]
    pub fn is_expected(&self) -> bool {
        same(self.group, self.got, self.expected)
    }
}

/// What the probe found out.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Probe {
    /// Rounding of `+` and `-`.
    pub rounding_add: Rounding,
    /// Rounding of `*`.
    pub rounding_multiply: Rounding,
    /// Rounding of integers to floats.
    pub rounding_convert: Rounding,
    /// `a * b + c` is fused, or otherwise not rounded twice, despite `NoContraction`.
    pub contracts: bool,
    /// `(a + b) - a` is simplified despite `NoContraction`.
    pub reassociates: bool,
    /// Denormal operands.
    pub denormals_in: Denormals,
    /// Denormal results.
    pub denormals_out: Denormals,
    /// The sign of zero is kept.
    pub signed_zero_kept: bool,
    /// Infinities and NaNs stay what they are in arithmetic.
    pub infinity_nan_kept: bool,
    /// NaNs and denormals keep their bits when moved as floats.
    pub payloads_kept: bool,
    /// Results beyond the largest float become infinite, as nearest-even has it.
    pub overflows_to_infinity: bool,
    /// Conversions that need no rounding are exact, and floats truncate.
    pub conversions_exact: bool,
    /// Shifts are right.
    pub shifts_exact: bool,
    /// Every chosen sample, and of the sweep those that were not as expected.
    pub samples: Vec<ProbeSample>,
    /// How many operations the device did in all.
    pub operations: usize,
}

impl Probe {
    /// Whether functions of tier F give their bits on this device: sums and
    /// products round to nearest even, and nothing is fused or simplified.
    /// Denormals may be flushed.
    #[must_use]
    pub fn tier_f(&self) -> bool {
        self.rounding_add == Rounding::NearestEven
            && self.rounding_multiply == Rounding::NearestEven
            && !self.contracts
            && !self.reassociates
    }

    /// Whether what tier I stands on holds: exact conversions and shifts. Every
    /// conformant device does; one that does not is broken.
    #[must_use]
    pub fn tier_i(&self) -> bool {
        self.conversions_exact && self.shifts_exact
    }
}

/// Runs the probe. `spirv` is `shaders/kernels/probe.comp`, compiled.
///
/// # Errors
/// As for [`Pipeline::new`], [`Buffer::new`] and [`Device::run`].
pub fn probe(device: &Arc<Device>, spirv: &[u32]) -> Result<Probe> {
    let mut rows = probe_samples::chosen();
    let chosen = rows.len();
    rows.extend(probe_samples::sweep());
    let results = run(device, spirv, &rows)?;
    Ok(judge(&rows, chosen, &results))
}

fn run(device: &Arc<Device>, spirv: &[u32], rows: &[Row]) -> Result<Vec<u32>> {
    let pipeline = Pipeline::new(
        device,
        &PipelineDescription {
            name: "probe",
            spirv,
            bindings: &[0, 1],
            push_constant_bytes: 0,
            specialization: &[],
        },
    )?;
    let words = rows.iter().flat_map(|row| {
        let [a, b, c] = row.operands;
        [row.op as u32, a, b, c]
    });
    let bytes: Vec<u8> = words.flat_map(u32::to_ne_bytes).collect();
    let mut input = Buffer::new(device, bytes.len() as u64, Access::Upload)?;
    let mut output = Buffer::new(device, rows.len() as u64 * 4, Access::Readback)?;
    input.write(0, &bytes)?;
    output.fill_zero()?;
    let groups = (rows.len() as u64).div_ceil(GROUP);
    device.run(&pipeline, &[(0, &input), (1, &output)], &[], groups)?;
    output.read(0, output.bytes(), |bytes| {
        let (words, _) = bytes.as_chunks::<4>();
        words.iter().map(|word| u32::from_ne_bytes(*word)).collect()
    })
}

/// Sums up. The first `chosen` rows are the chosen ones; the sweep follows.
fn judge(rows: &[Row], chosen: usize, results: &[u32]) -> Probe {
    let of = |group: ProbeGroup| {
        rows.iter()
            .zip(results)
            .filter(move |(row, _)| row.group == group)
    };
    let matches = |row: &Row, got: u32, mode: Mode| same(row.group, got, row.expected(mode));
    let all_match = |group, mode| of(group).all(|(row, got)| matches(row, *got, mode));
    let expected = |group| all_match(group, Mode::NearestEven);
    let rounding = |group| {
        if expected(group) {
            Rounding::NearestEven
        } else if all_match(group, Mode::TowardZero) {
            Rounding::TowardZero
        } else {
            Rounding::Other
        }
    };
    // Rounding twice is right in any mode; the mode is judged by itself.
    let odd = |group| {
        of(group).any(|(row, got)| {
            !matches(row, *got, Mode::NearestEven) && !matches(row, *got, Mode::TowardZero)
        })
    };
    let denormals = |group| {
        if expected(group) {
            Denormals::Preserved
        } else if of(group).all(|(row, got)| is_flushed(row, *got)) {
            Denormals::Flushed
        } else {
            Denormals::Mixed
        }
    };
    let sample = |(index, (row, got)): (usize, (&Row, &u32))| {
        let sample = ProbeSample {
            group: row.group,
            name: row.name(),
            got: *got,
            expected: row.expected(Mode::NearestEven),
        };
        (index < chosen || !sample.is_expected()).then_some(sample)
    };
    Probe {
        rounding_add: rounding(ProbeGroup::Add),
        rounding_multiply: rounding(ProbeGroup::Multiply),
        rounding_convert: rounding(ProbeGroup::Convert),
        contracts: odd(ProbeGroup::Contraction),
        reassociates: odd(ProbeGroup::Reassociation),
        denormals_in: denormals(ProbeGroup::DenormalsIn),
        denormals_out: denormals(ProbeGroup::DenormalsOut),
        signed_zero_kept: expected(ProbeGroup::SignedZero),
        infinity_nan_kept: expected(ProbeGroup::Infinity),
        payloads_kept: expected(ProbeGroup::Payload),
        overflows_to_infinity: expected(ProbeGroup::Overflow),
        conversions_exact: expected(ProbeGroup::Exact),
        shifts_exact: expected(ProbeGroup::Shift),
        samples: rows
            .iter()
            .zip(results)
            .enumerate()
            .filter_map(sample)
            .collect(),
        operations: results.len(),
    }
}

/// Equal bits, or two NaNs where only arithmetic made them.
fn same(group: ProbeGroup, got: u32, expected: u32) -> bool {
    let nan = |bits: u32| f32::from_bits(bits).is_nan();
    got == expected || (group == ProbeGroup::Infinity && nan(got) && nan(expected))
}

/// Whether `got` is what flushing makes of a row: of its operands first, then
/// of its result. A zero may have either sign.
fn is_flushed(row: &Row, got: u32) -> bool {
    let flush = |bits: u32| {
        if bits & 0x7f80_0000 == 0 {
            bits & 0x8000_0000
        } else {
            bits
        }
    };
    let operands = if row.group == ProbeGroup::DenormalsIn {
        row.operands.map(flush)
    } else {
        row.operands
    };
    let flushed = flush(Row { operands, ..*row }.expected(Mode::NearestEven));
    got == flushed || (got | flushed) & 0x7fff_ffff == 0
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What a device would find that gives `result` for each row.
    fn device(result: impl Fn(&Row) -> u32) -> Probe {
        let mut rows = probe_samples::chosen();
        let chosen = rows.len();
        rows.extend(probe_samples::sweep());
        let results: Vec<u32> = rows.iter().map(result).collect();
        judge(&rows, chosen, &results)
    }

    #[test]
    fn an_ieee_device_passes() {
        let probe = device(|row| row.expected(Mode::NearestEven));
        assert!(probe.tier_f() && probe.tier_i());
        assert_eq!(probe.denormals_in, Denormals::Preserved);
        assert_eq!(probe.denormals_out, Denormals::Preserved);
        assert!(probe.signed_zero_kept && probe.infinity_nan_kept && probe.payloads_kept);
        assert!(probe.samples.iter().all(ProbeSample::is_expected));
        assert!(probe.operations > probe.samples.len());
    }

    #[test]
    fn truncation_is_told_from_nearest() {
        let probe = device(|row| row.expected(Mode::TowardZero));
        assert_eq!(probe.rounding_add, Rounding::TowardZero);
        assert_eq!(probe.rounding_multiply, Rounding::TowardZero);
        assert_eq!(probe.rounding_convert, Rounding::TowardZero);
        assert!(!probe.contracts && !probe.tier_f() && probe.tier_i());
        assert!(!probe.overflows_to_infinity);
    }

    #[test]
    fn a_fused_product_is_seen() {
        use super::super::probe_rows::Op;
        let probe = device(|row| {
            let [x, y, z] = row.operands.map(f32::from_bits);
            match row.op {
                Op::MultiplyAdd => x.mul_add(y, z).to_bits(),
                _ => row.expected(Mode::NearestEven),
            }
        });
        assert!(probe.contracts && !probe.tier_f());
        assert_eq!(probe.rounding_multiply, Rounding::NearestEven);
    }

    #[test]
    fn a_simplified_sum_is_seen() {
        use super::super::probe_rows::Op;
        let probe = device(|row| match row.op {
            Op::SumError => 0,
            _ => row.expected(Mode::NearestEven),
        });
        assert!(probe.reassociates && !probe.contracts && !probe.tier_f());
    }

    #[test]
    fn flushing_alone_keeps_tier_f() {
        let flush = |bits: u32| {
            if bits & 0x7f80_0000 == 0 {
                bits & 0x8000_0000
            } else {
                bits
            }
        };
        let probe = device(|row| match row.group {
            ProbeGroup::DenormalsIn => {
                let operands = row.operands.map(flush);
                flush(Row { operands, ..*row }.expected(Mode::NearestEven))
            }
            ProbeGroup::DenormalsOut => 0,
            _ => row.expected(Mode::NearestEven),
        });
        assert_eq!(probe.denormals_in, Denormals::Flushed);
        assert_eq!(probe.denormals_out, Denormals::Flushed);
        assert!(probe.tier_f());
    }

    #[test]
    fn one_wrong_bit_is_seen_anywhere() {
        let wrong = device(|row| row.expected(Mode::NearestEven) ^ 1);
        assert_eq!(wrong.rounding_add, Rounding::Other);
        assert_eq!(wrong.rounding_convert, Rounding::Other);
        assert!(!wrong.tier_f() && !wrong.tier_i() && !wrong.signed_zero_kept);
        assert_eq!(wrong.denormals_in, Denormals::Mixed);
        assert_eq!(wrong.samples.len(), wrong.operations);
    }
}
