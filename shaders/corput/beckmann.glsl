// what:   the normals of a Beckmann microsurface, all of them by D cos, and reflection at
//         them, with pdf and inverse. Visible normals need ggx_vndf.glsl.
// source: Beckmann and Spizzichino 1963; Walter et al. 2007, Microfacet models for
//         refraction through rough surfaces, eq. 25, 28, 29; in slopes: a normal is
//         (alpha_x r cos phi, alpha_y r sin phi, 1) / length with r^2 = -ln(1 - u).
// domain: alpha of any size; its sign does not count, and what is below 2^-60 counts as that.
//         wo of any length, on either side; wo = 0 has the pdf 2^128 and the sample 0. Two
//         fractions of 2^32: u.x radius, u.y angle around +z.
// range:  unit vectors to 2^-23; reflected directions may lie below the horizon. No normal
//         lies beyond r = 4.71, for 1 - u is at least 2^-32.
// pdf:    with respect to solid angle: D cos of normals, D cos / (4 |wo.h|) of directions,
//         which is infinite where wo is perpendicular to the normal: the largest float.
// errors: normals and their pdf 0.6 ULP; directions half a ULP and 2^-26, the
//         pdf of a sample 0.6 ULP or 2^-30 / |wo.h|. The pdf of a normal 2^-23 of it,
//         and of a direction 2^-24 / alpha, see ggx_lobe.glsl. The inverse agrees with a
//         normal to 2^-20, with a direction to 2^-20 + 2^-22 / alpha.
// cost:   1000 to 1500 integer instructions. tier I.
// hooks:  none.
// mirror: src/reference/beckmann.rs
#ifndef CORPUT_BECKMANN_GLSL
#define CORPUT_BECKMANN_GLSL

#include "corput/exponential.glsl"
#include "corput/ggx.glsl"
#include "corput/logarithm.glsl"
#include "corput/scattered.glsl"

// (slopes, 1), not normalised.
CorputReal3 corput_beckmann_slopes(vec2 alpha, uvec2 u) {
    CorputReal radius = corput_real_sqrt(corput_real_negative_log(u.x));
    CorputReal3 around = corput_real3_around(radius, u.y, corput_real_uint(1u, 0));
    return corput_ggx_stretched(corput_ggx_alpha(alpha.x), corput_ggx_alpha(alpha.y), around);
}

// D cos at the slopes, where e^-r^2 is rest.
CorputReal corput_beckmann_density(vec2 alpha, CorputReal3 slopes, CorputReal rest) {
    CorputReal square = corput_real3_dot(slopes, slopes);
    CorputReal area = corput_real_multiply(corput_ggx_alpha(alpha.x), corput_ggx_alpha(alpha.y));
    CorputReal cube = corput_real_multiply(square, corput_real_sqrt(square));
    // 1 / pi.
    CorputReal scaled = corput_real_multiply(rest, CorputReal(2734261102u, -33, false));
    return corput_real_divide(corput_real_multiply(cube, scaled), area);
}

// The slopes of the normal h, which need not be normalised.
CorputReal3 corput_beckmann_slopes_of(CorputReal3 h) {
    return CorputReal3(corput_real_divide(h.x, h.z), corput_real_divide(h.y, h.z), corput_real_uint(1u, 0));
}

// r^2 for the slopes.
CorputReal corput_beckmann_square(vec2 alpha, CorputReal3 slopes) {
    CorputReal x = corput_real_divide(slopes.x, corput_ggx_alpha(alpha.x));
    CorputReal y = corput_real_divide(slopes.y, corput_ggx_alpha(alpha.y));
    return corput_real_add(corput_real_square(x), corput_real_square(y));
}

// e^-r^2 for the slopes.
CorputReal corput_beckmann_rest(vec2 alpha, CorputReal3 slopes) {
    return corput_real_exp(corput_real_negate(corput_beckmann_square(alpha, slopes)));
}

// The fractions that give these slopes.
uvec2 corput_beckmann_fractions(vec2 alpha, CorputReal3 slopes) {
    CorputReal square = corput_beckmann_square(alpha, slopes);
    // 1 - 2^-s with s = r^2 / ln 2.
    CorputReal s = corput_real_multiply(square, CorputReal(3098164009u, -31, false));
    CorputReal radius = corput_real_negate(corput_real_exp2m1(corput_real_negate(s)));
    return uvec2(corput_real_fraction_of(radius, corput_real_exp(corput_real_negate(square))),
        corput_real_turns(corput_real_multiply(slopes.y, corput_ggx_alpha(alpha.x)),
            corput_real_multiply(slopes.x, corput_ggx_alpha(alpha.y))));
}

// Normal and pdf.
CorputScattered corput_beckmann_normal(vec2 alpha, uvec2 u) {
    CorputReal3 slopes = corput_beckmann_slopes(alpha, u);
    return corput_scattered(corput_real3_normalize(slopes),
        corput_beckmann_density(alpha, slopes, corput_real_complement(u.x)));
}

// The pdf of a normal: 0 for normal.z <= 0.
float corput_beckmann_normal_pdf(vec2 alpha, vec3 normal) {
    CorputReal3 h = corput_real3(normal);
    if (h.z.negative || h.z.m == 0u) {
        return 0.0;
    }
    CorputReal3 slopes = corput_beckmann_slopes_of(h);
    return corput_real_float(corput_beckmann_density(alpha, slopes, corput_beckmann_rest(alpha, slopes)));
}

// The fractions that give this normal.
uvec2 corput_beckmann_normal_invert(vec2 alpha, vec3 normal) {
    return corput_beckmann_fractions(alpha, corput_beckmann_slopes_of(corput_real3(normal)));
}

// Direction and pdf.
CorputScattered corput_beckmann(vec2 alpha, vec3 wo, uvec2 u) {
    CorputReal3 o = corput_real3_normalize(corput_real3(wo));
    CorputReal3 slopes = corput_beckmann_slopes(alpha, u);
    CorputReal square = corput_real3_dot(slopes, slopes);
    CorputReal cosine = corput_real3_dot(o, slopes);
    // 2 (wo.h) h - wo.
    CorputReal scale = corput_real_shift(corput_real_divide(cosine, square), 1);
    CorputReal wo_h = corput_real_divide(CorputReal(cosine.m, cosine.e, false), corput_real_sqrt(square));
    CorputReal pdf = corput_real_divide(corput_beckmann_density(alpha, slopes, corput_real_complement(u.x)),
        corput_real_shift(wo_h, 2));
    return corput_scattered(corput_real3_subtract(corput_real3_scale(slopes, scale), o), pdf);
}

// The pdf of a direction.
float corput_beckmann_pdf(vec2 alpha, vec3 wo, vec3 wi) {
    CorputReal3 o = corput_real3_normalize(corput_real3(wo));
    CorputReal3 h = corput_real3_add(corput_real3_normalize(corput_real3(wi)), o);
    if (h.z.m == 0u) {
        return 0.0;
    }
    CorputReal3 slopes = corput_beckmann_slopes_of(h);
    // |wo.h| is half the length of the sum.
    return corput_real_float(corput_real_divide(
        corput_beckmann_density(alpha, slopes, corput_beckmann_rest(alpha, slopes)),
        corput_real_shift(corput_real3_length(h), 1)));
}

// The fractions that give this direction.
uvec2 corput_beckmann_invert(vec2 alpha, vec3 wo, vec3 wi) {
    CorputReal3 o = corput_real3_normalize(corput_real3(wo));
    CorputReal3 h = corput_real3_add(corput_real3_normalize(corput_real3(wi)), o);
    return corput_beckmann_fractions(alpha, corput_beckmann_slopes_of(h));
}

#endif
