// what:   draws of four dimensions of the Halton sequence from a domain, randomised.
// source: Owen 2017, A randomized Halton algorithm in R; the sources of
//         "corput/scrambled_radical_inverse.glsl".
// domain: every domain.
// range:  fractions of 2^32, truncated. Good in all four dimensions together; prefixes that
//         are multiples of the bases' powers are stratified in their boxes.
// cost:   four nested scrambled radical inverses.
// hooks:  CORPUT_PRIME(d): the d-th prime, d = 0 is 2; for d from 0 to 3.
// mirror: src/reference/domain_halton.rs
#ifndef CORPUT_DOMAIN_HALTON_GLSL
#define CORPUT_DOMAIN_HALTON_GLSL

#ifndef CORPUT_PRIME
#error define CORPUT_PRIME(d), the d-th prime, before this header; corput/primes.glsl has corput_prime(d)
#endif

#include "corput/domain.glsl"
#include "corput/scrambled_radical_inverse.glsl"

// Nested permutations of the digits in the first four primes.
uvec4 corput_draw_halton(CorputDomain domain) {
    uint n = domain.index;
    return uvec4(
        corput_radical_inverse_owen(n, CORPUT_PRIME(0u), corput_domain_seed(domain, 0u)),
        corput_radical_inverse_owen(n, CORPUT_PRIME(1u), corput_domain_seed(domain, 1u)),
        corput_radical_inverse_owen(n, CORPUT_PRIME(2u), corput_domain_seed(domain, 2u)),
        corput_radical_inverse_owen(n, CORPUT_PRIME(3u), corput_domain_seed(domain, 3u)));
}

// The same with one permutation per place of a digit.
uvec4 corput_draw_halton_permuted(CorputDomain domain) {
    uint n = domain.index;
    return uvec4(
        corput_radical_inverse_permuted(n, CORPUT_PRIME(0u), corput_domain_seed(domain, 0u)),
        corput_radical_inverse_permuted(n, CORPUT_PRIME(1u), corput_domain_seed(domain, 1u)),
        corput_radical_inverse_permuted(n, CORPUT_PRIME(2u), corput_domain_seed(domain, 2u)),
        corput_radical_inverse_permuted(n, CORPUT_PRIME(3u), corput_domain_seed(domain, 3u)));
}

// The same from a random start, which costs least.
uvec4 corput_draw_halton_started(CorputDomain domain) {
    uint n = domain.index;
    return uvec4(
        corput_radical_inverse_started(n, CORPUT_PRIME(0u), corput_domain_seed(domain, 0u)),
        corput_radical_inverse_started(n, CORPUT_PRIME(1u), corput_domain_seed(domain, 1u)),
        corput_radical_inverse_started(n, CORPUT_PRIME(2u), corput_domain_seed(domain, 2u)),
        corput_radical_inverse_started(n, CORPUT_PRIME(3u), corput_domain_seed(domain, 3u)));
}

#endif
