// what:   directions of a cone around +z, uniformly, with pdf and inverse.
// source: PBRT 4th ed., A.5.4, in terms of h = 1 - cos(theta_max) = 2 sin^2(theta_max/2)
//         rather than of the cosine, whose float has no digits of a thin cone: 1 - z = u h,
//         radius = sqrt(u h (2 - u h)).
// domain: h from 0 to 2 (the sphere), two fractions of 2^32. h <= 0 gives +z, with pdf 0; h > 2
//         counts as 2; a NaN as an infinity of its sign.
// range:  unit vectors to 2^-23.
// pdf:    with respect to solid angle: 1/(2 pi h) inside. The edge is widened by 2^-21 of
//         h, so that no sample falls outside by its rounding.
// errors: 0.6 ULP a coordinate, for every h; pdf 0.51 ULP. The inverse agrees with the
//         sample to 2^-21 in u.x and, seen from the axis, to 2^-23 in u.y. On the axis the
//         angle is lost.
// cost:   about 250 integer instructions. tier I.
// hooks:  none.
// mirror: src/reference/cone.rs
#ifndef CORPUT_CONE_GLSL
#define CORPUT_CONE_GLSL

#include "corput/sphere.glsl"

// h within its domain.
CorputReal corput_cone_height(float h) {
    uint bits = floatBitsToUint(h);
    if (bits >= 0x80000000u) {
        return corput_real_zero();
    }
    return corput_real(uintBitsToFloat(min(bits, 0x40000000u)));
}

// floor(u h * 2^63), for h up to 2 and a fraction u.
uvec2 corput_cone_versine(CorputReal h, uint u) {
    uvec2 product = corput_mul64(u, h.m);
    if (h.e > -31) {
        return corput_shl64(product, 1u);
    }
    return corput_shr64(product, uint(min(-31 - h.e, 63)));
}

// Uniform direction for h: 1 - z = u.x h, phi = 2 pi u.y.
CorputReal3 corput_cone_around(CorputReal h, uvec2 u) {
    CorputReal versine = corput_real_multiply(corput_real_uint(u.x, -32), h);
    // In fixed point 1 - z and 2 - (1 - z) lose nothing where they cancel.
    uvec2 fixed_versine = corput_cone_versine(h, u.x);
    CorputReal rest = corput_real_uint(2u, 0);
    if ((fixed_versine.x | fixed_versine.y) != 0u) {
        rest = corput_real_wide(corput_sub64(uvec2(0u), fixed_versine), -63);
    }
    uvec2 cosine = corput_sub64(uvec2(0u, 0x80000000u), fixed_versine);
    CorputReal z = corput_real_wide(cosine, -63);
    if (fixed_versine.y >= 0x80000000u) {
        z = corput_real_negate(corput_real_wide(corput_sub64(uvec2(0u), cosine), -63));
    }
    return corput_sphere_direction(corput_real_sqrt(corput_real_multiply(versine, rest)), u.y, z);
}

// 1/(2 pi h); 0 for h = 0.
CorputReal corput_cone_density(CorputReal h) {
    if (h.m == 0u) {
        return h;
    }
    return corput_real_divide(corput_real_uint(2734261102u, -34), h);
}

// Whether a direction lies within the cone of h, by 2^-21 of its distance to the poles.
bool corput_cone_inside(CorputReal h, CorputReal3 direction) {
    CorputReal z = direction.z;
    CorputReal square = corput_real_add(corput_real_square(direction.x), corput_real_square(direction.y));
    if (z.negative) {
        CorputReal rest = corput_real_subtract(corput_real_uint(2u, 0), h);
        CorputReal least = corput_real_multiply(rest, corput_real_uint(2097151u, -21));
        return !corput_real_less(corput_sphere_versine(square, corput_real_negate(z)), least);
    }
    CorputReal most = corput_real_multiply(h, corput_real_uint(2097153u, -21));
    return !corput_real_less(most, corput_sphere_versine(square, z));
}

// The fractions that give this direction for h.
uvec2 corput_cone_around_invert(CorputReal h, CorputReal3 direction) {
    CorputReal z = direction.z;
    CorputReal square = corput_real_add(corput_real_square(direction.x), corput_real_square(direction.y));
    uint turn = corput_real_turns(direction.y, direction.x);
    if (z.negative) {
        // 1 - u, by the distance to -z.
        CorputReal rest = corput_sphere_versine(square, corput_real_negate(z));
        CorputReal left = corput_real_subtract(rest, corput_real_subtract(corput_real_uint(2u, 0), h));
        uint fraction = max(corput_real_fraction_nearest(corput_real_divide(left, h)), 1u);
        return uvec2(0u - fraction, turn);
    }
    CorputReal versine = corput_sphere_versine(square, z);
    return uvec2(corput_real_fraction_nearest(corput_real_divide(versine, h)), turn);
}

// Uniform direction of the cone.
vec3 corput_cone(float h, uvec2 u) {
    return corput_real3_floats(corput_cone_around(corput_cone_height(h), u));
}

// 1/(2 pi h) inside, else 0.
float corput_cone_pdf(float h, vec3 direction) {
    CorputReal height = corput_cone_height(h);
    if (!corput_cone_inside(height, corput_real3(direction))) {
        return 0.0;
    }
    return corput_real_float(corput_cone_density(height));
}

// The fractions that give this direction.
uvec2 corput_cone_invert(float h, vec3 direction) {
    return corput_cone_around_invert(corput_cone_height(h), corput_real3(direction));
}

#endif
