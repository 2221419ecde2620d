// what:   points of a regular polygon of circumradius 1 with a vertex at (1, 0), uniformly,
//         with pdf and inverse.
// source: the polygon's triangles from the centre in turn by u.x, so that the map is continuous:
//         the part of the way around is linear along each side, the distance sqrt(u.y).
// domain: 3 to 65,536 sides, others count as the nearest of them; two fractions of 2^32.
// range:  the polygon.
// pdf:    with respect to area: 1 / (n sin(pi/n) cos(pi/n)) inside. The edge is widened by
//         2^-21, so that no sample falls outside by its rounding.
// errors: 0.9 ULP of a float of at least 1/16; pdf 0.6 ULP. The inverse agrees with the sample
//         to 2^-21 in u.y and, seen from the centre, to 2^-21 in u.x. At the centre the angle
//         is lost.
// cost:   700 integer instructions. tier I.
// hooks:  none.
// mirror: src/reference/regular_polygon.rs
#ifndef CORPUT_REGULAR_POLYGON_GLSL
#define CORPUT_REGULAR_POLYGON_GLSL

#include "corput/sphere.glsl"

// Half the angle of a side, in turns.
CorputReal corput_regular_polygon_half(uint sides) {
    return corput_real_divide(corput_real_uint(1u, -1), corput_real_uint(clamp(sides, 3u, 65536u), 0));
}

// The direction of the middle of a side, as a fraction of 2^32 of a turn.
uint corput_regular_polygon_middle(uint side, CorputReal half_side) {
    return corput_real_fraction_nearest(corput_real_multiply(corput_real_uint(2u * side + 1u, 0), half_side));
}

// Uniform point of the polygon.
vec2 corput_regular_polygon(uint sides, uvec2 u) {
    CorputReal half_side = corput_regular_polygon_half(sides);
    uvec2 at = corput_mul64(u.x, clamp(sides, 3u, 65536u));
    // From -1 to 1 along the side.
    CorputReal along = corput_real_subtract(corput_real_uint(at.x, -31), corput_real_uint(1u, 0));
    CorputReal radius = corput_real_sqrt(corput_real_uint(u.y, -32));
    CorputReal x = corput_real_multiply(radius, corput_angle_cosine(half_side));
    CorputReal y = corput_real_multiply(corput_real_multiply(radius, corput_angle_sine(half_side)), along);
    CorputSinCos turn = corput_sincos_scaled(corput_regular_polygon_middle(at.y, half_side));
    CorputReal cosine = corput_real_scaled(turn.cosine, turn.cosine_negative);
    CorputReal sine = corput_real_scaled(turn.sine, turn.sine_negative);
    return vec2(
        corput_real_float(corput_real_subtract(corput_real_multiply(x, cosine), corput_real_multiply(y, sine))),
        corput_real_float(corput_real_add(corput_real_multiply(x, sine), corput_real_multiply(y, cosine))));
}

// The side that a point is at, and the point turned so that its middle is on +x.
CorputReal3 corput_regular_polygon_turned(uint sides, vec2 p) {
    CorputReal half_side = corput_regular_polygon_half(sides);
    uint side = corput_mulhi(corput_atan2(p.y, p.x), clamp(sides, 3u, 65536u));
    CorputSinCos turn = corput_sincos_scaled(corput_regular_polygon_middle(side, half_side));
    CorputReal cosine = corput_real_scaled(turn.cosine, turn.cosine_negative);
    CorputReal sine = corput_real_scaled(turn.sine, turn.sine_negative);
    CorputReal x = corput_real(p.x);
    CorputReal y = corput_real(p.y);
    return CorputReal3(
        corput_real_add(corput_real_multiply(x, cosine), corput_real_multiply(y, sine)),
        corput_real_subtract(corput_real_multiply(y, cosine), corput_real_multiply(x, sine)),
        corput_real_uint(side, 0));
}

// 1 over the area inside, else 0.
float corput_regular_polygon_pdf(uint sides, vec2 p) {
    CorputReal half_side = corput_regular_polygon_half(sides);
    CorputReal cosine = corput_angle_cosine(half_side);
    CorputReal most = corput_real_multiply(cosine, corput_real_uint(2097153u, -21));
    if (corput_real_less(most, corput_regular_polygon_turned(sides, p).x)) {
        return 0.0;
    }
    CorputReal area = corput_real_multiply(corput_real_uint(clamp(sides, 3u, 65536u), 0),
        corput_real_multiply(corput_angle_sine(half_side), cosine));
    return corput_real_float(corput_real_divide(corput_real_uint(1u, 0), area));
}

// The fractions that give this point.
uvec2 corput_regular_polygon_invert(uint sides, vec2 p) {
    CorputReal half_side = corput_regular_polygon_half(sides);
    CorputReal3 local = corput_regular_polygon_turned(sides, p);
    CorputReal radius = corput_real_divide(local.x, corput_angle_cosine(half_side));
    CorputReal along = corput_real_divide(local.y, corput_real_multiply(radius, corput_angle_sine(half_side)));
    CorputReal one = corput_real_uint(1u, 0);
    CorputReal part = corput_real_shift(corput_real_add(along, one), -1);
    part = corput_real_min(corput_real_max(part, corput_real_zero()), one);
    CorputReal whole = corput_real_divide(corput_real_add(local.z, part),
        corput_real_uint(clamp(sides, 3u, 65536u), 0));
    return uvec2(corput_real_fraction_nearest(whole), corput_real_fraction_nearest(corput_real_square(radius)));
}

#endif
