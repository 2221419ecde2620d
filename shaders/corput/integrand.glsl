// what:   integrands of one to three dimensions, for estimators: x^2, an offset fraction,
//         1/sqrt(x), the disk's step, checkerboards, Ishigami's function.
// source: Ishigami and Homma 1990; the others by their formulas.
// domain: x a fraction u of 2^32, x = u 2^-32; in 1/sqrt(x) the middle of its cell.
// range:  x^2, offsets and steps are exact; reals within 2^-28 of the integrand's peak.
// cost:   x^2 1, a step 5, 1/sqrt(x) 120, Ishigami 250 integer instructions. tier I.
// hooks:  none.
// mirror: src/reference/integrand.rs
#ifndef CORPUT_INTEGRAND_GLSL
#define CORPUT_INTEGRAND_GLSL

#include "corput/sum.glsl"

// x^2 in units of 2^-64.
CorputTerm corput_x_squared(uint u) {
    return CorputTerm(corput_mul64(u, u), false);
}

// offset + x in units of 2^-32.
CorputTerm corput_offset_fraction(uint u, uint offset) {
    return CorputTerm(uvec2(u, offset), false);
}

// 1 or 0 in units of 1.
CorputTerm corput_indicator(bool inside) {
    return CorputTerm(uvec2(uint(inside), 0u), false);
}

// 1/sqrt(x), for x = (u + 1/2) 2^-32.
CorputReal corput_inverse_root(uint u) {
    CorputReal x = corput_real_wide(uvec2((u << 1) | 1u, u >> 31), -33);
    return corput_real_divide(corput_real_uint(1u, 0), corput_real_sqrt(x));
}

// Whether x^2 + y^2 < 1.
bool corput_disk_step(uvec2 u) {
    uvec2 xx = corput_mul64(u.x, u.x);
    uvec2 yy = corput_mul64(u.y, u.y);
    uvec2 low = corput_addc(xx.x, yy.x);
    uvec2 carried = corput_addc(xx.y, low.y);
    return (carried.y | corput_addc(carried.x, yy.y).y) == 0u;
}

// The number of x's cell among so many, of which the parities of all axes together make
// the colour.
uint corput_checkerboard_cell(uint u, uint cells) {
    return corput_mulhi(u, cells);
}

// sin(2 pi u) of a fraction of 2^32.
CorputReal corput_turns_sine(uint u) {
    CorputSinCos angle = corput_sincos_scaled(u);
    return corput_real_scaled(angle.sine, angle.sine_negative);
}

// sin t_1 + a sin^2 t_2 + b t_3^4 sin t_1, for t = pi (2 x - 1) and b_pi = b pi^4.
CorputReal corput_ishigami(uvec3 u, CorputReal a, CorputReal b_pi) {
    // sin(t) = -sin(t + pi).
    CorputReal first = corput_real_negate(corput_turns_sine(u.x));
    CorputReal second = corput_turns_sine(u.y);
    uint above = uint(u.z >= 0x80000000u);
    uint distance = ((u.z - 0x80000000u) & (0u - above)) | ((0x80000000u - u.z) & (above - 1u));
    CorputReal square = corput_real_square(corput_real_uint(distance, -31));
    CorputReal factor = corput_real_add(corput_real_uint(1u, 0),
        corput_real_multiply(b_pi, corput_real_square(square)));
    return corput_real_add(corput_real_multiply(first, factor),
        corput_real_multiply(a, corput_real_square(second)));
}

#endif
