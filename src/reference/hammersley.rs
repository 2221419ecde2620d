//! The coordinate k/N of the Hammersley set.
//!
//! Source: Hammersley 1960. Domain: k < N, 1 <= N <= 2^32; N = 2^32 is written as 0.
//! Range: exactly `ceil(2^32 k / N)`, at most 2^32 - 1.
//! Mirror: `shaders/corput/hammersley.glsl`.

use crate::reference::bits::find_msb;

/// The fraction `floor(2^32 k / N)`, and the remainder of that division.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct GridPoint {
    /// floor(2^32 k / N).
    pub fraction: u32,
    /// 2^32 k modulo N.
    pub remainder: u32,
}

/// 2^32 k / N by long division, which a power of two does not need.
#[inline]
#[must_use]
pub fn hammersley_start(k: u32, count: u32) -> GridPoint {
    if count == 0 {
        return GridPoint {
            fraction: k,
            remainder: 0,
        };
    }
    if count & count.wrapping_sub(1) == 0 {
        // In two steps: N = 1 shifts by 32.
        return GridPoint {
            fraction: (k << (31 - find_msb(count))) << 1,
            remainder: 0,
        };
    }
    let mut fraction = 0u32;
    let mut remainder = k;
    for _ in 0..32 {
        let carry = remainder >> 31 != 0;
        remainder <<= 1;
        fraction <<= 1;
        if carry || remainder >= count {
            remainder = remainder.wrapping_sub(count);
            fraction += 1;
        }
    }
    GridPoint {
        fraction,
        remainder,
    }
}

/// The grid point of k + 1 from that of k; `step` is the grid point of 1 (for N = 1,
/// where there is no k = 1, it is not called).
#[inline]
#[must_use]
pub fn hammersley_next(p: GridPoint, step: GridPoint, count: u32) -> GridPoint {
    let remainder = p.remainder.wrapping_add(step.remainder);
    let carry = remainder < p.remainder || (count != 0 && remainder >= count);
    GridPoint {
        fraction: p
            .fraction
            .wrapping_add(step.fraction)
            .wrapping_add(u32::from(carry)),
        remainder: if carry {
            remainder.wrapping_sub(count)
        } else {
            remainder
        },
    }
}

/// `ceil(2^32 k / N)`.
#[inline]
#[must_use]
pub fn hammersley_value(p: GridPoint) -> u32 {
    p.fraction.wrapping_add(u32::from(p.remainder != 0))
}

/// `ceil(2^32 k / N)`, from k and N.
#[inline]
#[must_use]
pub fn hammersley(k: u32, count: u32) -> u32 {
    hammersley_value(hammersley_start(k, count))
}
