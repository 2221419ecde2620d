// what:   free flight through a homogeneous medium: the exponential distribution, with pdf
//         and inverse.
// source: PBRT 4th ed., A.4.2, t = -ln(1 - u) / sigma.
// domain: sigma > 0, a fraction u of 2^32. sigma <= 0 gives the largest float, or 0 for
//         u = 0, with pdf 0; a NaN counts as an infinity.
// range:  t from 0 to 22.2 / sigma, finite.
// pdf:    with respect to length: sigma e^(-sigma t), 0 for t < 0. That of a sample is
//         sigma (1 - u): t of 24 bits is off by its own size, times sigma.
// errors: t 0.51 ULP, pdf of a sample 0.51 ULP, pdf of t 0.53 ULP.
// cost:   180 integer instructions. tier I.
// hooks:  none.
// mirror: src/reference/free_flight.rs
#ifndef CORPUT_FREE_FLIGHT_GLSL
#define CORPUT_FREE_FLIGHT_GLSL

#include "corput/exponential.glsl"

// A length and its pdf.
struct CorputFreeFlight {
    float t;
    float pdf;
};

// x, or 0 for x < 0.
CorputReal corput_real_positive(float x) {
    return corput_real_max(corput_real(x), corput_real_zero());
}

// 1 - e^(-x) as a fraction of 2^32, rounded to nearest, for x >= 0.
uint corput_exponential_fraction(CorputReal x) {
    // 3098164009 = 2^31 / ln 2.
    CorputReal power = corput_real_multiply(x, corput_real_uint(3098164009u, -31));
    CorputReal mass = corput_real_negate(corput_real_exp2m1(corput_real_negate(power)));
    return corput_real_fraction(corput_real_add(mass, corput_real_uint(1u, -33)));
}

// The length that light flies through the medium of sigma.
CorputFreeFlight corput_exponential(float sigma, uint u) {
    CorputReal rate = corput_real_positive(sigma);
    CorputReal t = corput_real_divide(corput_real_negative_log(u), rate);
    CorputReal pdf = corput_real_multiply(rate, corput_real_complement(u));
    return CorputFreeFlight(corput_real_float(t), corput_real_float(pdf));
}

// sigma e^(-sigma t); 0 for t < 0.
float corput_exponential_pdf(float sigma, float t) {
    CorputReal rate = corput_real_positive(sigma);
    CorputReal x = corput_real(t);
    if (x.negative) {
        return 0.0;
    }
    // The product is not rounded.
    CorputReal decay = corput_real_exp_wide(corput_mul64(rate.m, x.m), rate.e + x.e, true);
    return corput_real_float(corput_real_multiply(rate, decay));
}

// The fraction that gives this length.
uint corput_exponential_invert(float sigma, float t) {
    return corput_exponential_fraction(corput_real_multiply(corput_real_positive(sigma), corput_real_positive(t)));
}

#endif
