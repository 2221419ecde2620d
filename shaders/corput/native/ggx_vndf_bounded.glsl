// what:   reflection at those visible normals of a GGX lobe that may reflect above the
//         horizon in the native profile, with pdf and inverse.
// source: Eto and Tokuyoshi 2023, as ggx_vndf_bounded.glsl.
// domain: as ggx_vndf_cap.glsl. A wo on or below the horizon has all visible normals.
// range:  unit vectors to the device's precision.
// pdf:    with respect to solid angle; 0 outside the cap.
// errors: as ggx_vndf_cap.glsl.
// cost:   50 float instructions, and 65 for the lobe.
// hooks:  none.
// mirror: src/reference/native/ggx_vndf_bounded.rs
#ifndef CORPUT_NATIVE_GGX_VNDF_BOUNDED_GLSL
#define CORPUT_NATIVE_GGX_VNDF_BOUNDED_GLSL

#include "corput/native/ggx_vndf_cap.glsl"

// A lobe of all visible normals, less those beyond the bound.
CorputNativeGgx corput_native_ggx_vndf_bound(CorputNativeGgx all) {
    CorputNativeGgx g = all;
    if (g.wo.z <= 0.0) {
        return g;
    }
    float a = min(min(g.alpha.x, g.alpha.y), 1.0);
    float s = 1.0 + sqrt(g.wo.x * g.wo.x + g.wo.y * g.wo.y);
    float sum = s * s + a * a * g.wo.z * g.wo.z;
    float k = (1.0 - a) * (1.0 + a) * s * s / sum;
    g.excess = g.view.z * (2.0 * a * a * s / sum);
    g.cap_above = 1.0 + k * g.view.z;
    g.cap_below = g.view_below + g.excess;
    return g;
}

// The lobe of the normals within the bound.
CorputNativeGgx corput_native_ggx_vndf_bounded_prepare(vec2 alpha, vec3 wo) {
    return corput_native_ggx_vndf_bound(corput_native_ggx_prepare(alpha, wo));
}

// Direction and pdf.
CorputNativeScattered corput_native_ggx_vndf_bounded(CorputNativeGgx g, uvec2 u) {
    return corput_native_ggx_vndf_cap(g, u);
}

// The pdf of a direction.
float corput_native_ggx_vndf_bounded_pdf(CorputNativeGgx g, vec3 wi) {
    return corput_native_ggx_pdf(g, wi);
}

// The fractions that give this direction.
uvec2 corput_native_ggx_vndf_bounded_invert(CorputNativeGgx g, vec3 wi) {
    return corput_native_ggx_vndf_cap_invert(g, wi);
}

#endif
