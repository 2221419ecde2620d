// what:   normal distributions of mean 0 in the native profile: one coordinate or two by
//         quantiles, and two by the polar method, with pdf and inverse.
// source: Box and Muller 1958 for the polar method, with 1 - u in the logarithm.
// domain: sigma from 1e-30 on, below it counts as that; fractions of 2^32.
// pdf:    with respect to length or area; that of a sample by its fractions.
// errors: Vulkan allows sin and cos an absolute error of 2^-11, log 3 ULP.
// cost:   about 60 float instructions.
// hooks:  none.
// mirror: src/reference/native/gaussian.rs
#ifndef CORPUT_NATIVE_GAUSSIAN_GLSL
#define CORPUT_NATIVE_GAUSSIAN_GLSL

#include "corput/native/normal_quantile.glsl"

// A coordinate and its pdf.
struct CorputNativeGaussian {
    float x;
    float pdf;
};

// A point and its pdf.
struct CorputNativeGaussianPair {
    vec2 p;
    float pdf;
};

// One coordinate.
CorputNativeGaussian corput_native_gaussian(float sigma, uint u) {
    float s = corput_native_positive(sigma);
    float z = corput_native_normal_quantile(u);
    return CorputNativeGaussian(z * s, corput_native_normal_density(z) / s);
}

// The pdf of one coordinate.
float corput_native_gaussian_pdf(float sigma, float x) {
    float s = corput_native_positive(sigma);
    return corput_native_normal_density(x / s) / s;
}

// The fraction that gives this coordinate.
uint corput_native_gaussian_invert(float sigma, float x) {
    return corput_native_normal_fraction(x / corput_native_positive(sigma));
}

// Two coordinates by quantiles.
CorputNativeGaussianPair corput_native_normal_pair(float sigma, uvec2 u) {
    CorputNativeGaussian x = corput_native_gaussian(sigma, u.x);
    CorputNativeGaussian y = corput_native_gaussian(sigma, u.y);
    return CorputNativeGaussianPair(vec2(x.x, y.x), corput_native_density(x.pdf * y.pdf));
}

// The pdf of two coordinates, whichever way they were made.
float corput_native_normal_pair_pdf(float sigma, vec2 p) {
    return corput_native_density(corput_native_gaussian_pdf(sigma, p.x) * corput_native_gaussian_pdf(sigma, p.y));
}

// The fractions whose quantiles give this point.
uvec2 corput_native_normal_pair_invert(float sigma, vec2 p) {
    return uvec2(corput_native_gaussian_invert(sigma, p.x), corput_native_gaussian_invert(sigma, p.y));
}

// Two coordinates by the polar method: radius sqrt(-2 ln(1 - u.x)), angle 2 pi u.y.
CorputNativeGaussianPair corput_native_box_muller(float sigma, uvec2 u) {
    float s = corput_native_positive(sigma);
    float radius = s * sqrt(2.0 * corput_native_negative_log(u.x));
    float phi = 6.2831853 * corput_native_unit(u.y);
    float pdf = corput_native_density(0.15915494 * corput_native_complement(u.x) / s / s);
    return CorputNativeGaussianPair(vec2(radius * cos(phi), radius * sin(phi)), pdf);
}

// The fractions from which the polar method gives this point.
uvec2 corput_native_box_muller_invert(float sigma, vec2 p) {
    float s = corput_native_positive(sigma);
    float x = p.x / s;
    float y = p.y / s;
    return uvec2(corput_native_fraction(1.0 - exp(-0.5 * (x * x + y * y))),
        corput_native_fraction(corput_native_turns(p)));
}

#endif
