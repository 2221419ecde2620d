// what:   an orthonormal frame around a unit normal, and changes to and from it.
// source: Duff et al. 2017, Building an orthonormal basis, revisited, JCGT 6(1); the
//         sign of z is taken as an integer, the division is exact.
// domain: unit vectors. Components below 2^-40 count as zero, which moves a direction by
//         less than 2^-40 and keeps every intermediate out of the denormals.
// range:  right-handed: cross(tangent, bitangent) = normal, to 2^-21.
// cost:   about 60 instructions.
//         tier F: float + - * rounded to nearest even, never contracted.
// hooks:  CORPUT_PRECISE: `precise` where the language has it.
// mirror: src/reference/frame.rs
#ifndef CORPUT_FRAME_GLSL
#define CORPUT_FRAME_GLSL

#include "corput/elementary.glsl"

// naga knows no `precise`, ESSL knows it from 3.20 on.
#ifndef CORPUT_PRECISE
#if defined(CORPUT_PORTABLE) || defined(GL_ES)
#define CORPUT_PRECISE
#else
#define CORPUT_PRECISE precise
#endif
#endif

struct CorputFrame {
    vec3 tangent;
    vec3 bitangent;
    vec3 normal;
};

// x, or 0 where |x| < 2^-40.
float corput_frame_flush(float x) {
    return (floatBitsToUint(x) & 0x7fffffffu) < 0x2b800000u ? 0.0 : x;
}

// -x by its sign bit.
float corput_frame_negate(float x) {
    return uintBitsToFloat(floatBitsToUint(x) ^ 0x80000000u);
}

// The frame around a unit normal.
CorputFrame corput_frame(vec3 normal) {
    float x = corput_frame_flush(normal.x);
    float y = corput_frame_flush(normal.y);
    float z = corput_frame_flush(normal.z);
    uint sign = floatBitsToUint(z) & 0x80000000u;
    float one = uintBitsToFloat(0x3f800000u | sign);
    CORPUT_PRECISE float denominator = one + z;
    float a = corput_frame_negate(corput_divide(1.0, denominator));
    // The sign is put on by its bit, as a product with +-1 would.
    float signed_x = uintBitsToFloat(floatBitsToUint(x) ^ sign);
    CORPUT_PRECISE float xx = signed_x * x;
    CORPUT_PRECISE float yy = y * y;
    CORPUT_PRECISE float xy = x * y;
    CORPUT_PRECISE float xxa = xx * a;
    CORPUT_PRECISE float yya = yy * a;
    CORPUT_PRECISE float b = xy * a;
    CORPUT_PRECISE float tangent_x = 1.0 + xxa;
    CORPUT_PRECISE float bitangent_y = one + yya;
    return CorputFrame(
        vec3(tangent_x, uintBitsToFloat(floatBitsToUint(b) ^ sign), corput_frame_negate(signed_x)),
        vec3(b, bitangent_y, corput_frame_negate(y)),
        vec3(x, y, z));
}

// x a + y b + z c, from the left, for components of unit vectors.
float corput_frame_combine(vec3 v, vec3 w) {
    CORPUT_PRECISE float a = corput_frame_flush(v.x) * corput_frame_flush(w.x);
    CORPUT_PRECISE float b = corput_frame_flush(v.y) * corput_frame_flush(w.y);
    CORPUT_PRECISE float c = corput_frame_flush(v.z) * corput_frame_flush(w.z);
    CORPUT_PRECISE float ab = a + b;
    CORPUT_PRECISE float abc = ab + c;
    return abc;
}

// The vector with these coordinates in the frame.
vec3 corput_frame_to_world(CorputFrame f, vec3 local) {
    return vec3(
        corput_frame_combine(local, vec3(f.tangent.x, f.bitangent.x, f.normal.x)),
        corput_frame_combine(local, vec3(f.tangent.y, f.bitangent.y, f.normal.y)),
        corput_frame_combine(local, vec3(f.tangent.z, f.bitangent.z, f.normal.z)));
}

// Coordinates in the frame of this vector.
vec3 corput_frame_to_local(CorputFrame f, vec3 world) {
    return vec3(corput_frame_combine(world, f.tangent), corput_frame_combine(world, f.bitangent),
        corput_frame_combine(world, f.normal));
}

#endif
