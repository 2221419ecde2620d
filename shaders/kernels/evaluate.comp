#version 450
#extension GL_GOOGLE_include_directive : require
// One function of the headers over a buffer of arguments, or over indices.
#include "interface.glsl"
#ifdef KERNEL_FRAME
#include "corput/frame.glsl"
#include "corput/hemisphere.glsl"
#elif defined(KERNEL_NATIVE)
#include "corput/native/frame.glsl"
#include "corput/native/hemisphere.glsl"
#else
#include "corput/hammersley.glsl"
#include "corput/hemisphere.glsl"
#include "corput/radical_inverse.glsl"
#include "corput/unit.glsl"
#endif

float f(uint bits) {
    return uintBitsToFloat(bits);
}

uvec4 bits2(vec2 v) {
    return uvec4(floatBitsToUint(v), 0u, 0u);
}

uvec4 bits3(vec3 v) {
    return uvec4(floatBitsToUint(v), 0u);
}

uvec4 bits4(vec3 v, float w) {
    return uvec4(floatBitsToUint(v), floatBitsToUint(w));
}

#if !defined(KERNEL_FRAME) && !defined(KERNEL_NATIVE)
// k/N; the division behind it, and the remainder one step on.
uvec4 grid(uint k, uint count) {
    CorputGridPoint point = corput_hammersley_start(k, count);
    CorputGridPoint next = corput_hammersley_next(point, corput_hammersley_start(1u, count), count);
    return uvec4(corput_hammersley(k, count), point.fraction, point.remainder, next.remainder);
}
#endif

uvec4 evaluate(uvec4 a) {
#ifdef KERNEL_FRAME
    CorputFrame frame = corput_frame(vec3(f(a.x), f(a.y), f(a.z)));
    switch (FUNCTION) {
    case 0u:
        return bits3(frame.tangent);
    case 1u:
        return bits3(frame.bitangent);
    case 2u:
        return bits3(corput_frame_to_world(frame, corput_cosine_hemisphere(uvec2(a.w, a.w * 0x9e3779b9u))));
    default:
        return bits3(corput_frame_to_local(frame, corput_cosine_hemisphere(uvec2(a.w, a.w * 0x9e3779b9u))));
    }
#elif defined(KERNEL_NATIVE)
    vec3 v = vec3(f(a.x), f(a.y), f(a.z));
    CorputNativeFrame frame = corput_native_frame(v);
    vec3 d;
    switch (FUNCTION) {
    case 0u:
        return bits3(frame.tangent);
    case 1u:
        return bits3(frame.bitangent);
    case 2u:
        return bits2(corput_native_concentric_disk(a.xy));
    case 3u:
        return bits2(corput_native_polar_disk(a.xy));
    case 4u:
        d = corput_native_uniform_hemisphere(a.xy);
        return bits4(d, corput_native_uniform_hemisphere_pdf(d));
    case 5u:
        d = corput_native_cosine_hemisphere(a.xy);
        return bits4(d, corput_native_cosine_hemisphere_pdf(d));
    case 6u:
        d = corput_native_cosine_hemisphere_polar(a.xy);
        return bits4(d, corput_native_cosine_hemisphere_polar_pdf(d));
    case 7u:
        return uvec4(corput_native_uniform_hemisphere_invert(v), 0u, 0u);
    case 8u:
        return uvec4(corput_native_cosine_hemisphere_invert(v), 0u, 0u);
    case 9u:
        return uvec4(corput_native_cosine_hemisphere_polar_invert(v), 0u, 0u);
    case 10u:
        return bits3(corput_native_frame_to_world(frame, vec3(0.6, 0.0, 0.8)));
    default:
        return bits3(corput_native_frame_to_local(frame, vec3(0.6, 0.0, 0.8)));
    }
#else
    vec3 v = vec3(f(a.x), f(a.y), f(a.z));
    vec3 d;
    switch (FUNCTION) {
    case 0u:
        return uvec4(corput_mul64(a.x, a.y), corput_addc(a.x, a.y));
    case 1u:
        return uvec4(corput_add64(a.xy, a.zw), corput_sub64(a.xy, a.zw));
    case 2u:
        return uvec4(corput_shl64(a.xy, a.z & 63u), corput_shr64(a.xy, a.z & 63u));
    case 3u:
        return uvec4(corput_fixed31(f(a.x)), corput_fixed64(f(a.x & 0x7fffffffu), int(a.y % 129u) - 64), corput_find_msb(a.x));
    case 4u:
        return uvec4(floatBitsToUint(corput_unit_floor(a.x)), floatBitsToUint(corput_unit_ceil(a.x)), corput_van_der_corput(a.x), 0u);
    case 5u:
        return bits2(corput_cos_sin(a.x));
    case 6u:
        return uvec4(floatBitsToUint(corput_sqrt(f(a.x))), 0u, 0u, 0u);
    case 7u:
        return uvec4(floatBitsToUint(corput_divide(f(a.x), f(a.y))), 0u, 0u, 0u);
    case 8u:
        return uvec4(floatBitsToUint(corput_multiply(f(a.x), f(a.y))), 0u, 0u, 0u);
    case 9u:
        return uvec4(corput_atan2(f(a.y), f(a.x)), 0u, 0u, 0u);
    case 10u:
        return uvec4(corput_ratio(min(a.x, a.y) >> 1, max((max(a.x, a.y) >> 1), 1u)), 0u, 0u, 0u);
    case 11u:
        return uvec4(corput_radical_inverse(a.x, a.y), 0u, 0u, 0u);
    case 12u:
        return grid(a.x, a.y);
    case 13u:
        return bits2(corput_concentric_disk(a.xy));
    case 14u:
        return bits2(corput_polar_disk(a.xy));
    case 15u:
        d = corput_uniform_hemisphere(a.xy);
        return bits4(d, corput_uniform_hemisphere_pdf(d));
    case 16u:
        d = corput_cosine_hemisphere(a.xy);
        return bits4(d, corput_cosine_hemisphere_pdf(d));
    case 17u:
        d = corput_cosine_hemisphere_polar(a.xy);
        return bits4(d, corput_cosine_hemisphere_polar_pdf(d));
    case 18u:
        return uvec4(corput_concentric_disk_invert(v.xy), corput_polar_disk_invert(v.xy));
    case 19u:
        return uvec4(corput_uniform_hemisphere_invert(v), corput_cosine_hemisphere_invert(v));
    case 20u:
        return uvec4(corput_cosine_hemisphere_polar_invert(v), 0u, 0u);
    default:
        d = vec3(0.0, 0.0, f(a.x));
        return uvec4(floatBitsToUint(corput_cosine_hemisphere_pdf(d)),
            floatBitsToUint(corput_uniform_hemisphere_pdf(d)), 0u, 0u);
    }
#endif
}

void main() {
    uint i = kernel_invocation();
    if (i >= push.invocations) {
        return;
    }
    uint n = push.first + i * push.stride;
    results[i] = evaluate(INDEXED != 0u ? uvec4(n) : arguments[i]);
}
