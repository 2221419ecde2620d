#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
#extension GL_EXT_shader_explicit_arithmetic_types_int64 : require
// Points of one to four columns: TILE consecutive ones an invocation, in stores of eight words.
// llvmpipe stores lane by lane, so that fewer and wider stores are faster there.
#define TILE_PLACES
#include "interface.glsl"
#include "tile.glsl"

// Points whose words fill whole stores.
#if TILE_COLUMNS == 4
#define POINTS 2u
#elif TILE_COLUMNS == 2
#define POINTS 4u
#else
#define POINTS 8u
#endif
#define STORES (POINTS * TILE_COLUMNS / 8u)

void main() {
    uint i = kernel_invocation();
    if (i >= push.invocations) {
        return;
    }
    Tile tile = tile_start(push.first + i * TILE);
    uint at = i * (TILE / POINTS) * STORES;
    for (uint j = 0u; j < TILE; j += POINTS) {
        uint words[POINTS * TILE_COLUMNS];
        [[unroll]] for (uint k = 0u; k < POINTS; k++) {
            uvec4 point = tile_output(tile_fractions(tile), OUTPUT);
            [[unroll]] for (uint c = 0u; c < TILE_COLUMNS; c++) {
                words[k * TILE_COLUMNS + c] = point[c];
            }
            tile = tile_next(tile);
        }
        [[unroll]] for (uint s = 0u; s < STORES; s++) {
            uint w = 8u * s;
            results[at + s] = u64vec4(
                packUint2x32(uvec2(words[w], words[w + 1u])), packUint2x32(uvec2(words[w + 2u], words[w + 3u])),
                packUint2x32(uvec2(words[w + 4u], words[w + 5u])), packUint2x32(uvec2(words[w + 6u], words[w + 7u])));
        }
        at += STORES;
    }
}
