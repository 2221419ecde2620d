#version 450
#extension GL_GOOGLE_include_directive : require
// Points of one to four columns: TILE consecutive ones an invocation, in wide stores.
#include "interface.glsl"
#include "tile.glsl"

void main() {
    uint i = kernel_invocation();
    if (i >= push.invocations) {
        return;
    }
    Tile tile = tile_start(push.first + i * TILE);
    uint at = i * (TILE / 4u) * TILE_COLUMNS;
    for (uint j = 0u; j < TILE; j += 4u) {
        uvec4 p0 = tile_output(tile_fractions(tile), OUTPUT);
        tile = tile_next(tile);
        uvec4 p1 = tile_output(tile_fractions(tile), OUTPUT);
        tile = tile_next(tile);
        uvec4 p2 = tile_output(tile_fractions(tile), OUTPUT);
        tile = tile_next(tile);
        uvec4 p3 = tile_output(tile_fractions(tile), OUTPUT);
        tile = tile_next(tile);
#if TILE_COLUMNS == 1
        results[at] = uvec4(p0.x, p1.x, p2.x, p3.x);
#elif TILE_COLUMNS == 2
        results[at] = uvec4(p0.xy, p1.xy);
        results[at + 1u] = uvec4(p2.xy, p3.xy);
#elif TILE_COLUMNS == 3
        results[at] = uvec4(p0.xyz, p1.x);
        results[at + 1u] = uvec4(p1.yz, p2.xy);
        results[at + 2u] = uvec4(p2.z, p3.xyz);
#else
        results[at] = p0;
        results[at + 1u] = p1;
        results[at + 2u] = p2;
        results[at + 3u] = p3;
#endif
        at += TILE_COLUMNS;
    }
}
