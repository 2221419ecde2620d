//! The operands that the probe asks a device about.

use super::probe::ProbeGroup as Group;
use super::probe_rows::{Op, Row};

/// Rows per operation of the sweep.
pub(super) const SWEEP: u32 = 512;

/// The chosen cases.
pub(super) fn chosen() -> Vec<Row> {
    let mut rows = Vec::new();
    let mut push = |group, op, operands| {
        rows.push(Row {
            group,
            op,
            operands,
        })
    };
    // A power of two.
    let p = |exponent: i32| ((127 + exponent) as u32) << 23;
    const ONE: u32 = 0x3f80_0000;
    const MINUS: u32 = 0x8000_0000;
    const INF: u32 = 0x7f80_0000;
    const NAN: u32 = 0x7fc0_0000;
    const LARGEST: u32 = 0x7f7f_ffff;

    // Sums: ties both ways, and just off a tie.
    let sums = [
        (ONE, p(-24)),              // tie, down to even
        (ONE + 1, p(-24)),          // tie, up to even
        (ONE + 2, p(-24)),          // tie, down to even
        (ONE, p(-24) + 1),          // just above a tie
        (ONE + 1, p(-24) - 1),      // just below a tie
        (ONE, p(-25)),              // a quarter
        (ONE, p(-40)),              // far below
        (0x3fff_ffff, p(-24)),      // tie that carries into the exponent
        (0x4b80_0000, ONE),         // 2^24 + 1
        (0x4b80_0001, ONE),         // 2^24 + 2 + 1
        (0x3dcc_cccd, 0x3e4c_cccd), // 0.1 + 0.2
    ];
    for (a, b) in sums {
        push(Group::Add, Op::Add, [a, b, 0]);
        push(Group::Add, Op::Add, [a ^ MINUS, b ^ MINUS, 0]);
        push(Group::Add, Op::Subtract, [a, b ^ MINUS, 0]);
        push(Group::Add, Op::Subtract, [a, b, 0]);
    }
    for (a, b) in [
        (p(1), p(-24)),
        (p(1), p(-24) + 1),
        (ONE, p(-25)),
        (ONE, p(-25) + 1),
    ] {
        push(Group::Add, Op::Add, [a, b ^ MINUS, 0]);
        push(Group::Add, Op::Subtract, [a ^ MINUS, b ^ MINUS, 0]);
    }

    // Products: ties both ways ((1 + i/2^11)(1 + j/2^13) and the like), and off.
    let products = [
        (0x3f80_0800, 0x3f80_0800), // (1+2^-12)^2: tie, down to even
        (0x3f80_0800, 0x3f80_1800), // (1+2^-12)(1+3*2^-12): tie, up to even
        (0x3f80_0801, 0x3f80_0800), // just above a tie
        (0x3f80_0001, 0x3fc0_0000), // (1+2^-23)*1.5: tie, up to even
        (0x3f80_0003, 0x3fc0_0000), // (1+3*2^-23)*1.5: tie, down to even
        (0x3f80_0001, 0x3f7f_ffff), // close to 1
        (0x3f7f_ffff, 0x3f7f_ffff), // (1-2^-24)^2
        (0x4049_0fdb, 0x402d_f854), // pi * e
        (0x3dcc_cccd, 0x4120_0000), // 0.1 * 10
    ];
    for (a, b) in products {
        push(Group::Multiply, Op::Multiply, [a, b, 0]);
        push(Group::Multiply, Op::Multiply, [a ^ MINUS, b, 0]);
        push(Group::Multiply, Op::Multiply, [a ^ MINUS, b ^ MINUS, 0]);
    }

    // Products whose rounding shows when something is added.
    let contractions = [
        (0x3f80_0800, 0x3f80_0800, 0xbf80_1000), // (1+2^-12)^2 - (1+2^-11)
        (0x3f80_0001, 0x3f7f_ffff, 0xbf80_0000),
        (0x3f80_0001, 0x3f7f_fffe, 0xbf80_0000), // (1+2^-23)(1-2^-23) - 1
        (0x4049_0fdb, 0x402d_f854, 0xc108_a2c0), // pi * e - 8.54
        (0x3dcc_cccd, 0x4120_0000, 0xbf80_0000), // 0.1 * 10 - 1
        (0x3eaa_aaab, 0x4040_0000, 0xbf80_0000), // 1/3 * 3 - 1
        (0x3f80_0001, 0x3f80_0001, 0xbf80_0002), // (1+2^-23)^2 - (1+2^-22)
    ];
    for (a, b, c) in contractions {
        push(Group::Contraction, Op::MultiplyAdd, [a, b, c]);
        push(
            Group::Contraction,
            Op::MultiplyAdd,
            [a ^ MINUS, b, c ^ MINUS],
        );
        push(Group::Contraction, Op::MultiplySubtract, [a, b, c ^ MINUS]);
        push(Group::Contraction, Op::SubtractProduct, [a, b, c ^ MINUS]);
    }
    for (a, b) in [
        (ONE, p(-30)),
        (ONE, 0x3380_0001),
        (p(20), 0x3dcc_cccd),
        (0x4049_0fdb, p(-23)),
    ] {
        push(Group::Reassociation, Op::SumError, [a, b, 0]);
        push(Group::Reassociation, Op::SumError, [a ^ MINUS, b, 0]);
    }

    // Integers that no float is equal to: ties both ways, and off.
    let integers = [
        16_777_217u32,
        16_777_219,
        16_777_221,
        33_554_434,
        33_554_435,
        0x0300_0003,
        0x7fff_ffff,
        0x7fff_ffc0,
        0x7fff_ff40,
        0x4000_0021,
        0x4000_0020,
        0x4000_0060,
    ];
    for i in integers {
        push(Group::Convert, Op::FromUnsigned, [i, 0, 0]);
        push(Group::Convert, Op::FromSigned, [i, 0, 0]);
        push(Group::Convert, Op::FromSigned, [i.wrapping_neg(), 0, 0]);
    }
    for i in [
        0xffff_ffff,
        0xffff_ff80,
        0x8000_0080,
        0x8000_0081,
        0x8000_0180,
        0x8000_017f,
        0xc6de_a6b5, // a tie for whoever converts the lower 31 bits by themselves
        0xd479_c395,
    ] {
        push(Group::Convert, Op::FromUnsigned, [i, 0, 0]);
    }

    // Denormal operands with normal results; then the reverse.
    push(Group::DenormalsIn, Op::Multiply, [0x0000_0400, p(30), 0]);
    push(Group::DenormalsIn, Op::Multiply, [0x8040_0000, p(3), 0]);
    push(Group::DenormalsIn, Op::Add, [0x0080_0000, 0x0000_0200, 0]);
    push(
        Group::DenormalsIn,
        Op::Subtract,
        [0x0080_0200, 0x0000_0200, 0],
    );
    push(Group::DenormalsIn, Op::Less, [0, 1, 0]);
    push(Group::DenormalsOut, Op::Multiply, [p(-100), p(-30), 0]);
    push(
        Group::DenormalsOut,
        Op::Multiply,
        [p(-126) ^ MINUS, p(-1), 0],
    );
    push(
        Group::DenormalsOut,
        Op::Subtract,
        [0x00c0_0000, 0x0080_0000, 0],
    );
    push(Group::DenormalsOut, Op::Add, [0x80c0_0000, 0x0080_0000, 0]);

    for (op, operands) in [
        (Op::Choose, [MINUS, 0, 1]),
        (Op::Choose, [0, MINUS, 0]),
        (Op::Negate, [0, 0, 0]),
        (Op::Negate, [MINUS, 0, 0]),
        (Op::Add, [MINUS, MINUS, 0]),
        (Op::Add, [MINUS, 0, 0]),
        (Op::Subtract, [MINUS, 0, 0]),
        (Op::Subtract, [0, 0, 0]),
        (Op::Subtract, [ONE, ONE, 0]),
        (Op::Multiply, [0, ONE ^ MINUS, 0]),
        (Op::Multiply, [MINUS, ONE ^ MINUS, 0]),
    ] {
        push(Group::SignedZero, op, operands);
    }

    for bits in [
        NAN,
        0x7fc1_2345,
        0xffc0_0001,
        0x7f80_0001,
        0xff91_2345,
        1,
        0x807f_ffff,
    ] {
        push(Group::Payload, Op::Choose, [bits, ONE, 1]);
        push(Group::Payload, Op::Choose, [ONE, bits, 0]);
    }
    for (op, operands) in [
        (Op::Add, [INF, ONE, 0]),
        (Op::Subtract, [ONE, INF, 0]),
        (Op::Multiply, [INF, ONE ^ MINUS, 0]),
        (Op::Multiply, [INF, INF, 0]),
        (Op::Subtract, [INF, INF, 0]),
        (Op::Multiply, [0, INF, 0]),
        (Op::Add, [NAN, ONE, 0]),
        (Op::Multiply, [NAN, 0, 0]),
        (Op::Less, [LARGEST, INF, 0]),
        (Op::Less, [NAN, INF, 0]),
    ] {
        push(Group::Infinity, op, operands);
    }
    push(Group::Overflow, Op::Add, [LARGEST, LARGEST, 0]);
    push(Group::Overflow, Op::Multiply, [LARGEST ^ MINUS, ONE + 1, 0]);
    push(Group::Overflow, Op::Add, [LARGEST, p(103), 0]); // tie, up to infinity
    push(Group::Overflow, Op::Add, [LARGEST, p(102), 0]); // below, stays

    for u in [
        0,
        0xff,
        0x100,
        0x1ff,
        0x8000_0000,
        0xffff_feff,
        0xffff_ff00,
        0xffff_ffff,
        0x1234_5678,
    ] {
        push(Group::Exact, Op::FromFraction, [u, 0, 0]);
    }
    for i in [
        0,
        1,
        0x00ff_ffff,
        0x0100_0000,
        0x0100_0002,
        0x8000_0000,
        0xffff_ff00,
    ] {
        push(Group::Exact, Op::FromUnsigned, [i, 0, 0]);
        push(Group::Exact, Op::FromSigned, [i, 0, 0]);
    }
    for x in [
        0.0f32,
        0.999_999_94,
        1.0,
        2.75,
        16_777_215.0,
        2_147_483_648.0,
        4_294_967_040.0,
    ] {
        push(Group::Exact, Op::ToUnsigned, [x.to_bits(), 0, 0]);
    }
    for x in [
        -0.75f32,
        -3.75,
        3.75,
        -16_777_215.0,
        2_147_483_520.0,
        -2_147_483_648.0,
    ] {
        push(Group::Exact, Op::ToSigned, [x.to_bits(), 0, 0]);
    }
    for x in [
        -0.75f32,
        0.999_999_94,
        2.0,
        -2.000_000_2,
        8_388_607.5,
        16_777_215.0,
    ] {
        push(Group::Exact, Op::Floor, [x.to_bits(), 0, 0]);
    }
    for b in [0, 1, 7, 8, 24, 31] {
        for a in [1, 0x8000_0001, 0xdead_beef, 0xffff_ffff] {
            push(Group::Shift, Op::ShiftLeft, [a, b, 0]);
            push(Group::Shift, Op::ShiftRight, [a, b, 0]);
            push(Group::Shift, Op::ShiftRightSigned, [a, b, 0]);
        }
    }
    rows
}

/// Many more operands, of moderate size, for what tier F needs.
pub(super) fn sweep() -> Vec<Row> {
    let mut state = 0x9e37_79b9u32;
    let mut next = || {
        state ^= state << 13;
        state ^= state >> 17;
        state ^= state << 5;
        state
    };
    let mut rows = Vec::new();
    for _ in 0..SWEEP {
        for (group, op) in [
            (Group::Add, Op::Add),
            (Group::Add, Op::Subtract),
            (Group::Multiply, Op::Multiply),
            (Group::Contraction, Op::MultiplyAdd),
            (Group::Contraction, Op::MultiplySubtract),
            (Group::Contraction, Op::SubtractProduct),
            (Group::Reassociation, Op::SumError),
            (Group::Convert, Op::FromUnsigned),
        ] {
            // Random sign and mantissa, exponents -8 to 7.
            let float = |bits: u32| (bits & 0x87ff_ffff) + ((127 - 8) << 23);
            let mut operands = [next(), next(), next()];
            if op != Op::FromUnsigned {
                operands = operands.map(float);
            }
            if matches!(
                op,
                Op::MultiplyAdd | Op::MultiplySubtract | Op::SubtractProduct
            ) {
                // Half of them cancel, which lays the product's rounding bare.
                let [a, b, c] = operands;
                let product = f32::from_bits(a) * f32::from_bits(b);
                let against = if op == Op::MultiplyAdd {
                    -product
                } else {
                    product
                };
                operands[2] = if c & 1 == 0 {
                    c
                } else {
                    against.to_bits() ^ (c >> 4 & 7)
                };
            }
            rows.push(Row {
                group,
                op,
                operands,
            });
        }
    }
    rows
}

#[cfg(test)]
mod tests {
    use super::super::probe_rows::Mode;
    use super::*;

    /// The same in f32 arithmetic, which Rust guarantees to be IEEE.
    fn f32_result(row: &Row) -> u32 {
        let [a, ..] = row.operands;
        let [x, y, z] = row.operands.map(f32::from_bits);
        let value = match row.op {
            Op::Add => x + y,
            Op::Subtract => x - y,
            Op::Multiply => x * y,
            Op::MultiplyAdd => x * y + z,
            Op::MultiplySubtract => x * y - z,
            Op::SubtractProduct => z - x * y,
            Op::SumError => y - ((x + y) - x),
            Op::FromUnsigned => a as f32,
            Op::FromSigned => a as i32 as f32,
            Op::FromFraction => (a >> 8) as f32,
            Op::Floor => x.floor(),
            _ => return row.expected(Mode::NearestEven),
        };
        value.to_bits()
    }

    #[test]
    fn the_judge_agrees_with_f32() {
        for row in chosen().iter().chain(&sweep()) {
            let (judge, native) = (row.expected(Mode::NearestEven), f32_result(row));
            let nan = f32::from_bits(judge).is_nan() && f32::from_bits(native).is_nan();
            assert!(
                judge == native || nan,
                "{}: {judge:08x} {native:08x}",
                row.name()
            );
        }
    }

    #[test]
    fn every_chosen_contraction_tells_fused_from_separate() {
        for row in chosen()
            .iter()
            .filter(|row| row.group == Group::Contraction)
        {
            let [x, y, z] = row.operands.map(f32::from_bits);
            let fused = match row.op {
                Op::MultiplyAdd => x.mul_add(y, z),
                Op::MultiplySubtract => x.mul_add(y, -z),
                _ => (-x).mul_add(y, z),
            };
            assert_ne!(
                fused.to_bits(),
                row.expected(Mode::NearestEven),
                "{}",
                row.name()
            );
            assert_ne!(
                fused.to_bits(),
                row.expected(Mode::TowardZero),
                "{}",
                row.name()
            );
        }
    }

    #[test]
    fn the_groups_tell_the_rounding_modes_apart() {
        for group in [Group::Add, Group::Multiply, Group::Convert] {
            let all = chosen();
            let rows: Vec<_> = all.iter().filter(|row| row.group == group).collect();
            let differ =
                |row: &&&Row| row.expected(Mode::NearestEven) != row.expected(Mode::TowardZero);
            assert!(rows.iter().filter(differ).count() > 4, "{group:?}");
            // Ties that go down to even, where rounding half away would go up.
            assert!(rows.iter().any(|row| is_tie(row, false)), "{group:?}");
            assert!(rows.iter().any(|row| is_tie(row, true)), "{group:?}");
        }
    }

    /// Whether the exact result lies halfway, and nearest-even goes `up`.
    fn is_tie(row: &Row, up: bool) -> bool {
        let [x, y, _] = row.operands.map(|bits| f64::from(f32::from_bits(bits)));
        let exact = match row.op {
            Op::Add => x + y,
            Op::Subtract => x - y,
            Op::Multiply => x * y,
            Op::FromUnsigned => f64::from(row.operands[0]),
            Op::FromSigned => f64::from(row.operands[0] as i32),
            _ => return false,
        };
        let low = row.expected(Mode::TowardZero);
        let (low, high) = (f32::from_bits(low), f32::from_bits(low + 1));
        let tie = (f64::from(low) + f64::from(high)) / 2.0 == exact;
        tie && up == (row.expected(Mode::NearestEven) == high.to_bits())
    }

    #[test]
    fn no_row_is_undefined() {
        for row in chosen() {
            let [a, b, _] = row.operands;
            let x = f32::from_bits(a);
            match row.op {
                Op::ShiftLeft | Op::ShiftRight | Op::ShiftRightSigned => assert!(b < 32),
                Op::ToUnsigned => assert!((0.0..4_294_967_296.0).contains(&x)),
                Op::ToSigned => assert!((-2_147_483_648.0..2_147_483_648.0).contains(&x)),
                _ => {}
            }
        }
    }
}
