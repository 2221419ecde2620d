// Radical inverses with permuted digits.
#ifndef KERNEL_COLUMN_DIGITS_GLSL
#define KERNEL_COLUMN_DIGITS_GLSL

#include "corput/scrambled_radical_inverse.glsl"
#include "corput/unit.glsl"

const uint FAURE = 14u;
const uint PERMUTED = 15u;
const uint OWEN = 16u;
const uint STARTED = 17u;

struct Column {
    uint kind;
    uint base;
    uint seed;
};

#ifdef COLUMN_TABLE
Column column_load(uint at) {
    return Column(columns[at].x, columns[at].y, columns[at].z);
}

#define COLUMN_SHAPE(P)  \
    P.kind = P##_KIND;   \
    P.base = P##_BASE
#else
#define COLUMN(P) Column(P##_KIND, P##_BASE, P##_SEED)
#endif

uint column_value(uint n, Column c) {
    uint value = 0u;
    if (KIND_OCCURS(FAURE)) {
        value = corput_radical_inverse_faure(n, c.base);
    }
    if (KIND_OCCURS(PERMUTED)) {
        if (kind_is(c.kind, PERMUTED)) {
            value = corput_radical_inverse_permuted(n, c.base, c.seed);
        }
    }
    if (KIND_OCCURS(OWEN)) {
        if (kind_is(c.kind, OWEN)) {
            value = corput_radical_inverse_owen(n, c.base, c.seed);
        }
    }
    if (KIND_OCCURS(STARTED)) {
        if (kind_is(c.kind, STARTED)) {
            value = corput_radical_inverse_started(n, c.base, c.seed);
        }
    }
    return value;
}

#include "cursor.glsl"

float column_unit(uint fraction, Column c) {
    // Faure's permutations keep 0, so that points lie on lower edges, as unscrambled ones do.
    // In base 2 floats are cut at digits, and none may go up.
    return c.kind == FAURE && c.base != 2u ? corput_unit_ceil(fraction) : corput_unit_floor(fraction);
}

#endif
