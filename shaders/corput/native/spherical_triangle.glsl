// what:   directions of a spherical triangle in the native profile, uniformly, with solid
//         angle, pdf and inverse, by the device's own functions.
// source: the sums of corput/spherical_triangle.glsl, which never cancel: Arvo 1995 and Peters
//         2021; Van Oosterom and Strackee 1983.
// domain: three vertices seen from the origin, of any order, of lengths from 1e-6 to 1e6; two
//         fractions of 2^32. Where they span no solid angle: +z, with pdf 0, inverse (0, 0).
// range:  unit vectors to the device's precision.
// pdf:    with respect to solid angle: 1 over it inside; edges are widened by 2^-12 of the
//         longest side.
// errors: Vulkan allows sin and cos an absolute error of 2^-11 and atan 4096 ULP; sines of
//         small angles are a polynomial here, so that small triangles lose nothing.
// cost:   prepare 200, sample 150 float instructions.
// hooks:  none.
// mirror: src/reference/native/spherical_triangle.rs
#ifndef CORPUT_NATIVE_SPHERICAL_TRIANGLE_GLSL
#define CORPUT_NATIVE_SPHERICAL_TRIANGLE_GLSL

#include "corput/native/sphere.glsl"

struct CorputNativeSphericalTriangle {
    // The vertices as unit vectors.
    vec3 a;
    vec3 b;
    vec3 c;
    // Cosines of half the sides ab, bc, ca, and sines.
    vec3 cosines;
    vec3 sines;
    // Half the solid angle in radians, and what it lacks of pi.
    float area;
    float rest;
    // Unit normals of the sides, inwards, and at b the tangent towards a.
    vec3 ab_normal;
    vec3 bc_normal;
    vec3 ca_normal;
    vec3 tangent;
    // The sine of the angle between b and the side ca.
    float height;
};

// x / |x|; 0 for 0.
vec3 corput_native_direction(vec3 v) {
    float square = dot(v, v);
    return square > 0.0 ? v / sqrt(square) : vec3(0.0);
}

// The sine, with its digits where the angle is small; 0 to pi.
float corput_native_sine(float angle) {
    float square = angle * angle;
    if (angle < 0.25) {
        return angle * (1.0 - square * (0.16666667 - square * (0.0083333333 - square * 0.00019841270)));
    }
    return sin(angle);
}

// Cosine and sine of half the angle between two vectors with this vector product.
vec2 corput_native_arc(vec3 a, vec3 b, vec3 across) {
    float product = sqrt(dot(a, a) * dot(b, b));
    float cosine = dot(a, b);
    float large = product + abs(cosine);
    bool known = large > 0.0;
    if (!known) {
        return vec2(0.0);
    }
    float far = sqrt(large / (2.0 * product));
    float near = sqrt(dot(across, across) / (large * 2.0 * product));
    return cosine < 0.0 ? vec2(near, far) : vec2(far, near);
}

// The triangle with vertices a, b, c, given a x b, b x c, c x a and the triple product.
CorputNativeSphericalTriangle corput_native_spherical_triangle_of(vec3 a, vec3 b, vec3 c, vec3 ab_across, vec3 bc_across, vec3 ca_across, float volume) {
    float b_length = sqrt(dot(b, b));
    float lengths = sqrt(dot(a, a)) * b_length * sqrt(dot(c, c));
    vec2 ab = corput_native_arc(a, b, ab_across);
    vec2 bc = corput_native_arc(b, c, bc_across);
    vec2 ca = corput_native_arc(c, a, ca_across);
    float side = volume < 0.0 ? -1.0 : 1.0;
    float sine = abs(volume);
    vec3 ua = corput_native_direction(a);
    vec3 ub = corput_native_direction(b);
    vec3 uc = corput_native_direction(c);
    float cosine = (1.0 + dot(ua, ub) + dot(ub, uc) + dot(uc, ua)) * lengths;
    // Vertices on each other or opposite have no side between them.
    bool seen = sine > 0.0 && min(ab.x * ab.y, min(bc.x * bc.y, ca.x * ca.y)) > 0.0;
    float area = seen ? atan(sine, cosine) : 0.0;
    float rest = seen ? atan(sine, -cosine) : 0.0;
    vec3 ab_normal = corput_native_direction(ab_across);
    float height = sine / max(b_length * sqrt(dot(ca_across, ca_across)), 1e-37);
    return CorputNativeSphericalTriangle(
        ua,
        ub,
        uc,
        vec3(ab.x, bc.x, ca.x),
        vec3(ab.y, bc.y, ca.y),
        area,
        rest,
        side * ab_normal,
        side * corput_native_direction(bc_across),
        side * corput_native_direction(ca_across),
        cross(ub, ab_normal),
        height);
}

// a . (b x c) by the sides at the shortest of them.
float corput_native_volume(vec3 a, vec3 b, vec3 c) {
    float x = dot(a, a);
    float y = dot(b, b);
    float z = dot(c, c);
    if (x <= min(y, z)) {
        return dot(a, cross(b - a, c - a));
    }
    if (y <= z) {
        return dot(b, cross(c - b, a - b));
    }
    return dot(c, cross(a - c, b - c));
}

// a x b by the sum or difference, whichever is short.
vec3 corput_native_across(vec3 a, vec3 b) {
    return dot(a, b) < 0.0 ? cross(a, a + b) : cross(a, b - a);
}

// The triangle with these vertices.
CorputNativeSphericalTriangle corput_native_spherical_triangle_prepare(vec3 a, vec3 b, vec3 c) {
    return corput_native_spherical_triangle_of(a, b, c, corput_native_across(a, b),
        corput_native_across(b, c), corput_native_across(c, a), corput_native_volume(a, b, c));
}

// The direction whose moving vertex parts half the solid angle into before and behind, a
// fraction of the way from b.
vec3 corput_native_spherical_triangle_at(CorputNativeSphericalTriangle t, float before, float behind, uint u) {
    float before_sine = corput_native_sine(min(before, t.rest + behind));
    float behind_sine = corput_native_sine(min(behind, t.rest + before));
    float area_sine = corput_native_sine(min(t.area, t.rest));
    float q = t.cosines.x * before_sine;
    float d = 2.0 * t.cosines.y * t.cosines.z * behind_sine;
    // The limit of a hemisphere.
    if (before_sine + behind_sine == 0.0) {
        q = t.cosines.x;
        d = 2.0 * t.cosines.y * t.cosines.z;
    }
    float ca_square = t.cosines.z * t.cosines.z;
    // On one scale, so that their squares stay normal floats.
    float scale = 1.0 / max(q + d, 1e-37);
    q *= scale;
    d *= scale;
    float along = d + 2.0 * q * ca_square;
    float square = max(d * d + 4.0 * q * (d + q) * ca_square, 1e-37);
    float root = sqrt(square);
    float cosine = clamp(2.0 * t.cosines.x * t.cosines.y * t.cosines.z * area_sine * scale / root, 1e-18, 1.0);
    float part = corput_native_unit(u);
    float rest = corput_native_complement(u);
    float cosine_square = cosine * cosine;
    float sine_square = 1.0 - cosine_square;
    float part_root = sqrt(part);
    float near = sqrt(rest + part * cosine_square);
    if (cosine_square < 0.5 && cosine_square * t.cosines.x < t.sines.x) {
        float a_cosine = along / root;
        float y = a_cosine * before_sine;
        float x = a_cosine * cos(before) - t.cosines.x * cosine;
        float radius = 2.0 * near * sqrt(part * sine_square) / max(sqrt(x * x + y * y), 1e-18);
        return corput_native_direction((1.0 - 2.0 * part * sine_square) * t.b
            + radius * (x * t.tangent + y * t.ab_normal));
    }
    float weight_b = rest * (cosine * near + sine_square * part_root) / (near + cosine * part_root);
    float moving = part_root * near / square;
    return corput_native_direction(weight_b * t.b
        + moving * (d * (d + 2.0 * q) * t.a + 2.0 * q * along * t.c));
}

// Uniform direction of the triangle.
vec3 corput_native_spherical_triangle(CorputNativeSphericalTriangle t, uvec2 u) {
    bool seen = t.area > 0.0;
    if (!seen) {
        return vec3(0.0, 0.0, 1.0);
    }
    return corput_native_spherical_triangle_at(t, t.area * corput_native_unit(u.x),
        t.area * corput_native_complement(u.x), u.y);
}

// The solid angle.
float corput_native_spherical_triangle_solid_angle(CorputNativeSphericalTriangle t) {
    return 2.0 * t.area;
}

// Whether a direction is in the triangle.
bool corput_native_spherical_triangle_inside(CorputNativeSphericalTriangle t, vec3 direction) {
    float slack = -0.00024414062 * max(t.sines.x, max(t.sines.y, t.sines.z)) - 2.3841858e-7;
    return t.area >= 1e-37 && dot(t.ab_normal, direction) >= slack && dot(t.bc_normal, direction) >= slack
        && dot(t.ca_normal, direction) >= slack;
}

// 1 over the solid angle, the pdf of every sample; 0 where there is none.
float corput_native_spherical_triangle_density(CorputNativeSphericalTriangle t) {
    return t.area >= 1e-37 ? 0.5 / t.area : 0.0;
}

// 1 over the solid angle inside, else 0.
float corput_native_spherical_triangle_pdf(CorputNativeSphericalTriangle t, vec3 direction) {
    return corput_native_spherical_triangle_inside(t, direction) ? corput_native_spherical_triangle_density(t) : 0.0;
}

// Half the solid angle before the moving vertex of a direction, and what u.y is.
vec2 corput_native_spherical_triangle_parts(CorputNativeSphericalTriangle t, vec3 direction) {
    float x = dot(direction, t.tangent);
    float y = max(dot(direction, t.ab_normal), 0.0);
    float radius = sqrt(x * x + y * y);
    float scale = 1.0 / max(radius, 1e-18);
    float slope = (t.cosines.x * t.cosines.x - t.sines.x * t.sines.x)
        / max(2.0 * t.cosines.x * t.sines.x, 1e-18);
    float lean = dot(t.ab_normal, t.ca_normal) / max(t.height, 1e-18);
    float cotangent = clamp((slope * x - lean * y) * scale, -1e18, 1e18);
    float root = sqrt(1.0 + cotangent * cotangent) + abs(cotangent);
    float tangent = cotangent < 0.0 ? root : 1.0 / root;
    float product = tangent * t.sines.x / max(t.cosines.x, 1e-18) * scale;
    float before = product * y;
    float turned = 1.0 + product * x;
    if (before > 0.0) {
        before = atan(before, turned);
    } else {
        before = turned < 0.0 ? t.area : 0.0;
    }
    float cosine = dot(direction, t.b);
    float versine = cosine < 0.5 ? 1.0 - cosine : radius * radius / (1.0 + cosine);
    float whole = 2.0 * tangent / (1.0 + tangent * tangent) * tangent;
    return vec2(before, versine / max(whole, 1e-37));
}

// The fractions that give this direction.
uvec2 corput_native_spherical_triangle_invert(CorputNativeSphericalTriangle t, vec3 direction) {
    bool seen = t.area > 0.0;
    if (!seen) {
        return uvec2(0u);
    }
    vec2 parts = corput_native_spherical_triangle_parts(t, direction);
    return uvec2(corput_native_fraction(parts.x / t.area), corput_native_fraction(parts.y));
}

#endif
