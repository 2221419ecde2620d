// Jittered strata: grids, Latin hypercubes, correlated multi-jittered sets.
#ifndef KERNEL_COLUMN_STRATA_GLSL
#define KERNEL_COLUMN_STRATA_GLSL

#include "corput/random.glsl"
#include "corput/stratified.glsl"

const uint STRATIFIED = 11u;
const uint LATIN_HYPERCUBE = 12u;
const uint MULTI_JITTERED = 13u;

struct Column {
    uint kind;
    uint dimension;
    uint seed_low;
    uint seed_high;
    uint stride;
    // Along this axis.
    uint strata;
    uint permutation;
    uint grid_x;
    uint grid_y;
};

#ifdef COLUMN_TABLE
Column column_load(uint at) {
    uvec4 a = columns[at];
    uvec4 b = columns[at + 1u];
    return Column(a.x, a.y, a.z, a.w, b.x, b.y, b.z, b.w, columns[at + 2u].x);
}

#define COLUMN_SHAPE(P)  \
    P.kind = P##_KIND;   \
    P.dimension = P##_DIMENSION
#else
#define COLUMN(P)                                                            \
    Column(P##_KIND, P##_DIMENSION, P##_SEED_LOW, P##_SEED_HIGH, P##_STRIDE, \
        P##_STRATA, P##_PERMUTATION, P##_GRID_X, P##_GRID_Y)
#endif

uint column_value(uint n, Column c) {
    uint jitter = corput_random_of(n, c.dimension, c.kind, uvec2(c.seed_low, c.seed_high));
    uint value = 0u;
    if (KIND_OCCURS(STRATIFIED)) {
        value = corput_stratified(n, c.stride, c.strata, jitter);
    }
    if (KIND_OCCURS(LATIN_HYPERCUBE)) {
        if (kind_is(c.kind, LATIN_HYPERCUBE)) {
            value = corput_latin_hypercube(n, c.strata, c.permutation, jitter);
        }
    }
    if (KIND_OCCURS(MULTI_JITTERED)) {
        if (kind_is(c.kind, MULTI_JITTERED)) {
            uvec2 p = corput_cmj(n, uvec2(c.grid_x, c.grid_y), c.permutation, uvec2(jitter));
            value = c.dimension == 0u ? p.x : p.y;
        }
    }
    return value;
}

#include "cursor.glsl"

float column_unit(uint fraction, Column c) {
    return corput_unit_stratum(fraction, c.strata);
}

#endif
