// what:   directions of the hemisphere around +z, uniform and cosine-weighted, with pdf
//         and inverse.
// source: Malley's method over the disk maps; z from the integer samples, never from
//         1 - x^2 - y^2: Shirley and Chiu 1997; Pharr, Jakob and Humphreys, PBRT 4th ed.,
//         A.5.
// domain: two fractions of 2^32. range: unit vectors to 2^-22, z >= 0.
// pdf:    with respect to solid angle: 1/(2 pi) and z/pi; 0 below the horizon.
// errors: x and y as the disk maps, z and the pdf 0.53 ULP. Inverses agree with the sample to 2^-22 a
//         coordinate, angles modulo one turn.
//         Singular points: at the pole the angle is lost, see disk.glsl.
// cost:   about 100 integer instructions. tier I.
// hooks:  none.
// mirror: src/reference/hemisphere.rs
#ifndef CORPUT_HEMISPHERE_GLSL
#define CORPUT_HEMISPHERE_GLSL

#include "corput/disk.glsl"

// z/pi for z > 0, else 0: the pdf of both cosine-weighted forms. For z below
// 2^-124 it is 0 as well; infinities and NaN are no directions and have pdf 0.
float corput_cosine_over_pi(float z) {
    uint bits = floatBitsToUint(z);
    // z below 2^-124 is where z/pi could leave the normal floats.
    if (bits < 0x01800000u || bits >= 0x7f800000u) {
        return 0.0;
    }
    CorputScaled scaled = CorputScaled((bits << 8) | 0x80000000u, int(bits >> 23) - 158);
    // 1/pi to 32 bits: its float alone would be half a ULP off.
    return corput_pack(corput_scaled_mul(scaled, CorputScaled(2734261102u, -33)), false);
}

// Uniform direction: z = u.x, phi = 2 pi u.y.
vec3 corput_uniform_hemisphere(uvec2 u) {
    CorputScaled z = corput_scaled(u.x, -32);
    CorputScaled radius = CorputScaled(0x80000000u, -31);
    if (u.x != 0u) {
        radius = corput_sqrt_fraction64(corput_sub64(uvec2(0u), corput_mul64(u.x, u.x)));
    }
    CorputSinCos phi = corput_sincos_scaled(u.y);
    return vec3(corput_pack(corput_scaled_mul(radius, phi.cosine), phi.cosine_negative),
        corput_pack(corput_scaled_mul(radius, phi.sine), phi.sine_negative),
        corput_pack(z, false));
}

// 1/(2 pi) for z >= 0, else 0.
float corput_uniform_hemisphere_pdf(vec3 direction) {
    // By the bits: a device may compare denormals as zeros.
    uint z = floatBitsToUint(direction.z);
    return z <= 0x7f800000u || z == 0x80000000u ? uintBitsToFloat(0x3e22f983u) : 0.0;
}

// The fractions that give this direction.
uvec2 corput_uniform_hemisphere_invert(vec3 direction) {
    uint z = corput_fixed31(direction.z);
    return uvec2(z >= 0x80000000u ? 0xffffffffu : z << 1, corput_atan2(direction.y, direction.x));
}

// Cosine-weighted direction over the concentric disk.
vec3 corput_cosine_hemisphere(uvec2 u) {
    uint radius = max(corput_disk_magnitude(u.x), corput_disk_magnitude(u.y));
    CorputScaled z = CorputScaled(0x80000000u, -31);
    if (radius != 0u) {
        // 1 - radius^2, exact, as a fraction of 2^62.
        uvec2 square = corput_sub64(uvec2(0u, 0x40000000u), corput_mul64(radius, radius));
        z = corput_sqrt_fraction64(corput_shl64(square, 2u));
    }
    return vec3(corput_concentric_disk(u), corput_pack(z, false));
}

// z/pi.
float corput_cosine_hemisphere_pdf(vec3 direction) {
    return corput_cosine_over_pi(direction.z);
}

// The fractions that give this direction.
uvec2 corput_cosine_hemisphere_invert(vec3 direction) {
    return corput_concentric_disk_invert(direction.xy);
}

// Cosine-weighted direction over the polar disk: z = sqrt(1 - u.x), phi = 2 pi u.y.
vec3 corput_cosine_hemisphere_polar(uvec2 u) {
    CorputScaled z = CorputScaled(0x80000000u, -31);
    if (u.x != 0u) {
        z = corput_sqrt_fraction(0u - u.x);
    }
    return vec3(corput_polar_disk(u), corput_pack(z, false));
}

// z/pi.
float corput_cosine_hemisphere_polar_pdf(vec3 direction) {
    return corput_cosine_over_pi(direction.z);
}

// The fractions that give this direction.
uvec2 corput_cosine_hemisphere_polar_invert(vec3 direction) {
    return corput_polar_disk_invert(direction.xy);
}

#endif
