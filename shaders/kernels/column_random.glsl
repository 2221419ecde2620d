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
    uvec4 a = columns[at];
    return Column(a.x, a.y, a.z, a.w, columns[at + 1u].x);
}

#define COLUMN_SHAPE(P)  \
    P.kind = P##_KIND;   \
    P.dimension = P##_DIMENSION
#else
#define COLUMN(P)                                                                \
    Column(P##_KIND, P##_DIMENSION, P##_DIMENSIONS, P##_SEED_LOW, P##_SEED_HIGH)
#endif

uint column_value(uint n, Column c) {
    uvec2 seed = uvec2(c.seed_low, c.seed_high);
    uint value = 0u;
    if (KIND_OCCURS(PHILOX)) {
        value = corput_random(n, c.dimension, seed);
    }
    if (KIND_OCCURS(PCG4D)) {
        if (kind_is(c.kind, PCG4D)) {
            value = corput_random_fast(n, c.dimension, seed);
        }
    }
    if (KIND_OCCURS(PCG32)) {
        if (kind_is(c.kind, PCG32)) {
            // Row after row from one stream, that of PCG's demonstration program.
            uvec2 place = corput_add64(corput_mul64(n, c.dimensions), uvec2(c.dimension, 0u));
            CorputPcg32 start = corput_pcg32_seed(seed, uvec2(54u, 0u));
            value = corput_pcg32_value(corput_pcg32_advance(start, place));
        }
    }
    return value;
}

#include "cursor.glsl"

float column_unit(uint fraction, Column c) {
    return corput_unit_floor(fraction);
}

// Of kernels without a loop.
#define WIDE_CURSOR(c)
#define WIDE_FRACTION(c, p) column_value(first + uint(p), COLUMN(COLUMN##c))
#define WIDE_NEXT(c, p)
#define WIDE_UNIT(c, fraction) corput_unit_floor(fraction)

#endif
