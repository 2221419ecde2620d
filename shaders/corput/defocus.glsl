// what:   estimators of the share of a lens that sees one side of an edge in its circle of
//         confusion: 1 or 0 for each point of the unit disk.
// source: Potmesil and Chakravarty 1981, A lens and aperture camera model for synthetic image
//         generation, SIGGRAPH; Shirley and Chiu 1997.
// domain: fractions of 2^32; the edge x nx + y ny = offset, given (nx, ny, offset).
// range:  0 or 1, or of the square 0 or 4/pi. A point within 2^-23 of the edge may count as
//         on its other side.
// cost:   100 integer instructions. tier I.
// hooks:  none.
// mirror: src/reference/defocus.rs
#ifndef CORPUT_DEFOCUS_GLSL
#define CORPUT_DEFOCUS_GLSL

#include "corput/disk.glsl"
#include "corput/real_vector.glsl"

// 1 below the edge, else 0.
CorputReal corput_defocus_side(CorputReal3 edge, CorputReal x, CorputReal y) {
    CorputReal across = corput_real_add(corput_real_multiply(edge.x, x), corput_real_multiply(edge.y, y));
    return corput_real_uint(uint(corput_real_less(across, edge.z)), 0);
}

// By points of the square around the disk: 4/pi where they are in both.
CorputReal corput_defocus_square(CorputReal3 edge, uvec2 u) {
    CorputReal one = corput_real_uint(1u, 0);
    CorputReal x = corput_real_subtract(corput_real_uint(u.x, -31), one);
    CorputReal y = corput_real_subtract(corput_real_uint(u.y, -31), one);
    CorputReal value = corput_real_multiply(corput_defocus_side(edge, x, y), corput_real_uint(2734261102u, -31));
    if (!corput_real_less(corput_real_add(corput_real_square(x), corput_real_square(y)), one)) {
        value = corput_real_zero();
    }
    return value;
}

// By the polar map.
CorputReal corput_defocus_polar(CorputReal3 edge, uvec2 u) {
    vec2 p = corput_polar_disk(u);
    return corput_defocus_side(edge, corput_real(p.x), corput_real(p.y));
}

// By the concentric map.
CorputReal corput_defocus_concentric(CorputReal3 edge, uvec2 u) {
    vec2 p = corput_concentric_disk(u);
    return corput_defocus_side(edge, corput_real(p.x), corput_real(p.y));
}

#endif
