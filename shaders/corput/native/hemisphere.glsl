// what:   directions of the hemisphere around +z in the native profile, with pdf and
//         inverse, by the device's own functions.
// source: Malley's method over the disk maps; PBRT 4th ed., A.5.
// domain: two fractions of 2^32. range: unit vectors to the device's precision, z >= 0.
// pdf:    with respect to solid angle: 1/(2 pi) and z/pi; 0 below the horizon.
// errors: Vulkan allows sin and cos an absolute error of 2^-11.
// cost:   about 30 float instructions.
// hooks:  none.
// mirror: src/reference/native/hemisphere.rs
#ifndef CORPUT_NATIVE_HEMISPHERE_GLSL
#define CORPUT_NATIVE_HEMISPHERE_GLSL

#include "corput/native/disk.glsl"

// Uniform direction: z = u.x, phi = 2 pi u.y.
vec3 corput_native_uniform_hemisphere(uvec2 u) {
    float z = corput_unit_floor(u.x);
    float radius = sqrt((1.0 - z) * (1.0 + z));
    float phi = 6.2831853 * corput_unit_floor(u.y);
    return vec3(radius * cos(phi), radius * sin(phi), z);
}

// 1/(2 pi) above the horizon.
float corput_native_uniform_hemisphere_pdf(vec3 direction) {
    return direction.z >= 0.0 ? 0.15915494 : 0.0;
}

// The fractions that give this direction.
uvec2 corput_native_uniform_hemisphere_invert(vec3 direction) {
    return uvec2(corput_native_fraction(direction.z),
        corput_native_fraction(corput_native_turns(direction.xy)));
}

// Cosine-weighted direction over the concentric disk.
vec3 corput_native_cosine_hemisphere(uvec2 u) {
    float radius = max(abs(corput_native_signed_unit(u.x)), abs(corput_native_signed_unit(u.y)));
    return vec3(corput_native_concentric_disk(u), sqrt((1.0 - radius) * (1.0 + radius)));
}

// z/pi for z > 0, else 0.
float corput_native_cosine_hemisphere_pdf(vec3 direction) {
    return max(direction.z, 0.0) * 0.31830989;
}

// The fractions that give this direction.
uvec2 corput_native_cosine_hemisphere_invert(vec3 direction) {
    return corput_native_concentric_disk_invert(direction.xy);
}

// Cosine-weighted direction over the polar disk: z = sqrt(1 - u.x).
vec3 corput_native_cosine_hemisphere_polar(uvec2 u) {
    return vec3(corput_native_polar_disk(u), sqrt(1.0 - corput_unit_floor(u.x)));
}

// z/pi for z > 0, else 0.
float corput_native_cosine_hemisphere_polar_pdf(vec3 direction) {
    return max(direction.z, 0.0) * 0.31830989;
}

// The fractions that give this direction.
uvec2 corput_native_cosine_hemisphere_polar_invert(vec3 direction) {
    return corput_native_polar_disk_invert(direction.xy);
}

#endif
