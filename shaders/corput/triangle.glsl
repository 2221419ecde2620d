// what:   points of a triangle in the plane, uniformly, with pdf and inverse.
// source: Heitz 2019, A low-distortion map between triangle and square: continuous, and
//         without a root, so that barycentric coordinates are integers of an exact sum.
// domain: three vertices, two fractions of 2^32, of which 30 bits count.
//         A degenerate triangle: points of it, with pdf 0, inverse (0, 0).
// range:  the triangle; barycentric coordinates >= 0 that sum to 2^31 exactly.
// pdf:    with respect to area: 1 over it inside. Edges are widened by 2^-22 of the largest
//         coordinate and of the triangle, so that no sample falls outside by its rounding.
// errors: 0.6 ULP, or 2^-29 of the largest vertex where they cancel; pdf 0.6 ULP, for
//         angles down to 1e-7. The inverse agrees with the sample to 2^-20, more where the
//         rounding of a point is more of the triangle.
// cost:   a point 600, a pdf 1,200 integer instructions. tier I.
// hooks:  none.
// mirror: src/reference/triangle.rs
#ifndef CORPUT_TRIANGLE_GLSL
#define CORPUT_TRIANGLE_GLSL

#include "corput/sphere.glsl"
#include "corput/wide.glsl"

// Barycentric coordinates as fractions of 2^31, whose sum is 2^31.
uvec3 corput_triangle_weights(uvec2 u) {
    uint x = u.x >> 2;
    uint y = u.y >> 2;
    if (y > x) {
        return uvec3(x, 2u * y - x, 0x80000000u - 2u * y);
    }
    return uvec3(2u * x - y, y, 0x80000000u - 2u * x);
}

// a, b and c by their weights.
CorputReal corput_triangle_mean(float a, float b, float c, uvec3 weights) {
    CorputReal x = corput_real_multiply(corput_real(a), corput_real_uint(weights.x, -31));
    CorputReal y = corput_real_multiply(corput_real(b), corput_real_uint(weights.y, -31));
    CorputReal z = corput_real_multiply(corput_real(c), corput_real_uint(weights.z, -31));
    return corput_real_add(corput_real_add(x, y), z);
}

// Twice the area of a, b, c; negative if they turn clockwise.
CorputReal corput_triangle_area(vec2 a, vec2 b, vec2 c) {
    CorputReal x = corput_real(a.x);
    CorputReal y = corput_real(a.y);
    return corput_wide_real(corput_wide_determinant(
        corput_real_subtract(corput_real(b.x), x), corput_real_subtract(corput_real(b.y), y),
        corput_real_subtract(corput_real(c.x), x), corput_real_subtract(corput_real(c.y), y)));
}

// Uniform point of the triangle.
vec2 corput_triangle(vec2 a, vec2 b, vec2 c, uvec2 u) {
    uvec3 weights = corput_triangle_weights(u);
    return vec2(corput_real_float(corput_triangle_mean(a.x, b.x, c.x, weights)),
        corput_real_float(corput_triangle_mean(a.y, b.y, c.y, weights)));
}

// The magnitude of a vector's larger coordinate.
CorputReal corput_triangle_size(CorputReal x, CorputReal y) {
    return corput_real_max(CorputReal(x.m, x.e, false), CorputReal(y.m, y.e, false));
}

// Whether p is on the inner side of ab, or beyond it by its rounding.
bool corput_triangle_side(vec2 a, vec2 b, vec2 p, bool clockwise) {
    CorputReal area = corput_triangle_area(a, b, p);
    if (clockwise) {
        area = corput_real_negate(area);
    }
    CorputReal side = corput_triangle_size(corput_real_subtract(corput_real(b.x), corput_real(a.x)),
        corput_real_subtract(corput_real(b.y), corput_real(a.y)));
    CorputReal size = corput_triangle_size(corput_real(p.x), corput_real(p.y));
    CorputReal slack = corput_real_shift(corput_real_multiply(side, corput_real_add(side, size)), -22);
    return !corput_real_add(area, slack).negative;
}

// 1 over the area inside, else 0.
float corput_triangle_pdf(vec2 a, vec2 b, vec2 c, vec2 p) {
    CorputReal area = corput_triangle_area(a, b, c);
    if (area.m == 0u || !corput_triangle_side(a, b, p, area.negative)
        || !corput_triangle_side(b, c, p, area.negative) || !corput_triangle_side(c, a, p, area.negative)) {
        return 0.0;
    }
    return corput_real_float(corput_real_divide(corput_real_uint(2u, 0), CorputReal(area.m, area.e, false)));
}

// The fractions that give this point.
uvec2 corput_triangle_invert(vec2 a, vec2 b, vec2 c, vec2 p) {
    CorputReal area = corput_triangle_area(a, b, c);
    if (area.m == 0u) {
        return uvec2(0u);
    }
    CorputReal zero = corput_real_zero();
    CorputReal x = corput_real_max(corput_real_divide(corput_triangle_area(p, b, c), area), zero);
    CorputReal y = corput_real_max(corput_real_divide(corput_triangle_area(p, c, a), area), zero);
    uint sum = corput_real_fraction_nearest(corput_real_add(x, y));
    if (corput_real_less(x, y)) {
        return uvec2(corput_real_fraction_nearest(corput_real_shift(x, 1)), sum);
    }
    return uvec2(sum, corput_real_fraction_nearest(corput_real_shift(y, 1)));
}

#endif
