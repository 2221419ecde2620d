// what:   reals with a significand of 64 bits, for sums of products that cancel:
//         determinants, vector products.
// source: Kahan 2004, On the cost of floating-point computation without extra-precise
//         arithmetic, has the reason; here the precision is there.
// domain: as real.glsl.
// range:  a product of reals is exact; a sum is within 2^-62 of its larger operand.
// cost:   a product 10, a sum 40, a vector product 330, a triple product 500 integer
//         instructions. tier I.
// hooks:  none.
// mirror: src/reference/wide.rs
#ifndef CORPUT_WIDE_GLSL
#define CORPUT_WIDE_GLSL

#include "corput/real_vector.glsl"

// (negative ? -1 : 1) * m * 2^e: bit 63 of m is set, or all of it is 0.
struct CorputWide {
    uvec2 m;
    int e;
    bool negative;
};

// (negative ? -1 : 1) * m * 2^e, for any m.
CorputWide corput_wide(uvec2 m, int e, bool negative) {
    uvec2 rest = m;
    int exponent = e;
    if (rest.y == 0u) {
        rest = uvec2(0u, rest.x);
        exponent -= 32;
    }
    if (rest.y == 0u) {
        return CorputWide(uvec2(0u), 0, false);
    }
    uint shift = 31u - corput_find_msb(rest.y);
    return CorputWide(corput_shl64(rest, shift), exponent - int(shift), negative);
}

// a * b, exactly.
CorputWide corput_wide_product(CorputReal a, CorputReal b) {
    return corput_wide(corput_mul64(a.m, b.m), a.e + b.e, a.negative != b.negative);
}

// a * b.
CorputWide corput_wide_multiply(CorputWide a, CorputReal b) {
    uvec2 low = corput_mul64(a.m.x, b.m);
    uvec2 product = corput_add64(corput_mul64(a.m.y, b.m), uvec2(low.y, 0u));
    return corput_wide(product, a.e + b.e + 32, a.negative != b.negative);
}

// Whether |a| < |b|.
bool corput_wide_smaller(CorputWide a, CorputWide b) {
    if (a.m.y == 0u || b.m.y == 0u) {
        return b.m.y != 0u;
    }
    if (a.e != b.e) {
        return a.e < b.e;
    }
    return a.m.y < b.m.y || (a.m.y == b.m.y && a.m.x < b.m.x);
}

// a + b.
CorputWide corput_wide_add(CorputWide a, CorputWide b) {
    CorputWide large = a;
    CorputWide small = b;
    if (corput_wide_smaller(a, b)) {
        large = b;
        small = a;
    }
    if (small.m.y == 0u) {
        return large;
    }
    uvec2 shifted = corput_shr64(small.m, uint(min(large.e - small.e, 63)));
    if (large.negative != small.negative) {
        return corput_wide(corput_sub64(large.m, shifted), large.e, large.negative);
    }
    uvec2 sum = corput_add64(large.m, shifted);
    if (sum.y < large.m.y || (sum.y == large.m.y && sum.x < large.m.x)) {
        sum = corput_shr64(sum, 1u);
        return CorputWide(uvec2(sum.x, sum.y | 0x80000000u), large.e + 1, large.negative);
    }
    return CorputWide(sum, large.e, large.negative);
}

// a * d - b * c.
CorputWide corput_wide_determinant(CorputReal a, CorputReal b, CorputReal c, CorputReal d) {
    return corput_wide_add(corput_wide_product(a, d), corput_wide_product(corput_real_negate(b), c));
}

// a cut to 32 significant bits.
CorputReal corput_wide_real(CorputWide a) {
    if (a.m.y == 0u) {
        return corput_real_zero();
    }
    return CorputReal(a.m.y, a.e + 32, a.negative);
}

// The vector product of v and w, each component within 2^-31 of itself where the products
// cancel by 31 bits at most.
CorputReal3 corput_wide_cross(CorputReal3 v, CorputReal3 w) {
    return CorputReal3(corput_wide_real(corput_wide_determinant(v.y, v.z, w.y, w.z)),
        corput_wide_real(corput_wide_determinant(v.z, v.x, w.z, w.x)),
        corput_wide_real(corput_wide_determinant(v.x, v.y, w.x, w.y)));
}

// The scalar product of u with the vector product of v and w.
CorputReal corput_wide_triple(CorputReal3 u, CorputReal3 v, CorputReal3 w) {
    CorputWide x = corput_wide_multiply(corput_wide_determinant(v.y, v.z, w.y, w.z), u.x);
    CorputWide y = corput_wide_multiply(corput_wide_determinant(v.z, v.x, w.z, w.x), u.y);
    CorputWide z = corput_wide_multiply(corput_wide_determinant(v.x, v.y, w.x, w.y), u.z);
    return corput_wide_real(corput_wide_add(corput_wide_add(x, y), z));
}

#endif
