// what:   directions of the hemisphere around +z by a power of their cosine, with pdf and
//         inverse: cos^n lobes, of which the uniform hemisphere is n = 0 and the
//         cosine-weighted one n = 1.
// source: PBRT 3rd ed., 14.1.1, z = (1 - u)^(1/(n + 1)), by logarithms: with
//         w = ln(1 - u) / (n + 1), z = e^w, radius = sqrt(-(e^w - 1) (1 + e^w)), where the
//         common 1 - z^2 has no digits of a narrow lobe.
// domain: n >= 0, any float; two fractions of 2^32. n < 0 counts as 0, infinities and NaN
//         as numbers of at least 2^128; the pdf is then at most the largest float.
// range:  unit vectors to 2^-23, z >= 2^-32.
// pdf:    with respect to solid angle: (n + 1)/(2 pi) z^n, 0 below the horizon; ln z by
//         x^2 + y^2 where z is near 1. It is then well conditioned: that of a sample's
//         rounded direction is within 20 ULP of the exact direction's. That of a sample is
//         (n + 1)/(2 pi) (1 - u)^(n/(n + 1)).
// errors: coordinates 0.6 ULP, the pdf of a sample 0.7 ULP. The inverse of a sample is
//         within 2^-23 of it, angles modulo one turn; on the axis the angle is lost.
// cost:   600 integer instructions. tier I.
// hooks:  none.
// mirror: src/reference/cosine_power.rs
#ifndef CORPUT_COSINE_POWER_GLSL
#define CORPUT_COSINE_POWER_GLSL

#include "corput/free_flight.glsl"
#include "corput/scattered.glsl"

// n and n + 1.
struct CorputCosinePower {
    CorputReal n;
    CorputReal next;
};

// By n.
CorputCosinePower corput_cosine_power_prepare(float n) {
    CorputReal power = corput_real_positive(n);
    return CorputCosinePower(power, corput_real_add(power, corput_real_uint(1u, 0)));
}

// (n + 1)/(2 pi) 2^(n w).
CorputReal corput_cosine_power_density(CorputCosinePower lobe, CorputReal w) {
    CorputReal power = corput_real_exp2(corput_real_multiply(lobe.n, w));
    return corput_real_multiply(corput_real_multiply(lobe.next, CorputReal(2734261102u, -34, false)), power);
}

// log2 z of a unit vector, to full relative precision also next to the pole; that of the
// horizon for what is below it.
CorputReal corput_cosine_power_log2(vec3 direction) {
    CorputReal3 d = corput_real3(direction);
    CorputReal z = corput_real_max(d.z, corput_real_zero());
    CorputReal square = corput_real_add(corput_real_square(d.x), corput_real_square(d.y));
    CorputReal versine = corput_real_divide(square, corput_real_add(z, corput_real_uint(1u, 0)));
    if (corput_real_less(versine, corput_real_uint(1u, -2))) {
        // ln(1 - v) = -v P(-v); 3098164009 = 2^31 / ln 2.
        uint p = corput_log_polynomial(corput_real_fraction(versine), true);
        CorputReal rest = corput_real_multiply(versine, corput_real_uint(p, -31));
        return corput_real_negate(corput_real_multiply(rest, CorputReal(3098164009u, -31, false)));
    }
    return corput_real_log2(z);
}

// Direction and pdf.
CorputScattered corput_cosine_power(CorputCosinePower lobe, uvec2 u) {
    CorputReal w = corput_real_divide(corput_real_log2(corput_real_complement(u.x)), lobe.next);
    CorputReal z = corput_real_exp2(w);
    CorputReal versine = corput_real_negate(corput_real_exp2m1(w));
    CorputReal above = corput_real_add(z, corput_real_uint(1u, 0));
    CorputReal radius = corput_real_sqrt(corput_real_multiply(versine, above));
    return corput_scattered(corput_real3_around(radius, u.y, z), corput_cosine_power_density(lobe, w));
}

// The pdf of a direction.
float corput_cosine_power_pdf(CorputCosinePower lobe, vec3 direction) {
    if (corput_real(direction.z).negative) {
        return 0.0;
    }
    return corput_real_float(corput_cosine_power_density(lobe, corput_cosine_power_log2(direction)));
}

// The fractions that give this direction.
uvec2 corput_cosine_power_invert(CorputCosinePower lobe, vec3 direction) {
    CorputReal w = corput_real_multiply(lobe.next, corput_cosine_power_log2(direction));
    CorputReal above = corput_real_exp2(w);
    CorputReal below = corput_real_negate(corput_real_exp2m1(w));
    return uvec2(corput_real_fraction_of(below, above), corput_atan2(direction.y, direction.x));
}

#endif
