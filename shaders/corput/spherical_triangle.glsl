// what:   directions of a spherical triangle, uniformly, with solid angle, pdf and inverse.
// source: Arvo 1995, Stratified sampling of spherical triangles, in the tangent form of
//         Peters 2021, BRDF importance sampling for polygonal lights, section 3. Here every
//         difference is replaced: with s and r the parts of half the solid angle before and
//         behind the moving vertex c' on ac, and C_ab the cosine of half the side ab, its
//         weights on a and c are d (d + 2 q) and 2 q (d + 2 q C_ca^2), with q = C_ab sin s
//         and d = 2 C_bc C_ca sin r, both positive. Solid angle: Van Oosterom and Strackee
//         1983, by edges.
// domain: three vertices seen from the origin, of any length and order; two fractions of
//         2^32. u.x = 0 is on the side ab, u.y = 0 is the vertex b.
//         Where the vertices span no solid angle: +z, with pdf 0, inverse (0, 0). Where the
//         origin is within the triangle: the hemisphere towards a x b.
// range:  unit vectors to 2^-23.
// pdf:    with respect to solid angle: 1 over it inside. Edges are widened by the rounding
//         of a direction, 2^-22 of its components, so that no sample falls outside.
// errors: the solid angle 0.6 ULP, for any lengths, sides down to 1e-12, and vertices within
//         1e-7 of the plane of the other two and the origin; the direction 0.6 ULP, or 2^-24
//         of the longest side where that is more, and of a and c nearly opposite 2^-29 over
//         the cosine of half their angle. The inverse agrees with the sample to 2^-20, more
//         where the rounding of a direction is more of the triangle.
// cost:   prepare 5,000, sample 1,900 integer instructions. tier I.
// hooks:  none.
// mirror: src/reference/spherical_triangle.rs
#ifndef CORPUT_SPHERICAL_TRIANGLE_GLSL
#define CORPUT_SPHERICAL_TRIANGLE_GLSL

#include "corput/arc.glsl"
#include "corput/sphere.glsl"

struct CorputSphericalTriangle {
    // The vertices as unit vectors.
    CorputReal3 a;
    CorputReal3 b;
    CorputReal3 c;
    CorputArc ab;
    CorputArc bc;
    CorputArc ca;
    // Half the solid angle, in turns, and what it lacks of 1/2.
    CorputReal area;
    CorputReal rest;
    // Unit normals of the sides, inwards, and at b the tangent towards a.
    CorputReal3 ab_normal;
    CorputReal3 bc_normal;
    CorputReal3 ca_normal;
    CorputReal3 tangent;
    // The sine of the angle between b and the side ca.
    CorputReal height;
};

// The cosine's part of Van Oosterom and Strackee's formula for unit vectors, with the
// widest side from u to v.
CorputReal corput_spherical_triangle_cosine(CorputReal3 u, CorputReal3 v, CorputReal3 w, CorputArc arc, CorputReal3 normal) {
    CorputReal square = corput_real_shift(corput_real_square(arc.cosine), 1);
    return corput_real_add(square, corput_real3_dot(w, corput_arc_sum(u, v, arc, normal)));
}

// The triangle with vertices a, b, c, given the products a x b, b x c, c x a and the triple
// product as exactly as they can be had.
CorputSphericalTriangle corput_spherical_triangle_of(CorputReal3 a, CorputReal3 b, CorputReal3 c, CorputReal3 ab_across, CorputReal3 bc_across, CorputReal3 ca_across, CorputReal volume) {
    CorputArc ab = corput_arc(a, b, ab_across);
    CorputArc bc = corput_arc(b, c, bc_across);
    CorputArc ca = corput_arc(c, a, ca_across);
    CorputReal magnitude = CorputReal(volume.m, volume.e, false);
    CorputReal b_length = corput_real3_length(b);
    CorputReal lengths = corput_real_multiply(corput_real_multiply(corput_real3_length(a), b_length),
        corput_real3_length(c));
    CorputReal3 ua = corput_real3_normalize(a);
    CorputReal3 ub = corput_real3_normalize(b);
    CorputReal3 uc = corput_real3_normalize(c);
    CorputReal3 ab_normal = corput_real3_normalize(ab_across);
    CorputReal3 bc_normal = corput_real3_normalize(bc_across);
    CorputReal3 ca_normal = corput_real3_normalize(ca_across);
    CorputReal cosine = corput_spherical_triangle_cosine(ua, ub, uc, ab, ab_normal);
    if (corput_real_less(bc.cosine, corput_real_min(ab.cosine, ca.cosine))) {
        cosine = corput_spherical_triangle_cosine(ub, uc, ua, bc, bc_normal);
    } else if (corput_real_less(ca.cosine, ab.cosine)) {
        cosine = corput_spherical_triangle_cosine(uc, ua, ub, ca, ca_normal);
    }
    CorputReal sine = corput_real_divide(magnitude, lengths);
    // A vertex at the origin, on another or opposite to it: then there is no side.
    if (ab.cosine.m == 0u || ab.sine.m == 0u || bc.cosine.m == 0u || bc.sine.m == 0u
        || ca.cosine.m == 0u || ca.sine.m == 0u) {
        cosine = corput_real_uint(1u, 0);
        sine = corput_real_zero();
    }
    CorputReal height = corput_real_divide(magnitude,
        corput_real_multiply(b_length, corput_real3_length(ca_across)));
    return CorputSphericalTriangle(
        ua,
        ub,
        uc,
        ab,
        bc,
        ca,
        corput_angle(sine, cosine),
        corput_angle(sine, corput_real_negate(cosine)),
        corput_real3_signed(ab_normal, volume.negative),
        corput_real3_signed(bc_normal, volume.negative),
        corput_real3_signed(ca_normal, volume.negative),
        corput_real3_normalize(corput_wide_cross(b, ab_across)),
        height);
}

// a . (b x c), whose products are exact, but for what 64 bits cut; where that tells, as of small
// triangles, by the sides at a, which are exact if the lengths are alike.
CorputReal corput_spherical_triangle_volume(CorputReal3 a, CorputReal3 b, CorputReal3 c) {
    CorputReal volume = corput_wide_triple(a, b, c);
    CorputReal x = corput_real3_length(a);
    CorputReal y = corput_real3_length(b);
    CorputReal z = corput_real3_length(c);
    CorputReal lengths = corput_real_multiply(corput_real_multiply(x, y), z);
    CorputReal shortest = corput_real_min(x, corput_real_min(y, z));
    CorputReal longest = corput_real_max(x, corput_real_max(y, z));
    if (corput_real_smaller(volume, corput_real_shift(lengths, -30))
        && corput_real_less(longest, corput_real_shift(shortest, 7))) {
        return corput_wide_triple(a, corput_real3_subtract(b, a), corput_real3_subtract(c, a));
    }
    return volume;
}

// The triangle with these vertices.
CorputSphericalTriangle corput_spherical_triangle_prepare(vec3 a, vec3 b, vec3 c) {
    CorputReal3 va = corput_real3(a);
    CorputReal3 vb = corput_real3(b);
    CorputReal3 vc = corput_real3(c);
    return corput_spherical_triangle_of(va, vb, vc, corput_wide_cross(va, vb), corput_wide_cross(vb, vc),
        corput_wide_cross(vc, va), corput_spherical_triangle_volume(va, vb, vc));
}

// The moving vertex c' on ca: weight_a a + weight_c c has this length squared.
struct CorputMovingVertex {
    CorputReal weight_a;
    CorputReal weight_c;
    CorputReal square;
    // Cosine of half the angle from a to c', and of that from b to c'.
    CorputReal a_cosine;
    CorputReal b_cosine;
};

// The vertex that parts half the solid angle into before and behind, in turns.
CorputMovingVertex corput_moving_vertex(CorputSphericalTriangle t, CorputReal before, CorputReal behind) {
    CorputReal before_sine = corput_angle_sine_half(before, corput_real_add(t.rest, behind));
    CorputReal behind_sine = corput_angle_sine_half(behind, corput_real_add(t.rest, before));
    CorputReal area_sine = corput_angle_sine_half(t.area, t.rest);
    // Of a hemisphere they are equal, also where both vanish.
    if (before_sine.m == 0u && behind_sine.m == 0u) {
        before_sine = corput_real_uint(1u, 0);
        behind_sine = before_sine;
    }
    CorputReal q = corput_real_multiply(t.ab.cosine, before_sine);
    CorputReal d = corput_real_multiply(corput_real_multiply(t.bc.cosine, t.ca.cosine),
        corput_real_shift(behind_sine, 1));
    CorputReal q2 = corput_real_shift(q, 1);
    CorputReal ca_square = corput_real_square(t.ca.cosine);
    CorputReal along = corput_real_add(d, corput_real_multiply(q2, ca_square));
    CorputReal across = corput_real_multiply(corput_real_multiply(q2, corput_real_add(d, q)), ca_square);
    CorputReal square = corput_real_add(corput_real_square(d), corput_real_shift(across, 1));
    CorputReal root = corput_real_sqrt(square);
    CorputReal cosines = corput_real_multiply(corput_real_multiply(t.ab.cosine, t.bc.cosine), t.ca.cosine);
    CorputReal b_cosine = corput_real_divide(
        corput_real_shift(corput_real_multiply(cosines, area_sine), 1), root);
    return CorputMovingVertex(
        corput_real_multiply(d, corput_real_add(d, q2)),
        corput_real_multiply(q2, along),
        square,
        corput_real_divide(along, root),
        corput_real_min(corput_real_uint(1u, 0), b_cosine));
}

// The direction a fraction u of the way from b to c' by the versine, as a sum of vertices.
vec3 corput_spherical_triangle_sum(CorputSphericalTriangle t, CorputMovingVertex v, uint u) {
    CorputReal cosine = v.b_cosine;
    CorputReal part = corput_real_uint(u, -32);
    CorputReal rest = corput_real_complement(u);
    CorputReal part_root = corput_real_sqrt(part);
    CorputReal cosine_square = corput_real_square(cosine);
    CorputReal sine_square = corput_real_subtract(corput_real_uint(1u, 0), cosine_square);
    // Cosine of half the angle from b to the direction.
    CorputReal near = corput_real_sqrt(corput_real_add(rest, corput_real_multiply(part, cosine_square)));
    CorputReal weight_b = corput_real_divide(corput_real_multiply(rest, corput_real_add(
        corput_real_multiply(cosine, near), corput_real_multiply(sine_square, part_root))),
        corput_real_multiply(cosine, corput_real_add(near, corput_real_multiply(cosine, part_root))));
    CorputReal moving = corput_real_divide(corput_real_multiply(part_root, near),
        corput_real_multiply(cosine, v.square));
    CorputReal3 side = corput_real3_combine(t.a, corput_real_multiply(v.weight_a, moving),
        t.c, corput_real_multiply(v.weight_c, moving));
    return corput_real3_floats(corput_real3_add(corput_real3_scale(t.b, weight_b), side));
}

// The same by polar coordinates around b, for c' far from it, where the sum would cancel.
vec3 corput_spherical_triangle_polar(CorputSphericalTriangle t, CorputMovingVertex v, CorputReal before, uint u) {
    CorputReal one = corput_real_uint(1u, 0);
    CorputReal part = corput_real_uint(u, -32);
    CorputReal cosine_square = corput_real_square(v.b_cosine);
    CorputReal sine_square = corput_real_subtract(one, cosine_square);
    CorputReal y = corput_real_multiply(v.a_cosine,
        corput_angle_sine_half(before, corput_real_subtract(corput_real_uint(1u, -1), before)));
    CorputReal x = corput_real_subtract(corput_real_multiply(v.a_cosine, corput_angle_cosine(before)),
        corput_real_multiply(t.ab.cosine, v.b_cosine));
    CorputReal length = corput_real_sqrt(corput_real_add(corput_real_square(x), corput_real_square(y)));
    CorputReal near = corput_real_sqrt(corput_real_add(corput_real_complement(u),
        corput_real_multiply(part, cosine_square)));
    CorputReal sine = corput_real_multiply(near, corput_real_sqrt(corput_real_multiply(part, sine_square)));
    CorputReal radius = corput_real_divide(corput_real_shift(sine, 1), length);
    CorputReal cosine = corput_real_subtract(one, corput_real_shift(corput_real_multiply(part, sine_square), 1));
    CorputReal3 side = corput_real3_combine(t.tangent, corput_real_multiply(radius, x),
        t.ab_normal, corput_real_multiply(radius, y));
    return corput_real3_floats(corput_real3_add(corput_real3_scale(t.b, cosine), side));
}

// The direction whose moving vertex parts half the solid angle into before and behind, in
// turns, a fraction u of the way from b.
vec3 corput_spherical_triangle_at(CorputSphericalTriangle t, CorputReal before, CorputReal behind, uint u) {
    CorputMovingVertex v = corput_moving_vertex(t, before, behind);
    CorputReal square = corput_real_square(v.b_cosine);
    bool far = corput_real_less(square, corput_real_uint(1u, -1))
        && corput_real_less(corput_real_multiply(square, t.ab.cosine), t.ab.sine);
    // Nearly opposite vertices leave nothing of their sum.
    if (far || corput_real_less(t.ca.cosine, corput_real_shift(t.ab.sine, -5))) {
        return corput_spherical_triangle_polar(t, v, before, u);
    }
    return corput_spherical_triangle_sum(t, v, u);
}

// Uniform direction of the triangle.
vec3 corput_spherical_triangle(CorputSphericalTriangle t, uvec2 u) {
    if (t.area.m == 0u) {
        return vec3(0.0, 0.0, 1.0);
    }
    CorputReal before = corput_real_multiply(t.area, corput_real_uint(u.x, -32));
    CorputReal behind = corput_real_multiply(t.area, corput_real_complement(u.x));
    return corput_spherical_triangle_at(t, before, behind, u.y);
}

// The solid angle.
float corput_spherical_triangle_solid_angle(CorputSphericalTriangle t) {
    // 4 pi to 32 bits.
    return corput_real_float(corput_real_multiply(t.area, corput_real_uint(3373259426u, -28)));
}

// Whether a direction is on the inner side of a plane, or beyond it by its rounding.
bool corput_spherical_triangle_side(CorputReal3 normal, CorputReal3 direction, CorputReal size) {
    CorputReal x = corput_real_multiply(normal.x, direction.x);
    CorputReal y = corput_real_multiply(normal.y, direction.y);
    CorputReal z = corput_real_multiply(normal.z, direction.z);
    CorputReal sum = corput_real_add(corput_real_add(CorputReal(x.m, x.e, false),
        CorputReal(y.m, y.e, false)), CorputReal(z.m, z.e, false));
    CorputReal slack = corput_real_add(corput_real_shift(sum, -22), corput_real_shift(size, -24));
    return !corput_real_add(corput_real_add(corput_real_add(x, y), z), slack).negative;
}

// Whether a direction is in the triangle.
bool corput_spherical_triangle_inside(CorputSphericalTriangle t, CorputReal3 direction) {
    CorputReal size = corput_real_max(t.ab.sine, corput_real_max(t.bc.sine, t.ca.sine));
    return t.area.m != 0u && corput_spherical_triangle_side(t.ab_normal, direction, size)
        && corput_spherical_triangle_side(t.bc_normal, direction, size)
        && corput_spherical_triangle_side(t.ca_normal, direction, size);
}

// 1 over the solid angle, the pdf of every sample; 0 where there is none.
float corput_spherical_triangle_density(CorputSphericalTriangle t) {
    CorputReal density = corput_real_zero();
    if (t.area.m != 0u) {
        // 1/(4 pi) to 32 bits.
        density = corput_real_divide(corput_real_uint(2734261102u, -35), t.area);
    }
    return corput_real_float(density);
}

// 1 over the solid angle inside, else 0.
float corput_spherical_triangle_pdf(CorputSphericalTriangle t, vec3 direction) {
    if (!corput_spherical_triangle_inside(t, corput_real3(direction))) {
        return 0.0;
    }
    return corput_spherical_triangle_density(t);
}

// Half the solid angle before the moving vertex of a direction, in turns, and what u.y is.
CorputArc corput_spherical_triangle_parts(CorputSphericalTriangle t, CorputReal3 direction) {
    CorputReal one = corput_real_uint(1u, 0);
    CorputReal x = corput_real3_dot(direction, t.tangent);
    CorputReal y = corput_real_max(corput_real3_dot(direction, t.ab_normal), corput_real_zero());
    CorputReal radius_square = corput_real_add(corput_real_square(x), corput_real_square(y));
    CorputReal radius = corput_real_sqrt(radius_square);
    x = corput_real_divide(x, radius);
    y = corput_real_divide(y, radius);
    // The way from b in this direction meets ca at an angle with this cotangent.
    CorputReal slope = corput_real_divide(corput_real_subtract(corput_real_square(t.ab.cosine),
        corput_real_square(t.ab.sine)), corput_real_shift(corput_real_multiply(t.ab.cosine, t.ab.sine), 1));
    CorputReal lean = corput_real_divide(corput_real3_dot(t.ab_normal, t.ca_normal), t.height);
    CorputReal cotangent = corput_real_subtract(corput_real_multiply(slope, x), corput_real_multiply(lean, y));
    CorputReal root = corput_real_sqrt(corput_real_add(one, corput_real_square(cotangent)));
    CorputReal tangent = corput_real_add(root, CorputReal(cotangent.m, cotangent.e, false));
    if (!cotangent.negative) {
        tangent = corput_real_divide(one, tangent);
    }
    CorputReal product = corput_real_divide(corput_real_multiply(tangent, t.ab.sine), t.ab.cosine);
    CorputReal before = corput_angle(corput_real_multiply(product, y),
        corput_real_add(one, corput_real_multiply(product, x)));
    // sin^2 of half the angle from b to the direction, over that to the moving vertex.
    CorputReal versine = corput_real_shift(
        corput_sphere_versine(radius_square, corput_real3_dot(direction, t.b)), -1);
    CorputReal square = corput_real_square(tangent);
    CorputReal whole = corput_real_divide(square, corput_real_add(one, square));
    return CorputArc(before, corput_real_divide(versine, whole));
}

// The fractions that give this direction.
uvec2 corput_spherical_triangle_invert(CorputSphericalTriangle t, vec3 direction) {
    if (t.area.m == 0u) {
        return uvec2(0u);
    }
    CorputArc parts = corput_spherical_triangle_parts(t, corput_real3(direction));
    return uvec2(corput_real_fraction_nearest(corput_real_divide(parts.cosine, t.area)),
        corput_real_fraction_nearest(parts.sine));
}

#endif
