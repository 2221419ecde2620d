//! Bit operations that the other modules build on.
//!
//! Source: core GLSL 4.00 and ESSL 3.10. Domain: any `u32`.
//! Mirror: `shaders/corput/bits.glsl`.

/// Position of the highest set bit, 0 to 31; `0xffff_ffff` for `x = 0`.
#[inline(always)]
#[must_use]
pub fn find_msb(x: u32) -> u32 {
    31u32.wrapping_sub(x.leading_zeros())
}

/// The bits of `x` in reverse order: bit i goes to bit 31 - i.
#[inline]
#[must_use]
pub fn reverse_bits(x: u32) -> u32 {
    x.reverse_bits()
}
