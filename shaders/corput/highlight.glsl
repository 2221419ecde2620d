// what:   estimators of the highlight that a GGX surface shows of a spherical light of radiance
//         1, without Fresnel's term: for each sample that meets the light, D G2 / (4 cos cos')
//         times cos' over its pdf. With w = G2 / G1, the weight by visible normals, and q their
//         pdf over that of the light, w of a visible normal, w q of a direction of the light,
//         and by the balance heuristic 2 w q / (1 + q), the harmonic mean of both.
// source: Heitz 2018, Sampling the GGX distribution of visible normals, JCGT 7(4); Veach and
//         Guibas 1995, Optimally combining sampling techniques for Monte Carlo rendering,
//         SIGGRAPH.
// domain: fractions of 2^32; a lobe of ggx_lobe.glsl seen from above the horizon; a light of
//         sphere_light.glsl above it, seen from outside.
// range:  0 to 1, q, and 2 q / (1 + q) at the q of the lobe's peak, and 2 pi times the peak of
//         the pdf by uniform directions. A direction within 2^-26 of the light's rim may count
//         as on its other side.
// errors: 2^-29 + 2^-30 / (alpha cos) of the largest sample, for a view at this cosine, as reals
//         are rounded. No direction is rounded to float, which a sharp lobe would show.
// cost:   by uniform directions and by the light 1,100, by visible normals 2,000, by both 3,000
//         integer instructions. tier I.
// hooks:  none.
// mirror: src/reference/highlight.rs
#ifndef CORPUT_HIGHLIGHT_GLSL
#define CORPUT_HIGHLIGHT_GLSL

#include "corput/ggx_vndf.glsl"
#include "corput/sphere_light.glsl"

// wo reflected at a visible normal.
CorputReal3 corput_highlight_reflected(CorputGgx g, uvec2 u) {
    CorputGgxVisible v = corput_ggx_vndf_visible(g, u);
    CorputReal3 s = corput_ggx_stretched(g.alpha_x, g.alpha_y, v.normal);
    return corput_ggx_reflected(g, s, corput_real3_dot(s, s), v.cosine);
}

// A uniform direction of the light.
CorputReal3 corput_highlight_drawn(CorputSphereLight light, uvec2 u) {
    return corput_real_frame_to_world(light.frame, corput_cone_around(light.h, u));
}

// Whether a direction meets the light: by the chord to its centre, whose square is 2 (1 - cos)
// and does not cancel where the light is small.
bool corput_highlight_met(CorputSphereLight light, CorputReal3 d) {
    CorputReal3 chord = corput_real3_subtract(d, light.frame.normal);
    return corput_real_less(corput_real3_dot(chord, chord), corput_real_shift(light.h, 1));
}

// The pdf of a reflected direction over the 1 / (2 pi h) of a cone.
CorputReal corput_highlight_ratio(CorputGgx g, CorputReal h, CorputReal3 d) {
    CorputReal density = corput_ggx_density(g.alpha_x, g.alpha_y, corput_real3_add(g.wo, d));
    CorputReal angle = corput_real_multiply(h, corput_real_uint(3373259426u, -30));
    return corput_ggx_over_area(g, corput_real_multiply(density, angle));
}

// By uniform directions of the hemisphere, the cone of h = 1.
CorputReal corput_highlight_uniform(CorputGgx g, CorputSphereLight light, uvec2 u) {
    CorputReal one = corput_real_uint(1u, 0);
    CorputReal3 d = corput_cone_around(one, u);
    CorputReal value = corput_real_multiply(corput_ggx_weight_of(g, d), corput_highlight_ratio(g, one, d));
    if (!corput_highlight_met(light, d)) {
        value = corput_real_zero();
    }
    return value;
}

// By reflection at visible normals: w.
CorputReal corput_highlight_visible(CorputGgx g, CorputSphereLight light, uvec2 u) {
    CorputReal3 d = corput_highlight_reflected(g, u);
    CorputReal value = corput_ggx_weight_of(g, d);
    if (!corput_highlight_met(light, d)) {
        value = corput_real_zero();
    }
    return value;
}

// By directions of the light: w q.
CorputReal corput_highlight_light(CorputGgx g, CorputSphereLight light, uvec2 u) {
    CorputReal3 d = corput_highlight_drawn(light, u);
    return corput_real_multiply(corput_ggx_weight_of(g, d), corput_highlight_ratio(g, light.h, d));
}

// A visible normal for half of all u.z and a direction of the light for the others, with the
// balance heuristic: 2 w q / (1 + q).
CorputReal corput_highlight_mis(CorputGgx g, CorputSphereLight light, uvec3 u) {
    CorputReal3 d = corput_highlight_reflected(g, u.xy);
    bool met = corput_highlight_met(light, d);
    CorputReal3 drawn = corput_highlight_drawn(light, u.xy);
    if (u.z >= 0x80000000u) {
        d = drawn;
        met = true;
    }
    CorputReal q = corput_highlight_ratio(g, light.h, d);
    CorputReal share = corput_real_divide(corput_real_shift(q, 1), corput_real_add(corput_real_uint(1u, 0), q));
    CorputReal value = corput_real_multiply(corput_ggx_weight_of(g, d), share);
    if (!met) {
        value = corput_real_zero();
    }
    return value;
}

#endif
