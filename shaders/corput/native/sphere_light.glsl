// what:   directions from the origin towards a sphere in the native profile, uniformly over its
//         solid angle, with pdf and inverse, by the device's own functions.
// source: PBRT 4th ed., 6.2.4, by h = 1 - cos(theta_max) = r^2 / (d^2 + d sqrt(d^2 - r^2)).
// domain: a centre at 1e-9 to 1e9 from the origin, a radius; two fractions of 2^32. The origin
//         within the sphere, or a centre at the origin: uniform over all directions, the axis
//         then +z. r <= 0 gives the direction of the centre, with pdf 0.
// range:  unit vectors to the device's precision.
// pdf:    with respect to solid angle: 1/(2 pi h) inside, 1/(4 pi) from within; the edge as
//         that of cones, and widened by 2^-20.
// errors: those of corput/native/cone.glsl, and 2^-21.
// cost:   prepare 50, sample 60 float instructions.
// hooks:  none.
// mirror: src/reference/native/sphere_light.rs
#ifndef CORPUT_NATIVE_SPHERE_LIGHT_GLSL
#define CORPUT_NATIVE_SPHERE_LIGHT_GLSL

#include "corput/native/cone.glsl"
#include "corput/native/frame.glsl"

struct CorputNativeSphereLight {
    // Its normal points to the centre.
    CorputNativeFrame frame;
    // 1 - cos(theta_max).
    float h;
};

// The sphere with this centre and radius.
CorputNativeSphereLight corput_native_sphere_light_prepare(vec3 center, float radius) {
    float square = dot(center, center);
    float distance = sqrt(square);
    float r = max(radius, 0.0);
    vec3 axis = vec3(0.0, 0.0, 1.0);
    float h = 2.0;
    if (distance > 0.0) {
        axis = center / distance;
        if (distance >= r) {
            float rest = (distance - r) * (distance + r);
            h = r * r / (square + distance * sqrt(rest));
        }
    }
    return CorputNativeSphereLight(corput_native_frame(axis), h);
}

// Uniform direction towards the sphere.
vec3 corput_native_sphere_light(CorputNativeSphereLight light, uvec2 u) {
    return corput_native_frame_to_world(light.frame, corput_native_cone(light.h, u));
}

// 1/(2 pi h) towards the sphere, else 0.
float corput_native_sphere_light_pdf(CorputNativeSphereLight light, vec3 direction) {
    vec3 local = corput_native_frame_to_local(light.frame, direction);
    // The sine of the edge, and that of the direction less its rounding.
    float edge = sqrt(light.h * (2.0 - light.h));
    float sine = sqrt(local.x * local.x + local.y * local.y) - 9.5367432e-7;
    bool inside = light.h > 0.75 ? local.z >= 1.0 - light.h * 1.0009766
        : local.z > 0.0 && sine <= edge * 1.0009766;
    inside = inside || light.h >= 2.0;
    return inside && light.h >= 1e-36 ? 0.15915494 / light.h : 0.0;
}

// The fractions that give this direction.
uvec2 corput_native_sphere_light_invert(CorputNativeSphereLight light, vec3 direction) {
    return corput_native_cone_invert(light.h, corput_native_frame_to_local(light.frame, direction));
}

#endif
