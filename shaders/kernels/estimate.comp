#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
// Exact sums of an integrand and of its square over consecutive points, one record an
// invocation: no groups, no atomics, so no size of a group and no split shows in the bits.
#include "interface.glsl"
#if defined RENDER_ENVIRONMENT
#include "integrand_environment.glsl"
#elif defined RENDER_SCENE
#include "integrand_scene.glsl"
#else
#include "integrand.glsl"
#endif
#ifdef TILE_COLUMNS
#include "tile.glsl"
#else
#include "column.glsl"
#endif

#ifndef TILE_COLUMNS
// TILE points side by side, dimension after dimension, so that they share what is loaded
// for a dimension and what its cursor starts with.
CorputSum tile_sum(CorputSum sum, uint index, uint count, uvec4 head) {
    Integrand states[TILE];
    [[unroll]] for (uint k = 0u; k < TILE; k++) {
        states[k] = integrand_start(head);
    }
    [[dont_unroll]] for (uint j = 0u; j < DIMENSIONS; j++) {
        Column c = column_load(j * COLUMN_ROWS);
        uvec4 words = coefficients[1u + j];
        Cursor cursor = cursor_start(index, c);
        [[unroll]] for (uint k = 0u; k < TILE; k++) {
            states[k] = integrand_step(states[k], j, cursor_value(cursor, c), head, words);
            cursor = cursor_next(cursor, c);
        }
    }
    [[unroll]] for (uint k = 0u; k < TILE; k++) {
        if (k < count) {
            sum = corput_sum_add(sum, integrand_term(states[k], head, int(push.scale)));
        }
    }
    return sum;
}

CorputSum run_sum(uint index, uint count) {
    CorputSum sum = corput_sum_zero();
    uvec4 head = coefficients[0];
    [[dont_unroll]] for (uint done = 0u; done < count; done += TILE) {
        sum = tile_sum(sum, index + done, count - done, head);
    }
    return sum;
}
#else
CorputTerm tile_term(Tile tile, uvec4 words[1 + TILE_COLUMNS]) {
    uvec4 point = tile_fractions(tile);
    uvec4 head = words[0];
    Integrand state = integrand_step(integrand_start(head), 0u, point.x, head, words[1]);
#if TILE_COLUMNS > 1
    state = integrand_step(state, 1u, point.y, head, words[2]);
#endif
#if TILE_COLUMNS > 2
    state = integrand_step(state, 2u, point.z, head, words[3]);
#endif
#if TILE_COLUMNS > 3
    state = integrand_step(state, 3u, point.w, head, words[4]);
#endif
    return integrand_term(state, head, int(push.scale));
}

// Points come in groups of SIDE_BY_SIDE from a multiple of it on, of which the first and the
// last may reach beyond the run.
CorputSum run_sum(uint index, uint count) {
    CorputTally tally = corput_tally_zero();
    uvec4 words[1 + TILE_COLUMNS];
    [[unroll]] for (uint j = 0u; j <= TILE_COLUMNS; j++) {
        words[j] = coefficients[j];
    }
    tile_load();
    uint before = index & (SIDE_BY_SIDE - 1u);
    uint whole = before + count;
    [[dont_unroll]] for (uint done = 0u; done < whole; done += TILE) {
        Tile tile = tile_start(index - before + done);
        uint end = min(whole, done + TILE);
        [[dont_unroll]] for (uint k = done; k < end; k += SIDE_BY_SIDE) {
            [[unroll]] for (uint j = 0u; j < SIDE_BY_SIDE; j++) {
                CorputTerm term = tile_term(tile, words);
                if (k + j - before >= count) {
                    term = CorputTerm(uvec2(0u), false);
                }
                tally = corput_tally_add(tally, term);
                if (j + 1u < SIDE_BY_SIDE) {
                    tile = tile_beside(tile, j);
                } else {
                    tile = tile_group(tile, SIDE_BY_SIDE);
                }
            }
        }
    }
    return corput_tally_sum(tally);
}
#endif

void main() {
    uint i = kernel_invocation();
    if (i >= push.invocations) {
        return;
    }
    uint start = i * push.run;
    uint count = min(push.run, push.count - start);
    CorputSum sum = run_sum(push.first + start, count);
    results[3u * i] = sum.total;
    results[3u * i + 1u] = sum.squares;
    results[3u * i + 2u] = uvec4(sum.squares_high, count, 0u);
}
