// what:   reflection at the visible normals of a GGX lobe by spherical caps in the native
//         profile, with pdf and inverse.
// source: Dupuy and Benyoub 2023, as ggx_vndf_cap.glsl.
// domain: two fractions of 2^32: u.x height, u.y angle around +z. Lobes as ggx_lobe.glsl.
// range:  unit vectors to the device's precision.
// pdf:    with respect to solid angle.
// errors: as ggx_lobe.glsl; where the sampled normal is nearly perpendicular to wo, the pdf
//         has few digits.
// cost:   50 float instructions, and 40 for the lobe.
// hooks:  none.
// mirror: src/reference/native/ggx_vndf_cap.rs
#ifndef CORPUT_NATIVE_GGX_VNDF_CAP_GLSL
#define CORPUT_NATIVE_GGX_VNDF_CAP_GLSL

#include "corput/native/ggx_lobe.glsl"

// V + V' for a point V' of the cap.
vec3 corput_native_ggx_cap_sum(CorputNativeGgx g, uvec2 u) {
    float height = corput_native_complement(u.x) * g.cap_above;
    float below = corput_native_unit(u.x) * g.cap_above;
    float radius = sqrt(below * (height + g.cap_below));
    vec3 around = corput_native_around(radius, u.y, height + g.excess);
    return vec3(around.x + g.view.x, around.y + g.view.y, around.z);
}

// Direction and pdf.
CorputNativeScattered corput_native_ggx_vndf_cap(CorputNativeGgx g, uvec2 u) {
    vec3 n = corput_native_ggx_cap_sum(g, u);
    float square = dot(n, n);
    CorputNativeScattered made = corput_native_ggx_reflected(g, n, square, 0.5 * square);
    // Of a small n half its square is not V.n to all its digits.
    float size = sqrt(dot(made.direction, made.direction));
    return CorputNativeScattered(made.direction * corput_native_quotient(1.0, size), made.pdf);
}

// The pdf of a direction.
float corput_native_ggx_vndf_cap_pdf(CorputNativeGgx g, vec3 wi) {
    return corput_native_ggx_pdf(g, wi);
}

// The fractions that give this direction.
uvec2 corput_native_ggx_vndf_cap_invert(CorputNativeGgx g, vec3 wi) {
    vec3 n = corput_native_ggx_sphere_sum(g, corput_native_ggx_half(g, wi));
    vec2 around = vec2(n.x - g.view.x, n.y - g.view.y);
    float height = n.z - g.excess;
    float below = corput_native_quotient(dot(around, around), height + g.cap_below);
    return uvec2(corput_native_fraction_of(corput_native_quotient(below, g.cap_above),
        corput_native_quotient(height, g.cap_above)), corput_native_fraction(corput_native_turns(around)));
}

#endif
