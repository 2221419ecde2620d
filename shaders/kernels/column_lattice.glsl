// Coordinates of lattices.
#ifndef KERNEL_COLUMN_LATTICE_GLSL
#define KERNEL_COLUMN_LATTICE_GLSL

#include "corput/lattice.glsl"
#include "corput/unit.glsl"

const uint LATTICE = 18u;
const uint KOROBOV = 19u;
const uint KOROBOV_ROTATED = 20u;
const uint ADDITIVE = 21u;

struct Column {
    uint kind;
    // The step: an entry of the generating vector, or 64 bits of alpha.
    uint step_low;
    uint step_high;
    uint count;
    uint shift;
};

#ifdef COLUMN_TABLE
Column column_load(uint at) {
    return Column(columns[at], columns[at + 1u], columns[at + 2u], columns[at + 3u],
        columns[at + 4u]);
}
#endif

#define COLUMN(P) Column(P##_KIND, P##_LOW, P##_HIGH, P##_COUNT, P##_SHIFT)

uint column_value(uint n, Column c) {
    if (c.kind == LATTICE) {
        return corput_rotate(corput_lattice(n, c.step_low), c.shift);
    }
    if (c.kind == ADDITIVE) {
        return corput_rotate(corput_additive(n, uvec2(c.step_low, c.step_high)), c.shift);
    }
    return corput_rotate(corput_korobov(n, c.step_low, c.count), c.shift);
}

#include "cursor.glsl"

float column_unit(uint fraction, Column c) {
    // Multiples of 1/N are rounded up, as k/N of Hammersley's set is.
    return c.kind == KOROBOV ? corput_unit_ceil(fraction) : corput_unit_floor(fraction);
}

#endif
