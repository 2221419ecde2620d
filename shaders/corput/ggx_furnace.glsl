// what:   estimators of what a GGX surface reflects of a uniform sky of radiance 1, without
//         Fresnel's term and without light that meets the surface twice: the white furnace
//         test. For each sample, D G2 / (4 cos cos') times cos' over its pdf.
// source: Heitz 2014, Understanding the masking-shadowing function, JCGT 3(2), section 5.3;
//         Heitz 2018, Sampling the GGX distribution of visible normals, JCGT 7(4).
// domain: fractions of 2^32; a lobe of ggx_lobe.glsl seen from above the horizon.
// range:  0 to 1 by visible normals; by the others up to 1 / (2 cos alpha^3) for alpha <= 1.
// errors: 2^-24 / (alpha cos) of the largest sample, for a view at this cosine: as directions
//         are rounded.
// cost:   500 integer instructions, by visible normals 2,200. tier I.
// hooks:  none.
// mirror: src/reference/ggx_furnace.rs
#ifndef CORPUT_GGX_FURNACE_GLSL
#define CORPUT_GGX_FURNACE_GLSL

#include "corput/ggx_vndf.glsl"
#include "corput/hemisphere.glsl"

// pi D / (cos' |S wo| + cos |S wi|), with pi from the measure of directions.
CorputReal corput_furnace_lobe(CorputGgx g, CorputReal3 i) {
    CorputReal density = corput_ggx_density(g.alpha_x, g.alpha_y, corput_real3_add(g.wo, i));
    CorputReal stretch = corput_real3_length(corput_ggx_stretched(g.alpha_x, g.alpha_y, i));
    CorputReal sum = corput_real_add(corput_real_multiply(i.z, g.stretch), corput_real_multiply(g.wo.z, stretch));
    return corput_real_divide(corput_real_multiply(density, corput_real_uint(3373259426u, -30)), sum);
}

// By uniform directions of the hemisphere.
CorputReal corput_furnace_uniform(CorputGgx g, uvec2 u) {
    CorputReal3 i = corput_real3(corput_uniform_hemisphere(u));
    return corput_real_multiply(corput_furnace_lobe(g, i), i.z);
}

// By cosine-weighted directions.
CorputReal corput_furnace_cosine(CorputGgx g, uvec2 u) {
    return corput_real_shift(corput_furnace_lobe(g, corput_real3(corput_cosine_hemisphere(u))), -1);
}

// By reflection at visible normals: G2 / G1.
CorputReal corput_furnace_visible(CorputGgx g, uvec2 u) {
    return corput_real(corput_ggx_weight(g, corput_ggx_vndf(g, u).direction));
}

#endif
