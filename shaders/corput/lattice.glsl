// what:   rank-1 lattices: an embedded sequence in base 2, Korobov sets, and additive
//         recurrences; a rotation randomises any of them.
// source: Hickernell, Hong, L'Ecuyer and Lemieux 2000, Extensible lattice sequences for
//         quasi-Monte Carlo quadrature, SIAM J. Sci. Comput. 22; Korobov 1960; Roberts 2018,
//         The unreasonable effectiveness of quasirandom sequences (R2); Cranley and
//         Patterson 1976, Randomization of number theoretic methods.
// domain: every n unless a function says otherwise.
// range:  fractions of 2^32.
// cost:   2 to 5 instructions; Korobov sets two long divisions of 32 steps.
// hooks:  none.
// mirror: src/reference/lattice.rs
#ifndef CORPUT_LATTICE_GLSL
#define CORPUT_LATTICE_GLSL

#include "corput/fixed.glsl"
#include "corput/hammersley.glsl"

// A coordinate of point n of a lattice sequence: frac(phi_2(n) z), exact. For odd z each
// 2^k points from a multiple of 2^k on hold one of each interval of width 2^-k.
uint corput_lattice(uint n, uint z) {
    return corput_reverse_bits(n) * z;
}

// A coordinate of point n < count of a lattice of `count` points: ceil(2^32 k / count) with
// k = n z mod count, at most 2^32 - 1. z < count; count = 2^32 is written as 0.
uint corput_korobov(uint n, uint z, uint count) {
    uvec2 product = corput_mul64(n, z);
    if (count == 0u) {
        return product.x;
    }
    // The high word is below `count`, and is the first remainder.
    uint remainder = product.y;
    for (uint i = 0u; i < 32u; i++) {
        bool carry = (remainder >> 31) != 0u;
        remainder = (remainder << 1) | (product.x >> 31);
        product.x <<= 1;
        if (carry || remainder >= count) {
            remainder -= count;
        }
    }
    return corput_hammersley(remainder, count);
}

// A coordinate of point n of an additive recurrence: floor(2^32 frac(1/2 + n alpha)), exact
// for alpha as a fraction of 2^64 (x low, y high).
uint corput_additive(uint n, uvec2 alpha) {
    return n * alpha.y + corput_mulhi(n, alpha.x) + 0x80000000u;
}

// u moved by `shift` around the circle (Cranley and Patterson).
uint corput_rotate(uint u, uint shift) {
    return u + shift;
}

#endif
