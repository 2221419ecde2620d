// what:   the GGX microsurface over the plane z = 0 in the native profile, anisotropic: its
//         normals and Smith's shadowing.
// source: as ggx.glsl: forms in which nothing cancels and nothing divides by cos.
// domain: alpha along x and y; its sign does not count, and for D what is below 1e-9 counts
//         as that. Directions of any length near 1.
// errors: about 2^-20 of the result, by the device's sqrt and division.
// cost:   20 to 40 float instructions.
// hooks:  none.
// mirror: src/reference/native/ggx.rs
#ifndef CORPUT_NATIVE_GGX_GLSL
#define CORPUT_NATIVE_GGX_GLSL

#include "corput/native/scattered.glsl"

// |stretched w|.
float corput_native_ggx_stretch(vec2 alpha, vec3 w) {
    float x = w.x * alpha.x;
    float y = w.y * alpha.y;
    return sqrt(x * x + y * y + w.z * w.z);
}

// |alpha|, at least 1e-9.
float corput_native_ggx_alpha(float alpha) {
    return max(abs(alpha), 1e-9);
}

// D at h; 0 for h.z <= 0.
float corput_native_ggx_distribution(vec2 alpha, vec3 h) {
    if (h.z <= 0.0) {
        return 0.0;
    }
    float x = corput_native_ggx_alpha(alpha.x);
    float y = corput_native_ggx_alpha(alpha.y);
    vec3 n = vec3(h.x / x, h.y / y, h.z);
    float ratio = corput_native_quotient(dot(h, h), dot(n, n));
    return corput_native_density(0.31830989 * (ratio / x) * (ratio / y));
}

// Smith's Lambda; the largest float for w.z <= 0.
float corput_native_ggx_lambda(vec2 alpha, vec3 w) {
    if (w.z <= 0.0) {
        return uintBitsToFloat(0x7f7fffffu);
    }
    float x = w.x * alpha.x;
    float y = w.y * alpha.y;
    return corput_native_density((x * x + y * y) / (2.0 * w.z * (w.z + corput_native_ggx_stretch(alpha, w))));
}

// Smith's G1; 0 for w.z <= 0.
float corput_native_ggx_g1(vec2 alpha, vec3 w) {
    if (w.z <= 0.0) {
        return 0.0;
    }
    return corput_native_density(2.0 * w.z / (w.z + corput_native_ggx_stretch(alpha, w)));
}

// Smith's G2; 0 where wo.z or wi.z <= 0.
float corput_native_ggx_g2(vec2 alpha, vec3 wo, vec3 wi) {
    if (wo.z <= 0.0 || wi.z <= 0.0) {
        return 0.0;
    }
    return corput_native_density(2.0 * wo.z * wi.z / (wi.z * corput_native_ggx_stretch(alpha, wo)
        + wo.z * corput_native_ggx_stretch(alpha, wi)));
}

#endif
