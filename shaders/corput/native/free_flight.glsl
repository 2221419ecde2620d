// what:   free flight through a homogeneous medium in the native profile, with pdf and
//         inverse, by the device's own log and exp.
// source: PBRT 4th ed., A.4.2; the logarithm's series where u is small.
// domain: sigma from 1e-30 to 1e30, below it counts as that; a fraction u of 2^32.
// pdf:    with respect to length: sigma e^(-sigma t), 0 for t < 0.
// errors: Vulkan allows log 3 ULP and exp 3 + 2 |x| ULP.
// cost:   about 20 float instructions.
// hooks:  none.
// mirror: src/reference/native/free_flight.rs
#ifndef CORPUT_NATIVE_FREE_FLIGHT_GLSL
#define CORPUT_NATIVE_FREE_FLIGHT_GLSL

#include "corput/native/hemisphere.glsl"

// A length and its pdf.
struct CorputNativeFreeFlight {
    float t;
    float pdf;
};

// x, and at least 1e-30: what is divided by.
float corput_native_positive(float x) {
    return x > 1e-30 ? x : 1e-30;
}

// -ln(1 - u), u a fraction of 2^32. Next to 1 Vulkan allows log an absolute error, so that
// small u go by the series.
float corput_native_negative_log(uint u) {
    if (u < 0x10000000u) {
        float x = corput_native_unit(u);
        return x * (1.0 + x * (0.5 + x * (0.33333334 + x * (0.25 + x * (0.2 + x * 0.16666667)))));
    }
    return -log(corput_native_complement(u));
}

// The length that light flies through the medium of sigma.
CorputNativeFreeFlight corput_native_exponential(float sigma, uint u) {
    float rate = corput_native_positive(sigma);
    float t = corput_native_negative_log(u) / rate;
    return CorputNativeFreeFlight(t, rate * corput_native_complement(u));
}

// sigma e^(-sigma t); 0 for t < 0.
float corput_native_exponential_pdf(float sigma, float t) {
    float rate = corput_native_positive(sigma);
    return t >= 0.0 ? rate * exp(-(rate * t)) : 0.0;
}

// The fraction that gives this length.
uint corput_native_exponential_invert(float sigma, float t) {
    return corput_native_fraction(1.0 - exp(-(corput_native_positive(sigma) * t)));
}

#endif
