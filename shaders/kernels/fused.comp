#version 450
#extension GL_GOOGLE_include_directive : require
// Points to samples of a map in one kernel: no point travels through memory.
#include "interface.glsl"
#include "map.glsl"
#include "tile.glsl"

void main() {
    uint i = kernel_invocation();
    if (i >= push.invocations) {
        return;
    }
    Tile tile = tile_start(push.first + i * TILE);
    uint at = i * (TILE / 4u) * map_width();
    for (uint j = 0u; j < TILE; j += 4u) {
        uvec4 p0 = map_sample(tile_fractions(tile).xy);
        tile = tile_next(tile);
        uvec4 p1 = map_sample(tile_fractions(tile).xy);
        tile = tile_next(tile);
        uvec4 p2 = map_sample(tile_fractions(tile).xy);
        tile = tile_next(tile);
        uvec4 p3 = map_sample(tile_fractions(tile).xy);
        tile = tile_next(tile);
        map_store(at, p0, p1, p2, p3);
        at += map_width();
    }
}
