// what:   exponentials and powers with one set of bits everywhere: exp2, exp, 2^z - 1
//         without loss near 0, exp(-z^2/2), x^y and 1 - x^y.
// source: z = n + r with r in [0, 1); 1 + r P(r), P by interpolation in Chebyshev nodes
//         (scripts/elementary_polynomials.py), in fixed point.
// domain: any real. From 2^13 on in magnitude the result is 2^32767, or 0; as a float it
//         saturates at the largest finite one, and below 2^-126 it is +0.
// range:  reals within 2^-29.5 of themselves, 2^z - 1 within 2^-29; floats 0.52 ULP. A
//         power x^y is within 2^-29.5 + |y log2 x| 2^-29.7 of itself, and 1 - x^y within
//         2^-28 where x^y <= 1.
// cost:   60 integer instructions; a power 170. tier I.
// hooks:  none.
// mirror: src/reference/exponential.rs
#ifndef CORPUT_EXPONENTIAL_GLSL
#define CORPUT_EXPONENTIAL_GLSL

#include "corput/logarithm.glsl"

// (2^r - 1) / r as a fraction of 2^32, for r a fraction of 2^32: at least ln 2.
uint corput_exp2_polynomial(uint r) {
    // The coefficients sum up to 2^32 - 1: no step carries.
    uint p = 61958u + corput_mulhi(r, 7749u);
    p = 664660u + corput_mulhi(r, p);
    p = 5725253u + corput_mulhi(r, p);
    p = 41309926u + corput_mulhi(r, p);
    p = 238388284u + corput_mulhi(r, p);
    p = 1031764993u + corput_mulhi(r, p);
    return 2977044472u + corput_mulhi(r, p);
}

// 2^z for z = (negative ? -1 : 1) * m * 2^e, where m is 0 or at least 2^61.
CorputReal corput_real_exp2_wide(uvec2 m, int e, bool negative) {
    if (m.y != 0u && e > -49) {
        return CorputReal(negative ? 0u : 0x80000000u, negative ? 0 : 32736, false);
    }
    // 32 bits of fraction, in two's complement.
    uvec2 z = uvec2(0u);
    if (m.y != 0u && e > -96) {
        z = corput_shr64(m, uint(-32 - e));
    }
    if (negative) {
        z = corput_sub64(uvec2(0u), z);
    }
    uint fraction = corput_mulhi(z.x, corput_exp2_polynomial(z.x));
    uint rounded = min((fraction >> 1) + (fraction & 1u), 0x7fffffffu);
    return CorputReal(0x80000000u + rounded, int(z.y) - 31, false);
}

// e^z for z = (negative ? -1 : 1) * m * 2^e, where m is 0 or at least 2^62.
CorputReal corput_real_exp_wide(uvec2 m, int e, bool negative) {
    // The upper half of m / ln 2 * 2^63: three of four products, within 3 units.
    uvec2 low = uvec2(corput_mulhi(m.x, 3098164009u), 0u);
    low = corput_add64(low, uvec2(corput_mulhi(m.y, 1545072827u), 0u));
    uvec2 product = corput_add64(corput_mul64(m.y, 3098164009u), low);
    return corput_real_exp2_wide(product, e + 1, negative);
}

// 2^z.
CorputReal corput_real_exp2(CorputReal z) {
    return corput_real_exp2_wide(uvec2(0u, z.m), z.e - 32, z.negative);
}

// e^z.
CorputReal corput_real_exp(CorputReal z) {
    return corput_real_exp_wide(uvec2(0u, z.m), z.e - 32, z.negative);
}

// e^(-z^2/2): the square is not rounded.
CorputReal corput_real_gaussian(CorputReal z) {
    return corput_real_exp_wide(corput_mul64(z.m, z.m), 2 * z.e - 1, true);
}

// 2^z - 1, to full relative precision.
CorputReal corput_real_exp2m1(CorputReal z) {
    if (z.m == 0u) {
        return corput_real_zero();
    }
    if (z.e > -32) {
        return corput_real_subtract(corput_real_exp2(z), CorputReal(0x80000000u, -31, false));
    }
    uint r = z.e > -64 ? z.m >> uint(-32 - z.e) : 0u;
    CorputReal t = corput_real_multiply(CorputReal(z.m, z.e, false), CorputReal(corput_exp2_polynomial(r), -32, false));
    if (z.negative) {
        // 2^-|z| - 1 = -t / (1 + t).
        return corput_real_negate(corput_real_divide(t, corput_real_add(t, CorputReal(0x80000000u, -31, false))));
    }
    return t;
}

// x^y for x > 0. 0^y and negative x count as the limit x = 2^-2^128; x^0 = 1.
CorputReal corput_real_power(CorputReal x, CorputReal y) {
    return corput_real_exp2(corput_real_multiply(y, corput_real_log2(x)));
}

// 1 - x^y, without loss where x^y is near 1; x as in corput_real_power.
CorputReal corput_real_power_complement(CorputReal x, CorputReal y) {
    return corput_real_negate(corput_real_exp2m1(corput_real_multiply(y, corput_real_log2(x))));
}

// 2^x.
float corput_exp2(float x) {
    return corput_real_float(corput_real_exp2(corput_real(x)));
}

// e^x.
float corput_exp(float x) {
    return corput_real_float(corput_real_exp(corput_real(x)));
}

// x^y.
float corput_power(float x, float y) {
    return corput_real_float(corput_real_power(corput_real(x), corput_real(y)));
}

#endif
