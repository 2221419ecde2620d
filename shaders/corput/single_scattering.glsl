// what:   estimators of light that a homogeneous slab scatters once into a ray: free flight
//         along the ray, then the phase function of Henyey and Greenstein, under a sky of
//         radiance 1 + z around the ray, which is not attenuated.
// source: Chandrasekhar 1950, Radiative transfer; Henyey and Greenstein 1941, ApJ 93.
// domain: fractions of 2^32; optical depths above 0; the phase function of
//         henyey_greenstein.glsl.
// range:  by the phase function 0 to 2, by uniform distances and directions 0 to
//         2 depth (1 + g) / (1 - g)^2.
// errors: 2^-22 of each sample, by uniform directions 2^-20.
// cost:   1,300 integer instructions, by uniform ones 900. tier I.
// hooks:  none.
// mirror: src/reference/single_scattering.rs
#ifndef CORPUT_SINGLE_SCATTERING_GLSL
#define CORPUT_SINGLE_SCATTERING_GLSL

#include "corput/exponential.glsl"
#include "corput/henyey_greenstein.glsl"
#include "corput/logarithm.glsl"
#include "corput/sphere.glsl"

// 1 + z.
CorputReal corput_scattering_sky(vec3 direction) {
    return corput_real_add(corput_real_uint(1u, 0), corput_real(direction.z));
}

// A uniform distance and direction: depth e^-t 4 pi p (1 + z).
CorputReal corput_scattering_uniform(CorputHenyeyGreenstein h, CorputReal depth, uvec3 u) {
    vec3 d = corput_uniform_sphere(u.xy);
    CorputReal t = corput_real_multiply(depth, corput_real_uint(u.z, -32));
    CorputReal flight = corput_real_multiply(depth, corput_real_exp(corput_real_negate(t)));
    CorputReal phase = corput_real_multiply(corput_real(corput_henyey_greenstein_pdf(h, d)),
        corput_real_uint(3373259426u, -28));
    return corput_real_multiply(corput_real_multiply(flight, phase), corput_scattering_sky(d));
}

// A free flight, and a direction by the phase function: 1 + z for flights that end within.
CorputReal corput_scattering_phase(CorputHenyeyGreenstein h, CorputReal depth, uvec3 u) {
    CorputReal value = corput_scattering_sky(corput_henyey_greenstein(h, u.xy).direction);
    if (!corput_real_less(corput_real_negative_log(u.z), depth)) {
        value = corput_real_zero();
    }
    return value;
}

#endif
