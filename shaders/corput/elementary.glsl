// what:   elementary functions with one set of bits everywhere: square root,
//         division, product, quotients in fixed point, sincos(2 pi u), and atan2 in
//         turns.
// source: correction of an inexact seed by its exact integer residual; minimax
//         polynomials (Remez on Chebyshev nodes) in fixed point, Horner's scheme.
// domain: as each function says; tier I: integers, and native float operations
//         only inside corput_seed_*, whose results integers correct.
// range:  errors below are worst cases in units of the last place (ULP) of float.
// cost:   20 to 60 integer instructions each.
// hooks:  none.
// mirror: src/reference/elementary.rs
#ifndef CORPUT_ELEMENTARY_GLSL
#define CORPUT_ELEMENTARY_GLSL

#include "corput/fixed.glsl"

// sin and cos of one angle: magnitudes and signs.
struct CorputSinCos {
    CorputScaled sine;
    CorputScaled cosine;
    bool sine_negative;
    bool cosine_negative;
};

// About sqrt(m) * 2^9, for m >= 2^30. Vulkan allows this to be off by 20.
uint corput_seed_sqrt(uint m) {
    return uint(sqrt(float(m)) * 512.0);
}

// About a / b * 2^24, for a, b in [2^23, 2^25). Vulkan allows this to be off by 6.
uint corput_seed_divide(uint a, uint b) {
    return uint(float(a) / float(b) * 16777216.0);
}

// floor(b * 2^15 / a) or one less, for b < 2^32, 1 <= a, b <= a.
uint corput_seed_quotient(uint b, uint a) {
    // 32767.875 = 2^15 (1 - 2^-18): two conversions, a division and a product are
    // together off by less than 2^-20, so the result is never too large.
    return uint(float(b) / float(a) * 32767.875);
}

// About floor(r / d), for |r / d| < 32, d >= 2^23.
int corput_seed_step(int r, uint d) {
    return int(floor(float(r) / float(d)));
}

// floor(sqrt(m * 2^18)), for m >= 2^30: 25 bits.
uint corput_sqrt_floor(uint m) {
    uint s = corput_seed_sqrt(m);
    // The residual is exact modulo 2^32, since |r| < 2^31 for a seed within 31.
    int r = int((m << 18) - s * s);
    int step = corput_seed_step(r, 2u * s);
    s += uint(step);
    r = int((m << 18) - s * s);
    // One step leaves at most one unit, for 2 s step differs from r by step^2.
    return s + uint(r > int(2u * s)) - uint(r < 0);
}

// sqrt(u * 2^-32), rounded down to 25 significant bits.
CorputScaled corput_sqrt_fraction(uint u) {
    if (u == 0u) {
        return CorputScaled(0u, 0);
    }
    uint shift = (31u - corput_find_msb(u)) & ~1u;
    uint s = corput_sqrt_floor(u << shift);
    return CorputScaled(s << 7, -32 - int(shift >> 1));
}

// sqrt(v * 2^-64), rounded down to 25 significant bits, of v cut to 32 bits.
CorputScaled corput_sqrt_fraction64(uvec2 v) {
    if (v.y == 0u) {
        CorputScaled low = corput_sqrt_fraction(v.x);
        return CorputScaled(low.m, low.e - 16);
    }
    uint shift = (31u - corput_find_msb(v.y)) & ~1u;
    uint s = corput_sqrt_floor(corput_shl64(v, shift).y);
    return CorputScaled(s << 7, -32 - int(shift >> 1));
}

// sqrt(x), correctly rounded to nearest even. Denormals count as zero;
// sqrt(+-0) = +0, sqrt(+inf) = +inf, NaN (0x7fc00000) for x < 0 and NaN.
float corput_sqrt(float x) {
    uint bits = floatBitsToUint(x);
    uint magnitude = bits & 0x7fffffffu;
    if (magnitude < 0x00800000u) {
        return 0.0;
    }
    if (magnitude > 0x7f800000u || bits != magnitude) {
        return uintBitsToFloat(0x7fc00000u);
    }
    if (magnitude == 0x7f800000u) {
        return x;
    }
    // x = m 2^18 * 2^(even): the root's exponent is a whole number.
    uint exponent = bits >> 23;
    uint odd = exponent & 1u;
    uint m = ((bits & 0x7fffffu) | 0x800000u) << (8u - odd);
    uint s = corput_sqrt_floor(m);
    // s is odd only where the root is irrational: no ties.
    return uintBitsToFloat((((exponent + odd) >> 1) << 23) + (62u << 23) + (s >> 1) + (s & 1u));
}

// x / y, correctly rounded to nearest even; IEEE 754 for zeros, infinities and NaN
// (0x7fc00000). Denormals count as zero, and a result below 2^-126 is zero.
float corput_divide(float x, float y) {
    uint x_bits = floatBitsToUint(x) & 0x7fffffffu;
    uint y_bits = floatBitsToUint(y) & 0x7fffffffu;
    uint sign = (floatBitsToUint(x) ^ floatBitsToUint(y)) & 0x80000000u;
    bool x_zero = x_bits < 0x00800000u;
    bool y_zero = y_bits < 0x00800000u;
    bool x_infinite = x_bits == 0x7f800000u;
    bool y_infinite = y_bits == 0x7f800000u;
    if (x_bits > 0x7f800000u || y_bits > 0x7f800000u || (x_zero && y_zero)
        || (x_infinite && y_infinite)) {
        return uintBitsToFloat(0x7fc00000u);
    }
    if (x_zero || y_infinite) {
        return uintBitsToFloat(sign);
    }
    if (y_zero || x_infinite) {
        return uintBitsToFloat(sign | 0x7f800000u);
    }
    uint a = (x_bits & 0x7fffffu) | 0x800000u;
    uint b = (y_bits & 0x7fffffu) | 0x800000u;
    uint less = a < b ? 1u : 0u;
    a <<= less;
    // q = floor(a * 2^24 / b), 25 bits; its residual is exact modulo 2^32.
    uint q = corput_seed_divide(a, b);
    int r = int((a << 24) - q * b);
    q += uint(corput_seed_step(r, b));
    r = int((a << 24) - q * b);
    if (r < 0) {
        q -= 1u;
        r += int(b);
    } else if (r >= int(b)) {
        q += 1u;
        r -= int(b);
    }
    uint rounded = (q >> 1) + (q & (q >> 1 | (r != 0 ? 1u : 0u)) & 1u);
    int exponent = int(x_bits >> 23) - int(y_bits >> 23) + 126 - int(less);
    // The implicit bit of `rounded` adds one to the exponent field.
    if (exponent < 0) {
        // A result that rounds up to 2^-126 is still a normal number.
        return uintBitsToFloat(sign | (exponent == -1 && rounded == 0x1000000u ? 0x00800000u : 0u));
    }
    uint bits = (uint(exponent) << 23) + rounded;
    return uintBitsToFloat(sign | min(bits, 0x7f800000u));
}

// x * y, correctly rounded to nearest even; IEEE 754 for zeros, infinities and NaN
// (0x7fc00000). Denormals count as zero, and a result below 2^-126 is zero.
float corput_multiply(float x, float y) {
    uint x_bits = floatBitsToUint(x) & 0x7fffffffu;
    uint y_bits = floatBitsToUint(y) & 0x7fffffffu;
    uint sign = (floatBitsToUint(x) ^ floatBitsToUint(y)) & 0x80000000u;
    bool x_zero = x_bits < 0x00800000u;
    bool y_zero = y_bits < 0x00800000u;
    bool x_infinite = x_bits == 0x7f800000u;
    bool y_infinite = y_bits == 0x7f800000u;
    if (x_bits > 0x7f800000u || y_bits > 0x7f800000u || (x_zero && y_infinite)
        || (x_infinite && y_zero)) {
        return uintBitsToFloat(0x7fc00000u);
    }
    if (x_zero || y_zero) {
        return uintBitsToFloat(sign);
    }
    if (x_infinite || y_infinite) {
        return uintBitsToFloat(sign | 0x7f800000u);
    }
    uint a = (x_bits & 0x7fffffu) | 0x800000u;
    uint b = (y_bits & 0x7fffffu) | 0x800000u;
    // (a << 8)(b << 8) has bit 63 or bit 62 set.
    uvec2 product = corput_mul64(a << 8, b << 8);
    uint small = (product.y >> 31) ^ 1u;
    product = corput_shl64(product, small);
    uint half_up = (product.y >> 7) & 1u;
    uint sticky = (product.y & 0x7fu) | product.x;
    uint kept = product.y >> 8;
    uint rounded = kept + (half_up & (kept | (sticky != 0u ? 1u : 0u)));
    int exponent = int(x_bits >> 23) + int(y_bits >> 23) - 127 - int(small);
    if (exponent < 0) {
        return uintBitsToFloat(sign | (exponent == -1 && rounded == 0x1000000u ? 0x00800000u : 0u));
    }
    uint bits = (uint(exponent) << 23) + rounded;
    return uintBitsToFloat(sign | min(bits, 0x7f800000u));
}

// floor(b * 2^30 / a), for 0 <= b <= a <= 2^31, a > 0.
uint corput_ratio(uint b, uint a) {
    uint high = corput_seed_quotient(b, a);
    // Both residuals lie in [0, 2 a), hence fit in 32 bits.
    uint r = (b << 15) - high * a;
    if (r >= a) {
        r -= a;
        high += 1u;
    }
    uint low = corput_seed_quotient(r, a);
    r = (r << 15) - low * a;
    if (r >= a) {
        low += 1u;
    }
    return (high << 15) + low;
}

// rho^2 as a fraction of 2^32 (1 becomes 1 - 2^-32), for rho as a fraction of 2^31.
uint corput_square31(uint rho) {
    uint z = corput_mulhi(rho, rho);
    return (z << 2) - (z >> 30);
}

// sin(pi/4 rho) / rho * 2^32, for w = rho^2 as a fraction of 2^32: at least 2^31.
uint corput_sin_polynomial(uint w) {
    uint p = 1346u - corput_mulhi(w, 7u);
    p = 157094u - corput_mulhi(w, p);
    p = 10696163u - corput_mulhi(w, p);
    p = 346799334u - corput_mulhi(w, p);
    return 3373259426u - corput_mulhi(w, p);
}

// cos(pi/4 rho) * 2^32, for w = rho^2 as a fraction of 2^32: at least 2^31, and
// 2^32 - 1 in place of 2^32.
uint corput_cos_polynomial(uint w) {
    uint p = 15422u - corput_mulhi(w, 104u);
    p = 1400124u - corput_mulhi(w, p);
    p = 68093890u - corput_mulhi(w, p);
    p = 1324675879u - corput_mulhi(w, p);
    uint versine = corput_mulhi(w, p);
    return ~versine + (versine == 0u ? 0u : 1u);
}

// sin and cos of 2 pi u, u a fraction of 2^32.
CorputSinCos corput_sincos_scaled(uint u) {
    // Nearest quarter turn, and the signed rest, in integers: no reduction error.
    uint quarter = (u + 0x20000000u) >> 30;
    int rest = int(u - (quarter << 30));
    uint t = uint(abs(rest));
    uint w = corput_square31(t << 2);
    CorputScaled s = corput_scaled_mul(corput_scaled(t, -29), CorputScaled(corput_sin_polynomial(w), -32));
    CorputScaled c = CorputScaled(corput_cos_polynomial(w), -32);
    bool swapped = (quarter & 1u) != 0u;
    bool sine_negative = swapped ? quarter == 3u : (quarter == 2u) != (rest < 0);
    bool cosine_negative = swapped ? (quarter == 1u) == (rest > 0) : quarter == 2u;
    if (swapped) {
        return CorputSinCos(c, s, sine_negative, cosine_negative);
    }
    return CorputSinCos(s, c, sine_negative, cosine_negative);
}

// (cos 2 pi u, sin 2 pi u), u a fraction of 2^32.
vec2 corput_cos_sin(uint u) {
    CorputSinCos a = corput_sincos_scaled(u);
    return vec2(corput_pack(a.cosine, a.cosine_negative), corput_pack(a.sine, a.sine_negative));
}

// atan(rho) / rho in turns * 2^34, for w = rho^2 as a fraction of 2^32.
uint corput_atan_polynomial(uint w) {
    uint p = 12939847u - corput_mulhi(w, 1813896u);
    p = 43278767u - corput_mulhi(w, p);
    p = 92489715u - corput_mulhi(w, p);
    p = 147531653u - corput_mulhi(w, p);
    p = 197640003u - corput_mulhi(w, p);
    p = 245377293u - corput_mulhi(w, p);
    p = 303282135u - corput_mulhi(w, p);
    p = 390556750u - corput_mulhi(w, p);
    p = 546849516u - corput_mulhi(w, p);
    p = 911420312u - corput_mulhi(w, p);
    return 2734261102u - corput_mulhi(w, p);
}

// atan(b / a) in turns, as a fraction of 2^32: 0 to 2^29; 0 for a = b = 0.
// For 0 <= b <= a <= 2^31. Within 1.2 * 2^-32 of a turn.
uint corput_atan_ratio(uint b, uint a) {
    uint rho = corput_ratio(b, max(a, 1u)) << 1;
    uint w = corput_square31(rho);
    uint p = corput_atan_polynomial(w);
    // rho is at most 2^31, and p a fraction of 2^34.
    return (corput_mulhi(rho, p) + 1u) >> 1;
}

// Angle of (x, y) in turns, counter-clockwise from +x, as a fraction of 2^32.
// (0, 0) gives 0; signs of zeros do not matter; denormals count as zero;
// finite arguments only. Within 2 * 2^-32 of a turn.
uint corput_atan2(float y, float x) {
    uint x_bits = floatBitsToUint(x) & 0x7fffffffu;
    uint y_bits = floatBitsToUint(y) & 0x7fffffffu;
    uint large = max(x_bits, y_bits);
    uint small = min(x_bits, y_bits);
    if (large < 0x00800000u) {
        return 0u;
    }
    // Both on the scale of the larger: what is shifted out is below 2^-30 of it.
    uint a = ((large & 0x7fffffu) | 0x800000u) << 7;
    uint b = ((small & 0x7fffffu) | 0x800000u) << 7;
    uint shift = (large >> 23) - (small >> 23);
    b = shift > 30u || small < 0x00800000u ? 0u : b >> shift;
    uint angle = corput_atan_ratio(b, a);
    if (y_bits > x_bits) {
        angle = 0x40000000u - angle;
    }
    if (floatBitsToUint(x) > 0x80000000u && x_bits >= 0x00800000u) {
        angle = 0x80000000u - angle;
    }
    if (floatBitsToUint(y) > 0x80000000u && y_bits >= 0x00800000u) {
        angle = 0u - angle;
    }
    return angle;
}

#endif
