// what:   offsets from a pixel's centre by the 4-term window of Blackman and Harris in the
//         native profile, with pdf and inverse.
// source: as filter_blackman_harris.glsl, in float.
// domain: radius from 1e-30 on, below it counts as that; two fractions.
// pdf:    with respect to area; that of a sample by its fractions.
// errors: 2^-20 of the radius, 2^-17 of the pdf of a sample.
// cost:   300 float instructions.
// hooks:  none.
// mirror: src/reference/native/filter_blackman_harris.rs
#ifndef CORPUT_NATIVE_FILTER_BLACKMAN_HARRIS_GLSL
#define CORPUT_NATIVE_FILTER_BLACKMAN_HARRIS_GLSL

#include "corput/native/filter.glsl"

// A distance of at most half the radius, as a share of it: from the middle or the edge.
struct CorputNativeBlackmanHarris {
    float x;
    bool edge;
};

// w / a0 in the middle, or at the edge.
float corput_native_blackman_harris_end(bool edge) {
    return edge ? 0.000167247387 : 2.78745645;
}

// |mass / x - end| / z.
float corput_native_blackman_harris_integral(float z, bool edge) {
    if (edge) {
        float p = 6.16367906e-05 - z * 4.08140477e-06;
        p = 0.000567001291 - z * p;
        p = 0.00348306773 - z * p;
        p = 0.0116596044 - z * p;
        p = 0.000323287677 + z * p;
        p = 0.116827272 - z * p;
        return 0.0324287001 + z * p;
    }
    float p = 6.70962036e-05 - z * 4.25893813e-06;
    p = 0.000683878548 - z * p;
    p = 0.00533088297 - z * p;
    p = 0.0322542656 - z * p;
    p = 0.149917368 - z * p;
    p = 0.522520295 - z * p;
    return 1.32801775 - z * p;
}

// |density - end| / z.
float corput_native_blackman_harris_slope(float z, bool edge) {
    if (edge) {
        float p = 8.75503756e-05 - z * 5.07803634e-06;
        p = 0.000950583257 - z * p;
        p = 0.00739008887 - z * p;
        p = 0.0383212992 - z * p;
        p = 0.104938009 - z * p;
        p = 0.00226286193 + z * p;
        p = 0.584136355 - z * p;
        return 0.0972861005 + z * p;
    }
    float p = 9.09175724e-05 - z * 5.17535955e-06;
    p = 0.00103297643 - z * p;
    p = 0.00890985411 - z * p;
    p = 0.0586474137 - z * p;
    p = 0.290289988 - z * p;
    p = 1.04942173 - z * p;
    p = 2.61260148 - z * p;
    return 3.98405324 - z * p;
}

// w / a0 there: the density of the distance.
float corput_native_blackman_harris_density(CorputNativeBlackmanHarris at) {
    float z = 4.0 * at.x * at.x;
    float rest = z * corput_native_blackman_harris_slope(z, at.edge);
    return corput_native_blackman_harris_end(at.edge) + corput_native_filter_side(rest, !at.edge);
}

// The mass of the half between there and the middle or the edge.
float corput_native_blackman_harris_mass(CorputNativeBlackmanHarris at) {
    float z = 4.0 * at.x * at.x;
    float rest = z * corput_native_blackman_harris_integral(z, at.edge);
    return at.x * (corput_native_blackman_harris_end(at.edge) + corput_native_filter_side(rest, !at.edge));
}

// Where this share of the half, a fraction of 2^32 other than 0, lies within.
CorputNativeBlackmanHarris corput_native_blackman_harris_quantile(uint share) {
    bool edge = share > 3993430636u;
    float mass = corput_native_unit(edge ? 0u - share : share);
    float x = mass / corput_native_blackman_harris_end(edge);
    if (edge) {
        x = min(min(x, sqrt(sqrt(mass))), 0.5);
    }
    CorputNativeBlackmanHarris at = CorputNativeBlackmanHarris(x, edge);
    for (uint i = 0u; i < 5u; i++) {
        float excess = corput_native_blackman_harris_mass(at) - mass;
        at.x -= excess / corput_native_blackman_harris_density(at);
    }
    return at;
}

// Where |x| lies, at most the radius.
CorputNativeBlackmanHarris corput_native_blackman_harris_locate(float radius, float x) {
    float d = abs(x);
    float rest = max(radius - d, 0.0);
    if (d < rest) {
        return CorputNativeBlackmanHarris(d / radius, false);
    }
    return CorputNativeBlackmanHarris(rest / radius, true);
}

// The window around the centre.
CorputNativeFilterSample corput_native_filter_blackman_harris(float radius, uvec2 u) {
    float r = corput_native_positive(radius);
    CorputNativeBlackmanHarris x = corput_native_blackman_harris_quantile(corput_native_filter_share(u.x));
    CorputNativeBlackmanHarris y = corput_native_blackman_harris_quantile(corput_native_filter_share(u.y));
    float right = x.edge ? 1.0 - x.x : x.x;
    float up = y.edge ? 1.0 - y.x : y.x;
    vec2 p = corput_native_filter_point(r * right, r * up, u);
    float pdf = corput_native_blackman_harris_density(x) / r * (corput_native_blackman_harris_density(y) / r);
    return CorputNativeFilterSample(p, 0.25 * pdf);
}

// w(x/r) w(y/r) / (2 a0 r)^2 within the square.
float corput_native_filter_blackman_harris_pdf(float radius, vec2 p) {
    float r = corput_native_positive(radius);
    if (max(abs(p.x), abs(p.y)) > r) {
        return 0.0;
    }
    float x = corput_native_blackman_harris_density(corput_native_blackman_harris_locate(r, p.x));
    float y = corput_native_blackman_harris_density(corput_native_blackman_harris_locate(r, p.y));
    return 0.25 * (x / r) * (y / r);
}

// The fractions that give this offset.
uvec2 corput_native_filter_blackman_harris_invert(float radius, vec2 p) {
    float r = corput_native_positive(radius);
    CorputNativeBlackmanHarris x = corput_native_blackman_harris_locate(r, p.x);
    CorputNativeBlackmanHarris y = corput_native_blackman_harris_locate(r, p.y);
    float right = corput_native_blackman_harris_mass(x);
    float up = corput_native_blackman_harris_mass(y);
    return corput_native_filter_fractions(x.edge ? 1.0 - right : right, y.edge ? 1.0 - up : up, p);
}

#endif
