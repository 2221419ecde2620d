// what:   estimators of a pixel's value at an edge, seen through a tent filter: the filtered
//         share of one side of a straight line.
// source: Ernst, Stamminger and Greiner 2006, Filter importance sampling; PBRT 4th ed., 8.8.
// domain: fractions of 2^32, which stand for midpoints of their parts; the edge x nx + y ny =
//         offset, given (nx, ny, offset), in units of the filter's radius.
// range:  by the filter 0 or 1, uniform from 0 to 4, within 2^-29. A point within 2^-28 of
//         the edge may count as on its other side.
// cost:   uniform 200, by the filter 450 integer instructions. tier I.
// hooks:  none.
// mirror: src/reference/pixel_edge.rs
#ifndef CORPUT_PIXEL_EDGE_GLSL
#define CORPUT_PIXEL_EDGE_GLSL

#include "corput/filter.glsl"
#include "corput/real_vector.glsl"

// A distance on the side of u.
CorputReal corput_pixel_coordinate(CorputReal d, uint u) {
    return CorputReal(d.m, d.e, u < 0x80000000u);
}

// A weight where a point is below the edge, else 0.
CorputReal corput_pixel_side(CorputReal3 edge, CorputReal x, CorputReal y, CorputReal weight) {
    CorputReal across = corput_real_add(corput_real_multiply(edge.x, x), corput_real_multiply(edge.y, y));
    CorputReal value = weight;
    if (!corput_real_less(across, edge.z)) {
        value = corput_real_zero();
    }
    return value;
}

// By points that are uniform in the filter's square: 4 (1 - |x|) (1 - |y|).
CorputReal corput_pixel_uniform(CorputReal3 edge, uvec2 u) {
    uint a = corput_filter_share(u.x);
    uint b = corput_filter_share(u.y);
    CorputReal x = corput_pixel_coordinate(corput_real_uint(a, -32), u.x);
    CorputReal y = corput_pixel_coordinate(corput_real_uint(b, -32), u.y);
    CorputReal height = corput_real_multiply(corput_real_uint(0u - a, -32), corput_real_uint(0u - b, -32));
    return corput_pixel_side(edge, x, y, corput_real_shift(height, 2));
}

// By the filter: 1.
CorputReal corput_pixel_filter(CorputReal3 edge, uvec2 u) {
    uint a = corput_filter_share(u.x);
    uint b = corput_filter_share(u.y);
    CorputReal x = corput_pixel_coordinate(corput_tent_distance(a, corput_tent_height(a)), u.x);
    CorputReal y = corput_pixel_coordinate(corput_tent_distance(b, corput_tent_height(b)), u.y);
    return corput_pixel_side(edge, x, y, corput_real_uint(1u, 0));
}

#endif
