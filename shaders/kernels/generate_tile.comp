#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
// Points of one to four columns: TILE consecutive ones an invocation, in wide stores.
// Four columns may be a part of a row of ROW_WORDS, which takes one dispatch per part. Rows that
// are no multiple of four are stored word by word, and their last part begins with SKIPPED columns
// that the part before it has stored.
#define TILE_PLACES
#include "interface.glsl"
#include "tile.glsl"

#if TILE_COLUMNS == 4
void store_row(uint word, uvec4 point) {
    if (ROW_WORDS % 4u == 0u) {
        results[word / 4u] = point;
        return;
    }
    [[unroll]] for (uint k = 0u; k < 4u; k++) {
        if (k >= SKIPPED) {
            results[(word + k) / 4u][(word + k) % 4u] = point[k];
        }
    }
}
#endif

void main() {
    uint i = kernel_invocation();
    if (i >= push.invocations) {
        return;
    }
    Tile tile = tile_start(push.first + i * TILE);
#if TILE_COLUMNS == 4
    uint at = i * TILE * ROW_WORDS + FIRST_COLUMN;
#else
    uint at = i * (TILE / 4u) * TILE_COLUMNS;
#endif
    for (uint j = 0u; j < TILE; j += 4u) {
        uvec4 p[4];
        for (uint k = 0u; k < 4u; k++) {
            p[k] = tile_output(tile_fractions(tile), OUTPUT);
            tile = tile_next(tile);
        }
#if TILE_COLUMNS == 1
        results[at] = uvec4(p[0].x, p[1].x, p[2].x, p[3].x);
#elif TILE_COLUMNS == 2
        results[at] = uvec4(p[0].xy, p[1].xy);
        results[at + 1u] = uvec4(p[2].xy, p[3].xy);
#elif TILE_COLUMNS == 3
        results[at] = uvec4(p[0].xyz, p[1].x);
        results[at + 1u] = uvec4(p[1].yz, p[2].xy);
        results[at + 2u] = uvec4(p[2].z, p[3].xyz);
#else
        [[unroll]] for (uint k = 0u; k < 4u; k++) {
            store_row(at + k * ROW_WORDS, p[k]);
        }
#endif
#if TILE_COLUMNS == 4
        at += 4u * ROW_WORDS;
#else
        at += TILE_COLUMNS;
#endif
    }
}
