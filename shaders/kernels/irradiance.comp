#version 450
#extension GL_GOOGLE_include_directive : require
// Sums the radiance that Hammersley points, cosine-weighted around an axis, meet in an
// environment map: 64-bit integers in units of 2^-scale, so the order does not matter.
#include "interface.glsl"
#include "corput/hammersley.glsl"
#include "corput/radical_inverse.glsl"
#include "corput/hemisphere.glsl"
#define CORPUT_ENVMAP_EDGE(i) edges[i]
#include "corput/envmap.glsl"

float negated(float x) {
    return uintBitsToFloat(floatBitsToUint(x) ^ 0x80000000u);
}

// The direction with +z turned to the axis, exactly: coordinates change places.
vec3 turned(vec3 d, uint axis) {
    vec3 v = axis >= 4u ? d : axis >= 2u ? d.yzx : d.zxy;
    if ((axis & 1u) == 0u) {
        return v;
    }
    // Half a turn about an axis across: two signs change.
    return axis == 1u ? vec3(negated(v.x), negated(v.y), v.z)
        : axis == 3u ? vec3(v.x, negated(v.y), negated(v.z))
        : vec3(negated(v.x), v.y, negated(v.z));
}

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
        uvec2 texel = corput_envmap_texel(turned(corput_cosine_hemisphere(u), push.axis),
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
