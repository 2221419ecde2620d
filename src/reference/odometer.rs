//! Radical inverses of consecutive indices, without a division per point.
//!
//! Source: the von Neumann-Kakutani odometer, phi_b(n + 1) = phi_b(n) + b^-j +
//! b^-(j+1) - 1, where j low digits of n are b - 1; here on the low digits alone, with
//! the exact chain over the high digits made once per window.
//! Domain: a window of at most `power` consecutive indices, bases 3 to 251.
//! Range: the same bits as `radical_inverse`, for every n.
//! Mirror: `shaders/corput/odometer.glsl`.

use crate::reference::radical_inverse::{Base, radical_inverse_table};

/// A base with the constants of its low digits: power = base^k <= 255, k <= 5.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct OdometerBase {
    /// The base with what the chain over the high digits needs.
    pub radical: Base,
    /// base^k, at least the window's length.
    pub power: u32,
    /// 2^32 / power: whole part.
    pub quotient: u32,
    /// 2^32 / power: fraction of 2^16, rounded down.
    pub fraction: u32,
}

/// Where a window stands.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Odometer {
    /// The low digits of the index, mirrored: 0 to power - 1.
    pub reversed: u32,
    /// The chain over the high digits divided by power, in this block: whole part.
    pub quotient: u32,
    /// Its fraction of 2^16, rounded down, plus 2^16 - 1.
    pub fraction: u32,
    /// The same whole part in the next block.
    pub next_quotient: u32,
    /// The same fraction in the next block.
    pub next_fraction: u32,
}

/// The window that starts at index n.
#[inline]
#[must_use]
pub fn odometer_start(n: u32, b: OdometerBase) -> Odometer {
    let block = n / b.power;
    let mut low = n - block * b.power;
    let mut reversed = 0;
    let mut scale = 1;
    while scale < b.power {
        let rest = low / b.radical.base;
        reversed = reversed * b.radical.base + (low - rest * b.radical.base);
        low = rest;
        scale *= b.radical.base;
    }
    let y = radical_inverse_table(block, b.radical);
    let next = radical_inverse_table(block + 1, b.radical);
    let quotient = y / b.power;
    let next_quotient = next / b.power;
    Odometer {
        reversed,
        quotient,
        fraction: ((y - quotient * b.power) << 16) / b.power + 0xffff,
        next_quotient,
        next_fraction: ((next - next_quotient * b.power) << 16) / b.power + 0xffff,
    }
}

/// `ceil(2^32 phi_b(n))` for the index n where the window stands.
#[inline]
#[must_use]
pub fn odometer_value(o: Odometer, b: OdometerBase) -> u32 {
    // The ceiling of (reversed * 2^32 + y) / power. Its fraction is a multiple of
    // 1 / power >= (power + 1) / 2^16; the fractions of 2^16 fall short by less than
    // power / 2^16, so adding 1 - 2^-16 carries exactly where the ceiling does.
    o.reversed * b.quotient + o.quotient + ((o.reversed * b.fraction + o.fraction) >> 16)
}

/// The window one index on.
#[inline]
#[must_use]
pub fn odometer_next(o: Odometer, b: OdometerBase) -> Odometer {
    // Weights of the first five digits; past the last digit a weight is 0, and the
    // step of that line is the wrap to 0.
    let first = b.power / b.radical.base;
    let second = first / b.radical.base;
    let third = second / b.radical.base;
    let fourth = third / b.radical.base;
    let fifth = fourth / b.radical.base;
    let step = if o.reversed < b.power - first {
        first
    } else if o.reversed < b.power - second {
        (first + second).wrapping_sub(b.power)
    } else if o.reversed < b.power - third {
        (second + third).wrapping_sub(b.power)
    } else if o.reversed < b.power - fourth {
        (third + fourth).wrapping_sub(b.power)
    } else if o.reversed < b.power - fifth {
        (fourth + fifth).wrapping_sub(b.power)
    } else {
        1u32.wrapping_sub(b.power)
    };
    let reversed = o.reversed.wrapping_add(step);
    let wrapped = reversed == 0;
    Odometer {
        reversed,
        quotient: if wrapped { o.next_quotient } else { o.quotient },
        fraction: if wrapped { o.next_fraction } else { o.fraction },
        next_quotient: o.next_quotient,
        next_fraction: o.next_fraction,
    }
}
