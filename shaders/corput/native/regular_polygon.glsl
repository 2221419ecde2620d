// what:   points of a regular polygon of circumradius 1 with a vertex at (1, 0) in the native
//         profile, uniformly, with pdf and inverse.
// source: the polygon's triangles from the centre in turn.
// domain: 3 to 65,536 sides, others count as the nearest of them; two fractions of 2^32.
// range:  the polygon, to the device's precision.
// pdf:    with respect to area: 1 / (n sin(pi/n) cos(pi/n)) inside; the edge widened by 2^-10.
// errors: Vulkan allows sin and cos an absolute error of 2^-11, n times as much in the pdf.
// cost:   about 40 float instructions.
// hooks:  none.
// mirror: src/reference/native/regular_polygon.rs
#ifndef CORPUT_NATIVE_REGULAR_POLYGON_GLSL
#define CORPUT_NATIVE_REGULAR_POLYGON_GLSL

#include "corput/native/disk.glsl"

// The sine of pi/n, with its digits for many sides.
float corput_native_regular_polygon_sine(float sides) {
    float angle = 3.1415927 / sides;
    float square = angle * angle;
    if (sides < 13.0) {
        return sin(angle);
    }
    return angle * (1.0 - square * (0.16666667 - square * (0.0083333333 - square * 0.00019841270)));
}

// Sides within their domain.
float corput_native_regular_polygon_sides(uint sides) {
    return float(clamp(sides, 3u, 65536u));
}

// Uniform point of the polygon.
vec2 corput_native_regular_polygon(uint sides, uvec2 u) {
    float n = corput_native_regular_polygon_sides(sides);
    float sine = corput_native_regular_polygon_sine(n);
    float around = corput_native_unit(u.x) * n;
    float side = min(floor(around), n - 1.0);
    float radius = sqrt(corput_native_unit(u.y));
    float x = radius * sqrt(1.0 - sine * sine);
    float y = radius * sine * (2.0 * (around - side) - 1.0);
    float turn = 6.2831853 * ((side + 0.5) / n);
    return vec2(x * cos(turn) - y * sin(turn), x * sin(turn) + y * cos(turn));
}

// A point turned so that the middle of its side is on +x, and the side.
vec3 corput_native_regular_polygon_turned(float n, vec2 p) {
    float side = min(floor(corput_native_turns(p) * n), n - 1.0);
    float turn = 6.2831853 * ((side + 0.5) / n);
    return vec3(p.x * cos(turn) + p.y * sin(turn), p.y * cos(turn) - p.x * sin(turn), side);
}

// 1 over the area inside, else 0.
float corput_native_regular_polygon_pdf(uint sides, vec2 p) {
    float n = corput_native_regular_polygon_sides(sides);
    float sine = corput_native_regular_polygon_sine(n);
    float cosine = sqrt(1.0 - sine * sine);
    vec3 local = corput_native_regular_polygon_turned(n, p);
    return local.x <= cosine * 1.0009766 ? 1.0 / (n * sine * cosine) : 0.0;
}

// The fractions that give this point.
uvec2 corput_native_regular_polygon_invert(uint sides, vec2 p) {
    float n = corput_native_regular_polygon_sides(sides);
    float sine = corput_native_regular_polygon_sine(n);
    vec3 local = corput_native_regular_polygon_turned(n, p);
    float radius = local.x / sqrt(1.0 - sine * sine);
    float along = 0.5 + 0.5 * clamp(local.y / max(radius * sine, 1e-37), -1.0, 1.0);
    return uvec2(corput_native_fraction((local.z + along) / n), corput_native_fraction(radius * radius));
}

#endif
