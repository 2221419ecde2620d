// what:   directions of a rectangle seen from the origin in the native profile, uniformly
//         over its solid angle, with solid angle, pdf and inverse.
// source: two triangles that share the corner and the diagonal from it: Peters 2021.
// domain: a corner, two sides from it; two fractions of 2^32. Where the rectangle spans no
//         solid angle: +z, with pdf 0, inverse (0, 0).
// range:  unit vectors to the device's precision.
// pdf:    with respect to solid angle: 1 over it inside, edges as those of triangles.
// errors: those of corput/native/spherical_triangle.glsl.
// cost:   prepare 400, sample 160 float instructions.
// hooks:  none.
// mirror: src/reference/native/spherical_rectangle.rs
#ifndef CORPUT_NATIVE_SPHERICAL_RECTANGLE_GLSL
#define CORPUT_NATIVE_SPHERICAL_RECTANGLE_GLSL

#include "corput/native/spherical_triangle.glsl"

struct CorputNativeSphericalRectangle {
    // Corner, its neighbour along x, the opposite corner; and that, the corner, the other.
    CorputNativeSphericalTriangle first;
    CorputNativeSphericalTriangle second;
    // Half the solid angle in radians.
    float area;
};

// The rectangle with this corner and these sides.
CorputNativeSphericalRectangle corput_native_spherical_rectangle_prepare(vec3 corner, vec3 x, vec3 y) {
    vec3 a = corner + x;
    vec3 e = corner + y;
    vec3 c = a + y;
    float volume = -dot(corner, cross(x, y));
    vec3 diagonal = cross(corner, x + y);
    CorputNativeSphericalTriangle first = corput_native_spherical_triangle_of(a, corner, c, cross(x, corner),
        diagonal, cross(y, a), volume);
    CorputNativeSphericalTriangle second = corput_native_spherical_triangle_of(c, corner, e, -diagonal,
        cross(corner, y), cross(e, x), volume);
    return CorputNativeSphericalRectangle(first, second, first.area + second.area);
}

// Uniform direction of the rectangle.
vec3 corput_native_spherical_rectangle(CorputNativeSphericalRectangle r, uvec2 u) {
    bool seen = r.area > 0.0;
    if (!seen) {
        return vec3(0.0, 0.0, 1.0);
    }
    float before = r.area * corput_native_unit(u.x);
    if (before < r.first.area) {
        return corput_native_spherical_triangle_at(r.first, before, r.first.area - before, u.y);
    }
    float behind = min(r.area * corput_native_complement(u.x), r.second.area);
    return corput_native_spherical_triangle_at(r.second, r.second.area - behind, behind, u.y);
}

// The solid angle.
float corput_native_spherical_rectangle_solid_angle(CorputNativeSphericalRectangle r) {
    return 2.0 * r.area;
}

// 1 over the solid angle, the pdf of every sample; 0 where there is none.
float corput_native_spherical_rectangle_density(CorputNativeSphericalRectangle r) {
    return r.area >= 1e-37 ? 0.5 / r.area : 0.0;
}

// 1 over the solid angle inside, else 0.
float corput_native_spherical_rectangle_pdf(CorputNativeSphericalRectangle r, vec3 direction) {
    bool inside = corput_native_spherical_triangle_inside(r.first, direction)
        || corput_native_spherical_triangle_inside(r.second, direction);
    return inside ? corput_native_spherical_rectangle_density(r) : 0.0;
}

// The fractions that give this direction.
uvec2 corput_native_spherical_rectangle_invert(CorputNativeSphericalRectangle r, vec3 direction) {
    bool seen = r.area > 0.0;
    if (!seen) {
        return uvec2(0u);
    }
    vec2 parts = corput_native_spherical_triangle_parts(r.second, direction);
    float before = parts.x + r.first.area;
    if (dot(direction, r.second.ab_normal) < 0.0) {
        parts = corput_native_spherical_triangle_parts(r.first, direction);
        before = min(parts.x, r.first.area);
    }
    return uvec2(corput_native_fraction(before / r.area), corput_native_fraction(parts.y));
}

#endif
