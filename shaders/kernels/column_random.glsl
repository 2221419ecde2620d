// Random numbers.
#ifndef KERNEL_COLUMN_RANDOM_GLSL
#define KERNEL_COLUMN_RANDOM_GLSL

#include "corput/fixed.glsl"
#include "corput/random.glsl"
#include "corput/unit.glsl"

const uint PHILOX = 8u;
const uint PCG4D = 9u;
const uint PCG32 = 10u;

struct Column {
    uint kind;
    uint dimension;
    uint dimensions;
    uint seed_low;
    uint seed_high;
};

#ifdef COLUMN_TABLE
Column column_load(uint at) {
    return Column(columns[at], columns[at + 1u], columns[at + 2u],
        columns[at + 3u], columns[at + 4u]);
}
#endif

#define COLUMN(P)                                                                \
    Column(P##_KIND, P##_DIMENSION, P##_DIMENSIONS, P##_SEED_LOW, P##_SEED_HIGH)

uint column_value(uint n, Column c) {
    if (c.kind == PHILOX) {
        return corput_random(n, c.dimension, uvec2(c.seed_low, c.seed_high));
    }
    if (c.kind == PCG4D) {
        return corput_random_fast(n, c.dimension, uvec2(c.seed_low, c.seed_high));
    }
    // Row after row from one stream, that of PCG's demonstration program.
    uvec2 place = corput_add64(corput_mul64(n, c.dimensions), uvec2(c.dimension, 0u));
    CorputPcg32 start = corput_pcg32_seed(uvec2(c.seed_low, c.seed_high), uvec2(54u, 0u));
    return corput_pcg32_value(corput_pcg32_advance(start, place));
}

#include "cursor.glsl"

float column_unit(uint fraction, Column c) {
    return corput_unit_floor(fraction);
}

#endif
