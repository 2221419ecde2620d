// what:   draws of four dimensions of the Sobol sequence from a domain.
// source: Burley 2020, Practical hash-based Owen scrambling: a shuffled index decorrelates
//         the draws of different domains; Owen 1995 for the exact scramble.
// domain: every domain.
// range:  fractions of 2^32, good in all four dimensions together. Prefixes of 2^k indices
//         come from aligned blocks of as many points, hence are digital nets.
// cost:   128 lookups of the hook and 5 hash scrambles; 25 Philox blocks in the exact form.
// hooks:  CORPUT_SOBOL_DIRECTION(dimension, bit) for dimensions 0 to 3, see
//         "corput/sobol.glsl".
// mirror: src/reference/domain_sobol.rs
#ifndef CORPUT_DOMAIN_SOBOL_GLSL
#define CORPUT_DOMAIN_SOBOL_GLSL

#ifndef CORPUT_SOBOL_DIRECTION
#error define CORPUT_SOBOL_DIRECTION(dimension, bit) before this header; corput/sobol_directions.glsl has corput_sobol_direction(dimension, bit)
#endif

#include "corput/domain.glsl"
#include "corput/owen.glsl"
#include "corput/sobol.glsl"

// Shuffled and scrambled by the fast hash.
uvec4 corput_draw_sobol(CorputDomain domain) {
    uint n = corput_owen_hash(domain.index, corput_domain_seed(domain, 0u));
    return uvec4(corput_owen_hash(corput_sobol(n, 0u), corput_domain_seed(domain, 1u)),
        corput_owen_hash(corput_sobol(n, 1u), corput_domain_seed(domain, 2u)),
        corput_owen_hash(corput_sobol(n, 2u), corput_domain_seed(domain, 3u)),
        corput_owen_hash(corput_sobol(n, 3u), corput_domain_seed(domain, 4u)));
}

// Shuffled and scrambled exactly.
uvec4 corput_draw_sobol_owen(CorputDomain domain) {
    uint n = corput_owen(domain.index, 4u, domain.pattern);
    return uvec4(corput_owen(corput_sobol(n, 0u), 0u, domain.pattern),
        corput_owen(corput_sobol(n, 1u), 1u, domain.pattern),
        corput_owen(corput_sobol(n, 2u), 2u, domain.pattern),
        corput_owen(corput_sobol(n, 3u), 3u, domain.pattern));
}

#endif
