// what:   a progressive multi-jittered (0,2) sequence: the first two dimensions of the
//         Sobol sequence, shuffled and scrambled by nested uniform permutations.
// source: Christensen, Kensler and Kilpatrick 2018, Progressive multi-jittered sample
//         sequences, for the class; Helmer, Christensen and Kensler 2021, Stochastic
//         generation of (t, s) sample sequences, that scrambling a (0,2) sequence gives
//         it; Burley 2020, Practical hash-based Owen scrambling, for the shuffle.
// domain: every index; every seed.
// range:  fractions of 2^32. Every prefix of 2^k points, and every aligned block of as
//         many, has one point in each elementary interval of area 2^-k.
// cost:   15 Philox blocks, 5 for each of the three scrambles.
// hooks:  none.
// mirror: src/reference/pmj02.rs
#ifndef CORPUT_PMJ02_GLSL
#define CORPUT_PMJ02_GLSL

#include "corput/bits.glsl"
#include "corput/owen.glsl"

// The first two coordinates of point n of the Sobol sequence, without a table: bits in
// reverse, and those times Pascal's triangle modulo 2.
uvec2 corput_sobol_pair(uint n) {
    uint x = corput_reverse_bits(n);
    // Rows of the triangle fold like the halves of Sierpinski's.
    uint y = n;
    y ^= y >> 16;
    y ^= (y & 0xff00ff00u) >> 8;
    y ^= (y & 0xf0f0f0f0u) >> 4;
    y ^= (y & 0xccccccccu) >> 2;
    y ^= (y & 0xaaaaaaaau) >> 1;
    return uvec2(x, corput_reverse_bits(y));
}

// Nested uniform scrambling in numbers of its own, so that a Sobol sequence scrambled with
// the same seed has other points: of coordinate 0 or 1, or of the index, which is 2.
uint corput_pmj02_scramble(uint x, uint which, uvec2 seed) {
    return corput_owen(x, 0x80000000u | which, seed);
}

// Where point n stands in the Sobol sequence: a prefix of 2^k points comes from an
// aligned block of as many.
uint corput_pmj02_index(uint n, uvec2 seed) {
    return corput_pmj02_scramble(n, 2u, seed);
}

// Point n.
uvec2 corput_pmj02(uint n, uvec2 seed) {
    uvec2 p = corput_sobol_pair(corput_pmj02_index(n, seed));
    return uvec2(corput_pmj02_scramble(p.x, 0u, seed), corput_pmj02_scramble(p.y, 1u, seed));
}

#endif
