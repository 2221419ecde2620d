//! Combining techniques: balance, power and maximum heuristics, one-sample and
//! multi-sample multiple importance sampling, and Russian roulette.
//!
//! Source: Veach and Guibas 1995, SIGGRAPH; Veach 1997, thesis, 9.2; Arvo and Kirk 1990,
//! SIGGRAPH. Domain: any floats as pdfs, any counts. A pdf that is negative, denormal or
//! NaN counts as 0; an infinite one outweighs all finite ones. Range: weights in [0, 1],
//! never NaN. Tier I.
//! Mirror: `shaders/corput/mis.glsl`.

use crate::reference::fixed::mul64;
use crate::reference::real::{
    Real, real, real_add, real_divide, real_float, real_fraction, real_less, real_multiply,
    real_shift, real_square, real_uint, real_wide, real_zero,
};
use glam::{UVec4, Vec4, uvec2};

/// Which technique, and the rest of the fraction that chose it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Technique {
    /// 0 to 3.
    pub index: u32,
    /// The rest, as a fraction.
    pub rest: u32,
}

/// Whether a path goes on, by which factor it then counts, and the rest of the fraction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Roulette {
    /// Whether it goes on.
    pub survives: bool,
    /// One over the probability of that; 0 where it does not.
    pub weight: f32,
    /// The rest, as a fraction.
    pub rest: u32,
}

/// Expected samples of a technique here: count * pdf.
#[inline]
#[must_use]
pub fn mis_term(count: u32, pdf: f32) -> Real {
    let bits = pdf.to_bits();
    if !(0x0080_0000..=0x7f80_0000).contains(&bits) {
        return real_zero();
    }
    let samples = real_multiply(real_uint(count, 0), real(pdf));
    // 2^4096 is beyond the squares of all that is finite.
    real_shift(samples, if bits == 0x7f80_0000 { 4096 } else { 0 })
}

/// Balance heuristic: weight of a sample of technique `a`, beside technique `b`.
#[inline]
#[must_use]
pub fn mis_balance(count_a: u32, pdf_a: f32, count_b: u32, pdf_b: f32) -> f32 {
    let a = mis_term(count_a, pdf_a);
    let b = mis_term(count_b, pdf_b);
    real_float(real_divide(a, real_add(a, b)))
}

/// Power heuristic with exponent 2.
#[inline]
#[must_use]
pub fn mis_power(count_a: u32, pdf_a: f32, count_b: u32, pdf_b: f32) -> f32 {
    let a = real_square(mis_term(count_a, pdf_a));
    let b = real_square(mis_term(count_b, pdf_b));
    real_float(real_divide(a, real_add(a, b)))
}

/// Maximum heuristic: 1 for the larger, 1/2 for equal ones.
#[inline]
#[must_use]
pub fn mis_maximum(count_a: u32, pdf_a: f32, count_b: u32, pdf_b: f32) -> f32 {
    let a = mis_term(count_a, pdf_a);
    let b = mis_term(count_b, pdf_b);
    if a.m == 0 || real_less(a, b) {
        return 0.0;
    }
    if real_less(b, a) { 1.0 } else { 0.5 }
}

/// Balance heuristic over four techniques: weight of a sample of the first, .x. A technique
/// that is not there has the count 0.
#[inline]
#[must_use]
pub fn mis_balance4(counts: UVec4, pdfs: Vec4) -> f32 {
    let x = mis_term(counts.x, pdfs.x);
    let y = mis_term(counts.y, pdfs.y);
    let z = mis_term(counts.z, pdfs.z);
    let w = mis_term(counts.w, pdfs.w);
    real_float(real_divide(x, real_add(real_add(x, y), real_add(z, w))))
}

/// Power heuristic with exponent 2 over four techniques.
#[inline]
#[must_use]
pub fn mis_power4(counts: UVec4, pdfs: Vec4) -> f32 {
    let x = real_square(mis_term(counts.x, pdfs.x));
    let y = real_square(mis_term(counts.y, pdfs.y));
    let z = real_square(mis_term(counts.z, pdfs.z));
    let w = real_square(mis_term(counts.w, pdfs.w));
    real_float(real_divide(x, real_add(real_add(x, y), real_add(z, w))))
}

/// One of four techniques, in proportion to weights that sum to less than 2^32: to each
/// belong floor or ceil of its share of the 2^32 fractions, to weight 0 none. Where all are
/// 0, the last.
#[inline]
#[must_use]
pub fn mis_choose(weights: UVec4, u: u32) -> Technique {
    let total = weights
        .x
        .wrapping_add(weights.y)
        .wrapping_add(weights.z)
        .wrapping_add(weights.w);
    let product = mul64(u, total);
    let mut place = product.y;
    let mut index = 0;
    let mut width = weights.x;
    if place >= width {
        place -= width;
        index = 1;
        width = weights.y;
        if place >= width {
            place -= width;
            index = 2;
            width = weights.z;
            if place >= width {
                place -= width;
                index = 3;
                width = weights.w;
            }
        }
    }
    // (place + the fraction below it) / width.
    let rest = real_divide(real_wide(uvec2(product.x, place), -32), real_uint(width, 0));
    Technique {
        index,
        rest: real_fraction(rest),
    }
}

/// Density of a sample of the technique that `mis_choose` picks, whichever it was: the mean
/// of the pdfs by these weights. f over it is the one-sample estimator with the balance
/// heuristic. Saturates at the largest float.
#[inline]
#[must_use]
pub fn mis_one_sample(weights: UVec4, pdfs: Vec4) -> f32 {
    let x = mis_term(weights.x, pdfs.x);
    let y = mis_term(weights.y, pdfs.y);
    let z = mis_term(weights.z, pdfs.z);
    let w = mis_term(weights.w, pdfs.w);
    let sum = real_add(real_add(x, y), real_add(z, w));
    let total = weights
        .x
        .wrapping_add(weights.y)
        .wrapping_add(weights.z)
        .wrapping_add(weights.w);
    real_float(real_divide(sum, real_uint(total, 0)))
}

/// Probability, as a fraction of 2^32, with which a path of this throughput survives: the
/// throughput itself, at most 1, which is written as 2^32 - 1; 0 for NaN.
#[inline]
#[must_use]
pub fn roulette_survival(throughput: f32) -> u32 {
    let bits = throughput.to_bits();
    if bits > 0x7f80_0000 {
        return 0;
    }
    real_fraction(real(throughput))
}

/// Whether u lets a path of this survival go on: for `survival` of the 2^32 fractions, with
/// 2^32 - 1 for all of them.
#[inline]
#[must_use]
pub fn roulette(survival: u32, u: u32) -> Roulette {
    if survival == 0xffff_ffff {
        return Roulette {
            survives: true,
            weight: 1.0,
            rest: u,
        };
    }
    if u < survival {
        let kept = real_uint(survival, 0);
        return Roulette {
            survives: true,
            weight: real_float(real_divide(real_uint(1, 32), kept)),
            rest: real_fraction(real_divide(real_uint(u, 0), kept)),
        };
    }
    if survival == 0 {
        return Roulette {
            survives: false,
            weight: 0.0,
            rest: u,
        };
    }
    let place = real_uint(u - survival, 0);
    let lost = real_uint(0u32.wrapping_sub(survival), 0);
    Roulette {
        survives: false,
        weight: 0.0,
        rest: real_fraction(real_divide(place, lost)),
    }
}
