#version 450
#extension GL_GOOGLE_include_directive : require
// Sums the radiance that Hammersley points, cosine-weighted around an axis, meet in an
// environment map: 64-bit integers in units of 2^-scale, so the order does not matter.
#include "interface.glsl"
#include "corput/axis.glsl"
#include "corput/hammersley.glsl"
#include "corput/radical_inverse.glsl"
#include "corput/hemisphere.glsl"
#define CORPUT_ENVMAP_EDGE(i) edges[i]
#include "corput/envmap.glsl"

void main() {
    uint i = kernel_invocation();
    if (i >= push.invocations) {
        return;
    }
    uvec2 red = uvec2(0u);
    uvec2 green = uvec2(0u);
    uvec2 blue = uvec2(0u);
    for (uint k = push.first + i; k < push.count; k += push.invocations) {
        uvec2 u = uvec2(corput_van_der_corput(k), corput_hammersley(k, push.count));
        uvec2 texel = corput_envmap_texel(corput_axis_turned(corput_cosine_hemisphere(u), push.axis),
            uvec2(push.width, push.height));
        uint at = 3u * (texel.y * push.width + texel.x);
        int scale = int(push.scale);
        red = corput_add64(red, corput_fixed64(uintBitsToFloat(texels[at]), scale));
        green = corput_add64(green, corput_fixed64(uintBitsToFloat(texels[at + 1u]), scale));
        blue = corput_add64(blue, corput_fixed64(uintBitsToFloat(texels[at + 2u]), scale));
    }
    results[2u * i] = uvec4(red, green);
    results[2u * i + 1u] = uvec4(blue, 0u, 0u);
}
