// what:   directions of the hemisphere around +z by a power of their cosine in the native
//         profile, with pdf and inverse.
// source: as cosine_power.glsl; 1 - e^-w and -ln(1 - v) by Taylor's series near 0, where
//         devices have no digits of them.
// domain: n >= 0, n < 0 counts as 0; two fractions of 2^32.
// range:  unit vectors to the device's precision.
// pdf:    with respect to solid angle; that of a sample by its fractions.
// errors: 2^-17 a coordinate, 2^-14 of the pdf of a sample, within what Vulkan allows log
//         and exp.
// cost:   60 float instructions.
// hooks:  none.
// mirror: src/reference/native/cosine_power.rs
#ifndef CORPUT_NATIVE_COSINE_POWER_GLSL
#define CORPUT_NATIVE_COSINE_POWER_GLSL

#include "corput/native/free_flight.glsl"
#include "corput/native/scattered.glsl"

// The exponent.
struct CorputNativeCosinePower {
    float n;
};

// By n.
CorputNativeCosinePower corput_native_cosine_power_prepare(float n) {
    return CorputNativeCosinePower(max(n, 0.0));
}

// 1 - e^-w, for w >= 0.
float corput_native_cosine_power_mass(float w) {
    if (w < 0.25) {
        return w * (1.0 - w * (0.5 - w * (0.16666667 - w * (0.041666668 - w * 0.008333333))));
    }
    return 1.0 - exp(-w);
}

// -ln z of a unit vector.
float corput_native_cosine_power_log(vec3 direction) {
    float z = max(direction.z, 1e-30);
    float v = (direction.x * direction.x + direction.y * direction.y) / (1.0 + z);
    if (v < 0.125) {
        return v * (1.0 + v * (0.5 + v * (0.33333334 + v * (0.25 + v * (0.2 + v * 0.16666667)))));
    }
    return max(-log(z), 0.0);
}

// Direction and pdf.
CorputNativeScattered corput_native_cosine_power(CorputNativeCosinePower lobe, uvec2 u) {
    float next = lobe.n + 1.0;
    float w = corput_native_negative_log(u.x) / next;
    float versine = corput_native_cosine_power_mass(w);
    float z = exp(-w);
    float pdf = 0.15915494 * next * exp(-(lobe.n * w));
    return CorputNativeScattered(corput_native_around(sqrt(versine * (1.0 + z)), u.y, z), pdf);
}

// The pdf of a direction.
float corput_native_cosine_power_pdf(CorputNativeCosinePower lobe, vec3 direction) {
    if (direction.z < 0.0) {
        return 0.0;
    }
    return 0.15915494 * (lobe.n + 1.0) * exp(-(lobe.n * corput_native_cosine_power_log(direction)));
}

// The fractions that give this direction.
uvec2 corput_native_cosine_power_invert(CorputNativeCosinePower lobe, vec3 direction) {
    float w = (lobe.n + 1.0) * corput_native_cosine_power_log(direction);
    return uvec2(corput_native_fraction_of(corput_native_cosine_power_mass(w), exp(-w)),
        corput_native_fraction(corput_native_turns(direction.xy)));
}

#endif
