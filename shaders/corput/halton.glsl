// what:   the Halton sequence: dimension d is the radical inverse in the d-th prime.
// source: Halton 1960, On the efficiency of certain quasi-random sequences of points in
//         evaluating multi-dimensional integrals, Numer. Math. 2.
// domain: every index; dimensions for which CORPUT_PRIME is defined.
// range:  fractions of 2^32, each ceil(2^32 phi).
// cost:   that of the radical inverse.
// hooks:  CORPUT_PRIME(d): the d-th prime, d = 0 is 2. "corput/primes.glsl" has 1,024 of
//         them; an engine that needs three dimensions names three constants.
// mirror: src/reference/halton.rs
#ifndef CORPUT_HALTON_GLSL
#define CORPUT_HALTON_GLSL

#ifndef CORPUT_PRIME
#error define CORPUT_PRIME(d), the d-th prime, before this header; corput/primes.glsl has corput_prime(d)
#endif

#include "corput/radical_inverse.glsl"

// Coordinate `dimension` of point n, as a fraction of 2^32.
uint corput_halton(uint n, uint dimension) {
    return corput_radical_inverse(n, CORPUT_PRIME(dimension));
}

#endif
