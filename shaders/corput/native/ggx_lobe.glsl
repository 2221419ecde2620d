// what:   a GGX lobe seen from one direction in the native profile: what its visible normals
//         and its reflection have in common whatever they are sampled by.
// source: as ggx_lobe.glsl.
// domain: finite alpha; its sign does not count, and what is below 1e-9 counts as that. wo of
//         any length near 1, above, on or below the horizon; (0, 0, 0) counts as +z.
// range:  unit vectors to the device's precision.
// pdf:    with respect to solid angle of wi, over the sphere; never more than the largest float,
//         0 for what is no direction.
// errors: about 2^-20 of a normal of the unit sphere, and 2^-20 / alpha of directions and,
//         relative, of the pdf.
// cost:   40 to 60 float instructions.
// hooks:  none.
// mirror: src/reference/native/ggx_lobe.rs
#ifndef CORPUT_NATIVE_GGX_LOBE_GLSL
#define CORPUT_NATIVE_GGX_LOBE_GLSL

#include "corput/native/ggx.glsl"

// A lobe.
struct CorputNativeGgx {
    // |alpha|.
    vec2 alpha;
    // The unit direction from which it is seen.
    vec3 wo;
    // The same stretched, and normalised.
    vec3 view;
    // The length of the stretched wo.
    float stretch;
    // 1 - view.z.
    float view_below;
    // 1 + b, where the cap of reflections on the unit sphere is z > -b.
    float cap_above;
    // 1 - b.
    float cap_below;
    // view.z - b.
    float excess;
};

// The lobe of all visible normals.
CorputNativeGgx corput_native_ggx_prepare(vec2 alpha, vec3 wo) {
    vec2 a = vec2(corput_native_ggx_alpha(alpha.x), corput_native_ggx_alpha(alpha.y));
    vec3 o = vec3(0.0, 0.0, 1.0);
    float square = dot(wo, wo);
    if (square > 0.0) {
        o = wo * (1.0 / sqrt(square));
    }
    float stretch = corput_native_ggx_stretch(a, o);
    float wide = stretch + abs(o.z);
    float x = o.x * a.x;
    float y = o.y * a.y;
    float narrow = (x * x + y * y) / wide;
    float above = wide / stretch;
    float below = narrow / stretch;
    if (o.z < 0.0) {
        above = narrow / stretch;
        below = wide / stretch;
    }
    vec3 view = vec3(x / stretch, y / stretch, o.z / stretch);
    return CorputNativeGgx(a, o, view, stretch, below, above, below, 0.0);
}

// Twice the projected area of the visible normals, or of those of the cap.
float corput_native_ggx_area(CorputNativeGgx g) {
    return g.stretch * g.cap_above;
}

// wo reflected at the normal n of the unit sphere, of squared length n_square, with
// V.n = cosine, and the pdf D / (2 area).
CorputNativeScattered corput_native_ggx_reflected(CorputNativeGgx g, vec3 n, float n_square, float cosine) {
    vec3 s = vec3(n.x * g.alpha.x, n.y * g.alpha.y, n.z);
    float s_square = dot(s, s);
    float scale = 2.0 * corput_native_quotient(g.stretch * cosine, s_square);
    float ratio = corput_native_quotient(s_square, n_square);
    float density = 0.31830989 * (ratio / g.alpha.x) * (ratio / g.alpha.y);
    return CorputNativeScattered(s * scale - g.wo,
        corput_native_density(corput_native_quotient(density, 2.0 * corput_native_ggx_area(g))));
}

// The microfacet normal for the normal n of the unit sphere, and its pdf 2 (wo.h) D / area.
CorputNativeScattered corput_native_ggx_normal(CorputNativeGgx g, vec3 n, float n_square, float cosine) {
    vec3 s = vec3(n.x * g.alpha.x, n.y * g.alpha.y, n.z);
    float s_square = dot(s, s);
    float inverse = corput_native_quotient(1.0, sqrt(s_square));
    float ratio = corput_native_quotient(s_square, n_square);
    float density = 0.31830989 * (ratio / g.alpha.x) * (ratio / g.alpha.y);
    float wo_h = g.stretch * cosine * inverse;
    return CorputNativeScattered(s * inverse,
        corput_native_density(corput_native_quotient(2.0 * wo_h * density, corput_native_ggx_area(g))));
}

// V + V', where V' is V reflected at the normal of the unit sphere whose facet reflects wo
// to wi; h is wo + wi.
vec3 corput_native_ggx_sphere_sum(CorputNativeGgx g, vec3 h) {
    vec3 n = vec3(h.x / g.alpha.x, h.y / g.alpha.y, h.z);
    return n * corput_native_quotient(dot(h, h) / g.stretch, dot(n, n));
}

// wo + wi, a multiple of the normal between them.
vec3 corput_native_ggx_half(CorputNativeGgx g, vec3 wi) {
    return wi * corput_native_quotient(1.0, sqrt(dot(wi, wi))) + g.wo;
}

// The pdf D(h) / (2 area) of a reflected direction; 0 outside the cap.
float corput_native_ggx_pdf(CorputNativeGgx g, vec3 wi) {
    vec3 h = corput_native_ggx_half(g, wi);
    vec3 n = corput_native_ggx_sphere_sum(g, h);
    // Nothing is outside above the horizon, whatever rounding says.
    if (wi.z < 0.0 && n.z < g.excess) {
        return 0.0;
    }
    return corput_native_density(corput_native_quotient(corput_native_ggx_distribution(g.alpha, h),
        2.0 * corput_native_ggx_area(g)));
}

// The weight G2 cos D / (4 cos cos' pdf) of a reflected direction, without Fresnel's term.
float corput_native_ggx_weight(CorputNativeGgx g, vec3 wi) {
    if (g.wo.z < 0.0 || wi.z <= 0.0) {
        return 0.0;
    }
    return corput_native_density(wi.z * corput_native_ggx_area(g)
        / (wi.z * g.stretch + g.wo.z * corput_native_ggx_stretch(g.alpha, wi)));
}

#endif
