#version 450
#extension GL_GOOGLE_include_directive : require
// Look-ups of dither masks and screen-space indices over a buffer of arguments, or over
// indices.
#include "interface.glsl"
// 240 ranks in disorder: 77 has no divisor in common with 240.
#define CORPUT_BLUE_NOISE(x, y) (((x) + 24u * (y)) * 77u % 240u)
#include "corput/blue_noise.glsl"
#include "corput/screen_space.glsl"

uvec4 evaluate(uvec4 a) {
    uvec2 size = uvec2(24u, 10u);
    switch (FUNCTION) {
    case 0u:
        uint count = (a.w & 0xffffu) + 1u;
        uint fraction = corput_blue_noise_fraction(a.z % count, count);
        return uvec4(corput_blue_noise(a.xy, size),
            corput_blue_noise_frame(a.xy, a.z, uvec3(24u, 2u, 5u)),
            fraction, corput_blue_noise_animate(fraction, a.x));
    case 1u:
        uvec2 shifted = corput_blue_noise_shift(a.xy, a.z, ((a.ww >> uvec2(0u, 16u)) & 0xffffu) + 1u);
        return uvec4(shifted, corput_blue_noise_rank(shifted, size),
            corput_screen_space_hash(a.x, a.y, a.z));
    default:
        uint bits = a.w & 31u;
        return uvec4(corput_screen_space_index(a.xy, a.z & ((1u << bits) - 1u), bits, a.z),
            corput_screen_space_index(a.xy, a.z, 32u, a.w),
            corput_screen_space_morton(a.xy), corput_screen_space_shuffle(a.x, a.w % 17u, a.y));
    }
}

void main() {
    uint i = kernel_invocation();
    if (i >= push.invocations) {
        return;
    }
    uint n = push.first + i * push.stride;
    results[i] = evaluate(INDEXED != 0u ? uvec4(n) : arguments[i]);
}
