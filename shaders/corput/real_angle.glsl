// what:   angles and complements of reals: the turns of a point, and the fraction of two
//         numbers that sum to 1.
// source: atan2 of elementary.glsl.
// domain: any reals.
// errors: an angle 2.5 * 2^-32 of a turn.
// cost:   80 integer instructions. tier I.
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

// The fraction of 2^32 nearest to a, where b = 1 - a: from the smaller, so that either end is
// exact.
uint corput_real_fraction_of(CorputReal a, CorputReal b) {
    CorputReal half_unit = corput_real_uint(1u, -33);
    if (corput_real_less(a, b)) {
        return corput_real_fraction(corput_real_add(a, half_unit));
    }
    return 0u - max(corput_real_fraction(corput_real_add(b, half_unit)), 1u);
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

#endif
