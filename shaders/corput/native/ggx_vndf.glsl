// what:   the visible normals of a GGX lobe, and reflection at them, in the native profile,
//         with pdf and inverse.
// source: Heitz 2018, as ggx_vndf.glsl.
// domain: two fractions of 2^32: u.x radius, u.y angle on the projected area. Lobes as
//         ggx_lobe.glsl, of all visible normals.
// range:  unit vectors to the device's precision.
// pdf:    with respect to solid angle.
// errors: as ggx_lobe.glsl.
// cost:   80 float instructions, and 40 for the lobe.
// hooks:  none.
// mirror: src/reference/native/ggx_vndf.rs
#ifndef CORPUT_NATIVE_GGX_VNDF_GLSL
#define CORPUT_NATIVE_GGX_VNDF_GLSL

#include "corput/native/ggx_lobe.glsl"

// A visible normal of the unit sphere.
struct CorputNativeGgxVisible {
    // The normal n.
    vec3 normal;
    // V.n.
    float cosine;
};

// The sine of V to +z, and the unit vector of its horizontal part: (-y, x) is T1.
vec3 corput_native_ggx_vndf_axis(CorputNativeGgx g) {
    float sine = sqrt(g.view.x * g.view.x + g.view.y * g.view.y);
    if (sine <= 0.0) {
        return vec3(0.0, -1.0, 0.0);
    }
    return vec3(g.view.x / sine, g.view.y / sine, sine);
}

// t2 sin + w cos, given rise = t2 + A cos.
float corput_native_ggx_vndf_height(float sine, float cosine, float t2, float w, float a, float rise) {
    float first = t2 * sine;
    float second = w * cosine;
    if (first * second >= 0.0) {
        return first + second;
    }
    return rise * abs(t2 - a * cosine) / (abs(first) + abs(second));
}

// The visible normal of the unit sphere.
CorputNativeGgxVisible corput_native_ggx_vndf_visible(CorputNativeGgx g, uvec2 u) {
    float rest = corput_native_complement(u.x);
    vec3 disk = corput_native_around(sqrt(corput_native_unit(u.x)), u.y, 0.0);
    float a = sqrt(rest + disk.y * disk.y);
    // A - y and A + y.
    float far = a + abs(disk.y);
    float less = rest / far;
    float more = far;
    if (disk.y < 0.0) {
        less = far;
        more = rest / far;
    }
    float s = 0.5 * g.cap_above;
    float q = s * less;
    float t2 = a - q;
    // sqrt(q (A + t2)).
    float w = sqrt(q * (0.5 * g.cap_below * less + more));
    vec3 axis = corput_native_ggx_vndf_axis(g);
    float along = w * axis.z - t2 * g.view.z;
    float height = corput_native_ggx_vndf_height(axis.z, g.view.z, t2, w, a, s * more);
    vec3 normal = vec3(along * axis.x - disk.x * axis.y, along * axis.y + disk.x * axis.x, height);
    return CorputNativeGgxVisible(normal, w);
}

// Direction and pdf.
CorputNativeScattered corput_native_ggx_vndf(CorputNativeGgx g, uvec2 u) {
    CorputNativeGgxVisible v = corput_native_ggx_vndf_visible(g, u);
    return corput_native_ggx_reflected(g, v.normal, 1.0, v.cosine);
}

// The pdf of a direction.
float corput_native_ggx_vndf_pdf(CorputNativeGgx g, vec3 wi) {
    return corput_native_ggx_pdf(g, wi);
}

// Normal and pdf.
CorputNativeScattered corput_native_ggx_vndf_normal(CorputNativeGgx g, uvec2 u) {
    CorputNativeGgxVisible v = corput_native_ggx_vndf_visible(g, u);
    return corput_native_ggx_normal(g, v.normal, 1.0, v.cosine);
}

// The pdf of a normal.
float corput_native_ggx_vndf_normal_pdf(CorputNativeGgx g, vec3 normal) {
    float wo_h = dot(g.wo, normal);
    if (wo_h <= 0.0) {
        return 0.0;
    }
    return corput_native_density(corput_native_quotient(
        2.0 * wo_h * corput_native_ggx_distribution(g.alpha, normal), corput_native_ggx_area(g)));
}

// t2 + A cos; where the terms differ in sign, by the difference of the squares of t2 sin and
// w cos, which is as exact as the sine.
float corput_native_ggx_vndf_rise(float sine, float cosine, float t2, float w, float a) {
    float near = a * cosine;
    if (near * t2 >= 0.0) {
        return t2 + near;
    }
    float first = t2 * sine;
    float second = w * cosine;
    return (first + second) * (abs(first) + abs(second)) / abs(t2 - near);
}

// The fractions that give the normal h, of any length, with wo.h.
uvec2 corput_native_ggx_vndf_fractions(CorputNativeGgx g, vec3 h, float wo_h) {
    vec3 shrunk = vec3(h.x / g.alpha.x, h.y / g.alpha.y, h.z);
    float inverse = corput_native_quotient(1.0, sqrt(dot(shrunk, shrunk)));
    vec3 n = shrunk * inverse;
    vec3 axis = corput_native_ggx_vndf_axis(g);
    float along = n.x * axis.x + n.y * axis.y;
    float t1 = n.y * axis.x - n.x * axis.y;
    float t2 = n.z * axis.z - along * g.view.z;
    float w = wo_h * inverse / g.stretch;
    float a = sqrt(t2 * t2 + w * w);
    // A - t2, from w^2 where it would cancel.
    float q = a - t2;
    if (t2 > 0.0) {
        q = w * w / (a + t2);
    }
    // A - y and A + y, whose product is 1 - u.
    float less = corput_native_quotient(2.0 * q, g.cap_above);
    float rise = corput_native_ggx_vndf_rise(axis.z, g.view.z, t2, w, a);
    float more = corput_native_quotient(2.0 * rise, g.cap_above);
    float y = a - less;
    return uvec2(corput_native_fraction_of(t1 * t1 + y * y, less * more),
        corput_native_fraction(corput_native_turns(vec2(t1, y))));
}

// The fractions that give this direction.
uvec2 corput_native_ggx_vndf_invert(CorputNativeGgx g, vec3 wi) {
    vec3 h = corput_native_ggx_half(g, wi);
    return corput_native_ggx_vndf_fractions(g, h, 0.5 * dot(h, h));
}

// The fractions that give this normal.
uvec2 corput_native_ggx_vndf_normal_invert(CorputNativeGgx g, vec3 normal) {
    return corput_native_ggx_vndf_fractions(g, normal, dot(g.wo, normal));
}

#endif
