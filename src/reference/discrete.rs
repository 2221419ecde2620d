//! Discrete distributions whose probabilities are integers over 2^32: search of a CDF,
//! alias table, and a weighted reservoir.
//!
//! Source: Walker 1977, ACM TOMS 3(3); Vose 1991, IEEE TSE 17(9); Chao 1982, Biometrika
//! 69(3); division by Knuth, TAOCP vol. 2, 4.3.1, algorithm D. Domain: tables as
//! `environment::cdf_table` and `alias_table` make them, from 1 to 2^24 items. Range: an
//! item is drawn for exactly `weight` of the 2^32 fractions u; one of weight 0 never.
//! Tier I.
//! Mirror: `shaders/corput/discrete.glsl`.
//!
//! The shader reads its tables by its hook `CORPUT_DISCRETE(i)`, the twin as `words`.

use crate::reference::bits::find_msb;
use crate::reference::fixed::{add64, mul64, mulhi, shl64};
use crate::reference::real::{real_divide, real_float, real_uint, real_wide};
use glam::{UVec2, uvec2};

/// An item, the place of u in it, and its weight out of 2^32.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Choice {
    /// Which item.
    pub index: u32,
    /// Where in it u lies.
    pub rest: u32,
    /// Its weight.
    pub weight: UVec2,
}

/// An item of a stream, its weight, and the sum of all weights.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Reservoir {
    /// Which item.
    pub index: u32,
    /// Its weight.
    pub weight: u32,
    /// All weights so far.
    pub total: UVec2,
}

/// floor((high 2^16 + next) / d), for high < d, next < 2^16, d >= 2^31.
#[inline]
#[must_use]
pub fn discrete_digit(high: u32, next: u32, d: u32) -> u32 {
    let divisor = d >> 16;
    let mut q = high / divisor;
    let mut r = high - q * divisor;
    // The guess is too large by 2 at most.
    for _ in 0..2 {
        if r < 65536 && (q >= 65536 || q * (d & 0xffff) > (r << 16) + next) {
            q -= 1;
            r += divisor;
        }
    }
    q
}

/// floor(n / d), for n < 2^32 d, d > 0.
#[inline]
#[must_use]
pub fn discrete_divide(n: UVec2, d: u32) -> u32 {
    let shift = 31 - find_msb(d.max(1));
    let v = shl64(n, shift);
    let divisor = d.max(1) << shift;
    let high = discrete_digit(v.y, v.x >> 16, divisor);
    let r = (v.y << 16)
        .wrapping_add(v.x >> 16)
        .wrapping_sub(high.wrapping_mul(divisor));
    (high << 16).wrapping_add(discrete_digit(r, v.x & 0xffff, divisor))
}

/// floor(v f / 2^32).
#[inline]
#[must_use]
pub fn discrete_scale(v: UVec2, f: u32) -> UVec2 {
    add64(mul64(v.y, f), uvec2(mulhi(v.x, f), 0))
}

/// The middle (part + 1/2) / width of one of `width` equal parts, as a fraction of 2^32.
/// A width of 2^32 is written as 0.
#[inline]
#[must_use]
pub fn discrete_rest(part: u32, width: u32) -> u32 {
    if width == 0 {
        return part;
    }
    discrete_divide(uvec2(0x8000_0000, part), width)
}

/// The part that holds this fraction's middle, (rest + 1/2) / 2^32.
#[inline]
#[must_use]
pub fn discrete_part(rest: u32, width: u32) -> u32 {
    if width == 0 {
        return rest;
    }
    add64(mul64(rest, width), uvec2(width >> 1, 0)).y
}

/// Sum of the weights before an item of the CDF at word `first`, modulo 2^32.
#[inline]
#[must_use]
pub fn cdf_lower(first: u32, index: u32, words: &[u32]) -> u32 {
    // The first word counts the items up to the last with a weight: 0 goes before it.
    if index == 0 || index >= words[first as usize] {
        0
    } else {
        words[(first + index) as usize]
    }
}

/// Weight of an item of the CDF at word `first`, out of 2^32.
#[inline]
#[must_use]
pub fn cdf_weight(first: u32, index: u32, words: &[u32]) -> UVec2 {
    let count = words[first as usize];
    if index >= count {
        return UVec2::ZERO;
    }
    let width = cdf_lower(first, index + 1, words).wrapping_sub(cdf_lower(first, index, words));
    uvec2(width, u32::from(index + 1 == count && width == 0))
}

/// The item that u draws by the CDF at word `first`.
#[inline]
#[must_use]
pub fn cdf(first: u32, u: u32, words: &[u32]) -> Choice {
    let mut low = 0;
    let mut high = words[first as usize].max(1) - 1;
    while low < high {
        let middle = (low + high + 1) >> 1;
        // Strict: the u that equals an item's end belongs to the next.
        if u < words[(first + middle) as usize] {
            high = middle - 1;
        } else {
            low = middle;
        }
    }
    let weight = cdf_weight(first, low, words);
    Choice {
        index: low,
        rest: discrete_rest(u.wrapping_sub(cdf_lower(first, low, words)), weight.x),
        weight,
    }
}

/// The u that draws this item and place by the CDF at word `first`.
#[inline]
#[must_use]
pub fn cdf_invert(first: u32, index: u32, rest: u32, words: &[u32]) -> u32 {
    let width = cdf_weight(first, index, words).x;
    cdf_lower(first, index, words).wrapping_add(discrete_part(rest, width))
}

/// The item that u draws by the alias table of `count` items at word `first`.
#[inline]
#[must_use]
pub fn alias_index(first: u32, count: u32, u: u32, words: &[u32]) -> u32 {
    let product = mul64(u, count);
    let at = (first + 3 * product.y) as usize;
    let other = words[at + 1];
    if product.x < words[at] {
        product.y
    } else {
        other
    }
}

/// The place of u.x among those of its bin that draw the same item, as a fraction; u.y
/// fills in the bits below, of which u.x leaves none for many items.
#[inline]
#[must_use]
pub fn alias_rest(first: u32, count: u32, u: UVec2, words: &[u32]) -> u32 {
    let bins = count.max(1);
    let product = mul64(u.x, bins);
    let at = (first + 3 * product.y) as usize;
    // Place among all u of the bin, how many those are, and how many draw its own item.
    let mut place = product.x / bins;
    let mut size = ((0xffff_ffff - (product.x - place * bins)) / bins).wrapping_add(1);
    let own = words[at] / bins;
    if words[at + 1] != product.y {
        let mine = product.x < words[at];
        place = place.wrapping_sub(if mine { 0 } else { own });
        size = if mine { own } else { size.wrapping_sub(own) };
    }
    // A bin of all 2^32.
    if size == 0 {
        return place;
    }
    discrete_divide(uvec2(u.y, place), size)
}

/// Weight of an item of the alias table at word `first`, out of 2^32.
#[inline]
#[must_use]
pub fn alias_weight(first: u32, index: u32, words: &[u32]) -> UVec2 {
    let at = (first + 3 * index) as usize;
    let weight = words[at + 2];
    // An item without weight leaves its bin to another; only one with all of it does not.
    uvec2(weight, u32::from(weight == 0 && words[at + 1] == index))
}

/// A reservoir of nothing.
#[inline]
#[must_use]
pub fn reservoir() -> Reservoir {
    Reservoir {
        index: 0,
        weight: 0,
        total: UVec2::ZERO,
    }
}

/// The reservoir after another item, which takes the place of the one in it with the
/// probability weight / total, rounded up to a multiple of 2^-32; never for weight 0.
#[inline]
#[must_use]
pub fn reservoir_add(r: Reservoir, index: u32, weight: u32, u: u32) -> Reservoir {
    let total = add64(r.total, uvec2(weight, 0));
    let place = discrete_scale(total, u);
    if place.y == 0 && place.x < weight {
        return Reservoir {
            index,
            weight,
            total,
        };
    }
    Reservoir { total, ..r }
}

/// The reservoir of two streams: `b`'s item with the probability b.total / total.
#[inline]
#[must_use]
pub fn reservoir_merge(a: Reservoir, b: Reservoir, u: u32) -> Reservoir {
    let total = add64(a.total, b.total);
    let place = discrete_scale(total, u);
    let other = place.y < b.total.y || (place.y == b.total.y && place.x < b.total.x);
    Reservoir {
        index: if other { b.index } else { a.index },
        weight: if other { b.weight } else { a.weight },
        total,
    }
}

/// Probability of the item in the reservoir, weight / total; 0 for none.
#[inline]
#[must_use]
pub fn reservoir_pdf(r: Reservoir) -> f32 {
    real_float(real_divide(real_uint(r.weight, 0), real_wide(r.total, 0)))
}
