// what:   wide products, carries, 64-bit integers as uvec2 (x low, y high),
//         and numbers m * 2^e packed to float.
// source: schoolbook arithmetic; Knuth, TAOCP vol. 2, 4.3.1.
// domain: any uint unless a function says otherwise.
// cost:   1 to 10 integer instructions. CORPUT_PORTABLE selects 16-bit halves and
//         compares in place of umulExtended, uaddCarry and usubBorrow, which naga
//         does not know; the results are the same bits.
// hooks:  none.
// mirror: src/reference/fixed.rs
#ifndef CORPUT_FIXED_GLSL
#define CORPUT_FIXED_GLSL

#include "corput/bits.glsl"

// A non-negative number m * 2^e, with bit 31 of m set, or m = 0.
struct CorputScaled {
    uint m;
    int e;
};

// floor(a * b / 2^32).
uint corput_mulhi(uint a, uint b) {
#ifdef CORPUT_PORTABLE
    uint a_low = a & 0xffffu;
    uint a_high = a >> 16;
    uint b_low = b & 0xffffu;
    uint b_high = b >> 16;
    uint middle = a_high * b_low + ((a_low * b_low) >> 16);
    uint cross = a_low * b_high + (middle & 0xffffu);
    return a_high * b_high + (middle >> 16) + (cross >> 16);
#else
    uint high;
    uint low;
    umulExtended(a, b, high, low);
    return high;
#endif
}

// a * b, all 64 bits.
uvec2 corput_mul64(uint a, uint b) {
#ifdef CORPUT_PORTABLE
    return uvec2(a * b, corput_mulhi(a, b));
#else
    uint high;
    uint low;
    umulExtended(a, b, high, low);
    return uvec2(low, high);
#endif
}

// x: a + b modulo 2^32; y: the carry, 0 or 1.
uvec2 corput_addc(uint a, uint b) {
#ifdef CORPUT_PORTABLE
    uint sum = a + b;
    return uvec2(sum, sum < a ? 1u : 0u);
#else
    uint carry;
    uint sum = uaddCarry(a, b, carry);
    return uvec2(sum, carry);
#endif
}

// x: a - b modulo 2^32; y: the borrow, 0 or 1.
uvec2 corput_subb(uint a, uint b) {
#ifdef CORPUT_PORTABLE
    return uvec2(a - b, a < b ? 1u : 0u);
#else
    uint borrow;
    uint difference = usubBorrow(a, b, borrow);
    return uvec2(difference, borrow);
#endif
}

// a + b modulo 2^64.
uvec2 corput_add64(uvec2 a, uvec2 b) {
    uvec2 low = corput_addc(a.x, b.x);
    return uvec2(low.x, a.y + b.y + low.y);
}

// a - b modulo 2^64.
uvec2 corput_sub64(uvec2 a, uvec2 b) {
    uvec2 low = corput_subb(a.x, b.x);
    return uvec2(low.x, a.y - b.y - low.y);
}

// v * 2^s modulo 2^64, for s from 0 to 63. Without branches, of which compilers for SIMD
// make masks; the same below.
uvec2 corput_shl64(uvec2 v, uint s) {
    uint whole = 0u - (s >> 5);
    uint part = s & 31u;
    uint low = v.x & ~whole;
    uint high = (v.y & ~whole) | (v.x & whole);
    return uvec2(low << part, (high << part) | ((low >> 1) >> (31u - part)));
}

// floor(v / 2^s), for s from 0 to 63.
uvec2 corput_shr64(uvec2 v, uint s) {
    uint whole = 0u - (s >> 5);
    uint part = s & 31u;
    uint low = (v.x & ~whole) | (v.y & whole);
    uint high = v.y & ~whole;
    return uvec2((low >> part) | ((high << 1) << (31u - part)), high >> part);
}

// The bits of the float nearest to v.m * 2^v.e, halves away from zero.
// The result must be 0 or a normal float: v.e from -157 to 96.
uint corput_pack_bits(CorputScaled v) {
    // m >> 8 carries the implicit bit, which raises the exponent field by one; so
    // does a rounding carry out of the mantissa, as it should.
    uint bits = (uint(v.e + 157) << 23) + (v.m >> 8) + ((v.m >> 7) & 1u);
    return v.m == 0u ? 0u : bits;
}

// m * 2^e in CorputScaled form, for any m.
CorputScaled corput_scaled(uint m, int e) {
    uint shift = m == 0u ? 0u : 31u - corput_find_msb(m);
    return CorputScaled(m << shift, e - int(shift));
}

// a * b, truncated to at least 31 significant bits.
CorputScaled corput_scaled_mul(CorputScaled a, CorputScaled b) {
    uint high = corput_mulhi(a.m, b.m);
    uint shift = (high >> 31) ^ 1u;
    return CorputScaled(high << shift, a.e + b.e + 32 - int(shift));
}

// The float nearest to (negative ? -1 : 1) * v; never -0.
float corput_pack(CorputScaled v, bool negative) {
    uint bits = corput_pack_bits(v);
    return uintBitsToFloat(negative && bits != 0u ? bits | 0x80000000u : bits);
}

// floor(|x| * 2^31), saturated to 2^31; 0 for NaN.
uint corput_fixed31(float x) {
    uint bits = floatBitsToUint(x) & 0x7fffffffu;
    uint exponent = bits >> 23;
    uint mantissa = (bits & 0x7fffffu) | 0x800000u;
    if (bits > 0x7f800000u) {
        return 0u;
    }
    if (exponent >= 127u) {
        return 0x80000000u;
    }
    if (exponent >= 119u) {
        return mantissa << (exponent - 119u);
    }
    uint shift = 119u - exponent;
    return shift > 23u ? 0u : mantissa >> shift;
}

// floor(x * 2^scale) modulo 2^64, for finite x >= 0; scale from -64 to 64.
uvec2 corput_fixed64(float x, int scale) {
    uint bits = floatBitsToUint(x);
    uint exponent = bits >> 23;
    uvec2 mantissa = uvec2((bits & 0x7fffffu) | 0x800000u, 0u);
    int shift = int(exponent) - 150 + scale;
    if (exponent == 0u || shift < -23 || shift > 63) {
        return uvec2(0u);
    }
    return shift < 0 ? corput_shr64(mantissa, uint(-shift)) : corput_shl64(mantissa, uint(shift));
}

#endif
