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

// 1 - u as a fraction of 2^32, from the integer, so that nothing cancels.
float corput_native_complement(uint u) {
    return u == 0u ? 1.0 : corput_native_unit(0u - u);
}

// Uniform direction: z = u.x, phi = 2 pi u.y.
vec3 corput_native_uniform_hemisphere(uvec2 u) {
    float z = corput_native_unit(u.x);
    float radius = sqrt(corput_native_complement(u.x) * (1.0 + z));
    float phi = 6.2831853 * corput_native_unit(u.y);
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
    uint x = u.x < 0x80000000u ? 0x80000000u - u.x : u.x - 0x80000000u;
    uint y = u.y < 0x80000000u ? 0x80000000u - u.y : u.y - 0x80000000u;
    uint radius = max(x, y);
    float z = sqrt(float(0x80000000u - radius) * 4.656612873077393e-10
        * (1.0 + float(radius) * 4.656612873077393e-10));
    return vec3(corput_native_concentric_disk(u), z);
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
    return vec3(corput_native_polar_disk(u), sqrt(corput_native_complement(u.x)));
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
