//! Radical inverse phi_b(n): the digits of n in base b mirrored at the point.
//!
//! Source: van der Corput 1935; Halton 1960; nested division, and division by an
//! invariant after Granlund and Montgomery 1994, figure 4.1.
//! Domain: every n; prime bases 2 to 65535. Range: exactly `ceil(2^32 phi_b(n))`, at
//! most 2^32 - 1, for `1 - phi_b(n) >= 1/(n+1)`.
//! Mirror: `shaders/corput/radical_inverse.glsl`.

use crate::reference::bits::reverse_bits;
use crate::reference::fixed::{addc, mulhi};
use glam::{UVec4, uvec4};

/// A base with what division by it needs.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Base {
    /// The base, a prime.
    pub base: u32,
    /// Digits of a group.
    pub digits: u32,
    /// `base^digits`: the largest power up to 65535.
    pub power: u32,
    /// Multiplier for division by `base`.
    pub base_magic: u32,
    /// Shift for division by `base`.
    pub base_shift: u32,
    /// Multiplier for division by `power`.
    pub power_magic: u32,
    /// Shift for division by `power`.
    pub power_shift: u32,
}

/// `floor(x / d)` for any x, where magic and shift belong to d.
#[inline]
#[must_use]
pub fn divide_by(x: u32, magic: u32, shift: u32) -> u32 {
    let t = mulhi(x, magic);
    (t + ((x - t) >> 1)) >> shift
}

/// The van der Corput sequence: phi_2(n) * 2^32, exact.
#[inline]
#[must_use]
pub fn van_der_corput(n: u32) -> u32 {
    reverse_bits(n)
}

/// The lowest `b.digits` digits of `group` in reverse order.
#[inline]
#[must_use]
pub fn reverse_digits(mut group: u32, b: Base) -> u32 {
    let mut reversed = 0;
    for _ in 0..b.digits {
        let rest = divide_by(group, b.base_magic, b.base_shift);
        reversed = reversed * b.base + (group - rest * b.base);
        group = rest;
    }
    reversed
}

/// `ceil((digits * 2^32 + y) / b.power)`, for `digits < b.power`.
#[inline]
#[must_use]
pub fn prepend_digits(digits: u32, y: u32, b: Base) -> u32 {
    let up = addc(y, b.power - 1);
    let high = ((digits + up.y) << 16) | (up.x >> 16);
    let q = divide_by(high, b.power_magic, b.power_shift);
    let low = ((high - q * b.power) << 16) | (up.x & 0xffff);
    (q << 16) | divide_by(low, b.power_magic, b.power_shift)
}

/// `ceil(2^32 phi_b(n))`, with the constants of the base from a table.
#[inline]
#[must_use]
pub fn radical_inverse_table(n: u32, b: Base) -> u32 {
    // At most four groups: b.power > 256, since b.power * b.base > 65535.
    let n1 = divide_by(n, b.power_magic, b.power_shift);
    let n2 = divide_by(n1, b.power_magic, b.power_shift);
    let n3 = divide_by(n2, b.power_magic, b.power_shift);
    let mut y = prepend_digits(reverse_digits(n3, b), 0, b);
    y = prepend_digits(reverse_digits(n2 - n3 * b.power, b), y, b);
    y = prepend_digits(reverse_digits(n1 - n2 * b.power, b), y, b);
    prepend_digits(reverse_digits(n - n1 * b.power, b), y, b)
}

/// `ceil(2^32 phi_b(n))` from the base alone, by integer division; 0 for bases
/// below 2 and above 65535.
#[inline]
#[must_use]
pub fn radical_inverse(mut n: u32, base: u32) -> u32 {
    if base == 2 {
        return van_der_corput(n);
    }
    // No base: 0 is what `prime` gives past its table.
    if !(2..=65535).contains(&base) {
        return 0;
    }
    let mut power = base;
    while power * base <= 65535 {
        power *= base;
    }
    // Groups of digits from the lowest up, each reversed: group 3 is the highest.
    let mut group = UVec4::ZERO;
    for _ in 0..4 {
        let rest = n / power;
        let mut digits = n - rest * power;
        let mut reversed = 0;
        let mut scale = 1;
        while scale < power {
            let q = digits / base;
            reversed = reversed * base + (digits - q * base);
            digits = q;
            scale *= base;
        }
        group = uvec4(group.y, group.z, group.w, reversed);
        n = rest;
    }
    let mut y = 0;
    for _ in 0..4 {
        let up = addc(y, power - 1);
        let high = ((group.w + up.y) << 16) | (up.x >> 16);
        let q = high / power;
        let low = ((high - q * power) << 16) | (up.x & 0xffff);
        y = (q << 16) | (low / power);
        group = uvec4(0, group.x, group.y, group.z);
    }
    y
}
