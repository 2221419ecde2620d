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

// x, exactly. Denormals count as 0; infinities and NaN as numbers of at least 2^128.
CorputReal corput_real(float x) {
    uint bits = floatBitsToUint(x);
    uint exponent = (bits >> 23) & 255u;
    if (exponent == 0u) {
        return corput_real_zero();
    }
    return CorputReal((bits << 8) | 0x80000000u, int(exponent) - 158, bits > 0x80000000u);
}

// m * 2^e, exactly, for any m.
CorputReal corput_real_uint(uint m, int e) {
    if (m == 0u) {
        return corput_real_zero();
    }
    uint shift = 31u - corput_find_msb(m);
    return CorputReal(m << shift, e - int(shift), false);
}

// v * 2^e, for v of 64 bits, cut to 32 significant bits.
CorputReal corput_real_wide(uvec2 v, int e) {
    if (v.y == 0u) {
        return corput_real_uint(v.x, e);
    }
    uint shift = 31u - corput_find_msb(v.y);
    return CorputReal(corput_shl64(v, shift).y, e + 32 - int(shift), false);
}

// (negative ? -1 : 1) * v.
CorputReal corput_real_scaled(CorputScaled v, bool negative) {
    if (v.m == 0u) {
        return corput_real_zero();
    }
    return CorputReal(v.m, v.e, negative);
}

// -a.
CorputReal corput_real_negate(CorputReal a) {
    return CorputReal(a.m, a.e, a.m != 0u && !a.negative);
}

// a * 2^k.
CorputReal corput_real_shift(CorputReal a, int k) {
    return CorputReal(a.m, a.m == 0u ? 0 : a.e + k, a.negative);
}

// Whether |a| < |b|.
bool corput_real_smaller(CorputReal a, CorputReal b) {
    if (a.m == 0u || b.m == 0u) {
        return b.m != 0u;
    }
    return a.e < b.e || (a.e == b.e && a.m < b.m);
}

// Whether a < b.
bool corput_real_less(CorputReal a, CorputReal b) {
    if (a.negative != b.negative) {
        return a.negative;
    }
    // Of two negative numbers the larger magnitude is the lesser.
    if (a.negative) {
        return corput_real_smaller(b, a);
    }
    return corput_real_smaller(a, b);
}

// The lesser of a and b.
CorputReal corput_real_min(CorputReal a, CorputReal b) {
    if (corput_real_less(b, a)) {
        return b;
    }
    return a;
}

// The greater of a and b.
CorputReal corput_real_max(CorputReal a, CorputReal b) {
    if (corput_real_less(a, b)) {
        return b;
    }
    return a;
}

// a + b.
CorputReal corput_real_add(CorputReal a, CorputReal b) {
    CorputReal large = a;
    CorputReal small = b;
    if (corput_real_smaller(a, b)) {
        large = b;
        small = a;
    }
    if (small.m == 0u) {
        return large;
    }
    uvec2 shifted = corput_shr64(uvec2(0u, small.m), uint(min(large.e - small.e, 63)));
    if (large.negative == small.negative) {
        uvec2 sum = corput_addc(large.m, shifted.y);
        if (sum.y != 0u) {
            return CorputReal((sum.x >> 1) | 0x80000000u, large.e + 1, large.negative);
        }
        return CorputReal(sum.x, large.e, large.negative);
    }
    // 32 guard bits: where more than one bit cancels, none was shifted out.
    CorputReal rest = corput_real_wide(corput_sub64(uvec2(0u, large.m), shifted), large.e - 32);
    return CorputReal(rest.m, rest.e, rest.m != 0u && large.negative);
}

// a - b.
CorputReal corput_real_subtract(CorputReal a, CorputReal b) {
    return corput_real_add(a, corput_real_negate(b));
}

// a * b.
CorputReal corput_real_multiply(CorputReal a, CorputReal b) {
    if (a.m == 0u || b.m == 0u) {
        return corput_real_zero();
    }
    uvec2 product = corput_mul64(a.m, b.m);
    uint shift = (product.y >> 31) ^ 1u;
    return CorputReal(corput_shl64(product, shift).y, a.e + b.e + 32 - int(shift), a.negative != b.negative);
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
    if (a.m == 0u) {
        return corput_real_zero();
    }
    if (b.m == 0u) {
        return CorputReal(0x80000000u, 97, a.negative);
    }
    uint x = corput_real_reciprocal(b.m);
    // a.m / b.m in units of 2^-31, never too large; the residual gives 26 bits more.
    uint q = corput_mulhi(a.m, x);
    uvec2 r = corput_sub64(corput_shr64(uvec2(0u, a.m), 1u), corput_mul64(q, b.m));
    uint low = corput_mulhi(corput_shr64(r, 5u).x, x);
    uvec2 quotient = corput_add64(corput_shl64(uvec2(q, 0u), 26u), uvec2(low, 0u));
    CorputReal result = corput_real_wide(quotient, a.e - b.e - 57);
    return CorputReal(result.m, result.e, a.negative != b.negative);
}

// sqrt(a); 0 for a < 0.
CorputReal corput_real_sqrt(CorputReal a) {
    if (a.m == 0u || a.negative) {
        return corput_real_zero();
    }
    uint odd = uint(a.e) & 1u;
    uint half_m = a.m >> odd;
    uint s = corput_sqrt_floor(half_m);
    // The residual, and with it the next term of Taylor's series.
    uint r = (half_m << 18) - s * s + ((a.m & odd) << 17);
    uint low = min((r << 6) / s, 127u);
    return CorputReal((s << 7) + low, ((a.e + int(odd)) >> 1) - 16, false);
}

// The nearest float, halves away from zero: at most the largest finite float in magnitude,
// +0 below 2^-126.
float corput_real_float(CorputReal a) {
    if (a.m == 0u || a.e < -157) {
        return 0.0;
    }
    uint bits = 0x7f7fffffu;
    if (a.e <= 96) {
        bits = min(bits, corput_pack_bits(CorputScaled(a.m, a.e)));
    }
    return uintBitsToFloat(a.negative ? bits | 0x80000000u : bits);
}

// floor(a * 2^32), from 0 to 2^32 - 1.
uint corput_real_fraction(CorputReal a) {
    if (a.negative || a.e < -63) {
        return 0u;
    }
    if (a.e > -32) {
        return a.m == 0u ? 0u : 0xffffffffu;
    }
    return a.m >> uint(-32 - a.e);
}

#endif
