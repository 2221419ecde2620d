// what:   angles as reals, and back, with all their digits however small they are.
// source: the polynomials of elementary.glsl, in the tangent and the angle as reals.
// domain: as each function says; angles in turns.
// range:  as each function says.
// errors: relative to the result: angle 2^-28, sine 2^-29 up to an eighth of a turn, beyond
//         it 2^-29 absolutely.
// cost:   angle 190, sine 60 integer instructions. tier I.
// hooks:  none.
// mirror: src/reference/angle.rs
#ifndef CORPUT_ANGLE_GLSL
#define CORPUT_ANGLE_GLSL

#include "corput/real.glsl"

// The angle of (x, y) from +x, for y >= 0: 0 to 1/2; 0 for (0, 0).
CorputReal corput_angle(CorputReal y, CorputReal x) {
    CorputReal width = CorputReal(x.m, x.e, false);
    bool steep = corput_real_less(width, y);
    CorputReal tangent = corput_real_divide(y, width);
    if (steep) {
        tangent = corput_real_divide(width, y);
    }
    uint w = corput_square31(corput_real_fraction(tangent) >> 1);
    CorputReal turns = corput_real_multiply(tangent, corput_real_uint(corput_atan_polynomial(w), -34));
    if (y.m == 0u) {
        turns = corput_real_zero();
    }
    if (steep) {
        turns = corput_real_subtract(corput_real_uint(1u, -2), turns);
    }
    if (x.negative) {
        turns = corput_real_subtract(corput_real_uint(1u, -1), turns);
    }
    return turns;
}

// The sine of an angle from 0 to 1/4.
CorputReal corput_angle_sine(CorputReal turns) {
    if (corput_real_less(corput_real_uint(1u, -3), turns)) {
        CorputReal rest = corput_real_subtract(corput_real_uint(1u, -2), turns);
        uint w = corput_square31(corput_real_fraction(corput_real_shift(rest, 3)) >> 1);
        return corput_real_uint(corput_cos_polynomial(w), -32);
    }
    CorputReal eighths = corput_real_shift(turns, 3);
    uint w = corput_square31(corput_real_fraction(eighths) >> 1);
    return corput_real_multiply(eighths, corput_real_uint(corput_sin_polynomial(w), -32));
}

// The sine of an angle from 0 to 1/2, given it and what it lacks of 1/2.
CorputReal corput_angle_sine_half(CorputReal turns, CorputReal rest) {
    return corput_angle_sine(corput_real_min(turns, rest));
}

// The cosine of an angle from 0 to 1/2.
CorputReal corput_angle_cosine(CorputReal turns) {
    CorputReal rest = corput_real_subtract(corput_real_uint(1u, -2), turns);
    if (rest.negative) {
        return corput_real_negate(corput_angle_sine(corput_real_negate(rest)));
    }
    return corput_angle_sine(rest);
}

#endif
