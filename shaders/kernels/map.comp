#version 450
#extension GL_GOOGLE_include_directive : require
// Pairs of fractions from a buffer to samples of a map, four an invocation.
#include "interface.glsl"
#include "map.glsl"

void main() {
    uint i = kernel_invocation();
    if (i >= push.invocations) {
        return;
    }
    uvec4 samples[4];
    for (uint k = 0u; k < 4u; k++) {
        uvec4 pair = points[2u * i + (k >> 1)];
        samples[k] = map_sample((k & 1u) == 0u ? pair.xy : pair.zw);
    }
    map_store(i * map_width(), samples[0], samples[1], samples[2], samples[3]);
}
