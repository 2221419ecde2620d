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
    bool zero = exponent == 0u;
    bool negative = bits > 0x80000000u;
    return CorputReal(zero ? 0u : (bits << 8) | 0x80000000u, zero ? 0 : int(exponent) - 158, zero ? false : negative);
}

// m * 2^e, exactly, for any m.
CorputReal corput_real_uint(uint m, int e) {
    uint shift = 31u - corput_find_msb(m | 1u);
    return CorputReal(m << shift, m == 0u ? 0 : e - int(shift), false);
}

// v * 2^e, for v of 64 bits, cut to 32 significant bits.
CorputReal corput_real_wide(uvec2 v, int e) {
    bool wide = v.y != 0u;
    uint high = wide ? v.y : v.x;
    uint low = wide ? v.x : 0u;
    uint shift = 31u - corput_find_msb(high | 1u);
    int exponent = (wide ? e + 32 : e) - int(shift);
    uint m = (high << shift) | ((low >> 1) >> (31u - shift));
    return CorputReal(m, m == 0u ? 0 : exponent, false);
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
    uint am = a.m;
    uint bm = b.m;
    // 0 is below all exponents.
    int ae = am == 0u ? -0x40000000 : a.e;
    int be = bm == 0u ? -0x40000000 : b.e;
    bool less = am < bm;
    return ae == be ? less : ae < be;
}

// Whether a < b.
bool corput_real_less(CorputReal a, CorputReal b) {
    bool smaller = corput_real_smaller(a, b);
    bool larger = corput_real_smaller(b, a);
    bool negative = a.negative;
    // Of two negative numbers the larger magnitude is the lesser.
    bool less = negative ? larger : smaller;
    return negative == b.negative ? less : negative;
}

// The lesser of a and b.
CorputReal corput_real_min(CorputReal a, CorputReal b) {
    bool less = corput_real_less(b, a);
    return CorputReal(less ? b.m : a.m, less ? b.e : a.e, less ? b.negative : a.negative);
}

// The greater of a and b.
CorputReal corput_real_max(CorputReal a, CorputReal b) {
    bool less = corput_real_less(a, b);
    return CorputReal(less ? b.m : a.m, less ? b.e : a.e, less ? b.negative : a.negative);
}

// a + b.
CorputReal corput_real_add(CorputReal a, CorputReal b) {
    bool swap = corput_real_smaller(a, b);
    uint large = swap ? b.m : a.m;
    uint small = swap ? a.m : b.m;
    int exponent = swap ? b.e : a.e;
    int below = swap ? a.e : b.e;
    bool negative = swap ? b.negative : a.negative;
    // Of a 0 any shift will do.
    uint distance = uint(min(abs(exponent - below), 63));
    uvec2 shifted = corput_shr64(uvec2(0u, small), distance);
    uvec2 sum = corput_addc(large, shifted.y);
    bool carried = sum.y != 0u;
    uint summed = carried ? (sum.x >> 1) | 0x80000000u : sum.x;
    int raised = carried ? exponent + 1 : exponent;
    // 32 guard bits: where more than one bit cancels, none was shifted out.
    CorputReal rest = corput_real_wide(corput_sub64(uvec2(0u, large), shifted), exponent - 32);
    bool alike = a.negative == b.negative;
    bool kept = small == 0u;
    bool add = kept ? true : alike;
    uint m = add ? summed : rest.m;
    return CorputReal(m, add ? raised : rest.e, m == 0u ? false : negative);
}

// a - b.
CorputReal corput_real_subtract(CorputReal a, CorputReal b) {
    return corput_real_add(a, corput_real_negate(b));
}

// a * b.
CorputReal corput_real_multiply(CorputReal a, CorputReal b) {
    uvec2 product = corput_mul64(a.m, b.m);
    bool zero = product.y == 0u;
    uint shift = (product.y >> 31) ^ 1u;
    uint m = shift == 0u ? product.y : (product.y << 1) | (product.x >> 31);
    bool negative = a.negative != b.negative;
    return CorputReal(zero ? 0u : m, zero ? 0 : a.e + b.e + 32 - int(shift), zero ? false : negative);
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
    // Any divisor in place of 0: the result is not of it.
    uint divisor = b.m | 0x80000000u;
    uint x = corput_real_reciprocal(divisor);
    // a.m / b.m in units of 2^-31, never too large; the residual gives 26 bits more.
    uint q = corput_mulhi(a.m, x);
    uvec2 r = corput_sub64(corput_shr64(uvec2(0u, a.m), 1u), corput_mul64(q, divisor));
    uint low = corput_mulhi(corput_shr64(r, 5u).x, x);
    uvec2 quotient = corput_add64(corput_shl64(uvec2(q, 0u), 26u), uvec2(low, 0u));
    CorputReal result = corput_real_wide(quotient, a.e - b.e - 57);
    bool undefined = b.m == 0u;
    uint m = undefined ? 0x80000000u : result.m;
    int e = undefined ? 97 : result.e;
    bool negative = undefined ? a.negative : a.negative != b.negative;
    bool zero = a.m == 0u;
    return CorputReal(zero ? 0u : m, zero ? 0 : e, zero ? false : negative);
}

// sqrt(a); 0 for a < 0.
CorputReal corput_real_sqrt(CorputReal a) {
    // Any number in place of 0: the result is not of it.
    uint am = a.m | 0x80000000u;
    uint odd = uint(a.e) & 1u;
    uint half_m = am >> odd;
    uint s = corput_sqrt_floor(half_m);
    // The residual, and with it the next term of Taylor's series.
    uint r = (half_m << 18) - s * s + ((am & odd) << 17);
    uint low = min((r << 6) / s, 127u);
    bool zero = a.negative ? true : a.m == 0u;
    return CorputReal(zero ? 0u : (s << 7) + low, zero ? 0 : ((a.e + int(odd)) >> 1) - 16, false);
}

// The nearest float, halves away from zero: at most the largest finite float in magnitude,
// +0 below 2^-126.
float corput_real_float(CorputReal a) {
    uint m = a.e < -157 ? 0u : a.m;
    uint bits = corput_pack_bits(CorputScaled(m, clamp(a.e, -157, 96)));
    uint most = a.e > 96 ? 0x7f7fffffu : min(bits, 0x7f7fffffu);
    uint magnitude = m == 0u ? 0u : most;
    bool negative = a.negative ? magnitude != 0u : false;
    return uintBitsToFloat(negative ? magnitude | 0x80000000u : magnitude);
}

// floor(a * 2^32), from 0 to 2^32 - 1.
uint corput_real_fraction(CorputReal a) {
    uint shift = uint(clamp(-32 - a.e, 0, 31));
    uint part = a.e < -63 ? 0u : a.m >> shift;
    uint most = a.m == 0u ? 0u : 0xffffffffu;
    uint fraction = a.e > -32 ? most : part;
    return a.negative ? 0u : fraction;
}

#endif
