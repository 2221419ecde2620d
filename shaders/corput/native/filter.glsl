// what:   offsets from a pixel's centre by its reconstruction filter in the native profile:
//         box, tent, truncated Gaussian, with pdf and inverse.
// source: Ernst, Stamminger and Greiner 2006; PBRT 4th ed., 8.8.
// domain: radius and sigma from 1e-30 on, below it they count as that; two fractions.
// pdf:    with respect to area; that of a sample by its fractions.
// errors: 2^-21 of the radius, within what Vulkan allows division, sqrt, log and exp.
// cost:   box 10, tent 20, Gaussian 100 float instructions.
// hooks:  none.
// mirror: src/reference/native/filter.rs
#ifndef CORPUT_NATIVE_FILTER_GLSL
#define CORPUT_NATIVE_FILTER_GLSL

#include "corput/native/gaussian.glsl"

// An offset from the pixel's centre, and its pdf.
struct CorputNativeFilterSample {
    vec2 p;
    float pdf;
};

// A truncated Gaussian: its edge and deviation, and the masses of the normal distribution
// from 0 to the edge and beyond it.
struct CorputNativeFilterGaussian {
    float radius;
    float sigma;
    vec2 masses;
};

// The share of its half below u's midpoint, counted from the middle, as an odd fraction.
uint corput_native_filter_share(uint u) {
    uint upper = u < 0x80000000u ? ~u : u;
    return (upper << 1) | 1u;
}

// x or -x.
float corput_native_filter_side(float x, bool negative) {
    return negative ? -x : x;
}

// The point with these distances from the axes.
vec2 corput_native_filter_point(float x, float y, uvec2 u) {
    return vec2(corput_native_filter_side(x, u.x < 0x80000000u), corput_native_filter_side(y, u.y < 0x80000000u));
}

// The fractions with these shares of their halves.
uvec2 corput_native_filter_fractions(float x, float y, vec2 p) {
    float right = 0.5 * corput_native_filter_side(x, p.x < 0.0);
    float up = 0.5 * corput_native_filter_side(y, p.y < 0.0);
    return uvec2(corput_native_fraction(0.5 + right), corput_native_fraction(0.5 + up));
}

// A square around the centre.
CorputNativeFilterSample corput_native_filter_box(float radius, uvec2 u) {
    float r = corput_native_positive(radius);
    float x = r * corput_native_unit(corput_native_filter_share(u.x));
    float y = r * corput_native_unit(corput_native_filter_share(u.y));
    return CorputNativeFilterSample(corput_native_filter_point(x, y, u), 0.25 / r / r);
}

// 1 / (4 r^2) within the square.
float corput_native_filter_box_pdf(float radius, vec2 p) {
    float r = corput_native_positive(radius);
    return max(abs(p.x), abs(p.y)) <= r ? 0.25 / r / r : 0.0;
}

// The fractions that give this offset.
uvec2 corput_native_filter_box_invert(float radius, vec2 p) {
    float r = corput_native_positive(radius);
    return corput_native_filter_fractions(abs(p.x) / r, abs(p.y) / r, p);
}

// A pyramid around the centre.
CorputNativeFilterSample corput_native_filter_tent(float radius, uvec2 u) {
    float r = corput_native_positive(radius);
    uint x_share = corput_native_filter_share(u.x);
    uint y_share = corput_native_filter_share(u.y);
    float x_height = sqrt(corput_native_unit(0u - x_share));
    float y_height = sqrt(corput_native_unit(0u - y_share));
    // 1 - sqrt(1 - a) = a / (1 + sqrt(1 - a)).
    float x = r * (corput_native_unit(x_share) / (1.0 + x_height));
    float y = r * (corput_native_unit(y_share) / (1.0 + y_height));
    return CorputNativeFilterSample(corput_native_filter_point(x, y, u), x_height / r * (y_height / r));
}

// (1 - |x|/r) (1 - |y|/r) / r^2.
float corput_native_filter_tent_pdf(float radius, vec2 p) {
    float r = corput_native_positive(radius);
    float x = max(r - abs(p.x), 0.0) / r;
    float y = max(r - abs(p.y), 0.0) / r;
    return x / r * (y / r);
}

// The fractions that give this offset.
uvec2 corput_native_filter_tent_invert(float radius, vec2 p) {
    float r = corput_native_positive(radius);
    float x = min(abs(p.x) / r, 1.0);
    float y = min(abs(p.y) / r, 1.0);
    return corput_native_filter_fractions(x * (2.0 - x), y * (2.0 - y), p);
}

// The Gaussian of this deviation up to this radius.
CorputNativeFilterGaussian corput_native_filter_gaussian_prepare(float radius, float sigma) {
    float r = corput_native_positive(radius);
    float s = corput_native_positive(sigma);
    return CorputNativeFilterGaussian(r, s, corput_native_normal_masses(r / s));
}

// |x| / sigma for a sample's coordinate.
float corput_native_filter_gaussian_quantile(CorputNativeFilterGaussian f, uint u) {
    uint share = corput_native_filter_share(u);
    float rest = f.masses.x * corput_native_unit(0u - share);
    return corput_native_quantile(f.masses.x * corput_native_unit(share), f.masses.y + rest);
}

// The pdf of a coordinate's share of sigma.
float corput_native_filter_gaussian_density(CorputNativeFilterGaussian f, float z) {
    return corput_native_normal_density(z) / (2.0 * f.sigma * f.masses.x);
}

// A truncated Gaussian around the centre.
CorputNativeFilterSample corput_native_filter_gaussian(CorputNativeFilterGaussian f, uvec2 u) {
    float x = corput_native_filter_gaussian_quantile(f, u.x);
    float y = corput_native_filter_gaussian_quantile(f, u.y);
    float pdf = corput_native_filter_gaussian_density(f, x) * corput_native_filter_gaussian_density(f, y);
    vec2 p = corput_native_filter_point(min(x * f.sigma, f.radius), min(y * f.sigma, f.radius), u);
    return CorputNativeFilterSample(p, pdf);
}

// The truncated density.
float corput_native_filter_gaussian_pdf(CorputNativeFilterGaussian f, vec2 p) {
    if (max(abs(p.x), abs(p.y)) > f.radius) {
        return 0.0;
    }
    return corput_native_filter_gaussian_density(f, p.x / f.sigma) * corput_native_filter_gaussian_density(f, p.y / f.sigma);
}

// The fractions that give this offset.
uvec2 corput_native_filter_gaussian_invert(CorputNativeFilterGaussian f, vec2 p) {
    float x = corput_native_normal_masses(p.x / f.sigma).x / f.masses.x;
    float y = corput_native_normal_masses(p.y / f.sigma).x / f.masses.x;
    return corput_native_filter_fractions(x, y, p);
}

#endif
