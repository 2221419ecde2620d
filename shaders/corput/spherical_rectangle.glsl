// what:   directions of a rectangle seen from the origin, uniformly over its solid angle,
//         with solid angle, pdf and inverse.
// source: two triangles that share the corner and the diagonal from it, each as in
//         spherical_triangle.glsl: the moving vertex runs along the two sides opposite the
//         corner, so that the map is continuous (Peters 2021, BRDF importance sampling for
//         polygonal lights, section 4). The map of Urena et al. 2013, An area-preserving
//         parametrization for spherical rectangles, has 0 / 0 for small ones.
// domain: a corner, two sides from it (a parallelogram will do); two fractions of 2^32.
//         u.y = 0 is the corner. Where the rectangle spans no solid angle, as when the origin is
//         in its plane outside of it: +z, with pdf 0, inverse (0, 0).
// range:  unit vectors to 2^-23.
// pdf:    with respect to solid angle: 1 over it inside; edges as those of triangles.
// errors: the solid angle 0.7 ULP; else as spherical_triangle.glsl.
// cost:   prepare 10,000, sample 2,000 integer instructions. tier I.
// hooks:  none.
// mirror: src/reference/spherical_rectangle.rs
#ifndef CORPUT_SPHERICAL_RECTANGLE_GLSL
#define CORPUT_SPHERICAL_RECTANGLE_GLSL

#include "corput/spherical_triangle.glsl"

struct CorputSphericalRectangle {
    // Corner, its neighbour along x, the opposite corner; and that, the corner, the other.
    CorputSphericalTriangle first;
    CorputSphericalTriangle second;
    // Half the solid angle in turns.
    CorputReal area;
};

// The rectangle with this corner and these sides.
CorputSphericalRectangle corput_spherical_rectangle_prepare(vec3 corner, vec3 x, vec3 y) {
    CorputReal3 o = corput_real3(corner);
    CorputReal3 ex = corput_real3(x);
    CorputReal3 ey = corput_real3(y);
    CorputReal3 a = corput_real3_add(o, ex);
    CorputReal3 e = corput_real3_add(o, ey);
    CorputReal3 c = corput_real3_add(a, ey);
    // Products by the sides: those of the corners would have lost their digits.
    CorputReal volume = corput_wide_triple(o, ex, ey);
    CorputReal3 diagonal = corput_wide_cross(o, corput_real3_add(ex, ey));
    CorputSphericalTriangle first = corput_spherical_triangle_of(a, o, c, corput_wide_cross(ex, o), diagonal,
        corput_wide_cross(ey, a), corput_real_negate(volume));
    CorputSphericalTriangle second = corput_spherical_triangle_of(c, o, e, corput_real3_signed(diagonal, true),
        corput_wide_cross(o, ey), corput_wide_cross(e, ex), corput_real_negate(volume));
    return CorputSphericalRectangle(first, second, corput_real_add(first.area, second.area));
}

// Uniform direction of the rectangle.
vec3 corput_spherical_rectangle(CorputSphericalRectangle r, uvec2 u) {
    if (r.area.m == 0u) {
        return vec3(0.0, 0.0, 1.0);
    }
    CorputReal before = corput_real_multiply(r.area, corput_real_uint(u.x, -32));
    if (corput_real_less(before, r.first.area)) {
        CorputReal behind = corput_real_subtract(r.first.area, before);
        return corput_spherical_triangle_at(r.first, before, behind, u.y);
    }
    // From the other end: the first half may be larger by far.
    CorputReal behind = corput_real_min(corput_real_multiply(r.area, corput_real_complement(u.x)), r.second.area);
    return corput_spherical_triangle_at(r.second, corput_real_subtract(r.second.area, behind), behind, u.y);
}

// The solid angle.
float corput_spherical_rectangle_solid_angle(CorputSphericalRectangle r) {
    // 4 pi to 32 bits.
    return corput_real_float(corput_real_multiply(r.area, corput_real_uint(3373259426u, -28)));
}

// 1 over the solid angle, the pdf of every sample; 0 where there is none.
float corput_spherical_rectangle_density(CorputSphericalRectangle r) {
    CorputReal density = corput_real_zero();
    if (r.area.m != 0u) {
        // 1/(4 pi) to 32 bits.
        density = corput_real_divide(corput_real_uint(2734261102u, -35), r.area);
    }
    return corput_real_float(density);
}

// 1 over the solid angle inside, else 0.
float corput_spherical_rectangle_pdf(CorputSphericalRectangle r, vec3 direction) {
    CorputReal3 d = corput_real3(direction);
    if (!corput_spherical_triangle_inside(r.first, d) && !corput_spherical_triangle_inside(r.second, d)) {
        return 0.0;
    }
    return corput_spherical_rectangle_density(r);
}

// The fractions that give this direction.
uvec2 corput_spherical_rectangle_invert(CorputSphericalRectangle r, vec3 direction) {
    if (r.area.m == 0u) {
        return uvec2(0u);
    }
    CorputReal3 d = corput_real3(direction);
    CorputArc parts = corput_spherical_triangle_parts(r.second, d);
    if (corput_real3_dot(d, r.second.ab_normal).negative) {
        parts = corput_spherical_triangle_parts(r.first, d);
        parts.cosine = corput_real_min(parts.cosine, r.first.area);
    } else {
        parts.cosine = corput_real_add(parts.cosine, r.first.area);
    }
    return uvec2(corput_real_fraction_nearest(corput_real_divide(parts.cosine, r.area)),
        corput_real_fraction_nearest(parts.sine));
}

#endif
