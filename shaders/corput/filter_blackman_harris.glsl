// what:   offsets from a pixel's centre by the 4-term window of Blackman and Harris, as a
//         product of two coordinates, with pdf and inverse.
// source: Harris 1978, On the use of windows for harmonic analysis with the discrete
//         Fourier transform, table 1, 4 terms of -92 dB; Ernst, Stamminger and Greiner
//         2006, Filter importance sampling. The exact inverse of the cumulative
//         distribution by 5 steps of Newton's method, from the middle or from the edge,
//         whichever is nearer: the window ends at 6e-5, where 1 less the mass has no
//         digits. Polynomials by scripts/blackman_harris.py.
// domain: radius > 0, two fractions of 2^32, which stand for midpoints of their parts.
//         radius <= 0 gives the centre; a NaN counts as an infinity.
// range:  coordinates from -radius to radius.
// pdf:    with respect to area: w(x/r) / (2 a0 r) a coordinate, w(t) = a0 + a1 cos(pi t) +
//         a2 cos(2 pi t) + a3 cos(3 pi t); 0 beyond the radius. That of a sample is the one
//         before its coordinates are rounded.
// errors: coordinates 0.6 ULP, pdf of a sample 1 ULP.
// cost:   3000 integer instructions. tier I.
// hooks:  none.
// mirror: src/reference/filter_blackman_harris.rs
#ifndef CORPUT_FILTER_BLACKMAN_HARRIS_GLSL
#define CORPUT_FILTER_BLACKMAN_HARRIS_GLSL

#include "corput/filter.glsl"

// A distance of at most half the radius, as a share of it: from the middle or the edge.
struct CorputBlackmanHarris {
    CorputReal x;
    bool edge;
};

// w / a0 in the middle, or at the edge.
CorputReal corput_blackman_harris_end(bool edge) {
    if (edge) {
        return CorputReal(2942247143u, -44, false);
    }
    return CorputReal(2993008569u, -30, false);
}

// |mass / x - end| / z, z a fraction of 2^32.
CorputReal corput_blackman_harris_integral(uint z, bool edge) {
    if (edge) {
        uint p = 529456u - corput_mulhi(z, 35059u);
        p = 4870504u - corput_mulhi(z, p);
        p = 29919324u - corput_mulhi(z, p);
        p = 100155239u - corput_mulhi(z, p);
        p = 2777020u + corput_mulhi(z, p);
        p = 1003538625u - corput_mulhi(z, p);
        return corput_real_uint(278560413u + corput_mulhi(z, p), -33);
    }
    uint p = 72044u - corput_mulhi(z, 4573u);
    p = 734309u - corput_mulhi(z, p);
    p = 5723992u - corput_mulhi(z, p);
    p = 34632754u - corput_mulhi(z, p);
    p = 160972548u - corput_mulhi(z, p);
    p = 561051895u - corput_mulhi(z, p);
    return corput_real_uint(1425948196u - corput_mulhi(z, p), -30);
}

// |density - end| / z, z a fraction of 2^32.
CorputReal corput_blackman_harris_slope(uint z, bool edge) {
    if (edge) {
        uint p = 376026u - corput_mulhi(z, 21810u);
        p = 4082724u - corput_mulhi(z, p);
        p = 31740190u - corput_mulhi(z, p);
        p = 164588727u - corput_mulhi(z, p);
        p = 450705315u - corput_mulhi(z, p);
        p = 9718918u + corput_mulhi(z, p);
        p = 2508846541u - corput_mulhi(z, p);
        return corput_real_uint(417840620u + corput_mulhi(z, p), -32);
    }
    uint p = 97622u - corput_mulhi(z, 5557u);
    p = 1109150u - corput_mulhi(z, p);
    p = 9566883u - corput_mulhi(z, p);
    p = 62972181u - corput_mulhi(z, p);
    p = 311696501u - corput_mulhi(z, p);
    p = 1126808004u - corput_mulhi(z, p);
    p = 2805259479u - corput_mulhi(z, p);
    return corput_real_uint(4277844588u - corput_mulhi(z, p), -30);
}

// 4 x^2.
CorputReal corput_blackman_harris_square(CorputReal x) {
    return corput_real_shift(corput_real_square(x), 2);
}

// w / a0 there: the density of the distance.
CorputReal corput_blackman_harris_density(CorputBlackmanHarris at) {
    CorputReal square = corput_blackman_harris_square(at.x);
    CorputReal rest = corput_real_multiply(square, corput_blackman_harris_slope(corput_real_fraction(square), at.edge));
    return corput_real_add(corput_blackman_harris_end(at.edge), CorputReal(rest.m, rest.e, rest.m != 0u && !at.edge));
}

// The mass of the half between there and the middle or the edge.
CorputReal corput_blackman_harris_mass(CorputBlackmanHarris at) {
    CorputReal square = corput_blackman_harris_square(at.x);
    CorputReal rest = corput_real_multiply(square, corput_blackman_harris_integral(corput_real_fraction(square), at.edge));
    CorputReal mean = corput_real_add(corput_blackman_harris_end(at.edge), CorputReal(rest.m, rest.e, rest.m != 0u && !at.edge));
    return corput_real_multiply(at.x, mean);
}

// Where this share of the half, a fraction of 2^32 other than 0, lies within.
CorputBlackmanHarris corput_blackman_harris_quantile(uint share) {
    // 3993430636 = 2^32 times the share of the inner half of the radius.
    bool edge = share > 3993430636u;
    CorputReal mass = corput_real_uint(edge ? 0u - share : share, -32);
    CorputReal x = corput_real_divide(mass, corput_blackman_harris_end(edge));
    if (edge) {
        CorputReal root = corput_real_sqrt(corput_real_sqrt(mass));
        x = corput_real_min(corput_real_min(x, root), corput_real_uint(1u, -1));
    }
    CorputBlackmanHarris at = CorputBlackmanHarris(x, edge);
    // From there on 2^-40 of x in five steps.
    for (uint i = 0u; i < 5u; i++) {
        CorputReal excess = corput_real_subtract(corput_blackman_harris_mass(at), mass);
        at.x = corput_real_subtract(at.x, corput_real_divide(excess, corput_blackman_harris_density(at)));
    }
    return at;
}

// Where |x| lies, at most the radius.
CorputBlackmanHarris corput_blackman_harris_locate(CorputReal radius, float x) {
    CorputReal d = corput_filter_distance(x);
    CorputReal rest = corput_real_max(corput_real_subtract(radius, d), corput_real_zero());
    if (corput_real_less(d, rest)) {
        return CorputBlackmanHarris(corput_real_divide(d, radius), false);
    }
    return CorputBlackmanHarris(corput_real_divide(rest, radius), true);
}

// The window around the centre.
CorputFilterSample corput_filter_blackman_harris(float radius, uvec2 u) {
    CorputReal r = corput_real_positive(radius);
    CorputReal density = corput_real_uint(1u, -2);
    vec2 p = vec2(0.0);
    for (uint i = 0u; i < 2u; i++) {
        CorputBlackmanHarris at = corput_blackman_harris_quantile(corput_filter_share(u[i]));
        density = corput_real_multiply(density, corput_blackman_harris_density(at));
        CorputReal d = at.x;
        if (at.edge) {
            d = corput_real_subtract(corput_real_uint(1u, 0), d);
        }
        p[i] = corput_filter_offset(corput_real_multiply(r, d), r, u[i]);
    }
    return CorputFilterSample(p, corput_gaussian_area_pdf(density, r));
}

// w(x/r) w(y/r) / (2 a0 r)^2 within the square.
float corput_filter_blackman_harris_pdf(float radius, vec2 p) {
    CorputReal r = corput_real_positive(radius);
    if (corput_real_less(r, corput_real_max(corput_filter_distance(p.x), corput_filter_distance(p.y)))) {
        return 0.0;
    }
    CorputReal density = corput_real_uint(1u, -2);
    for (uint i = 0u; i < 2u; i++) {
        density = corput_real_multiply(density, corput_blackman_harris_density(corput_blackman_harris_locate(r, p[i])));
    }
    return corput_gaussian_area_pdf(density, r);
}

// The fractions that give this offset.
uvec2 corput_filter_blackman_harris_invert(float radius, vec2 p) {
    CorputReal r = corput_real_positive(radius);
    uvec2 u = uvec2(0u);
    for (uint i = 0u; i < 2u; i++) {
        CorputBlackmanHarris at = corput_blackman_harris_locate(r, p[i]);
        CorputReal share = corput_blackman_harris_mass(at);
        if (at.edge) {
            share = corput_real_subtract(corput_real_uint(1u, 0), share);
        }
        u[i] = corput_filter_fraction(share, p[i]);
    }
    return u;
}

#endif
