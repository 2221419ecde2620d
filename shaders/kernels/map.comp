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
    uvec4 first = points[2u * i];
    uvec4 second = points[2u * i + 1u];
    map_store(i * map_width(), map_sample(first.xy), map_sample(first.zw), map_sample(second.xy),
        map_sample(second.zw));
}
