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
#ifdef COLUMN_TABLE
#include "column.glsl"
#else
#include "tile.glsl"
#endif

#ifdef COLUMN_TABLE
CorputSum run_sum(uint index, uint count) {
    CorputSum sum = corput_sum_zero();
    [[dont_unroll]] for (uint k = 0u; k < count; k++) {
        Integrand state = integrand_start();
        [[dont_unroll]] for (uint j = 0u; j < DIMENSIONS; j++) {
            Column c = column_load(j * COLUMN_WORDS);
            state = integrand_step(state, j, cursor_value(cursor_start(index + k, c), c));
        }
        sum = corput_sum_add(sum, integrand_term(state, int(push.scale)));
    }
    return sum;
}
#else
CorputTerm tile_term(Tile tile) {
    uvec4 point = tile_fractions(tile);
    Integrand state = integrand_step(integrand_start(), 0u, point.x);
#if TILE_COLUMNS > 1
    state = integrand_step(state, 1u, point.y);
#endif
#if TILE_COLUMNS > 2
    state = integrand_step(state, 2u, point.z);
#endif
#if TILE_COLUMNS > 3
    state = integrand_step(state, 3u, point.w);
#endif
    return integrand_term(state, int(push.scale));
}

CorputSum run_sum(uint index, uint count) {
    CorputSum sum = corput_sum_zero();
    [[dont_unroll]] for (uint done = 0u; done < count; done += TILE) {
        Tile tile = tile_start(index + done);
        uint end = min(TILE, count - done);
        [[dont_unroll]] for (uint k = 0u; k < end; k++) {
            sum = corput_sum_add(sum, tile_term(tile));
            tile = tile_next(tile);
        }
    }
    return sum;
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
