// what:   estimators of the irradiance of a surface that faces +z under a spherical light of
//         radiance 1, behind an edge that hides a part of it: for each sample that meets the
//         light on the open side, cos t over its pdf.
// source: Cook, Porter and Carpenter 1984, Distributed ray tracing, SIGGRAPH; PBRT 4th ed.,
//         6.2.4; Veach and Guibas 1995, Optimally combining sampling techniques for Monte
//         Carlo rendering, SIGGRAPH.
// domain: fractions of 2^32; a light of sphere_light.glsl above the horizon, seen from
//         outside; the edge's plane through the origin, given its normal to the open side.
// range:  a direction within 2^-22 of the light's rim, or of the edge, may count as on its
//         other side.
// cost:   500, by the light's directions 1,000, by both 1,300 integer instructions. tier I.
// hooks:  none.
// mirror: src/reference/soft_shadow.rs
#ifndef CORPUT_SOFT_SHADOW_GLSL
#define CORPUT_SOFT_SHADOW_GLSL

#include "corput/hemisphere.glsl"
#include "corput/sphere_light.glsl"

// A weight where a direction is on the open side, else 0.
CorputReal corput_shadow_open(CorputReal3 edge, CorputReal3 d, CorputReal weight) {
    CorputReal value = weight;
    if (corput_real3_dot(edge, d).negative) {
        value = corput_real_zero();
    }
    return value;
}

// A weight where a direction meets the light on the open side, else 0.
CorputReal corput_shadow_met(CorputSphereLight light, CorputReal3 edge, CorputReal3 d, CorputReal weight) {
    CorputReal value = corput_shadow_open(edge, d, weight);
    CorputReal versine = corput_real_subtract(corput_real_uint(1u, 0), corput_real3_dot(light.frame.normal, d));
    if (!corput_real_less(versine, light.h)) {
        value = corput_real_zero();
    }
    return value;
}

// By uniform directions of the hemisphere: 2 pi cos t.
CorputReal corput_shadow_uniform(CorputSphereLight light, CorputReal3 edge, uvec2 u) {
    CorputReal3 d = corput_real3(corput_uniform_hemisphere(u));
    return corput_shadow_met(light, edge, d, corput_real_multiply(d.z, corput_real_uint(3373259426u, -29)));
}

// By cosine-weighted directions: pi.
CorputReal corput_shadow_cosine(CorputSphereLight light, CorputReal3 edge, uvec2 u) {
    CorputReal3 d = corput_real3(corput_cosine_hemisphere(u));
    return corput_shadow_met(light, edge, d, corput_real_uint(3373259426u, -30));
}

// By directions of the light: cos t times its solid angle, 2 pi h.
CorputReal corput_shadow_light(CorputSphereLight light, CorputReal3 edge, uvec2 u) {
    CorputReal3 d = corput_real3(corput_sphere_light(light, u));
    CorputReal angle = corput_real_multiply(light.h, corput_real_uint(3373259426u, -29));
    return corput_shadow_open(edge, d, corput_real_multiply(d.z, angle));
}

// A cosine-weighted direction for half of all u.z and one of the light for the others, with
// the balance heuristic: cos t over the mean of both pdfs.
CorputReal corput_shadow_mis(CorputSphereLight light, CorputReal3 edge, uvec3 u) {
    CorputReal3 d = corput_real3(corput_cosine_hemisphere(u.xy));
    CorputReal versine = corput_real_subtract(corput_real_uint(1u, 0), corput_real3_dot(light.frame.normal, d));
    bool inside = corput_real_less(versine, light.h);
    vec3 other = corput_sphere_light(light, u.xy);
    if (u.z >= 0x80000000u) {
        d = corput_real3(other);
        inside = true;
    }
    // 1/pi to 32 bits.
    CorputReal cosine = corput_real_multiply(d.z, corput_real_uint(2734261102u, -33));
    CorputReal both = corput_real_add(cosine, corput_cone_density(light.h));
    CorputReal value = corput_shadow_open(edge, d, corput_real_divide(corput_real_shift(d.z, 1), both));
    if (!inside) {
        value = corput_real_zero();
    }
    return value;
}

#endif
