// what:   exact sums of fixed-point terms and of their squares: no bit depends on the order.
// source: Kulisch 2002, Advanced Arithmetic for the Digital Computer, ch. 4: a long
//         accumulator in place of rounding.
// domain: terms of 64 bits and a sign, at most 2^62 of them.
// range:  exact; a term made of a real is its nearest multiple of 2^-scale, halves away from
//         zero, at most 2^64 - 1 of them.
// cost:   a term of a real 15, adding a term 40 integer instructions. tier I.
// hooks:  none.
// mirror: src/reference/sum.rs
#ifndef CORPUT_SUM_GLSL
#define CORPUT_SUM_GLSL

#include "corput/real.glsl"

// (negative ? -1 : 1) * m, in units of 2^-scale that all terms of a sum share.
struct CorputTerm {
    uvec2 m;
    bool negative;
};

// Sum of terms, 128 bits in two's complement, and of their squares, 192 bits.
struct CorputSum {
    uvec4 total;
    uvec4 squares;
    uvec2 squares_high;
};

// The sum of nothing.
CorputSum corput_sum_zero() {
    return CorputSum(uvec4(0u), uvec4(0u), uvec2(0u));
}

// a in units of 2^-scale, for scales within +-2^29.
CorputTerm corput_term(CorputReal a, int scale) {
    // a.m, from 2^31 on, times 2^place.
    int place = a.e + scale;
    uvec2 left = corput_shl64(uvec2(a.m, 0u), uint(clamp(place, 0, 32)));
    // One bit more than is kept, to round by.
    uint right = a.m >> uint(clamp(-1 - place, 0, 31));
    uvec2 m = left;
    if (place < 0) {
        m = uvec2((right >> 1) + (right & 1u), 0u);
    }
    if (place < -32) {
        m = uvec2(0u);
    }
    if (place > 32) {
        m = uvec2(0u - uint(a.m != 0u));
    }
    return CorputTerm(m, a.negative);
}

// The sum with one term more.
CorputSum corput_sum_add(CorputSum sum, CorputTerm term) {
    uint flip = 0u - uint(term.negative);
    // Of -m the complement, and one more.
    uvec2 low = corput_addc(term.m.x ^ flip, flip & 1u);
    uvec2 w0 = corput_addc(sum.total.x, low.x);
    uvec2 high = corput_addc(term.m.y ^ flip, low.y + w0.y);
    uvec2 w1 = corput_addc(sum.total.y, high.x);
    uvec2 sign = corput_addc(flip, high.y + w1.y);
    uvec2 w2 = corput_addc(sum.total.z, sign.x);
    uint w3 = sum.total.w + flip + sign.y + w2.y;

    uvec2 outer = corput_mul64(term.m.x, term.m.x);
    uvec2 cross = corput_mul64(term.m.x, term.m.y);
    uvec2 inner = corput_mul64(term.m.y, term.m.y);
    // Words of the square; the cross product counts twice.
    uvec2 s1 = corput_addc(outer.y, cross.x << 1);
    uvec2 s2 = corput_addc(inner.x, (cross.y << 1) | (cross.x >> 31));
    uvec2 t2 = corput_addc(s2.x, s1.y);
    uint s3 = inner.y + (cross.y >> 31) + s2.y + t2.y;
    uvec2 q0 = corput_addc(sum.squares.x, outer.x);
    uvec2 c1 = corput_addc(sum.squares.y, q0.y);
    uvec2 q1 = corput_addc(c1.x, s1.x);
    uvec2 c2 = corput_addc(sum.squares.z, c1.y + q1.y);
    uvec2 q2 = corput_addc(c2.x, t2.x);
    uvec2 c3 = corput_addc(sum.squares.w, c2.y + q2.y);
    uvec2 q3 = corput_addc(c3.x, s3);
    uvec2 q4 = corput_addc(sum.squares_high.x, c3.y + q3.y);
    return CorputSum(uvec4(w0.x, w1.x, w2.x, w3), uvec4(q0.x, q1.x, q2.x, q3.x), uvec2(q4.x, sum.squares_high.y + q4.y));
}

#endif
