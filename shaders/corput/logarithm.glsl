// what:   logarithms with one set of bits everywhere, to full relative precision also
//         next to 1: -ln(1 - u) of a fraction, ln and log2 of floats and reals.
// source: x = 2^n (1 + f), f from sqrt(1/2) - 1 to sqrt(2) - 1; f P(f), P by interpolation
//         in Chebyshev nodes (scripts/elementary_polynomials.py), in fixed point.
// domain: all fractions u of 2^32, 0 among them, for 1 - u is never 0; reals above 0 with
//         exponents within +-65535. 0 and negative numbers give -2^128, as a float the
//         lowest finite one; infinities and NaN count as numbers of at least 2^128.
// range:  reals within 2^-29.5 of themselves; floats 0.52 ULP.
// cost:   100 integer instructions. tier I.
// hooks:  none.
// mirror: src/reference/logarithm.rs
#ifndef CORPUT_LOGARITHM_GLSL
#define CORPUT_LOGARITHM_GLSL

#include "corput/real_angle.glsl"

// ln x = n ln 2 + (negative ? -1 : 1) * rest * 2^-63.
struct CorputLogarithm {
    int n;
    uvec2 rest;
    bool negative;
};

// c - f p, for f = (negative ? -1 : 1) * a * 2^-32.
uint corput_log_step(uint c, uint a, bool negative, uint p) {
    uint product = corput_mulhi(a, p);
    return negative ? c + product : c - product;
}

// ln(1 + f) / f as a fraction of 2^31, for f = (negative ? -1 : 1) * a * 2^-32 from
// sqrt(1/2) - 1 to sqrt(2) - 1.
uint corput_log_polynomial(uint a, bool negative) {
    uint p = corput_log_step(421096635u, a, negative, 224879699u);
    p = corput_log_step(431524174u, a, negative, p);
    p = corput_log_step(427177283u, a, negative, p);
    p = corput_log_step(472705744u, a, negative, p);
    p = corput_log_step(536674861u, a, negative, p);
    p = corput_log_step(613785691u, a, negative, p);
    p = corput_log_step(715843255u, a, negative, p);
    p = corput_log_step(858988655u, a, negative, p);
    p = corput_log_step(1073741512u, a, negative, p);
    p = corput_log_step(1431655805u, a, negative, p);
    p = corput_log_step(2147483650u, a, negative, p);
    // The last product with one bit less, and rounded.
    uint product = (corput_mulhi(a, p) + 1u) >> 1;
    return negative ? 0x80000000u + product : 0x80000000u - product;
}

// The parts of ln(m * 2^e), for m >= 2^31.
CorputLogarithm corput_log_split(uint m, int e) {
    // 0xb504f333 = floor(sqrt(2) * 2^31). f is exact on either side.
    bool negative = m > 0xb504f333u;
    uint a = negative ? 0u - m : m << 1;
    int n = negative ? e + 32 : e + 31;
    return CorputLogarithm(n, corput_mul64(a, corput_log_polynomial(a, negative)), negative);
}

// ln x.
CorputReal corput_real_log(CorputReal x) {
    if (x.m == 0u || x.negative) {
        return CorputReal(0x80000000u, 97, true);
    }
    CorputLogarithm part = corput_log_split(x.m, x.e);
    if (part.n == 0) {
        CorputReal rest = corput_real_wide(part.rest, -63);
        return CorputReal(rest.m, rest.e, rest.m != 0u && part.negative);
    }
    // In units of 2^-48; 2977044472 = ln 2 * 2^32. The rest is at most half of n ln 2.
    uvec2 whole = corput_mul64(uint(min(abs(part.n), 65535)) << 16, 2977044472u);
    uvec2 rest = corput_shr64(part.rest, 15u);
    bool negative = part.n < 0;
    if (negative != part.negative) {
        rest = corput_sub64(uvec2(0u), rest);
    }
    CorputReal sum = corput_real_wide(corput_add64(whole, rest), -48);
    return CorputReal(sum.m, sum.e, negative);
}

// log2 x.
CorputReal corput_real_log2(CorputReal x) {
    if (x.m == 0u || x.negative) {
        return CorputReal(0x80000000u, 97, true);
    }
    CorputLogarithm part = corput_log_split(x.m, x.e);
    // 3098164009 = 2^31 / ln 2.
    CorputReal rest = corput_real_multiply(corput_real_wide(part.rest, -63), CorputReal(3098164009u, -31, false));
    CorputReal whole = corput_real_uint(uint(abs(part.n)), 0);
    return corput_real_add(CorputReal(whole.m, whole.e, part.n < 0), CorputReal(rest.m, rest.e, rest.m != 0u && part.negative));
}

// -ln(1 - u), u a fraction of 2^32: 0 to 32 ln 2, never infinite.
CorputReal corput_real_negative_log(uint u) {
    return corput_real_negate(corput_real_log(corput_real_complement(u)));
}

// -ln(1 - u), u a fraction of 2^32: +0 to 22.18071.
float corput_negative_log(uint u) {
    return corput_real_float(corput_real_negative_log(u));
}

// ln x.
float corput_log(float x) {
    return corput_real_float(corput_real_log(corput_real(x)));
}

// log2 x; exact for powers of two.
float corput_log2(float x) {
    return corput_real_float(corput_real_log2(corput_real(x)));
}

#endif
