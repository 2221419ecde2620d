// what:   a GGX lobe seen from one direction: what its visible normals and its reflection
//         have in common whatever they are sampled by.
// source: Heitz 2018, Sampling the GGX distribution of visible normals, JCGT 7(4); Dupuy
//         and Benyoub 2023, Sampling visible GGX normals with spherical caps, CGF 42(8).
//         With V = S wo / |S wo| and n the normal of the unit sphere, S stretching x and y
//         by alpha: h = S n / |S n|, wo.h = |S wo| (V.n) / |S n|, D(h) = |S n|^4 / (pi
//         alpha_x alpha_y |n|^4), and G1 / wo.z = 2 / (wo.z + |S wo|).
// domain: alpha of any size; its sign does not count, and what is below 2^-60 counts as that:
//         a mirror, to the precision of floats. wo of any length; above the horizon, on it,
//         and below it, where the normals that Smith's surface shows downwards are few but
//         not none (Heitz et al. 2016). wo = 0 counts as +z; from straight below nothing is
//         visible: the pdf is 0 and the sample -wo. Infinities and NaN count as large numbers.
// range:  unit vectors to 2^-23; pdf from 0 to the largest float.
// pdf:    with respect to solid angle of wi, over the sphere: reflected directions may lie
//         below the horizon. A rounded direction belongs to a normal up to 2^-24 / alpha away
//         in units of the lobe, where the pdf may differ by four times that; hence samples
//         carry the pdf of the exact direction.
// errors: samples, see the map. The pdf of a direction, taken as exact: 2^-29 (4 + 4 / alpha)
//         of it; weights 0.6 ULP.
// cost:   700 to 1500 integer instructions. tier I.
// hooks:  none.
// mirror: src/reference/ggx_lobe.rs
#ifndef CORPUT_GGX_LOBE_GLSL
#define CORPUT_GGX_LOBE_GLSL

#include "corput/ggx.glsl"
#include "corput/scattered.glsl"

// A lobe.
struct CorputGgx {
    // |alpha.x|.
    CorputReal alpha_x;
    // |alpha.y|.
    CorputReal alpha_y;
    // The unit direction from which it is seen.
    CorputReal3 wo;
    // The same stretched, and normalised.
    CorputReal3 view;
    // The length of the stretched wo.
    CorputReal stretch;
    // 1 - view.z.
    CorputReal view_below;
    // 1 + b, where the cap of reflections on the unit sphere is z > -b: of all visible
    // normals b = view.z.
    CorputReal cap_above;
    // 1 - b.
    CorputReal cap_below;
    // view.z - b.
    CorputReal excess;
};

// The lobe of all visible normals.
CorputGgx corput_ggx_prepare(vec2 alpha, vec3 wo) {
    CorputReal alpha_x = corput_ggx_alpha(alpha.x);
    CorputReal alpha_y = corput_ggx_alpha(alpha.y);
    CorputReal3 o = corput_real3_normalize(corput_real3(wo));
    if (o.x.m == 0u && o.y.m == 0u && o.z.m == 0u) {
        o.z = corput_real_uint(1u, 0);
    }
    CorputReal3 stretched = corput_ggx_stretched(alpha_x, alpha_y, o);
    CorputReal stretch = corput_real3_length(stretched);
    // stretch + |z|, and stretch - |z| without cancellation.
    CorputReal wide = corput_real_add(stretch, CorputReal(o.z.m, o.z.e, false));
    CorputReal flat_square = corput_real_add(corput_real_square(stretched.x), corput_real_square(stretched.y));
    CorputReal narrow = corput_real_divide(flat_square, wide);
    CorputReal above = corput_real_divide(wide, stretch);
    CorputReal below = corput_real_divide(narrow, stretch);
    if (o.z.negative) {
        above = corput_real_divide(narrow, stretch);
        below = corput_real_divide(wide, stretch);
    }
    CorputReal3 view = CorputReal3(corput_real_divide(stretched.x, stretch),
        corput_real_divide(stretched.y, stretch), corput_real_divide(stretched.z, stretch));
    return CorputGgx(alpha_x, alpha_y, o, view, stretch, below, above, below, corput_real_zero());
}

// Twice the projected area of the visible normals, wo.z + |S wo|, or of those of the cap.
CorputReal corput_ggx_area(CorputGgx g) {
    return corput_real_multiply(g.stretch, g.cap_above);
}

// a over that area; 0 where nothing is visible.
CorputReal corput_ggx_over_area(CorputGgx g, CorputReal a) {
    CorputReal quotient = corput_real_divide(a, corput_ggx_area(g));
    if (g.cap_above.m == 0u) {
        quotient = corput_real_zero();
    }
    return quotient;
}

// D(h) for the normal n of the unit sphere, of squared length n_square, where S n has the
// squared length s_square.
CorputReal corput_ggx_density_of(CorputGgx g, CorputReal s_square, CorputReal n_square) {
    CorputReal ratio = corput_real_divide(s_square, n_square);
    CorputReal area = corput_real_multiply(g.alpha_x, g.alpha_y);
    // 1 / pi.
    return corput_real_divide(corput_real_multiply(corput_real_square(ratio), CorputReal(2734261102u, -33, false)),
        area);
}

// wo reflected at s = S n for the normal n of the unit sphere, with V.n = cosine.
CorputReal3 corput_ggx_reflected(CorputGgx g, CorputReal3 s, CorputReal s_square, CorputReal cosine) {
    // 2 (wo.h) h - wo.
    CorputReal scale = corput_real_shift(corput_real_divide(corput_real_multiply(g.stretch, cosine), s_square), 1);
    return corput_real3_subtract(corput_real3_scale(s, scale), g.wo);
}

// The pdf D / (2 area) of that direction, for the normal n of squared length n_square.
CorputReal corput_ggx_reflected_pdf(CorputGgx g, CorputReal s_square, CorputReal n_square) {
    return corput_real_shift(corput_ggx_over_area(g, corput_ggx_density_of(g, s_square, n_square)), -1);
}

// The microfacet normal for the normal n of the unit sphere, and its pdf 2 (wo.h) D / area.
CorputScattered corput_ggx_normal(CorputGgx g, CorputReal3 n, CorputReal n_square, CorputReal cosine) {
    CorputReal3 s = corput_ggx_stretched(g.alpha_x, g.alpha_y, n);
    CorputReal s_square = corput_real3_dot(s, s);
    CorputReal inverse = corput_real_divide(corput_real_uint(1u, 0), corput_real_sqrt(s_square));
    CorputReal wo_h = corput_real_multiply(corput_real_multiply(g.stretch, cosine), inverse);
    CorputReal pdf = corput_ggx_over_area(g, corput_real_multiply(corput_real_shift(wo_h, 1),
        corput_ggx_density_of(g, s_square, n_square)));
    return corput_scattered(corput_real3_scale(s, inverse), pdf);
}

// V + V', where V' is V reflected at the normal of the unit sphere whose facet reflects wo
// to wi; h is wo + wi.
CorputReal3 corput_ggx_sphere_sum(CorputGgx g, CorputReal3 h) {
    CorputReal area = corput_real_multiply(g.alpha_x, g.alpha_y);
    CorputReal3 shrunk = CorputReal3(corput_real_multiply(h.x, g.alpha_y), corput_real_multiply(h.y, g.alpha_x),
        corput_real_multiply(h.z, area));
    CorputReal scale = corput_real_divide(corput_real_multiply(corput_real3_dot(h, h), area),
        corput_real_multiply(corput_real3_dot(shrunk, shrunk), g.stretch));
    return corput_real3_scale(shrunk, scale);
}

// wo + wi, a multiple of the normal between them. The length of a rounded wi, 2^-25 off, would
// turn that of nearly opposite directions.
CorputReal3 corput_ggx_half(CorputGgx g, vec3 wi) {
    return corput_real3_add(corput_real3_normalize(corput_real3(wi)), g.wo);
}

// The pdf D(h) / (2 area) of a reflected direction; 0 outside the cap.
float corput_ggx_pdf(CorputGgx g, vec3 wi) {
    CorputReal3 h = corput_ggx_half(g, wi);
    // Nothing is outside above the horizon, whatever rounding says.
    if (corput_real_less(h.z, g.wo.z) && corput_real_less(corput_ggx_sphere_sum(g, h).z, g.excess)) {
        return 0.0;
    }
    CorputReal pdf = corput_ggx_over_area(g, corput_ggx_density(g.alpha_x, g.alpha_y, h));
    return corput_real_float(corput_real_shift(pdf, -1));
}

// The weight G2 cos D / (4 cos cos' pdf) of a reflected direction, without Fresnel's term:
// for all visible normals G2 / G1, at most 1. 0 where wo or wi lies below the horizon.
CorputReal corput_ggx_weight_of(CorputGgx g, CorputReal3 i) {
    CorputReal stretch = corput_real3_length(corput_ggx_stretched(g.alpha_x, g.alpha_y, i));
    CorputReal sum = corput_real_add(corput_real_multiply(i.z, g.stretch), corput_real_multiply(g.wo.z, stretch));
    CorputReal weight = corput_real_divide(corput_real_multiply(i.z, corput_ggx_area(g)), sum);
    if ((uint(g.wo.z.negative) | uint(i.z.negative)) != 0u) {
        weight = corput_real_zero();
    }
    return weight;
}

// The same of a rounded direction.
float corput_ggx_weight(CorputGgx g, vec3 wi) {
    return corput_real_float(corput_ggx_weight_of(g, corput_real3(wi)));
}

#endif
