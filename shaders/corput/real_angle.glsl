// what:   angles of reals, their sines and cosines, and fractions of 2^32.
// source: the polynomials of elementary.glsl, in the tangent and the angle as reals; its atan2.
// domain: any reals, or as a function says; angles in turns.
// range:  as each function says.
// errors: a fraction of a turn 2.5 * 2^-32; relative to the result, however small: an angle
//         2^-28, a sine 2^-29 up to an eighth of a turn, beyond it 2^-29 absolutely.
// cost:   a fraction of a turn 80, an angle 190, a sine 60 integer instructions. tier I.
// hooks:  none.
// mirror: src/reference/real_angle.rs
#ifndef CORPUT_REAL_ANGLE_GLSL
#define CORPUT_REAL_ANGLE_GLSL

#include "corput/real.glsl"

// 1 - u, for u a fraction of 2^32: from 2^-32 to 1, exactly.
CorputReal corput_real_complement(uint u) {
    if (u == 0u) {
        return corput_real_uint(1u, 0);
    }
    return corput_real_uint(0u - u, -32);
}

// The fraction of 2^32 nearest to a, from 0 to 2^32 - 1.
uint corput_real_fraction_nearest(CorputReal a) {
    return corput_real_fraction(corput_real_add(a, corput_real_uint(1u, -33)));
}

// The fraction of 2^32 nearest to a, where b = 1 - a: from the smaller, so that either end is
// exact.
uint corput_real_fraction_of(CorputReal a, CorputReal b) {
    if (corput_real_less(a, b)) {
        return corput_real_fraction_nearest(a);
    }
    return 0u - max(corput_real_fraction_nearest(b), 1u);
}

// Angle of (x, y) in turns, counter-clockwise from +x, as a fraction of 2^32; 0 for (0, 0).
uint corput_real_turns(CorputReal y, CorputReal x) {
    CorputReal large = x;
    CorputReal small = y;
    if (corput_real_smaller(x, y)) {
        large = y;
        small = x;
    }
    // Both on the scale of the larger, at most 2^31: what is shifted out is below 2^-31.
    uint angle = 0u;
    if (small.m != 0u) {
        uint shift = uint(min(large.e - small.e, 30)) + 1u;
        angle = corput_atan_ratio(small.m >> shift, large.m >> 1);
    }
    if (corput_real_smaller(x, y)) {
        angle = 0x40000000u - angle;
    }
    if (x.negative) {
        angle = 0x80000000u - angle;
    }
    if (y.negative) {
        angle = 0u - angle;
    }
    return angle;
}

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
