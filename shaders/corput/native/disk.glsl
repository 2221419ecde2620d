// what:   the unit disk in the native profile: concentric and polar maps, with inverse,
//         by the device's own sin, cos, sqrt and atan.
// source: Shirley and Chiu 1997, A low distortion map between disk and square, JGT 2(3).
// domain: two fractions of 2^32. range: the unit disk, to the device's precision.
// pdf:    with respect to area: 1/pi.
// errors: Vulkan allows sin and cos an absolute error of 2^-11 and atan 4096 ULP.
// cost:   about 20 float instructions.
// hooks:  none.
// mirror: src/reference/native/disk.rs
#ifndef CORPUT_NATIVE_DISK_GLSL
#define CORPUT_NATIVE_DISK_GLSL

// u as a fraction of 2^32; rounds to 1 for the highest u, unlike corput_unit_floor.
float corput_native_unit(uint u) {
    return float(u) * 2.3283064365386963e-10;
}

// 2u - 1 in [-1, 1].
float corput_native_signed_unit(uint u) {
    return float(int(u ^ 0x80000000u)) * 4.656612873077393e-10;
}

// The fraction of 2^32 nearest below x, for x clamped to [0, 1); 0 for NaN.
uint corput_native_fraction(float x) {
    return x > 0.0 ? uint(min(x, 0.99999994) * 4294967296.0) : 0u;
}

// x as a density: the largest float for what is larger, 0 for what is negative or NaN.
float corput_native_density(float x) {
    return x > 0.0 ? min(x, 3.4028235e38) : 0.0;
}

// Angle of p in turns, in [0, 1].
float corput_native_turns(vec2 p) {
    if (p.x == 0.0 && p.y == 0.0) {
        return 0.0;
    }
    float turns = atan(p.y, p.x) * 0.15915494;
    return turns < 0.0 ? turns + 1.0 : turns;
}

// Point of the disk, concentric map.
vec2 corput_native_concentric_disk(uvec2 u) {
    float x = corput_native_signed_unit(u.x);
    float y = corput_native_signed_unit(u.y);
    if (x == 0.0 && y == 0.0) {
        return vec2(0.0);
    }
    if (abs(x) >= abs(y)) {
        float phi = 0.78539816 * (y / x);
        return vec2(x * cos(phi), x * sin(phi));
    }
    float phi = 0.78539816 * (x / y);
    return vec2(y * sin(phi), y * cos(phi));
}

// The fractions that the concentric map takes to p.
uvec2 corput_native_concentric_disk_invert(vec2 p) {
    float radius = sqrt(p.x * p.x + p.y * p.y);
    float large = max(abs(p.x), abs(p.y));
    float small = min(abs(p.x), abs(p.y));
    float rest = large == 0.0 ? 0.0 : radius * (1.2732395 * atan(small / large));
    float x = abs(p.x) >= abs(p.y) ? radius : rest;
    float y = abs(p.x) >= abs(p.y) ? rest : radius;
    return uvec2(corput_native_fraction(0.5 + 0.5 * (p.x < 0.0 ? -x : x)),
        corput_native_fraction(0.5 + 0.5 * (p.y < 0.0 ? -y : y)));
}

// Point of the disk, polar map.
vec2 corput_native_polar_disk(uvec2 u) {
    float radius = sqrt(corput_native_unit(u.x));
    float phi = 6.2831853 * corput_native_unit(u.y);
    return vec2(radius * cos(phi), radius * sin(phi));
}

// The fractions that the polar map takes to p.
uvec2 corput_native_polar_disk_invert(vec2 p) {
    return uvec2(corput_native_fraction(p.x * p.x + p.y * p.y),
        corput_native_fraction(corput_native_turns(p)));
}

#endif
