// what:   the normals of a Beckmann microsurface, all of them by D cos, and reflection at
//         them, in the native profile, with pdf and inverse.
// source: Walter et al. 2007, as beckmann.glsl.
// domain: finite alpha; its sign does not count, and what is below 1e-9 counts as that. wo of
//         any length near 1; wo = 0 has the sample 0 and as its pdf the largest float. Two
//         fractions of 2^32.
// range:  unit vectors to the device's precision.
// pdf:    with respect to solid angle; the largest float where it is infinite, 0 for h.z = 0,
//         beyond r = 10 and for what is no direction.
// errors: about 2^-19 of normals, directions and, relative, their pdf.
// cost:   40 to 60 float instructions.
// hooks:  none.
// mirror: src/reference/native/beckmann.rs
#ifndef CORPUT_NATIVE_BECKMANN_GLSL
#define CORPUT_NATIVE_BECKMANN_GLSL

#include "corput/native/ggx.glsl"

// -ln(1 - u): by its series for small u, where Vulkan's log has an absolute error of 2^-21.
float corput_native_beckmann_square(uint u) {
    float x = corput_native_unit(u);
    if (u < 0x01000000u) {
        return x * (1.0 + x * (0.5 + x * 0.33333334));
    }
    return -log(corput_native_complement(u));
}

// (slopes, 1), not normalised.
vec3 corput_native_beckmann_slopes(vec2 alpha, uvec2 u) {
    vec3 around = corput_native_around(sqrt(corput_native_beckmann_square(u.x)), u.y, 1.0);
    return vec3(around.x * corput_native_ggx_alpha(alpha.x), around.y * corput_native_ggx_alpha(alpha.y), 1.0);
}

// D cos at the slopes, where e^-r^2 is rest.
float corput_native_beckmann_density(vec2 alpha, vec3 slopes, float rest) {
    float square = dot(slopes, slopes);
    return corput_native_density(0.31830989 * rest / corput_native_ggx_alpha(alpha.x)
        / corput_native_ggx_alpha(alpha.y) * square * sqrt(square));
}

// e^-r^2 for the slopes; 0 beyond r = 10.
float corput_native_beckmann_rest(vec2 alpha, vec3 slopes) {
    float x = slopes.x / corput_native_ggx_alpha(alpha.x);
    float y = slopes.y / corput_native_ggx_alpha(alpha.y);
    float square = x * x + y * y;
    return square < 100.0 ? exp(-square) : 0.0;
}

// The fractions that give these slopes.
uvec2 corput_native_beckmann_fractions(vec2 alpha, vec3 slopes) {
    float rest = corput_native_beckmann_rest(alpha, slopes);
    vec2 around = vec2(slopes.x / corput_native_ggx_alpha(alpha.x), slopes.y / corput_native_ggx_alpha(alpha.y));
    return uvec2(corput_native_fraction_of(1.0 - rest, rest),
        corput_native_fraction(corput_native_turns(around)));
}

// Normal and pdf.
CorputNativeScattered corput_native_beckmann_normal(vec2 alpha, uvec2 u) {
    vec3 slopes = corput_native_beckmann_slopes(alpha, u);
    return CorputNativeScattered(slopes * (1.0 / sqrt(dot(slopes, slopes))),
        corput_native_beckmann_density(alpha, slopes, corput_native_complement(u.x)));
}

// The pdf of a normal: 0 for normal.z <= 0.
float corput_native_beckmann_normal_pdf(vec2 alpha, vec3 normal) {
    if (normal.z <= 0.0) {
        return 0.0;
    }
    vec3 slopes = vec3(normal.x / normal.z, normal.y / normal.z, 1.0);
    return corput_native_beckmann_density(alpha, slopes, corput_native_beckmann_rest(alpha, slopes));
}

// The fractions that give this normal.
uvec2 corput_native_beckmann_normal_invert(vec2 alpha, vec3 normal) {
    return corput_native_beckmann_fractions(alpha, vec3(normal.x / normal.z, normal.y / normal.z, 1.0));
}

// Direction and pdf.
CorputNativeScattered corput_native_beckmann(vec2 alpha, vec3 wo, uvec2 u) {
    vec3 o = wo * corput_native_quotient(1.0, sqrt(dot(wo, wo)));
    vec3 slopes = corput_native_beckmann_slopes(alpha, u);
    float square = dot(slopes, slopes);
    float cosine = dot(o, slopes);
    float pdf = corput_native_beckmann_density(alpha, slopes, corput_native_complement(u.x));
    return CorputNativeScattered(slopes * (2.0 * cosine / square) - o,
        corput_native_density(pdf * sqrt(square) / (4.0 * abs(cosine))));
}

// The pdf of a direction.
float corput_native_beckmann_pdf(vec2 alpha, vec3 wo, vec3 wi) {
    vec3 h = wi + wo * corput_native_quotient(1.0, sqrt(dot(wo, wo)));
    if (h.z == 0.0) {
        return 0.0;
    }
    vec3 slopes = vec3(h.x / h.z, h.y / h.z, 1.0);
    return corput_native_density(corput_native_beckmann_density(alpha, slopes,
        corput_native_beckmann_rest(alpha, slopes)) / (2.0 * sqrt(dot(h, h))));
}

// The fractions that give this direction.
uvec2 corput_native_beckmann_invert(vec2 alpha, vec3 wo, vec3 wi) {
    vec3 h = wi + wo * corput_native_quotient(1.0, sqrt(dot(wo, wo)));
    return corput_native_beckmann_fractions(alpha, vec3(h.x / h.z, h.y / h.z, 1.0));
}

#endif
