// what:   offsets from a pixel's centre by its reconstruction filter: box, tent, truncated
//         Gaussian, as products of two coordinates, with pdf and inverse.
// source: Ernst, Stamminger and Greiner 2006, Filter importance sampling; PBRT 4th ed.,
//         8.8; the Gaussian by the quantile of its part between the edges.
// domain: radius > 0, sigma > 0, two fractions of 2^32, which stand for midpoints of their
//         parts. radius <= 0 gives the centre; sigma <= 0 likewise, with a pdf that the
//         largest float bounds; a NaN counts as an infinity.
// range:  coordinates from -radius to radius.
// pdf:    with respect to area: 1 / (2 r), (1 - |x|/r) / r, and the normal density over the
//         mass between the edges, a coordinate; 0 beyond the radius. That of a sample is
//         the one before its coordinates are rounded.
// errors: coordinates 0.54 ULP, the Gaussian's 0.6 ULP; pdf of a sample 0.6 ULP, the
//         Gaussian's 2.5 ULP.
// cost:   box 60, tent 300, Gaussian 900 integer instructions. tier I.
// hooks:  none.
// mirror: src/reference/filter.rs
#ifndef CORPUT_FILTER_GLSL
#define CORPUT_FILTER_GLSL

#include "corput/gaussian.glsl"

// An offset from the pixel's centre, and its pdf.
struct CorputFilterSample {
    vec2 p;
    float pdf;
};

// A truncated Gaussian: its edge and deviation, and the mass of the normal distribution
// from 0 to the edge and beyond it.
struct CorputFilterGaussian {
    CorputReal radius;
    CorputReal sigma;
    CorputReal mass;
    CorputReal tail;
};

// The share of its half below u's midpoint, counted from the middle, as a fraction of
// 2^32: an odd number.
uint corput_filter_share(uint u) {
    uint upper = u < 0x80000000u ? ~u : u;
    return (upper << 1) | 1u;
}

// The fraction with this share of the half on x's side.
uint corput_filter_fraction(CorputReal share, float x) {
    uint half_u = corput_real_fraction(share) >> 1;
    return floatBitsToUint(x) > 0x80000000u ? 0x7fffffffu - half_u : 0x80000000u | half_u;
}

// The float of this distance, at most the radius, on the side of u.
float corput_filter_offset(CorputReal d, CorputReal radius, uint u) {
    CorputReal nearer = corput_real_min(d, radius);
    return corput_real_float(CorputReal(nearer.m, nearer.e, nearer.m != 0u && u < 0x80000000u));
}

// |x|.
CorputReal corput_filter_distance(float x) {
    return corput_real(uintBitsToFloat(floatBitsToUint(x) & 0x7fffffffu));
}

// A square around the centre.
CorputFilterSample corput_filter_box(float radius, uvec2 u) {
    CorputReal r = corput_real_positive(radius);
    vec2 p = vec2(0.0);
    for (uint i = 0u; i < 2u; i++) {
        CorputReal x = corput_real_multiply(r, corput_real_uint(corput_filter_share(u[i]), -32));
        p[i] = corput_filter_offset(x, r, u[i]);
    }
    return CorputFilterSample(p, corput_gaussian_area_pdf(corput_real_uint(1u, -2), r));
}

// 1 / (4 r^2) within the square.
float corput_filter_box_pdf(float radius, vec2 p) {
    CorputReal r = corput_real_positive(radius);
    if (corput_real_less(r, corput_real_max(corput_filter_distance(p.x), corput_filter_distance(p.y)))) {
        return 0.0;
    }
    return corput_gaussian_area_pdf(corput_real_uint(1u, -2), r);
}

// The fractions that give this offset.
uvec2 corput_filter_box_invert(float radius, vec2 p) {
    CorputReal r = corput_real_positive(radius);
    uvec2 u = uvec2(0u);
    for (uint i = 0u; i < 2u; i++) {
        u[i] = corput_filter_fraction(corput_real_divide(corput_filter_distance(p[i]), r), p[i]);
    }
    return u;
}

// 1 - |x|/r for a sample's coordinate: the root of what lies outside.
CorputReal corput_tent_height(uint share) {
    return corput_real_sqrt(corput_real_uint(0u - share, -32));
}

// |x|/r for a sample's coordinate.
CorputReal corput_tent_distance(uint share, CorputReal height) {
    // 1 - sqrt(1 - a) = a / (1 + sqrt(1 - a)).
    return corput_real_divide(corput_real_uint(share, -32), corput_real_add(corput_real_uint(1u, 0), height));
}

// The share of the half within |x|.
CorputReal corput_tent_share(CorputReal radius, float x) {
    CorputReal d = corput_real_min(corput_real_divide(corput_filter_distance(x), radius), corput_real_uint(1u, 0));
    return corput_real_multiply(d, corput_real_subtract(corput_real_uint(2u, 0), d));
}

// A pyramid around the centre.
CorputFilterSample corput_filter_tent(float radius, uvec2 u) {
    CorputReal r = corput_real_positive(radius);
    CorputReal density = corput_real_uint(1u, 0);
    vec2 p = vec2(0.0);
    for (uint i = 0u; i < 2u; i++) {
        uint share = corput_filter_share(u[i]);
        CorputReal height = corput_tent_height(share);
        density = corput_real_multiply(density, height);
        p[i] = corput_filter_offset(corput_real_multiply(r, corput_tent_distance(share, height)), r, u[i]);
    }
    return CorputFilterSample(p, corput_gaussian_area_pdf(density, r));
}

// (1 - |x|/r) (1 - |y|/r) / r^2.
float corput_filter_tent_pdf(float radius, vec2 p) {
    CorputReal r = corput_real_positive(radius);
    CorputReal density = corput_real_uint(1u, 0);
    for (uint i = 0u; i < 2u; i++) {
        CorputReal rest = corput_real_subtract(r, corput_filter_distance(p[i]));
        rest = corput_real_max(rest, corput_real_zero());
        density = corput_real_multiply(density, corput_real_divide(rest, r));
    }
    return corput_gaussian_area_pdf(density, r);
}

// The fractions that give this offset.
uvec2 corput_filter_tent_invert(float radius, vec2 p) {
    CorputReal r = corput_real_positive(radius);
    uvec2 u = uvec2(0u);
    for (uint i = 0u; i < 2u; i++) {
        u[i] = corput_filter_fraction(corput_tent_share(r, p[i]), p[i]);
    }
    return u;
}

// The Gaussian of this deviation up to this radius.
CorputFilterGaussian corput_filter_gaussian_prepare(float radius, float sigma) {
    CorputReal r = corput_real_positive(radius);
    CorputReal s = corput_real_positive(sigma);
    CorputReal edge = corput_real_divide(r, s);
    CorputNormalMasses masses = corput_real_normal_masses(edge);
    return CorputFilterGaussian(r, s, masses.mass, masses.tail);
}

// |x| / sigma for a sample's coordinate.
CorputReal corput_filter_gaussian_quantile(CorputFilterGaussian f, uint u) {
    uint share = corput_filter_share(u);
    CorputReal mass = corput_real_multiply(f.mass, corput_real_uint(share, -32));
    CorputReal rest = corput_real_multiply(f.mass, corput_real_uint(0u - share, -32));
    return corput_real_quantile(mass, corput_real_add(f.tail, rest));
}

// The pdf of a coordinate's share of sigma.
CorputReal corput_filter_gaussian_density(CorputFilterGaussian f, CorputReal z) {
    CorputReal scale = corput_real_multiply(f.sigma, corput_real_shift(f.mass, 1));
    return corput_real_divide(corput_real_normal_density(z), scale);
}

// A truncated Gaussian around the centre.
CorputFilterSample corput_filter_gaussian(CorputFilterGaussian f, uvec2 u) {
    CorputReal density = corput_real_uint(1u, 0);
    vec2 p = vec2(0.0);
    for (uint i = 0u; i < 2u; i++) {
        CorputReal z = corput_filter_gaussian_quantile(f, u[i]);
        density = corput_real_multiply(density, corput_filter_gaussian_density(f, z));
        p[i] = corput_filter_offset(corput_real_multiply(z, f.sigma), f.radius, u[i]);
    }
    return CorputFilterSample(p, corput_real_float(density));
}

// The truncated density.
float corput_filter_gaussian_pdf(CorputFilterGaussian f, vec2 p) {
    CorputReal density = corput_real_uint(1u, 0);
    for (uint i = 0u; i < 2u; i++) {
        CorputReal x = corput_filter_distance(p[i]);
        if (corput_real_less(f.radius, x)) {
            return 0.0;
        }
        CorputReal z = corput_real_divide(x, f.sigma);
        density = corput_real_multiply(density, corput_filter_gaussian_density(f, z));
    }
    return corput_real_float(density);
}

// The fractions that give this offset.
uvec2 corput_filter_gaussian_invert(CorputFilterGaussian f, vec2 p) {
    uvec2 u = uvec2(0u);
    for (uint i = 0u; i < 2u; i++) {
        CorputReal z = corput_real_divide(corput_filter_distance(p[i]), f.sigma);
        CorputReal mass = corput_real_normal_masses(z).mass;
        u[i] = corput_filter_fraction(corput_real_divide(mass, f.mass), p[i]);
    }
    return u;
}

#endif
