// what:   a direction with its pdf, and a direction from height, radius and angle.
// source: cylindrical coordinates.
// domain: any reals. range: no infinity or NaN.
// errors: each coordinate half a ULP more than its real's error.
// cost:   130 integer instructions. tier I.
// hooks:  none.
// mirror: src/reference/scattered.rs
#ifndef CORPUT_SCATTERED_GLSL
#define CORPUT_SCATTERED_GLSL

#include "corput/real_angle.glsl"
#include "corput/real_vector.glsl"

// A direction, and the density there with respect to solid angle: of the exact direction,
// not of the rounded one.
struct CorputScattered {
    // The unit vector.
    vec3 direction;
    // The density.
    float pdf;
};

// Both rounded to float.
CorputScattered corput_scattered(CorputReal3 direction, CorputReal pdf) {
    return CorputScattered(corput_real3_floats(direction), corput_real_float(pdf));
}

// (radius cos 2 pi phi, radius sin 2 pi phi, z), phi a fraction of 2^32.
CorputReal3 corput_real3_around(CorputReal radius, uint phi, CorputReal z) {
    CorputSinCos angle = corput_sincos_scaled(phi);
    return CorputReal3(corput_real_multiply(radius, corput_real_scaled(angle.cosine, angle.cosine_negative)),
        corput_real_multiply(radius, corput_real_scaled(angle.sine, angle.sine_negative)), z);
}

#endif
