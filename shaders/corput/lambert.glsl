// what:   estimators of the irradiance of a surface that faces +z: under a sky of radiance
//         1 + gradient cos t, and under a light of radiance 1 that is seen as a spherical
//         triangle. For each sample, radiance times cos t over its pdf.
// source: Moon and Spencer 1942, Illumination from a non-uniform sky: gradient 2 is the
//         overcast sky of the CIE. Lambert 1760, Photometria; Veach and Guibas 1995,
//         Optimally combining sampling techniques for Monte Carlo rendering, SIGGRAPH.
// domain: fractions of 2^32; a gradient of at least 0; a triangle above the horizon.
// range:  each sample within 2^-22 of itself but for directions that lie within 2^-23 of a
//         side of the triangle, which may count as on its other side.
// cost:   of a sky 120, of a triangle 400, or with its own directions 2,000 integer
//         instructions. tier I.
// hooks:  none.
// mirror: src/reference/lambert.rs
#ifndef CORPUT_LAMBERT_GLSL
#define CORPUT_LAMBERT_GLSL

#include "corput/hemisphere.glsl"
#include "corput/spherical_triangle.glsl"

// 1 + gradient z.
CorputReal corput_sky_radiance(CorputReal gradient, CorputReal z) {
    return corput_real_add(corput_real_uint(1u, 0), corput_real_multiply(gradient, z));
}

// The sky by uniform directions: 2 pi cos t L.
CorputReal corput_sky_uniform(CorputReal gradient, uvec2 u) {
    CorputReal z = corput_real(corput_uniform_hemisphere(u).z);
    CorputReal weight = corput_real_multiply(z, corput_real_uint(3373259426u, -29));
    return corput_real_multiply(weight, corput_sky_radiance(gradient, z));
}

// The sky by cosine-weighted directions: pi L.
CorputReal corput_sky_cosine(CorputReal gradient, uvec2 u) {
    CorputReal z = corput_real(corput_cosine_hemisphere(u).z);
    return corput_real_multiply(corput_real_uint(3373259426u, -30), corput_sky_radiance(gradient, z));
}

// Whether a direction is in the triangle, by the exact planes of its sides.
bool corput_lambert_inside(CorputSphericalTriangle t, CorputReal3 d) {
    uint outside = uint(corput_real3_dot(t.ab_normal, d).negative)
        | uint(corput_real3_dot(t.bc_normal, d).negative) | uint(corput_real3_dot(t.ca_normal, d).negative);
    return outside == 0u;
}

// The triangle by uniform directions: 2 pi cos t inside.
CorputReal corput_lambert_uniform(CorputSphericalTriangle t, uvec2 u) {
    CorputReal3 d = corput_real3(corput_uniform_hemisphere(u));
    CorputReal weight = corput_real_multiply(d.z, corput_real_uint(3373259426u, -29));
    if (!corput_lambert_inside(t, d)) {
        weight = corput_real_zero();
    }
    return weight;
}

// The triangle by cosine-weighted directions: pi inside.
CorputReal corput_lambert_cosine(CorputSphericalTriangle t, uvec2 u) {
    CorputReal weight = corput_real_uint(3373259426u, -30);
    if (!corput_lambert_inside(t, corput_real3(corput_cosine_hemisphere(u)))) {
        weight = corput_real_zero();
    }
    return weight;
}

// The triangle by its own directions: cos t times its solid angle.
CorputReal corput_lambert_light(CorputSphericalTriangle t, uvec2 u) {
    CorputReal z = corput_real(corput_spherical_triangle(t, u).z);
    return corput_real_multiply(z, corput_real_multiply(t.area, corput_real_uint(3373259426u, -28)));
}

// A cosine-weighted direction for half of all u.z and one of the triangle for the others,
// with the balance heuristic: cos t over the mean of both pdfs inside.
CorputReal corput_lambert_mis(CorputSphericalTriangle t, uvec3 u) {
    CorputReal3 d = corput_real3(corput_cosine_hemisphere(u.xy));
    bool inside = corput_lambert_inside(t, d);
    vec3 other = corput_spherical_triangle(t, u.xy);
    if (u.z >= 0x80000000u) {
        d = corput_real3(other);
        inside = true;
    }
    // 1/pi and 1/(4 pi) to 32 bits.
    CorputReal cosine = corput_real_multiply(d.z, corput_real_uint(2734261102u, -33));
    CorputReal light = corput_real_divide(corput_real_uint(2734261102u, -35), t.area);
    CorputReal both = corput_real_add(cosine, light);
    CorputReal weight = corput_real_divide(corput_real_shift(d.z, 1), both);
    if (!inside) {
        weight = corput_real_zero();
    }
    return weight;
}

#endif
