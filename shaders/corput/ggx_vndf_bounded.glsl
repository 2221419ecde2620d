// what:   reflection at those visible normals of a GGX lobe that may reflect above the
//         horizon, with pdf and inverse: spherical caps, bounded.
// source: Eto and Tokuyoshi 2023, Bounded VNDF sampling for Smith-GGX reflections, SIGGRAPH
//         Asia Technical Communications, eq. 5 and 6: the cap is z > -k V.z with
//         k = (1 - a^2) s^2 / (s^2 + a^2 wo.z^2), a = min(alpha, 1), s = 1 + |wo.xy|.
//         V.z - b is V.z (1 - k), and 1 - k = 2 a^2 s / (s^2 + a^2 wo.z^2) since wo is unit.
// domain: as ggx_vndf_cap.glsl. A wo on or below the horizon has all visible normals.
// range:  unit vectors to 2^-23. Some still lie below the horizon, none more than without
//         the bound; for alpha_x = alpha_y seen from +z, none.
// pdf:    with respect to solid angle: D / (2 (k wo.z + |S wo|)); 0 outside the cap.
// errors: as ggx_vndf_cap.glsl.
// cost:   1300 integer instructions, and 1700 for the lobe. tier I.
// hooks:  none.
// mirror: src/reference/ggx_vndf_bounded.rs
#ifndef CORPUT_GGX_VNDF_BOUNDED_GLSL
#define CORPUT_GGX_VNDF_BOUNDED_GLSL

#include "corput/ggx_vndf_cap.glsl"

// A lobe of all visible normals, less those beyond the bound.
CorputGgx corput_ggx_vndf_bound(CorputGgx all) {
    CorputGgx g = all;
    if (g.wo.z.negative || g.wo.z.m == 0u) {
        return g;
    }
    CorputReal one = corput_real_uint(1u, 0);
    CorputReal a = corput_real_min(corput_real_min(g.alpha_x, g.alpha_y), one);
    CorputReal a_square = corput_real_square(a);
    CorputReal s = corput_real_add(one, corput_real_sqrt(
        corput_real_add(corput_real_square(g.wo.x), corput_real_square(g.wo.y))));
    CorputReal s_square = corput_real_square(s);
    CorputReal sum = corput_real_add(s_square, corput_real_multiply(a_square, corput_real_square(g.wo.z)));
    // 1 - k, and k with 1 - a^2 as a product.
    CorputReal rest = corput_real_divide(corput_real_shift(corput_real_multiply(a_square, s), 1), sum);
    CorputReal narrowed = corput_real_multiply(corput_real_subtract(one, a), corput_real_add(one, a));
    CorputReal k = corput_real_divide(corput_real_multiply(narrowed, s_square), sum);
    g.excess = corput_real_multiply(g.view.z, rest);
    g.cap_above = corput_real_add(one, corput_real_multiply(k, g.view.z));
    g.cap_below = corput_real_add(g.view_below, g.excess);
    return g;
}

// The lobe of the normals within the bound.
CorputGgx corput_ggx_vndf_bounded_prepare(vec2 alpha, vec3 wo) {
    return corput_ggx_vndf_bound(corput_ggx_prepare(alpha, wo));
}

// Direction and pdf.
CorputScattered corput_ggx_vndf_bounded(CorputGgx g, uvec2 u) {
    return corput_ggx_vndf_cap(g, u);
}

// The pdf of a direction.
float corput_ggx_vndf_bounded_pdf(CorputGgx g, vec3 wi) {
    return corput_ggx_pdf(g, wi);
}

// The fractions that give this direction.
uvec2 corput_ggx_vndf_bounded_invert(CorputGgx g, vec3 wi) {
    return corput_ggx_vndf_cap_invert(g, wi);
}

#endif
