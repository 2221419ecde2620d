// what:   directions around +z by the phase function of Henyey and Greenstein, with pdf and
//         inverse. +z is the direction of propagation: g > 0 scatters forward, to +z.
// source: Henyey and Greenstein 1941, Diffuse radiation in the galaxy, ApJ 93. With
//         q = 1 - g, D = q + 2 g u: 1 - z = 2 q^2 (1 - u) (1 + g u) / D^2,
//         1 + z = 2 (1 + g)^2 u (q + g u) / D^2, pdf = D^3 / (4 pi (1 - g^2)^2): sums of
//         positive terms, where the common form of z cancels as g^2 nears 1, or 0.
// domain: two fractions of 2^32; z grows with u.x. g in (-1, 1): what is beyond, and NaN,
//         counts as 1 - 2^-24 of its sign. Nearer to 1 or -1, give 1 - |g|: from 2^-63 to 1,
//         what is beyond counts as the end.
// range:  unit vectors to 2^-23.
// pdf:    with respect to solid angle: (1 - g^2) / (4 pi (q^2 + 2 g (1 - z))^(3/2)), with
//         1 - z = (x^2 + y^2) / (1 + z) for z > 0. It is well conditioned: that of a
//         rounded direction is within 6 ULP of the exact direction's. Infinities and NaN are
//         no directions; their pdf is finite.
// errors: x, y and the pdf of a sample 0.6 ULP, z 0.6 ULP or 2^-29. The inverse of a sample
//         is within 2^-22 of it, angles modulo one turn; at the poles the angle is lost.
// cost:   1100 integer instructions. tier I.
// hooks:  none.
// mirror: src/reference/henyey_greenstein.rs
#ifndef CORPUT_HENYEY_GREENSTEIN_GLSL
#define CORPUT_HENYEY_GREENSTEIN_GLSL

#include "corput/scattered.glsl"

// The asymmetry of a phase function.
struct CorputHenyeyGreenstein {
    // |g|.
    CorputReal g;
    // 1 - |g|.
    CorputReal rest;
    // Whether g < 0.
    bool backward;
};

// 1 - z and 1 + z of a unit vector.
struct CorputVersines {
    // 1 - z.
    CorputReal below;
    // 1 + z.
    CorputReal above;
};

// By g.
CorputHenyeyGreenstein corput_henyey_greenstein_prepare(float g) {
    CorputReal given = corput_real(g);
    CorputReal magnitude = corput_real_min(CorputReal(given.m, given.e, false), CorputReal(0xffffff00u, -32, false));
    return CorputHenyeyGreenstein(magnitude, corput_real_subtract(corput_real_uint(1u, 0), magnitude),
        given.negative);
}

// By rest = 1 - |g|, which says more than g where g is near 1 or -1.
CorputHenyeyGreenstein corput_henyey_greenstein_complement(float rest, bool backward) {
    CorputReal one = corput_real_uint(1u, 0);
    CorputReal clamped = corput_real_min(corput_real_max(corput_real(rest), corput_real_uint(1u, -63)), one);
    return CorputHenyeyGreenstein(corput_real_subtract(one, clamped), clamped, backward);
}

// Direction and pdf.
CorputScattered corput_henyey_greenstein(CorputHenyeyGreenstein h, uvec2 u) {
    CorputReal a = corput_real_uint(u.x, -32);
    CorputReal b = corput_real_complement(u.x);
    if (h.backward) {
        a = corput_real_complement(u.x);
        b = corput_real_uint(u.x, -32);
    }
    CorputReal one = corput_real_uint(1u, 0);
    CorputReal sum = corput_real_add(one, h.g);
    CorputReal bent = corput_real_multiply(h.g, a);
    CorputReal near = corput_real_multiply(b, corput_real_add(one, bent));
    CorputReal far = corput_real_multiply(a, corput_real_add(h.rest, bent));
    CorputReal d = corput_real_add(h.rest, corput_real_shift(bent, 1));
    CorputReal k = corput_real_divide(corput_real_uint(2u, 0), corput_real_square(d));
    CorputReal product = corput_real_multiply(h.rest, sum);
    CorputReal below = corput_real_multiply(corput_real_multiply(k, corput_real_square(h.rest)), near);
    CorputReal above = corput_real_multiply(corput_real_multiply(k, corput_real_square(sum)), far);
    CorputReal z = corput_real_subtract(one, below);
    if (corput_real_less(above, below)) {
        z = corput_real_subtract(above, one);
    }
    if (h.backward) {
        z = corput_real_negate(z);
    }
    CorputReal radius = corput_real_multiply(corput_real_multiply(k, product),
        corput_real_sqrt(corput_real_multiply(near, far)));
    CorputReal pdf = corput_real_divide(corput_real_multiply(d, corput_real_square(d)),
        corput_real_square(product));
    // 1 / (4 pi).
    pdf = corput_real_multiply(pdf, CorputReal(2734261102u, -35, false));
    return corput_scattered(corput_real3_around(radius, u.y, z), pdf);
}

// 1 - z and 1 + z of a direction, neither by a difference that cancels.
CorputVersines corput_henyey_greenstein_versines(vec3 direction) {
    CorputReal3 d = corput_real3(direction);
    CorputReal one = corput_real_uint(1u, 0);
    CorputReal square = corput_real_add(corput_real_square(d.x), corput_real_square(d.y));
    CorputReal above = corput_real_add(one, CorputReal(d.z.m, d.z.e, false));
    CorputReal below = corput_real_divide(square, above);
    if (d.z.negative) {
        return CorputVersines(above, below);
    }
    return CorputVersines(below, above);
}

// The pdf of a direction.
float corput_henyey_greenstein_pdf(CorputHenyeyGreenstein h, vec3 direction) {
    CorputVersines v = corput_henyey_greenstein_versines(direction);
    CorputReal below = v.below;
    if (h.backward) {
        below = v.above;
    }
    CorputReal square = corput_real_add(corput_real_square(h.rest),
        corput_real_shift(corput_real_multiply(h.g, below), 1));
    CorputReal cube = corput_real_multiply(square, corput_real_sqrt(square));
    CorputReal product = corput_real_multiply(h.rest, corput_real_add(corput_real_uint(1u, 0), h.g));
    // 1 / (4 pi).
    CorputReal scaled = corput_real_multiply(product, CorputReal(2734261102u, -35, false));
    return corput_real_float(corput_real_divide(scaled, cube));
}

// The fractions that give this direction.
uvec2 corput_henyey_greenstein_invert(CorputHenyeyGreenstein h, vec3 direction) {
    CorputVersines v = corput_henyey_greenstein_versines(direction);
    CorputReal below = v.below;
    CorputReal above = v.above;
    if (h.backward) {
        below = v.above;
        above = v.below;
    }
    CorputReal sum = corput_real_add(corput_real_uint(1u, 0), h.g);
    CorputReal root = corput_real_sqrt(corput_real_add(corput_real_square(h.rest),
        corput_real_shift(corput_real_multiply(h.g, below), 1)));
    CorputReal a = corput_real_divide(corput_real_multiply(h.rest, above),
        corput_real_multiply(root, corput_real_add(sum, root)));
    CorputReal b = corput_real_divide(corput_real_multiply(sum, below),
        corput_real_multiply(root, corput_real_add(h.rest, root)));
    uint phi = corput_atan2(direction.y, direction.x);
    if (h.backward) {
        return uvec2(corput_real_fraction_of(b, a), phi);
    }
    return uvec2(corput_real_fraction_of(a, b), phi);
}

#endif
