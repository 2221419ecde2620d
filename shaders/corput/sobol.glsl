// what:   the Sobol sequence: coordinates are sums modulo 2 of direction numbers.
// source: Sobol 1967, On the distribution of points in a cube and the approximate
//         evaluation of integrals; Antonov and Saleev 1979 for the order by Gray code.
//         Scrambles are in "corput/owen.glsl".
// domain: every index; dimensions for which CORPUT_SOBOL_DIRECTION is defined.
// range:  fractions of 2^32, exact: 2^32 points, none twice. Every prefix of 2^k points,
//         and every aligned block of as many, is a digital net.
// cost:   32 lookups of the hook, which fold where it is a constant.
// hooks:  CORPUT_SOBOL_DIRECTION(dimension, bit): what bit `bit` of the index contributes.
//         "corput/sobol_directions.glsl" has those of 64 dimensions by Joe and Kuo.
// mirror: src/reference/sobol.rs
#ifndef CORPUT_SOBOL_GLSL
#define CORPUT_SOBOL_GLSL

#ifndef CORPUT_SOBOL_DIRECTION
#error define CORPUT_SOBOL_DIRECTION(dimension, bit) before this header; corput/sobol_directions.glsl has corput_sobol_direction(dimension, bit)
#endif

// The index whose point stands at place n of the order by Gray code, in which neighbours
// differ in one direction number. The first 2^k places hold the first 2^k points.
uint corput_gray(uint n) {
    return n ^ (n >> 1);
}

// Coordinate `dimension` of point n, as a fraction of 2^32.
uint corput_sobol(uint n, uint dimension) {
    uint x = 0u;
    for (uint bit = 0u; bit < 32u; bit++) {
        x ^= ((n >> bit) & 1u) != 0u ? CORPUT_SOBOL_DIRECTION(dimension, bit) : 0u;
    }
    return x;
}

#endif
