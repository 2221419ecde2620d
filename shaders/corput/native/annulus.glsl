// what:   points of the annulus between an inner radius and 1 in the native profile, uniformly,
//         with pdf and inverse, by the device's own functions.
// source: inversion of the radial CDF: r^2 = i^2 + u (1 - i) (1 + i).
// domain: an inner radius i from 0 to 1, others count as the nearest of them; two fractions of
//         2^32. i = 1: points of the circle, with pdf 0.
// range:  the annulus, to the device's precision.
// pdf:    with respect to area: 1 / (pi (1 - i) (1 + i)) inside; edges widened by 2^-10.
// errors: Vulkan allows sin and cos an absolute error of 2^-11.
// cost:   about 20 float instructions.
// hooks:  none.
// mirror: src/reference/native/annulus.rs
#ifndef CORPUT_NATIVE_ANNULUS_GLSL
#define CORPUT_NATIVE_ANNULUS_GLSL

#include "corput/native/disk.glsl"

// The inner radius within its domain.
float corput_native_annulus_inner(float inner) {
    return inner > 0.0 ? min(inner, 1.0) : 0.0;
}

// Uniform point of the annulus: |p|^2 = i^2 + u.x (1 - i^2), at the angle 2 pi u.y.
vec2 corput_native_annulus(float inner, uvec2 u) {
    float i = corput_native_annulus_inner(inner);
    float radius = sqrt(i * i + corput_native_unit(u.x) * ((1.0 - i) * (1.0 + i)));
    float phi = 6.2831853 * corput_native_unit(u.y);
    return vec2(radius * cos(phi), radius * sin(phi));
}

// 1/(pi (1 - i^2)) inside, else 0.
float corput_native_annulus_pdf(float inner, vec2 p) {
    float i = corput_native_annulus_inner(inner);
    float width = (1.0 - i) * (1.0 + i);
    float square = p.x * p.x + p.y * p.y;
    bool inside = width > 0.0 && square >= i * i * 0.9990234 && square <= 1.0009766;
    return inside ? 0.31830989 / width : 0.0;
}

// The fractions that give this point.
uvec2 corput_native_annulus_invert(float inner, vec2 p) {
    float i = corput_native_annulus_inner(inner);
    float radius = sqrt(p.x * p.x + p.y * p.y);
    float part = (radius - i) * (radius + i) / max((1.0 - i) * (1.0 + i), 1e-37);
    return uvec2(corput_native_fraction(part), corput_native_fraction(corput_native_turns(p)));
}

#endif
