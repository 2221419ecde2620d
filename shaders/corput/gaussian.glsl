// what:   normal distributions of mean 0: one coordinate or two by quantiles, which keeps
//         nets, and two by the polar method, with pdf and inverse.
// source: Box and Muller 1958 for the polar method, with 1 - u in the logarithm.
// domain: sigma > 0, fractions of 2^32; a quantile takes the midpoints (2 u + 1) / 2^33, so
//         that nothing is infinite. sigma <= 0 gives 0 with the largest float as its pdf; a
//         NaN counts as an infinity.
// range:  to 6.338 sigma by quantiles, to 6.661 sigma by the polar method.
// pdf:    with respect to length or area, e^(-x^2 / (2 sigma^2)) / (sqrt(2 pi) sigma) a
//         coordinate. That of a sample is the one before its coordinates are rounded.
// errors: coordinates 0.57 ULP, polar ones 0.6 ULP; pdf of a sample 1.5 ULP a coordinate,
//         polar 0.6 ULP, of a value 1 ULP a coordinate within 6.7 sigma. An inverse returns the fraction to 4 units where the float
//         still tells: z^2 2^-24 of the tail.
// cost:   300 integer instructions a coordinate. tier I.
// hooks:  none.
// mirror: src/reference/gaussian.rs
#ifndef CORPUT_GAUSSIAN_GLSL
#define CORPUT_GAUSSIAN_GLSL

#include "corput/free_flight.glsl"
#include "corput/normal_quantile.glsl"

// A coordinate and its pdf.
struct CorputGaussian {
    float x;
    float pdf;
};

// A point and its pdf.
struct CorputGaussianPair {
    vec2 p;
    float pdf;
};

// density / sigma^2.
float corput_gaussian_area_pdf(CorputReal density, CorputReal sigma) {
    return corput_real_float(corput_real_divide(density, corput_real_square(sigma)));
}

// One coordinate.
CorputGaussian corput_gaussian(float sigma, uint u) {
    CorputReal s = corput_real_positive(sigma);
    CorputReal z = corput_real_normal_quantile(u);
    CorputReal pdf = corput_real_divide(corput_real_normal_density(z), s);
    return CorputGaussian(corput_real_float(corput_real_multiply(z, s)), corput_real_float(pdf));
}

// The pdf of one coordinate.
float corput_gaussian_pdf(float sigma, float x) {
    CorputReal s = corput_real_positive(sigma);
    CorputReal z = corput_real_divide(corput_real(x), s);
    return corput_real_float(corput_real_divide(corput_real_normal_density(z), s));
}

// The fraction that gives this coordinate.
uint corput_gaussian_invert(float sigma, float x) {
    return corput_normal_fraction(corput_real_divide(corput_real(x), corput_real_positive(sigma)));
}

// Two coordinates by quantiles.
CorputGaussianPair corput_normal_pair(float sigma, uvec2 u) {
    CorputReal s = corput_real_positive(sigma);
    CorputReal density = corput_real_uint(1u, 0);
    vec2 p = vec2(0.0);
    // One body for both coordinates: drivers inline whatever is called.
    for (uint i = 0u; i < 2u; i++) {
        CorputReal z = corput_real_normal_quantile(u[i]);
        density = corput_real_multiply(density, corput_real_normal_density(z));
        p[i] = corput_real_float(corput_real_multiply(z, s));
    }
    return CorputGaussianPair(p, corput_gaussian_area_pdf(density, s));
}

// The pdf of two coordinates, whichever way they were made.
float corput_normal_pair_pdf(float sigma, vec2 p) {
    CorputReal s = corput_real_positive(sigma);
    CorputReal density = corput_real_uint(1u, 0);
    for (uint i = 0u; i < 2u; i++) {
        CorputReal z = corput_real_divide(corput_real(p[i]), s);
        density = corput_real_multiply(density, corput_real_normal_density(z));
    }
    return corput_gaussian_area_pdf(density, s);
}

// The fractions whose quantiles give this point.
uvec2 corput_normal_pair_invert(float sigma, vec2 p) {
    uvec2 u = uvec2(0u);
    for (uint i = 0u; i < 2u; i++) {
        u[i] = corput_gaussian_invert(sigma, p[i]);
    }
    return u;
}

// Two coordinates by the polar method: radius sqrt(-2 ln(1 - u.x)), angle 2 pi u.y.
CorputGaussianPair corput_box_muller(float sigma, uvec2 u) {
    CorputReal s = corput_real_positive(sigma);
    CorputReal radius = corput_real_sqrt(corput_real_shift(corput_real_negative_log(u.x), 1));
    radius = corput_real_multiply(radius, s);
    CorputSinCos phi = corput_sincos_scaled(u.y);
    CorputReal x = corput_real_multiply(radius, corput_real_scaled(phi.cosine, phi.cosine_negative));
    CorputReal y = corput_real_multiply(radius, corput_real_scaled(phi.sine, phi.sine_negative));
    // 2734261102 = 2^34 / (2 pi).
    CorputReal density = corput_real_multiply(corput_real_complement(u.x), corput_real_uint(2734261102u, -34));
    return CorputGaussianPair(vec2(corput_real_float(x), corput_real_float(y)), corput_gaussian_area_pdf(density, s));
}

// The fractions from which the polar method gives this point.
uvec2 corput_box_muller_invert(float sigma, vec2 p) {
    CorputReal s = corput_real_positive(sigma);
    CorputReal square = corput_real_zero();
    for (uint i = 0u; i < 2u; i++) {
        CorputReal z = corput_real_divide(corput_real(p[i]), s);
        square = corput_real_add(square, corput_real_square(z));
    }
    return uvec2(corput_exponential_fraction(corput_real_shift(square, -1)), corput_atan2(p.y, p.x));
}

#endif
