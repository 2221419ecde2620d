// what:   reflection and refraction at a microfacet in the native profile, with Jacobians.
// source: Walter et al. 2007, as reflect.glsl.
// domain: unit vectors: w points away from the surface, h to either side. eta is the index of
//         refraction beyond the surface over that on the side of w. Beyond total internal
//         reflection, for eta <= 0 and NaN direction and Jacobian are 0.
// range:  unit vectors to the device's precision; the largest float stands for an infinite
//         Jacobian.
// errors: about 2^-20.
// cost:   10 and 40 float instructions.
// hooks:  none.
// mirror: src/reference/native/reflect.rs
#ifndef CORPUT_NATIVE_REFLECT_GLSL
#define CORPUT_NATIVE_REFLECT_GLSL

#include "corput/native/scattered.glsl"

// A direction beyond a microfacet.
struct CorputNativeBent {
    // The unit vector; 0 where there is none.
    vec3 direction;
    // Solid angle of normals per solid angle of directions.
    float jacobian;
};

// w reflected at h, and the Jacobian 1 / (4 |w.h|).
CorputNativeBent corput_native_reflect(vec3 w, vec3 h) {
    float cosine = dot(w, h);
    return CorputNativeBent(h * (2.0 * cosine) - w, corput_native_density(0.25 / abs(cosine)));
}

// w refracted at h, and the Jacobian eta^2 |t.h| / (|w.h| - eta |t.h|)^2.
CorputNativeBent corput_native_refract(vec3 w, vec3 h, float eta) {
    float cosine = abs(dot(w, h));
    vec3 n = h;
    if (dot(w, h) < 0.0) {
        n = h * -1.0;
    }
    vec3 across = vec3(w.y * n.z - w.z * n.y, w.z * n.x - w.x * n.z, w.x * n.y - w.y * n.x);
    float rest = eta * eta - dot(across, across);
    bool bends = eta > 0.0 && rest > 0.0;
    if (!bends) {
        return CorputNativeBent(vec3(0.0, 0.0, 0.0), 0.0);
    }
    float beyond = sqrt(rest);
    float along = (1.0 - eta) * (1.0 + eta) / (cosine + beyond);
    vec3 direction = (n * along - w) * (1.0 / eta);
    return CorputNativeBent(direction, corput_native_density(beyond * eta / (along * along)));
}

#endif
