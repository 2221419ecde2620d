// what:   directions of the whole sphere in the native profile, uniformly, with pdf and
//         inverse, by the device's own functions.
// source: Archimedes' projection; PBRT 4th ed., A.5; u and 1 - u from the integers.
// domain: two fractions of 2^32. range: unit vectors to the device's precision.
// pdf:    with respect to solid angle: 1/(4 pi).
// errors: Vulkan allows sin and cos an absolute error of 2^-11.
// cost:   about 20 float instructions.
// hooks:  none.
// mirror: src/reference/native/sphere.rs
#ifndef CORPUT_NATIVE_SPHERE_GLSL
#define CORPUT_NATIVE_SPHERE_GLSL

#include "corput/native/hemisphere.glsl"

// 1 - z of a unit vector: z alone has no digits of it near +z.
float corput_native_sphere_versine(vec3 direction) {
    if (direction.z < 0.5) {
        return 1.0 - direction.z;
    }
    return (direction.x * direction.x + direction.y * direction.y) / (1.0 + direction.z);
}

// Uniform direction: z = 1 - 2 u.x, phi = 2 pi u.y.
vec3 corput_native_uniform_sphere(uvec2 u) {
    float radius = 2.0 * sqrt(corput_native_unit(u.x) * corput_native_complement(u.x));
    float phi = 6.2831853 * corput_native_unit(u.y);
    return vec3(radius * cos(phi), radius * sin(phi), -corput_native_signed_unit(u.x));
}

// 1/(4 pi).
float corput_native_uniform_sphere_pdf() {
    return 0.079577472;
}

// The fractions that give this direction.
uvec2 corput_native_uniform_sphere_invert(vec3 direction) {
    uint turn = corput_native_fraction(corput_native_turns(direction.xy));
    if (direction.z < 0.0) {
        float rest = 0.5 * corput_native_sphere_versine(vec3(direction.xy, -direction.z));
        return uvec2(0u - max(corput_native_fraction(rest), 1u), turn);
    }
    return uvec2(corput_native_fraction(0.5 * corput_native_sphere_versine(direction)), turn);
}

#endif
