// what:   the unit disk, uniformly: concentric and polar maps, with pdf and inverse.
// source: Shirley and Chiu 1997, A low distortion map between disk and square, JGT 2(3).
//         With r = a, phi = pi/4 b/a: y = a sin(pi/4 rho) with rho = b/a is b times an
//         even polynomial in rho, hence as exact as b; no angle is ever formed.
// domain: two fractions of 2^32. range: x^2 + y^2 <= 1 + 2^-22.
// pdf:    with respect to area: 1/pi.
// errors: concentric 0.6 ULP a coordinate, polar 1.6 ULP. Inverses agree with the sample
//         to 2^-22 a coordinate, angles modulo one turn.
//         Singular points: the centre has no angle; concentric gives (1/2, 1/2) back for
//         it, polar (0, 0).
// cost:   about 60 integer instructions. tier I.
// hooks:  none.
// mirror: src/reference/disk.rs
#ifndef CORPUT_DISK_GLSL
#define CORPUT_DISK_GLSL

#include "corput/elementary.glsl"

// |2u - 1| as a fraction of 2^31: 0 to 2^31.
uint corput_disk_magnitude(uint u) {
    return u < 0x80000000u ? 0x80000000u - u : u - 0x80000000u;
}

// The fraction u of 2^32 with 2u - 1 = (negative ? -1 : 1) * a / 2^31; below 1.
uint corput_disk_coordinate(uint a, bool negative) {
    return negative ? 0x80000000u - a : min(a, 0x7fffffffu) + 0x80000000u;
}

// Whether x < 0, by its bits: a device may compare denormals as zeros.
bool corput_disk_negative(float x) {
    return floatBitsToUint(x) > 0x80000000u;
}

// x^2 + y^2 as a fraction of 2^62, below 2^62.
uvec2 corput_disk_radius_squared(vec2 p) {
    uint x = corput_fixed31(p.x);
    uint y = corput_fixed31(p.y);
    uvec2 sum = corput_add64(corput_mul64(x, x), corput_mul64(y, y));
    return sum.y >= 0x40000000u ? uvec2(0xffffffffu, 0x3fffffffu) : sum;
}

// Point of the disk, concentric map.
vec2 corput_concentric_disk(uvec2 u) {
    uint x = corput_disk_magnitude(u.x);
    uint y = corput_disk_magnitude(u.y);
    uint large = max(x, y);
    uint small = min(x, y);
    uint w = corput_square31(corput_ratio(small, max(large, 1u)) << 1);
    CorputScaled near = corput_scaled_mul(corput_scaled(large, -31),
        CorputScaled(corput_cos_polynomial(w), -32));
    CorputScaled far = corput_scaled_mul(corput_scaled(small, -31),
        CorputScaled(corput_sin_polynomial(w), -32));
    bool x_large = x >= y;
    return vec2(corput_pack(x_large ? near : far, u.x < 0x80000000u),
        corput_pack(x_large ? far : near, u.y < 0x80000000u));
}

// 1/pi.
float corput_concentric_disk_pdf() {
    return uintBitsToFloat(0x3ea2f983u);
}

// The fractions that the concentric map takes to p.
uvec2 corput_concentric_disk_invert(vec2 p) {
    uint x = corput_fixed31(p.x);
    uint y = corput_fixed31(p.y);
    CorputScaled radius = corput_sqrt_fraction64(corput_shl64(corput_disk_radius_squared(p), 2u));
    uint large = radius.m == 0u ? 0u : radius.m >> uint(min(-31 - radius.e, 31));
    uint angle = corput_atan_ratio(min(x, y), max(x, y));
    uint small = corput_shr64(corput_mul64(large, angle), 29u).x;
    bool x_large = x >= y;
    return uvec2(corput_disk_coordinate(x_large ? large : small, corput_disk_negative(p.x)),
        corput_disk_coordinate(x_large ? small : large, corput_disk_negative(p.y)));
}

// Point of the disk, polar map: r = sqrt(u.x), phi = 2 pi u.y.
vec2 corput_polar_disk(uvec2 u) {
    CorputScaled radius = corput_sqrt_fraction(u.x);
    CorputSinCos phi = corput_sincos_scaled(u.y);
    return vec2(corput_pack(corput_scaled_mul(radius, phi.cosine), phi.cosine_negative),
        corput_pack(corput_scaled_mul(radius, phi.sine), phi.sine_negative));
}

// 1/pi.
float corput_polar_disk_pdf() {
    return uintBitsToFloat(0x3ea2f983u);
}

// The fractions that the polar map takes to p.
uvec2 corput_polar_disk_invert(vec2 p) {
    return uvec2(corput_shr64(corput_disk_radius_squared(p), 30u).x, corput_atan2(p.y, p.x));
}

#endif
