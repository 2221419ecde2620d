//! Radical inverses with permuted digits: Faure's permutations, random permutations of each
//! digit, nested (Owen) scrambling, and a random start.
//!
//! Source: Faure 1992, J. Number Theory 42; Owen 1995; Wang and Hickernell 2000, Math.
//! Comput. Modelling 32. Domain: every n; bases 2 to 65535; other bases give 0.
//! Range: fractions of 2^32. Faure keeps zeros, so his inverse has the digits of n and is
//! `ceil(2^32 x)`, at most 2^32 - 1: exact in its b-adic cells for n below the largest
//! b^m <= 2^32. The others have D digits, a whole number of groups, b^D >= 2^32, and are
//! `floor(2^32 x)`: of b^k cells, a point may leave its own over the lower edge with
//! probability below b^k 2^-32.
//! Mirror: `shaders/corput/scrambled_radical_inverse.glsl`.

use crate::reference::fixed::{addc, mulhi};
use crate::reference::permute::{permute, permute_key, permute_mix};
use glam::{UVec4, uvec4};

const SCRAMBLE_FAURE: u32 = 0;
const SCRAMBLE_PERMUTED: u32 = 1;
const SCRAMBLE_OWEN: u32 = 2;
const SCRAMBLE_STARTED: u32 = 3;

/// Faure's permutation of a digit: for even b that of b/2 doubled, then the same plus 1; for
/// odd b that of b - 1 around the middle (b - 1)/2, which stays. So the bases are b >> i.
/// Domain: digit < base < 2^32.
#[inline]
#[must_use]
pub fn faure_digit(mut digit: u32, base: u32) -> u32 {
    // Bit i: the digit is in the upper half at base b >> i.
    let mut upper = 0;
    let mut level = 0;
    let mut value = 0u32;
    let mut below = base > 1;
    while below {
        let b = base >> level;
        let middle = b >> 1;
        if b & 1 != 0 && digit == middle {
            value = middle;
            below = false;
        } else {
            if digit >= middle {
                digit = digit.wrapping_sub(middle + (b & 1));
                upper |= 1 << level;
            }
            level += 1;
            below = (b >> 1) > 1;
        }
    }
    while level > 0 {
        level -= 1;
        let b = base >> level;
        value = value.wrapping_mul(2).wrapping_add((upper >> level) & 1);
        value = value.wrapping_add(u32::from(b & 1 != 0 && value >= (b >> 1)));
    }
    value
}

/// The radical inverse with digits scrambled in one of the four ways; the four functions
/// below name them. Each way wants a seed of its own: with the same one they share
/// permutations, such as that of the first digit.
#[inline]
#[must_use]
pub fn radical_inverse_scrambled(mut n: u32, base: u32, seed: u32, scramble: u32) -> u32 {
    // No base: 0 is what `prime` gives past its table.
    if !(2..=65535).contains(&base) {
        return 0;
    }
    let mut power = base;
    while power * base <= 65535 {
        power *= base;
    }
    // 1626^3 is the least cube from 2^32 on; four groups always do, for power > 255.
    let groups = if power < 1626 { 4 } else { 3 };
    // Each base has keys of its own, so that dimensions may share a seed.
    let stream = permute_mix(permute_key(seed, base));
    let mut position = 0u32;
    let mut prefix = 0u32;
    let mut weight = 1u32;
    let mut carry = 0;
    // Groups of digits from the lowest up, each reversed: the last is the highest.
    let mut group = UVec4::ZERO;
    for _ in 0..groups {
        let mut reversed = 0;
        let mut scale = 1;
        while scale < power {
            let rest = n / base;
            let digit = n - rest * base;
            let key = permute_mix(stream.wrapping_add(position.wrapping_mul(0x9e37_79b9)));
            let mut scrambled;
            if scramble == SCRAMBLE_FAURE {
                scrambled = faure_digit(digit, base);
            } else if scramble == SCRAMBLE_STARTED {
                scrambled = digit + mulhi(key, base) + carry;
                carry = u32::from(scrambled >= base);
                scrambled -= carry * base;
            } else {
                let node = if scramble == SCRAMBLE_OWEN {
                    permute_mix(prefix)
                } else {
                    0
                };
                scrambled = permute(digit, base, key ^ node);
            }
            reversed = reversed * base + scrambled;
            // The weight may wrap only past the last digit of n that is not 0.
            prefix = prefix.wrapping_add(digit.wrapping_mul(weight));
            weight = weight.wrapping_mul(base);
            position += 1;
            n = rest;
            scale *= base;
        }
        group = uvec4(group.y, group.z, group.w, reversed);
    }
    let up = if scramble == SCRAMBLE_FAURE {
        power - 1
    } else {
        0
    };
    let mut y = 0;
    for _ in 0..groups {
        let low = addc(y, up);
        // ceil may reach 2^32 where n is above the largest power of the base.
        if group.w + low.y >= power {
            return 0xffff_ffff;
        }
        let high = ((group.w + low.y) << 16) | (low.x >> 16);
        let q = high / power;
        y = (q << 16) | ((((high - q * power) << 16) | (low.x & 0xffff)) / power);
        group = uvec4(0, group.x, group.y, group.z);
    }
    y
}

/// With Faure's permutation of every digit: no seed.
#[inline]
#[must_use]
pub fn radical_inverse_faure(n: u32, base: u32) -> u32 {
    radical_inverse_scrambled(n, base, 0, SCRAMBLE_FAURE)
}

/// With one random permutation per position of a digit.
#[inline]
#[must_use]
pub fn radical_inverse_permuted(n: u32, base: u32, seed: u32) -> u32 {
    radical_inverse_scrambled(n, base, seed, SCRAMBLE_PERMUTED)
}

/// With a random permutation per position and digits before it: nested uniform scrambling.
#[inline]
#[must_use]
pub fn radical_inverse_owen(n: u32, base: u32, seed: u32) -> u32 {
    radical_inverse_scrambled(n, base, seed, SCRAMBLE_OWEN)
}

/// Of n steps of the odometer from a random point, whose D digits are added with carry.
#[inline]
#[must_use]
pub fn radical_inverse_started(n: u32, base: u32, seed: u32) -> u32 {
    radical_inverse_scrambled(n, base, seed, SCRAMBLE_STARTED)
}
