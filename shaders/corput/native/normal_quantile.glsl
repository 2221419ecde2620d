// what:   the normal distribution in the native profile: quantile, masses, density and the
//         fraction that a value stands for, by the device's own log, sqrt and exp.
// source: as the exact profile's normal_quantile, with shorter polynomials
//         (scripts/elementary_polynomials.py).
// domain: all fractions u of 2^32, which stand for the midpoints (2 u + 1) / 2^33.
// errors: quantile 2e-6 of itself, masses 3e-6 of themselves, within what Vulkan allows log,
//         sqrt and exp.
// cost:   about 30 float instructions.
// hooks:  none.
// mirror: src/reference/native/normal_quantile.rs
#ifndef CORPUT_NATIVE_NORMAL_QUANTILE_GLSL
#define CORPUT_NATIVE_NORMAL_QUANTILE_GLSL

#include "corput/native/free_flight.glsl"

// z >= 0 with this mass from 0 to z, and this tail beyond, which is 1/2 - mass.
float corput_native_quantile(float mass, float tail) {
    float w = 8.0 * mass * mass;
    if (w < 1.0) {
        float p = -0.0061959893 + w * 0.0035484547;
        p = 0.0020796162 + w * (0.0093945165 + w * p);
        p = 0.044969951 + w * (0.0162886 + w * p);
        return 2.0 * mass * (1.2533141 + w * (0.16406464 + w * p));
    }
    float t = sqrt(-2.0 * log(tail));
    if (t < 3.75) {
        float s = t - 2.8;
        float p = -0.00028042517 + s * 0.00007739270;
        p = -0.0028255319 + s * (0.0008203773 + s * p);
        p = -0.038455928 + s * (0.010232437 + s * p);
        return 2.057042 + s * (1.1551948 + s * p);
    }
    float r = t - 5.25;
    float q = 0.00003847587 + r * -0.0000060494184;
    q = 0.0013574142 + r * (-0.00021403564 + r * q);
    return 4.746496 + r * (1.0623994 + r * (-0.0089535858 + r * q));
}

// z such that the normal distribution has mass (2 u + 1) / 2^33 below it.
float corput_native_normal_quantile(uint u) {
    uint upper = u < 0x80000000u ? ~u : u;
    uint share = (upper << 1) | 1u;
    float z = corput_native_quantile(0.5 * corput_native_unit(share), 0.5 * corput_native_unit(0u - share));
    return u < 0x80000000u ? -z : z;
}

// The density at z; 0 for NaN.
float corput_native_normal_density(float z) {
    return corput_native_density(0.39894228 * exp(-0.5 * z * z));
}

// The mass of the normal distribution from 0 to |z|, and above |z|.
vec2 corput_native_normal_masses(float z) {
    float x = abs(z);
    float w = 0.5 * x * x;
    if (w < 1.0) {
        float p = 0.0017401057 - w * 0.00019968907;
        p = 0.039881942 - w * (0.009445198 - w * p);
        float near = x * (0.39894227 - w * (0.13297972 - w * p));
        return vec2(near, 0.5 - near);
    }
    float s = 4.0 / (4.0 + x);
    float q = 0.27995643 - s * 0.0027563631;
    q = 0.26993855 + s * (-0.19465706 + s * q);
    q = 0.11147611 + s * (0.037224575 + s * q);
    float far = exp(-w) * (s * q - 0.00091536694);
    return vec2(0.5 - far, far);
}

// The fraction whose midpoint's quantile is z.
uint corput_native_normal_fraction(float z) {
    float tail = corput_native_normal_masses(z).y;
    float mass = z < 0.0 ? tail : 1.0 - tail;
    return corput_native_fraction(mass);
}

#endif
