#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
// Points to samples of a map in one kernel: no point travels through memory.
#include "interface.glsl"
#include "map_hemisphere.glsl"
#include "map_store.glsl"
#include "tile.glsl"

void main() {
    uint i = kernel_invocation();
    if (i >= push.invocations) {
        return;
    }
    Tile tile = tile_start(push.first + i * TILE);
    uint width = COORDINATES + WITH_PDF;
    uint at = i * (TILE / 4u) * width;
    // A loop, not four copies: the maps are long, and some drivers compile slowly.
    for (uint j = 0u; j < TILE; j += 4u) {
        uvec4 samples[4];
        for (uint k = 0u; k < 4u; k++) {
            samples[k] = map_sample(uvec3(tile_fractions(tile).xy, 0u));
            tile = tile_next(tile);
        }
        map_store(at, width, samples[0], samples[1], samples[2], samples[3]);
        at += width;
    }
}
