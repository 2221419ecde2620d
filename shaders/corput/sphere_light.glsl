// what:   directions from the origin towards a sphere, uniformly over its solid angle, with
//         pdf and inverse.
// source: PBRT 4th ed., 6.2.4, by h = 1 - cos(theta_max) = r^2 / (d^2 + d sqrt(d^2 - r^2)), in
//         which nothing cancels; d^2 - r^2 is formed from exact products.
// domain: a centre, a radius; two fractions of 2^32. The origin within the sphere, or a
//         centre at the origin: uniform over all directions, the axis then +z. r <= 0 gives
//         the direction of the centre, with pdf 0.
// range:  unit vectors to 2^-23.
// pdf:    with respect to solid angle: 1/(2 pi h) inside, 1/(4 pi) from within. The edge is
//         widened by the rounding of a direction, 2^-22 of its components, so that no sample
//         falls outside.
// errors: 0.6 ULP, or 2^-30 for coordinates below 2^-5, which a rotation leaves; pdf 0.6 ULP.
//         The inverse agrees with the sample to 2^-20, more where the rounding of a direction
//         is more of the sphere's angle. On the axis the angle is lost.
// cost:   prepare 1,700, sample 800 integer instructions. tier I.
// hooks:  none.
// mirror: src/reference/sphere_light.rs
#ifndef CORPUT_SPHERE_LIGHT_GLSL
#define CORPUT_SPHERE_LIGHT_GLSL

#include "corput/cone.glsl"
#include "corput/real_frame.glsl"
#include "corput/wide.glsl"

struct CorputSphereLight {
    // Its normal points to the centre.
    CorputRealFrame frame;
    // 1 - cos(theta_max), and sin(theta_max).
    CorputReal h;
    CorputReal sine;
};

// The sphere with this centre and radius.
CorputSphereLight corput_sphere_light_prepare(vec3 center, float radius) {
    CorputReal3 c = corput_real3(center);
    CorputReal r = corput_real_max(corput_real(radius), corput_real_zero());
    CorputReal3 axis = corput_real3_normalize(c);
    CorputReal square = corput_real3_dot(c, c);
    if (square.m == 0u) {
        axis.z = corput_real_uint(1u, 0);
    }
    CorputWide rest = corput_wide_add(
        corput_wide_add(corput_wide_product(c.x, c.x), corput_wide_product(c.y, c.y)),
        corput_wide_add(corput_wide_product(c.z, c.z), corput_wide_product(corput_real_negate(r), r)));
    CorputReal h = corput_real_uint(2u, 0);
    CorputReal sine = corput_real_uint(1u, 0);
    if (!rest.negative && square.m != 0u) {
        CorputReal root = corput_real_sqrt(corput_real_multiply(square, corput_wide_real(rest)));
        h = corput_real_divide(corput_real_square(r), corput_real_add(square, root));
        sine = corput_real_divide(r, corput_real_sqrt(square));
    }
    return CorputSphereLight(corput_real_frame(axis), h, sine);
}

// Uniform direction towards the sphere.
vec3 corput_sphere_light(CorputSphereLight light, uvec2 u) {
    return corput_real3_floats(corput_real_frame_to_world(light.frame, corput_cone_around(light.h, u)));
}

// Whether a direction meets the sphere, or does so by its rounding.
bool corput_sphere_light_inside(CorputSphereLight light, CorputReal3 d) {
    if (!corput_real_less(light.h, corput_real_uint(2u, 0))) {
        return true;
    }
    CorputReal3 n = light.frame.normal;
    CorputReal cosine = corput_real3_dot(d, n);
    if (corput_real_less(corput_real_uint(3u, -2), light.sine)) {
        // Near a right angle its sine says little.
        CorputReal edge = corput_real_subtract(corput_real_uint(1u, 0), light.h);
        return !corput_real_less(cosine, corput_real_subtract(edge, corput_real_uint(1u, -22)));
    }
    // |d x n|, and what the rounding of d changes of it.
    CorputReal3 across = corput_wide_cross(d, n);
    CorputReal3 size = CorputReal3(
        corput_real_add(corput_real_square(corput_real_multiply(d.y, n.z)), corput_real_square(corput_real_multiply(d.z, n.y))),
        corput_real_add(corput_real_square(corput_real_multiply(d.z, n.x)), corput_real_square(corput_real_multiply(d.x, n.z))),
        corput_real_add(corput_real_square(corput_real_multiply(d.x, n.y)), corput_real_square(corput_real_multiply(d.y, n.x))));
    CorputReal sum = corput_real_add(corput_real_add(size.x, size.y), size.z);
    CorputReal most = corput_real_add(
        corput_real_add(light.sine, corput_real_shift(light.sine, -22)), corput_real_shift(corput_real_sqrt(sum), -22));
    return !cosine.negative && !corput_real_less(most, corput_real3_length(across));
}

// 1/(2 pi h) towards the sphere, else 0.
float corput_sphere_light_pdf(CorputSphereLight light, vec3 direction) {
    if (!corput_sphere_light_inside(light, corput_real3(direction))) {
        return 0.0;
    }
    return corput_real_float(corput_cone_density(light.h));
}

// The fractions that give this direction.
uvec2 corput_sphere_light_invert(CorputSphereLight light, vec3 direction) {
    return corput_cone_around_invert(light.h, corput_real_frame_to_local(light.frame, corput_real3(direction)));
}

#endif
