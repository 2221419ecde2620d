// what:   a direction with its pdf, and a direction from height, radius and angle, in the
//         native profile.
// source: cylindrical coordinates; Taylor's polynomials for an eighth of a turn, as Vulkan
//         allows sin and cos to be off by 2^-11, many times the width of a narrow lobe.
// domain: any floats.
// errors: sine and cosine 2^-22.
// cost:   30 float instructions.
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

// (cos 2 pi phi, sin 2 pi phi), phi a fraction of 2^32.
vec2 corput_native_cos_sin(uint phi) {
    // Nearest quarter turn, and the signed rest, in integers: no reduction error.
    uint quarter = (phi + 0x20000000u) >> 30;
    float x = float(int(phi - (quarter << 30))) * 2.3283064365386963e-10;
    float w = x * x;
    float s = x * (6.2831853 + w * (-41.341702 + w * (81.605249 + w * (-76.705860 + w * 42.058694))));
    float c = 1.0 + w * (-19.739209 + w * (64.939394 + w * (-85.456817 + w * 60.244641)));
    if (quarter == 1u) {
        return vec2(-s, c);
    }
    if (quarter == 2u) {
        return vec2(-c, -s);
    }
    if (quarter == 3u) {
        return vec2(s, -c);
    }
    return vec2(c, s);
}

// (radius cos 2 pi phi, radius sin 2 pi phi, z), phi a fraction of 2^32.
vec3 corput_native_around(float radius, uint phi, float z) {
    vec2 circle = corput_native_cos_sin(phi);
    return vec3(radius * circle.x, radius * circle.y, z);
}

// a / b; 0 for b <= 0.
float corput_native_quotient(float a, float b) {
    if (b > 0.0) {
        return a / b;
    }
    return 0.0;
}

// The fraction a of 2^32, where b = 1 - a: from the smaller.
uint corput_native_fraction_of(float a, float b) {
    if (a < b) {
        return corput_native_fraction(a);
    }
    return 0u - max(corput_native_fraction(b), 1u);
}

#endif
