// what:   the GGX (Trowbridge-Reitz) microsurface over the plane z = 0, anisotropic: its
//         normals and Smith's shadowing.
// source: Walter et al. 2007, Microfacet models for refraction through rough surfaces;
//         Heitz 2014, Understanding the masking-shadowing function, JCGT 3(2), eq. 72, 85,
//         99. The common (alpha^2 - 1) cos^2 + 1 cancels for small alpha, and tan^2 is
//         infinite at grazing angles; here nothing cancels and nothing divides by cos.
// domain: alpha along x and y, of any size; its sign does not count, and for D what is below
//         2^-60 counts as that. Directions need not be normalised: each function is the same
//         for all lengths. Infinities and NaN count as large numbers.
// range:  0 to the largest float.
// errors: 0.6 ULP.
// cost:   500 to 900 integer instructions. tier I.
// hooks:  none.
// mirror: src/reference/ggx.rs
#ifndef CORPUT_GGX_GLSL
#define CORPUT_GGX_GLSL

#include "corput/real_vector.glsl"

// (x alpha.x, y alpha.y, z): the direction where the surface is stretched to unit roughness.
CorputReal3 corput_ggx_stretched(CorputReal alpha_x, CorputReal alpha_y, CorputReal3 w) {
    return CorputReal3(corput_real_multiply(w.x, alpha_x), corput_real_multiply(w.y, alpha_y), w.z);
}

// |alpha|, at least 2^-60.
CorputReal corput_ggx_alpha(float alpha) {
    CorputReal a = corput_real(alpha);
    return corput_real_max(CorputReal(a.m, a.e, false), corput_real_uint(1u, -60));
}

// |stretched w|.
CorputReal corput_ggx_stretch(vec2 alpha, vec3 w) {
    return corput_real3_length(corput_ggx_stretched(corput_real(alpha.x), corput_real(alpha.y), corput_real3(w)));
}

// The density of normals D at h with respect to solid angle; 0 for h.z <= 0.
CorputReal corput_ggx_density(CorputReal alpha_x, CorputReal alpha_y, CorputReal3 h) {
    // alpha_x alpha_y / pi (|h|^2 / (alpha_x alpha_y |h'|^2))^2, with h' shrunk by alpha and
    // multiplied by alpha_x alpha_y so that nothing is divided by alpha.
    CorputReal area = corput_real_multiply(alpha_x, alpha_y);
    CorputReal3 shrunk = CorputReal3(corput_real_multiply(h.x, alpha_y), corput_real_multiply(h.y, alpha_x),
        corput_real_multiply(h.z, area));
    CorputReal ratio = corput_real_divide(corput_real_multiply(area, corput_real3_dot(h, h)),
        corput_real3_dot(shrunk, shrunk));
    // 1 / pi.
    CorputReal density = corput_real_multiply(corput_real_multiply(area, corput_real_square(ratio)),
        CorputReal(2734261102u, -33, false));
    if ((uint(h.z.negative) | uint(h.z.m == 0u)) != 0u) {
        density = corput_real_zero();
    }
    return density;
}

// D at h.
float corput_ggx_distribution(vec2 alpha, vec3 h) {
    return corput_real_float(corput_ggx_density(corput_ggx_alpha(alpha.x), corput_ggx_alpha(alpha.y),
        corput_real3(h)));
}

// Smith's Lambda = (|stretched w| / w.z - 1) / 2; the largest float for w.z <= 0.
float corput_ggx_lambda(vec2 alpha, vec3 w) {
    CorputReal x = corput_real_multiply(corput_real(w.x), corput_real(alpha.x));
    CorputReal y = corput_real_multiply(corput_real(w.y), corput_real(alpha.y));
    CorputReal z = corput_real(w.z);
    if (z.negative || z.m == 0u) {
        return uintBitsToFloat(0x7f7fffffu);
    }
    CorputReal sum = corput_real_add(z, corput_ggx_stretch(alpha, w));
    CorputReal flat_square = corput_real_add(corput_real_square(x), corput_real_square(y));
    return corput_real_float(corput_real_divide(flat_square, corput_real_shift(corput_real_multiply(z, sum), 1)));
}

// Smith's masking G1 = 1 / (1 + Lambda) = 2 z / (z + |stretched w|): 0 for w.z <= 0.
float corput_ggx_g1(vec2 alpha, vec3 w) {
    CorputReal z = corput_real(w.z);
    if (z.negative || z.m == 0u) {
        return 0.0;
    }
    return corput_real_float(corput_real_divide(corput_real_shift(z, 1),
        corput_real_add(z, corput_ggx_stretch(alpha, w))));
}

// Smith's height-correlated masking and shadowing G2 = 1 / (1 + Lambda + Lambda) =
// 2 z z' / (z' |stretched wo| + z |stretched wi|): 0 where wo.z or wi.z <= 0.
float corput_ggx_g2(vec2 alpha, vec3 wo, vec3 wi) {
    CorputReal o = corput_real(wo.z);
    CorputReal i = corput_real(wi.z);
    if (o.negative || o.m == 0u || i.negative || i.m == 0u) {
        return 0.0;
    }
    CorputReal sum = corput_real_add(corput_real_multiply(i, corput_ggx_stretch(alpha, wo)),
        corput_real_multiply(o, corput_ggx_stretch(alpha, wi)));
    return corput_real_float(corput_real_divide(corput_real_shift(corput_real_multiply(o, i), 1), sum));
}

#endif
