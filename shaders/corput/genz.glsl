// what:   Genz's six families of integrands, Sobol's g and products of linear factors,
//         dimension by dimension: a term or factor for each, and what the sum or product of
//         them all gives.
// source: Genz 1984, Testing multidimensional integration routines; Saltelli and Sobol 1995;
//         Sobol and Asotsky 2003.
// domain: x = u 2^-32; coefficients as reals above 0, places w and phases as fractions of
//         2^32; dimensions to 64, of products of linear factors any number.
// range:  each step within 2^-29 of its result, a linear factor within 2^-29.9; a phase within
//         2^-32 of a turn a dimension.
// cost:   a step 5 to 100, an exponential at the end 60, a power 170 integer instructions.
//         tier I.
// hooks:  none.
// mirror: src/reference/genz.rs
#ifndef CORPUT_GENZ_GLSL
#define CORPUT_GENZ_GLSL

#include "corput/exponential.glsl"
#include "corput/integrand.glsl"

// Oscillatory: the phase with c x added, for c in turns, 32 bits of them a fraction.
uint corput_genz_phase(uint phase, uint u, uvec2 c) {
    return phase + c.y * u + corput_mulhi(c.x, u);
}

// cos of a phase.
CorputReal corput_genz_oscillation(uint phase) {
    return corput_turns_sine(phase + 0x40000000u);
}

// |x - w|.
CorputReal corput_genz_distance(uint u, uint w) {
    uint d = u - w;
    if (u < w) {
        d = w - u;
    }
    return corput_real_uint(d, -32);
}

// Product peak: product / (c^-2 + (x - w)^2), given c^-2.
CorputReal corput_genz_peak(CorputReal product, uint u, uint w, CorputReal width) {
    CorputReal square = corput_real_square(corput_genz_distance(u, w));
    return corput_real_divide(product, corput_real_add(width, square));
}

// Corner peak and discontinuous: sum + c x.
CorputReal corput_genz_linear(CorputReal sum, uint u, CorputReal c) {
    return corput_real_add(sum, corput_real_multiply(c, corput_real_uint(u, -32)));
}

// Corner peak: (1 + sum)^-(dimensions + 1).
CorputReal corput_genz_corner(CorputReal sum, uint dimensions) {
    CorputReal power = corput_real_negate(corput_real_uint(dimensions + 1u, 0));
    return corput_real_power(corput_real_add(sum, corput_real_uint(1u, 0)), power);
}

// Gaussian: sum + (c (x - w))^2.
CorputReal corput_genz_square(CorputReal sum, uint u, uint w, CorputReal c) {
    CorputReal distance = corput_real_multiply(c, corput_genz_distance(u, w));
    return corput_real_add(sum, corput_real_square(distance));
}

// Continuous: sum + c |x - w|.
CorputReal corput_genz_kink(CorputReal sum, uint u, uint w, CorputReal c) {
    return corput_real_add(sum, corput_real_multiply(c, corput_genz_distance(u, w)));
}

// Sobol's g: product (|4 x - 2| + a) / (1 + a), given a and 1 / (1 + a).
CorputReal corput_sobol_g(CorputReal product, uint u, CorputReal a, CorputReal share) {
    CorputReal factor = corput_real_add(corput_real_shift(corput_genz_distance(u, 0x80000000u), 2), a);
    return corput_real_multiply(product, corput_real_multiply(factor, share));
}

// Linear factors: product (1 + c (x - 1/2)), given 1 - c/2 and c.
CorputReal corput_linear_factor(CorputReal product, uint u, CorputReal least, CorputReal c) {
    return corput_real_multiply(product, corput_genz_linear(least, u, c));
}

#endif
