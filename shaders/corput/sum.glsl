// what:   exact sums of fixed-point terms and of their squares: no bit depends on the order.
// source: Kulisch 2002, Advanced Arithmetic for the Digital Computer, ch. 4: a long
//         accumulator in place of rounding, and carries that wait in a redundant one.
// domain: terms of 64 bits and a sign, at most 2^62 of them; in a tally at most 2^16.
// range:  exact; a term made of a real is its nearest multiple of 2^-scale, halves away from
//         zero, at most 2^64 - 1 of them.
// cost:   a term of a real 15, adding a term 40 integer instructions, to a tally 45 of
//         which none waits for a carry; the sum of a tally 60. tier I.
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

// The float of these bits where its exponent is one of the 32 of a window of 8, in units of
// 2^(32 window - 150) and exact, denormals too; else 0, as infinities and NaN are.
CorputTerm corput_term_window(uint bits, uint window) {
    uint exponent = (bits >> 23) & 0xffu;
    uint m = bits & 0x7fffffu;
    if (exponent != 0u) {
        m |= 0x800000u;
    }
    uint place = max(exponent, 1u);
    if ((uint((place >> 5) != window) | uint(exponent == 255u)) != 0u) {
        m = 0u;
    }
    return CorputTerm(corput_shl64(uvec2(m, 0u), place & 31u), (bits >> 31) != 0u);
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

// Sums of up to 2^16 terms before any carry: place k of four has units of 2^(16 k).
struct CorputTally {
    // Of the lower 64 bits of each term in two's complement.
    uvec4 total;
    // Of the squares: those of the lower words, the products of both, those of the upper.
    uvec4 outer;
    uvec4 cross;
    uvec4 inner;
    uint negatives;
};

// The tally of nothing.
CorputTally corput_tally_zero() {
    return CorputTally(uvec4(0u), uvec4(0u), uvec4(0u), uvec4(0u), 0u);
}

// 64 bits in four places.
uvec4 corput_tally_places(uvec2 v) {
    return uvec4(v.x & 0xffffu, v.x >> 16, v.y & 0xffffu, v.y >> 16);
}

// The tally with one term more.
CorputTally corput_tally_add(CorputTally tally, CorputTerm term) {
    uint negative = uint(term.negative);
    uint flip = 0u - negative;
    // Of -m the complement; the one more is that of `negatives`.
    return CorputTally(tally.total + corput_tally_places(uvec2(term.m.x ^ flip, term.m.y ^ flip)),
        tally.outer + corput_tally_places(corput_mul64(term.m.x, term.m.x)),
        tally.cross + corput_tally_places(corput_mul64(term.m.x, term.m.y)),
        tally.inner + corput_tally_places(corput_mul64(term.m.y, term.m.y)),
        tally.negatives + negative);
}

// Four places carried: the lower three of four words.
uvec4 corput_tally_carried(uvec4 places) {
    uvec2 w0 = corput_addc(places.x, places.y << 16);
    uvec2 middle = corput_addc(places.z, (places.y >> 16) + w0.y);
    uvec2 w1 = corput_addc(middle.x, places.w << 16);
    return uvec4(w0.x, w1.x, (places.w >> 16) + middle.y + w1.y, 0u);
}

// What the terms of a tally come to.
CorputSum corput_tally_sum(CorputTally tally) {
    uvec4 t = corput_tally_carried(tally.total);
    uvec2 t0 = corput_addc(t.x, tally.negatives);
    uvec2 t1 = corput_addc(t.y, t0.y);
    // Each complement of 64 bits is 2^64 too much.
    uvec2 high = corput_sub64(uvec2(t.z + t1.y, 0u), uvec2(tally.negatives, 0u));
    uvec4 o = corput_tally_carried(tally.outer);
    uvec4 c = corput_tally_carried(tally.cross);
    uvec4 i = corput_tally_carried(tally.inner);
    // The cross products count twice, one word up.
    uvec2 s1 = corput_addc(o.y, c.x << 1);
    uvec2 a2 = corput_addc(o.z, i.x);
    uvec2 b2 = corput_addc((c.y << 1) | (c.x >> 31), s1.y);
    uvec2 s2 = corput_addc(a2.x, b2.x);
    uvec2 a3 = corput_addc((c.z << 1) | (c.y >> 31), i.y);
    uvec2 s3 = corput_addc(a3.x, a2.y + b2.y + s2.y);
    return CorputSum(uvec4(t0.x, t1.x, high.x, high.y), uvec4(o.x, s1.x, s2.x, s3.x), uvec2(i.z + a3.y + s3.y, 0u));
}

#endif
