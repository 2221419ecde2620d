// what:   a direction with its pdf, and a direction from height, radius and angle, in the
//         native profile.
// source: cylindrical coordinates.
// domain: any floats.
// errors: Vulkan allows sin and cos an absolute error of 2^-11.
// cost:   5 float instructions.
// hooks:  none.
// mirror: src/reference/native/scattered.rs
#ifndef CORPUT_NATIVE_SCATTERED_GLSL
#define CORPUT_NATIVE_SCATTERED_GLSL

#include "corput/native/hemisphere.glsl"

// A direction, and the density there with respect to solid angle.
struct CorputNativeScattered {
    // The unit vector.
    vec3 direction;
    // The density.
    float pdf;
};

// (radius cos 2 pi phi, radius sin 2 pi phi, z), phi a fraction of 2^32.
vec3 corput_native_around(float radius, uint phi, float z) {
    float angle = 6.2831853 * corput_native_unit(phi);
    return vec3(radius * cos(angle), radius * sin(angle), z);
}

// The fraction a of 2^32, where b = 1 - a: from the smaller.
uint corput_native_fraction_of(float a, float b) {
    if (a < b) {
        return corput_native_fraction(a);
    }
    return 0u - max(corput_native_fraction(b), 1u);
}

#endif
