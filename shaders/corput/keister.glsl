// what:   integrands over normal distributions, dimension by dimension by quantiles:
//         Keister's, and a Gaussian peak by importance sampling.
// source: Keister 1996, Multidimensional quadrature algorithms, Computers in Physics 10(2);
//         Genz 1984 for the peak.
// domain: fractions of 2^32, of which quantiles take the midpoints; a centre w, a fraction of
//         2^32, and a width above 0.
// range:  each sum is cut by 2^-30 of itself: of 20 dimensions the cosine is within 2e-7, at
//         the ends, where the sum is 800.
// cost:   300 integer instructions a dimension. tier I.
// hooks:  none.
// mirror: src/reference/keister.rs
#ifndef CORPUT_KEISTER_GLSL
#define CORPUT_KEISTER_GLSL

#include "corput/integrand.glsl"
#include "corput/normal_quantile.glsl"

// sum + z^2.
CorputReal corput_keister_square(CorputReal sum, uint u) {
    return corput_real_add(sum, corput_real_square(corput_real_normal_quantile(u)));
}

// cos(sqrt(sum / 2)).
CorputReal corput_keister_cosine(CorputReal sum) {
    CorputReal root = corput_real_sqrt(corput_real_shift(sum, -1));
    // 1/(2 pi) to 32 bits.
    CorputReal turns = corput_real_multiply(root, corput_real_uint(2734261102u, -34));
    uint whole = turns.m << uint(clamp(turns.e + 32, 0, 31));
    uint part = turns.m >> uint(clamp(-32 - turns.e, 0, 31));
    uint phase = part;
    if (turns.e > -32) {
        phase = whole;
    }
    return corput_turns_sine(phase + 0x40000000u);
}

// 1 where centre + width z lies outside [0, 1), else 0.
uint corput_peak_outside(uint u, uint centre, CorputReal width) {
    CorputReal x = corput_real_multiply(width, corput_real_normal_quantile(u));
    x = corput_real_add(corput_real_uint(centre, -32), x);
    return uint(x.negative) | uint(!corput_real_less(x, corput_real_uint(1u, 0)));
}

#endif
