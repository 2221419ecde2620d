// what:   an orthonormal frame around a unit normal in the native profile.
// source: Duff et al. 2017, Building an orthonormal basis, revisited, JCGT 6(1).
// domain: unit vectors. range: right-handed, to the device's precision.
// cost:   about 20 float instructions.
// hooks:  none.
// mirror: src/reference/native/frame.rs
#ifndef CORPUT_NATIVE_FRAME_GLSL
#define CORPUT_NATIVE_FRAME_GLSL

struct CorputNativeFrame {
    vec3 tangent;
    vec3 bitangent;
    vec3 normal;
};

// The frame around a unit normal.
CorputNativeFrame corput_native_frame(vec3 normal) {
    // By the sign bit, so that -0 agrees with the denominator.
    float one = uintBitsToFloat(0x3f800000u | (floatBitsToUint(normal.z) & 0x80000000u));
    float a = -1.0 / (one + normal.z);
    float b = normal.x * normal.y * a;
    return CorputNativeFrame(
        vec3(1.0 + one * normal.x * normal.x * a, one * b, -one * normal.x),
        vec3(b, one + normal.y * normal.y * a, -normal.y),
        normal);
}

// The vector with these coordinates in the frame.
vec3 corput_native_frame_to_world(CorputNativeFrame f, vec3 local) {
    return local.x * f.tangent + local.y * f.bitangent + local.z * f.normal;
}

// Coordinates in the frame of this vector.
vec3 corput_native_frame_to_local(CorputNativeFrame f, vec3 world) {
    return vec3(dot(world, f.tangent), dot(world, f.bitangent), dot(world, f.normal));
}

#endif
