// what:   directions of the whole sphere, uniformly, with pdf and inverse.
// source: Archimedes' projection; PBRT 4th ed., A.5. z = 1 - 2 u and the radius
//         2 sqrt(u (1 - u)) are formed from the integers, so that nothing cancels at a pole.
// domain: two fractions of 2^32. range: unit vectors to 2^-23; the poles only at u.x = 0 and
//         1 - 2^-32 at a distance of 3e-5 from -z.
// pdf:    with respect to solid angle: 1/(4 pi).
// errors: 0.6 ULP a coordinate. The inverse agrees with the sample to 2^-23 in u.x (near a
//         pole to 2^-22 of u.x or 1 - u.x) and, seen from the axis, to 2^-23 in u.y. At a
//         pole the angle is lost: (0, 0) and (1 - 2^-32, 0).
// cost:   about 170 integer instructions. tier I.
// hooks:  none.
// mirror: src/reference/sphere.rs
#ifndef CORPUT_SPHERE_GLSL
#define CORPUT_SPHERE_GLSL

#include "corput/real_angle.glsl"
#include "corput/real_vector.glsl"

// 1 - z of a unit vector, given its x^2 + y^2: z alone has no digits of it near +z.
CorputReal corput_sphere_versine(CorputReal square, CorputReal z) {
    CorputReal one = corput_real_uint(1u, 0);
    if (corput_real_less(z, corput_real_uint(1u, -1))) {
        return corput_real_subtract(one, z);
    }
    return corput_real_divide(square, corput_real_add(one, z));
}

// radius * (cos 2 pi u, sin 2 pi u) and z.
CorputReal3 corput_sphere_direction(CorputReal radius, uint u, CorputReal z) {
    CorputSinCos phi = corput_sincos_scaled(u);
    CorputReal cosine = corput_real_scaled(phi.cosine, phi.cosine_negative);
    CorputReal sine = corput_real_scaled(phi.sine, phi.sine_negative);
    return CorputReal3(corput_real_multiply(radius, cosine), corput_real_multiply(radius, sine), z);
}

// Uniform direction: z = 1 - 2 u.x, phi = 2 pi u.y.
vec3 corput_uniform_sphere(uvec2 u) {
    // u (1 - u), exact, as a fraction of 2^64.
    CorputReal square = corput_real_wide(corput_mul64(u.x, 0u - u.x), -64);
    uint magnitude = u.x < 0x80000000u ? 0x80000000u - u.x : u.x - 0x80000000u;
    CorputReal z = corput_real_uint(magnitude, -31);
    if (u.x > 0x80000000u) {
        z = corput_real_negate(z);
    }
    CorputReal radius = corput_real_shift(corput_real_sqrt(square), 1);
    return corput_real3_floats(corput_sphere_direction(radius, u.y, z));
}

// 1/(4 pi).
float corput_uniform_sphere_pdf() {
    return uintBitsToFloat(0x3da2f983u);
}

// The fractions that give this direction.
uvec2 corput_uniform_sphere_invert(vec3 direction) {
    CorputReal x = corput_real(direction.x);
    CorputReal y = corput_real(direction.y);
    CorputReal z = corput_real(direction.z);
    CorputReal square = corput_real_add(corput_real_square(x), corput_real_square(y));
    uint turn = corput_atan2(direction.y, direction.x);
    if (z.negative) {
        CorputReal rest = corput_sphere_versine(square, corput_real_negate(z));
        uint fraction = max(corput_real_fraction_nearest(corput_real_shift(rest, -1)), 1u);
        return uvec2(0u - fraction, turn);
    }
    CorputReal versine = corput_sphere_versine(square, z);
    return uvec2(corput_real_fraction_nearest(corput_real_shift(versine, -1)), turn);
}

#endif
