// what:   directions around +z by the phase function of Henyey and Greenstein in the native
//         profile, with pdf and inverse. +z is the direction of propagation.
// source: as henyey_greenstein.glsl: sums of positive terms.
// domain: two fractions of 2^32; z grows with u.x. g in (-1, 1): what is beyond counts as
//         1 - 2^-24 of its sign. Or 1 - |g|: from 2^-60 to 1.
// range:  unit vectors to the device's precision.
// pdf:    with respect to solid angle.
// errors: x, y, z and the pdf about 2^-20 of themselves, or of 1.
// cost:   60 float instructions.
// hooks:  none.
// mirror: src/reference/native/henyey_greenstein.rs
#ifndef CORPUT_NATIVE_HENYEY_GREENSTEIN_GLSL
#define CORPUT_NATIVE_HENYEY_GREENSTEIN_GLSL

#include "corput/native/scattered.glsl"

// The asymmetry of a phase function.
struct CorputNativeHenyeyGreenstein {
    // |g|.
    float g;
    // 1 - |g|.
    float rest;
    // Whether g < 0.
    bool backward;
};

// By g.
CorputNativeHenyeyGreenstein corput_native_henyey_greenstein_prepare(float g) {
    float magnitude = min(abs(g), 0.99999994);
    return CorputNativeHenyeyGreenstein(magnitude, 1.0 - magnitude, g < 0.0);
}

// By rest = 1 - |g|, which says more than g where g is near 1 or -1.
CorputNativeHenyeyGreenstein corput_native_henyey_greenstein_complement(float rest, bool backward) {
    float clamped = min(max(rest, 8.673617379884035e-19), 1.0);
    return CorputNativeHenyeyGreenstein(1.0 - clamped, clamped, backward);
}

// Direction and pdf.
CorputNativeScattered corput_native_henyey_greenstein(CorputNativeHenyeyGreenstein h, uvec2 u) {
    float a = corput_native_unit(u.x);
    float b = corput_native_complement(u.x);
    if (h.backward) {
        a = corput_native_complement(u.x);
        b = corput_native_unit(u.x);
    }
    float sum = 1.0 + h.g;
    float bent = h.g * a;
    float near = b * (1.0 + bent);
    float far = a * (h.rest + bent);
    float d = h.rest + 2.0 * bent;
    // Quotients before squares, which could leave the floats.
    float low = h.rest / d;
    float high = sum / d;
    float below = 2.0 * low * low * near;
    float above = 2.0 * high * high * far;
    float z = 1.0 - below;
    if (above < below) {
        z = above - 1.0;
    }
    if (h.backward) {
        z = -z;
    }
    float radius = 2.0 * low * high * sqrt(near * far);
    float scale = d / (h.rest * sum);
    return CorputNativeScattered(corput_native_around(radius, u.y, z), 0.07957747 * scale * (scale * d));
}

// The pdf of a direction.
float corput_native_henyey_greenstein_pdf(CorputNativeHenyeyGreenstein h, vec3 direction) {
    float z = direction.z;
    if (h.backward) {
        z = -z;
    }
    float below = 1.0 - z;
    if (z > 0.0) {
        below = (direction.x * direction.x + direction.y * direction.y) / (1.0 + z);
    }
    float root = sqrt(h.rest * h.rest + 2.0 * h.g * below);
    return corput_native_density(0.07957747 * (h.rest / root) * (1.0 + h.g) / (root * root));
}

// The fractions that give this direction.
uvec2 corput_native_henyey_greenstein_invert(CorputNativeHenyeyGreenstein h, vec3 direction) {
    float square = direction.x * direction.x + direction.y * direction.y;
    float wide = 1.0 + abs(direction.z);
    bool same = h.backward == (direction.z < 0.0);
    float below = wide;
    float above = square / wide;
    if (same) {
        below = square / wide;
        above = wide;
    }
    float sum = 1.0 + h.g;
    float root = sqrt(h.rest * h.rest + 2.0 * h.g * below);
    float a = h.rest / root * (above / (sum + root));
    float b = sum / root * (below / (h.rest + root));
    uint phi = corput_native_fraction(corput_native_turns(direction.xy));
    if (h.backward) {
        return uvec2(corput_native_fraction_of(b, a), phi);
    }
    return uvec2(corput_native_fraction_of(a, b), phi);
}

#endif
