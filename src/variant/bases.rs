//! What the radical inverse and the odometer need of a base: multipliers and shifts
//! that replace division.

use crate::reference::odometer::OdometerBase;
use crate::reference::radical_inverse::Base;

/// Multiplier and shift for division of any `u32` by `d >= 2`: with t = mulhi(x, m),
/// floor(x / d) = (t + ((x - t) >> 1)) >> s.
///
/// Granlund and Montgomery 1994, figure 4.1.
fn division_magic(d: u32) -> (u32, u32) {
    let bits = 32 - (d - 1).leading_zeros();
    let magic = ((1u64 << 32) * ((1u64 << bits) - u64::from(d)) / u64::from(d) + 1) as u32;
    (magic, bits - 1)
}

/// What the radical inverse in this base needs; bases below 2 count as 2, bases above
/// 65535 as 65535.
#[must_use]
pub fn radical_base(base: u32) -> Base {
    let base = base.clamp(2, 65535);
    let mut digits = 1;
    let mut power = base;
    while power * base <= 65535 {
        power *= base;
        digits += 1;
    }
    let (base_magic, base_shift) = division_magic(base);
    let (power_magic, power_shift) = division_magic(power);
    Base {
        base,
        digits,
        power,
        base_magic,
        base_shift,
        power_magic,
        power_shift,
    }
}

/// The largest power of a base for which the odometer is exact: power (power + 1) may
/// be 2^16 at most.
const ODOMETER_LIMIT: u32 = 255;

/// Digits that its step looks at.
const ODOMETER_DIGITS: usize = 5;

/// Points that an odometer in this base passes at most: the largest power within its limits;
/// `None` where it has none.
pub(super) fn longest_odometer(base: u32) -> Option<u32> {
    let powers = std::iter::successors(Some(base), |power| power.checked_mul(base));
    let powers = powers.take_while(|power| *power <= ODOMETER_LIMIT);
    powers.take(ODOMETER_DIGITS).last().filter(|_| base >= 3)
}

/// What the odometer in this base needs for windows of `window` indices; `None` for
/// base 2, which has no use for it, and where no power of the base fits.
#[must_use]
pub fn odometer_base(base: u32, window: u32) -> Option<OdometerBase> {
    if longest_odometer(base)? < window {
        return None;
    }
    let mut power = base;
    while power < window {
        power *= base;
    }
    let wide = u64::from(power);
    Some(OdometerBase {
        radical: radical_base(base),
        power,
        quotient: ((1u64 << 32) / wide) as u32,
        fraction: ((((1u64 << 32) % wide) << 16) / wide) as u32,
    })
}
