// what:   points of a triangle in the plane in the native profile, uniformly, with pdf and
//         inverse.
// source: Heitz 2019, A low-distortion map between triangle and square.
// domain: three vertices up to 1e18 apart, two fractions of 2^32. A degenerate triangle: points
//         of it, with pdf 0, inverse (0, 0).
// range:  the triangle, to the device's precision.
// pdf:    with respect to area: 1 over it inside; edges widened by 2^-18 of coordinates.
// errors: a few roundings of the largest vertex.
// cost:   about 20 float instructions.
// hooks:  none.
// mirror: src/reference/native/triangle.rs
#ifndef CORPUT_NATIVE_TRIANGLE_GLSL
#define CORPUT_NATIVE_TRIANGLE_GLSL

#include "corput/native/disk.glsl"

// Twice the area of a, b, c; negative if they turn clockwise.
float corput_native_triangle_area(vec2 a, vec2 b, vec2 c) {
    vec2 x = b - a;
    vec2 y = c - a;
    return x.x * y.y - x.y * y.x;
}

// Uniform point of the triangle.
vec2 corput_native_triangle(vec2 a, vec2 b, vec2 c, uvec2 u) {
    float x = corput_native_unit(u.x);
    float y = corput_native_unit(u.y);
    if (y > x) {
        return 0.5 * x * a + (y - 0.5 * x) * b + (1.0 - y) * c;
    }
    return (x - 0.5 * y) * a + 0.5 * y * b + (1.0 - x) * c;
}

// Whether p is on the inner side of ab, or beyond it by its rounding.
bool corput_native_triangle_side(vec2 a, vec2 b, vec2 p, float sign) {
    vec2 side = abs(b - a);
    float size = max(side.x, side.y);
    float slack = 3.8146973e-6 * size * (size + max(abs(p.x), abs(p.y)));
    return sign * corput_native_triangle_area(a, b, p) >= -slack;
}

// 1 over the area inside, else 0.
float corput_native_triangle_pdf(vec2 a, vec2 b, vec2 c, vec2 p) {
    float area = corput_native_triangle_area(a, b, c);
    float sign = area < 0.0 ? -1.0 : 1.0;
    bool inside = abs(area) > 1e-37 && corput_native_triangle_side(a, b, p, sign)
        && corput_native_triangle_side(b, c, p, sign) && corput_native_triangle_side(c, a, p, sign);
    return inside ? 2.0 / abs(area) : 0.0;
}

// The fractions that give this point.
uvec2 corput_native_triangle_invert(vec2 a, vec2 b, vec2 c, vec2 p) {
    float area = corput_native_triangle_area(a, b, c);
    bool flat_one = abs(area) <= 1e-37;
    if (flat_one) {
        return uvec2(0u);
    }
    float x = max(corput_native_triangle_area(p, b, c) / area, 0.0);
    float y = max(corput_native_triangle_area(p, c, a) / area, 0.0);
    if (y > x) {
        return uvec2(corput_native_fraction(2.0 * x), corput_native_fraction(x + y));
    }
    return uvec2(corput_native_fraction(x + y), corput_native_fraction(2.0 * y));
}

#endif
