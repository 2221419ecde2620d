// what:   directions of a cone around +z in the native profile, uniformly, with pdf and
//         inverse, by the device's own functions.
// source: PBRT 4th ed., A.5.4, in terms of h = 1 - cos(theta_max) = 2 sin^2(theta_max/2).
// domain: h from 0 to 2, two fractions of 2^32; h <= 0 gives +z, with pdf 0; h > 2 counts
//         as 2. range: unit vectors to the device's precision.
// pdf:    with respect to solid angle: 1/(2 pi h) inside; the edge is widened by 2^-10 of h,
//         so that no sample falls outside by its rounding; h below 1e-36 has 0.
// errors: relative to the radius of the cone: Vulkan allows sin and cos an absolute error of
//         2^-11.
// cost:   about 30 float instructions.
// hooks:  none.
// mirror: src/reference/native/cone.rs
#ifndef CORPUT_NATIVE_CONE_GLSL
#define CORPUT_NATIVE_CONE_GLSL

#include "corput/native/sphere.glsl"

// h within its domain.
float corput_native_cone_height(float h) {
    return h > 0.0 ? min(h, 2.0) : 0.0;
}

// Uniform direction of the cone: 1 - z = u.x h, phi = 2 pi u.y.
vec3 corput_native_cone(float h, uvec2 u) {
    float height = corput_native_cone_height(h);
    float versine = corput_native_unit(u.x) * height;
    float rest = (2.0 - height) + height * corput_native_complement(u.x);
    float radius = sqrt(versine * rest);
    float phi = 6.2831853 * corput_native_unit(u.y);
    return vec3(radius * cos(phi), radius * sin(phi), 1.0 - versine);
}

// 1/(2 pi h) inside, else 0.
float corput_native_cone_pdf(float h, vec3 direction) {
    float height = corput_native_cone_height(h);
    float versine = corput_native_sphere_versine(direction);
    bool inside = versine <= height * 1.0009765625;
    if (direction.z < 0.0) {
        float rest = corput_native_sphere_versine(vec3(direction.xy, -direction.z));
        inside = rest >= (2.0 - height) * 0.9990234375;
    }
    return inside && height >= 1e-36 ? 0.15915494 / height : 0.0;
}

// The fractions that give this direction.
uvec2 corput_native_cone_invert(float h, vec3 direction) {
    float height = max(corput_native_cone_height(h), 1e-36);
    float versine = corput_native_sphere_versine(direction);
    if (direction.z < 0.0) {
        versine = 2.0 - corput_native_sphere_versine(vec3(direction.xy, -direction.z));
    }
    return uvec2(corput_native_fraction(versine / height),
        corput_native_fraction(corput_native_turns(direction.xy)));
}

#endif
