// what:   scrambled Halton sequences: dimension d is a scrambled radical inverse in the d-th
//         prime, which keeps the high bases from lining up.
// source: as corput/scrambled_radical_inverse.glsl; Halton 1960.
// domain: every index; dimensions for which CORPUT_PRIME is defined.
// range:  fractions of 2^32, as the radical inverses have them.
// cost:   that of the radical inverse.
// hooks:  CORPUT_PRIME(d): the d-th prime, d = 0 is 2.
// mirror: src/reference/halton_scrambled.rs
#ifndef CORPUT_HALTON_SCRAMBLED_GLSL
#define CORPUT_HALTON_SCRAMBLED_GLSL

#ifndef CORPUT_PRIME
#error define CORPUT_PRIME(d), the d-th prime, before this header; corput/primes.glsl has corput_prime(d)
#endif

#include "corput/scrambled_radical_inverse.glsl"

// Coordinate `dimension` of point n with Faure's permutations.
uint corput_halton_faure(uint n, uint dimension) {
    return corput_radical_inverse_faure(n, CORPUT_PRIME(dimension));
}

// The same with a random permutation per position of a digit; dimensions may share a seed.
uint corput_halton_permuted(uint n, uint dimension, uint seed) {
    return corput_radical_inverse_permuted(n, CORPUT_PRIME(dimension), seed);
}

// The same with nested (Owen) scrambling; dimensions may share a seed.
uint corput_halton_owen(uint n, uint dimension, uint seed) {
    return corput_radical_inverse_owen(n, CORPUT_PRIME(dimension), seed);
}

// The same from a random start; dimensions may share a seed.
uint corput_halton_started(uint n, uint dimension, uint seed) {
    return corput_radical_inverse_started(n, CORPUT_PRIME(dimension), seed);
}

#endif
