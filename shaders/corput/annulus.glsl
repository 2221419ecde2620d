// what:   points of the annulus between an inner radius and 1, uniformly, with pdf and
//         inverse.
// source: inversion of the radial CDF: r^2 = i^2 + u (1 - i) (1 + i), in which nothing cancels.
// domain: an inner radius i from 0 to 1, others count as the nearest of them, a NaN as an
//         infinity of its sign; two fractions of 2^32. i = 1: points of the circle, with pdf 0.
// range:  i (1 - 2^-23) <= |p| <= 1 + 2^-23.
// pdf:    with respect to area: 1 / (pi (1 - i) (1 + i)) inside. Edges are widened by 2^-22,
//         so that no sample falls outside by its rounding.
// errors: 0.6 ULP a coordinate; pdf 0.6 ULP. The inverse agrees with the sample to 2^-22 of 1 /
//         (1 - i^2), and in the angle to 2^-24; at the centre the angle is lost.
// cost:   250 integer instructions. tier I.
// hooks:  none.
// mirror: src/reference/annulus.rs
#ifndef CORPUT_ANNULUS_GLSL
#define CORPUT_ANNULUS_GLSL

#include "corput/sphere.glsl"
#include "corput/wide.glsl"

// The inner radius within its domain.
CorputReal corput_annulus_inner(float inner) {
    return corput_real_min(corput_real_max(corput_real(inner), corput_real_zero()), corput_real_uint(1u, 0));
}

// (1 - i) (1 + i).
CorputReal corput_annulus_width(CorputReal inner) {
    CorputReal one = corput_real_uint(1u, 0);
    return corput_real_multiply(corput_real_subtract(one, inner), corput_real_add(one, inner));
}

// Uniform point of the annulus: |p|^2 = i^2 + u.x (1 - i^2), at the angle 2 pi u.y.
vec2 corput_annulus(float inner, uvec2 u) {
    CorputReal i = corput_annulus_inner(inner);
    CorputReal part = corput_real_multiply(corput_annulus_width(i), corput_real_uint(u.x, -32));
    CorputReal radius = corput_real_sqrt(corput_real_add(corput_real_square(i), part));
    CorputReal3 p = corput_sphere_direction(radius, u.y, corput_real_zero());
    return vec2(corput_real_float(p.x), corput_real_float(p.y));
}

// |p|^2 - i^2.
CorputReal corput_annulus_excess(CorputReal inner, vec2 p) {
    CorputReal x = corput_real(p.x);
    CorputReal y = corput_real(p.y);
    CorputWide square = corput_wide_add(corput_wide_product(x, x), corput_wide_product(y, y));
    return corput_wide_real(corput_wide_add(square, corput_wide_product(corput_real_negate(inner), inner)));
}

// 1/(pi (1 - i^2)) inside, else 0.
float corput_annulus_pdf(float inner, vec2 p) {
    CorputReal i = corput_annulus_inner(inner);
    CorputReal width = corput_annulus_width(i);
    CorputReal excess = corput_annulus_excess(i, p);
    CorputReal slack = corput_real_shift(corput_real_square(i), -22);
    CorputReal most = corput_real_add(width, corput_real_uint(1u, -22));
    if (width.m == 0u || corput_real_add(excess, slack).negative || corput_real_less(most, excess)) {
        return 0.0;
    }
    // 1/pi to 32 bits.
    return corput_real_float(corput_real_divide(corput_real_uint(2734261102u, -33), width));
}

// The fractions that give this point.
uvec2 corput_annulus_invert(float inner, vec2 p) {
    CorputReal i = corput_annulus_inner(inner);
    CorputReal part = corput_real_divide(corput_annulus_excess(i, p), corput_annulus_width(i));
    return uvec2(corput_real_fraction_nearest(part), corput_atan2(p.y, p.x));
}

#endif
