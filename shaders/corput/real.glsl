// what:   real numbers with a significand of 32 bits, in integers: what float arithmetic
//         would give if every device agreed on it, and 8 bits more.
// source: Knuth, TAOCP vol. 2, 4.2.1; Newton's iteration for the reciprocal from
//         48/17 - 32/17 d, its last bits by the exact residual.
// domain: exponents within +-2^29, which no chain of a few thousand operations on floats
//         leaves.
// range:  each result is within 2^-30 of itself of the exact one, also where a
//         difference cancels; never an infinity or NaN.
// errors: a sum, product or square root 2^-30, a quotient 2^-30, conversion to float half
//         a ULP; conversion from float is exact.
// cost:   multiply 6, add 25, divide 60, square root 60 integer instructions. tier I.
// hooks:  none.
// mirror: src/reference/real.rs
#ifndef CORPUT_REAL_GLSL
#define CORPUT_REAL_GLSL

#include "corput/elementary.glsl"

// (negative ? -1 : 1) * m * 2^e: bit 31 of m is set, or all of it is 0.
struct CorputReal {
    uint m;
    int e;
    bool negative;
};

// 0.
CorputReal corput_real_zero() {
    return CorputReal(0u, 0, false);
}

// (negative ? -1 : 1) * m * 2^e with bit 31 of m set, or 0 for m = 0. A zero has no sign and
// no exponent: one place sets them, since each branch costs compilers dear.
CorputReal corput_real_or_zero(uint m, int e, bool negative) {
    CorputReal result = CorputReal(m, e, negative);
    if (m == 0u) {
        result = corput_real_zero();
    }
    return result;
}

// x, exactly. Denormals count as 0; infinities and NaN as numbers of at least 2^128.
CorputReal corput_real(float x) {
    uint bits = floatBitsToUint(x);
    uint exponent = (bits >> 23) & 255u;
    uint m = (bits << 8) | 0x80000000u;
    if (exponent == 0u) {
        m = 0u;
    }
    return corput_real_or_zero(m, int(exponent) - 158, bits > 0x80000000u);
}

// m * 2^e, exactly, for any m.
CorputReal corput_real_uint(uint m, int e) {
    uint shift = 31u - corput_find_msb(m | 1u);
    return corput_real_or_zero(m << shift, e - int(shift), false);
}

// v * 2^e, for v of 64 bits, cut to 32 significant bits.
CorputReal corput_real_wide(uvec2 v, int e) {
    uint whole = 0u - uint(v.y == 0u);
    uint high = v.y | (v.x & whole);
    uint low = v.x & ~whole;
    uint shift = 31u - corput_find_msb(high | 1u);
    return corput_real_or_zero((high << shift) | ((low >> 1) >> (31u - shift)),
        e + 32 - int(shift) - int(whole & 32u), false);
}

// (negative ? -1 : 1) * v.
CorputReal corput_real_scaled(CorputScaled v, bool negative) {
    return corput_real_or_zero(v.m, v.e, negative);
}

// -a.
CorputReal corput_real_negate(CorputReal a) {
    return corput_real_or_zero(a.m, a.e, !a.negative);
}

// a * 2^k.
CorputReal corput_real_shift(CorputReal a, int k) {
    return corput_real_or_zero(a.m, a.e + k, a.negative);
}

// Whether |a| < |b|.
bool corput_real_smaller(CorputReal a, CorputReal b) {
    // 0 below all others: its exponent is 0.
    int a_e = a.e - int(uint(a.m == 0u) << 30);
    int b_e = b.e - int(uint(b.m == 0u) << 30);
    return (uint(a_e < b_e) | (uint(a_e == b_e) & uint(a.m < b.m))) != 0u;
}

// Whether a < b.
bool corput_real_less(CorputReal a, CorputReal b) {
    uint smaller = uint(corput_real_smaller(a, b));
    // Of two negative numbers the larger magnitude is the lesser.
    uint larger = uint(corput_real_smaller(b, a));
    uint a_sign = uint(a.negative);
    uint b_sign = uint(b.negative);
    return ((a_sign & ((b_sign ^ 1u) | larger)) | (((a_sign | b_sign) ^ 1u) & smaller)) != 0u;
}

// The lesser of a and b.
CorputReal corput_real_min(CorputReal a, CorputReal b) {
    CorputReal lesser = a;
    if (corput_real_less(b, a)) {
        lesser = b;
    }
    return lesser;
}

// The greater of a and b.
CorputReal corput_real_max(CorputReal a, CorputReal b) {
    CorputReal greater = a;
    if (corput_real_less(a, b)) {
        greater = b;
    }
    return greater;
}

// a + b.
CorputReal corput_real_add(CorputReal a, CorputReal b) {
    CorputReal large = a;
    CorputReal small = b;
    if (corput_real_smaller(a, b)) {
        large = b;
        small = a;
    }
    // 32 guard bits: where more than one bit cancels, none was shifted out.
    uvec2 shifted = corput_shr64(uvec2(0u, small.m), uint(clamp(large.e - small.e, 0, 63)));
    uint differ = uint(large.negative) ^ uint(small.negative);
    uint flip = 0u - differ;
    uvec2 low = corput_addc(shifted.x ^ flip, differ);
    uvec2 high = corput_addc(large.m, (shifted.y ^ flip) + low.y);
    // The sum's carry; that of a difference says only that it is not negative.
    uint carry = high.y & ~flip;
    CorputReal sum = corput_real_wide(uvec2(low.x, (high.x >> carry) | (carry << 31)), large.e - 32 + int(carry));
    return corput_real_or_zero(sum.m, sum.e, large.negative);
}

// a - b.
CorputReal corput_real_subtract(CorputReal a, CorputReal b) {
    return corput_real_add(a, corput_real_negate(b));
}

// a * b.
CorputReal corput_real_multiply(CorputReal a, CorputReal b) {
    uvec2 product = corput_mul64(a.m, b.m);
    uint shift = (product.y >> 31) ^ 1u;
    return corput_real_or_zero((product.y << shift) | ((product.x >> 31) & shift),
        a.e + b.e + 32 - int(shift), a.negative != b.negative);
}

// a * a.
CorputReal corput_real_square(CorputReal a) {
    return corput_real_multiply(a, a);
}

// About 2^63 / m, and never more, for m >= 2^31.
uint corput_real_reciprocal(uint m) {
    // 1/d for d = m / 2^32, in units of 2^-30: wrong by 1/17, 2^-8, 2^-16 of itself.
    uint x = 3031741621u - corput_mulhi(2021161080u, m);
    x = corput_shr64(corput_mul64(x, 0x80000000u - corput_mulhi(m, x)), 30u).x;
    x = corput_shr64(corput_mul64(x, 0x80000000u - corput_mulhi(m, x)), 30u).x << 1;
    // In units of 2^-31; ~v is 2 - d x or less, so that x never passes 1/d.
    return corput_shr64(corput_mul64(x, ~corput_mulhi(m, x)), 31u).x;
}

// a / b; 0 / b is 0, also for b = 0, and a / 0 is 2^128 with the sign of a.
CorputReal corput_real_divide(CorputReal a, CorputReal b) {
    uint x = corput_real_reciprocal(b.m);
    // a.m / b.m in units of 2^-31, never too large; the residual gives 26 bits more.
    uint q = corput_mulhi(a.m, x);
    uvec2 r = corput_sub64(corput_shr64(uvec2(0u, a.m), 1u), corput_mul64(q, b.m));
    uint low = corput_mulhi(corput_shr64(r, 5u).x, x);
    uvec2 quotient = corput_add64(corput_shl64(uvec2(q, 0u), 26u), uvec2(low, 0u));
    CorputReal result = corput_real_wide(quotient, a.e - b.e - 57);
    if (b.m == 0u) {
        result = CorputReal(min(a.m, 0x80000000u), 97, false);
    }
    return corput_real_or_zero(result.m, result.e, a.negative != b.negative);
}

// sqrt(a); 0 for a < 0.
CorputReal corput_real_sqrt(CorputReal a) {
    // 1 in place of what has no root.
    bool none = (uint(a.m == 0u) | uint(a.negative)) != 0u;
    CorputReal square = a;
    if (none) {
        square = CorputReal(0x80000000u, -31, false);
    }
    uint odd = uint(square.e) & 1u;
    uint half_m = square.m >> odd;
    uint s = corput_sqrt_floor(half_m);
    // The residual, and with it the next term of Taylor's series.
    uint r = (half_m << 18) - s * s + ((square.m & odd) << 17);
    uint m = (s << 7) + min((r << 6) / s, 127u);
    if (none) {
        m = 0u;
    }
    return corput_real_or_zero(m, ((square.e + int(odd)) >> 1) - 16, false);
}

// The nearest float, halves away from zero: at most the largest finite float in magnitude,
// +0 below 2^-126.
float corput_real_float(CorputReal a) {
    uint bits = min(0x7f7fffffu, corput_pack_bits(CorputScaled(a.m, clamp(a.e, -157, 97))));
    if (a.e < -157) {
        bits = 0u;
    }
    uint sign = uint(a.negative) & uint(bits != 0u);
    return uintBitsToFloat(bits | (sign << 31));
}

// floor(a * 2^32), from 0 to 2^32 - 1.
uint corput_real_fraction(CorputReal a) {
    uint bits = a.m >> uint(clamp(-32 - a.e, 0, 31));
    if (a.e > -32) {
        bits = 0u - uint(a.m != 0u);
    }
    if ((uint(a.negative) | uint(a.e < -63)) != 0u) {
        bits = 0u;
    }
    return bits;
}

#endif
