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
    uvec4 a = columns[at];
    return Column(a.x, a.y, a.z, a.w, columns[at + 1u].x);
}

#define COLUMN_SHAPE(P) P.kind = P##_KIND
#else
#define COLUMN(P) Column(P##_KIND, P##_LOW, P##_HIGH, P##_COUNT, P##_SHIFT)
#endif

uint column_value(uint n, Column c) {
    uint value = 0u;
    if (KIND_OCCURS(KOROBOV) || KIND_OCCURS(KOROBOV_ROTATED)) {
        value = corput_korobov(n, c.step_low, c.count);
    }
    if (KIND_OCCURS(LATTICE)) {
        if (kind_is(c.kind, LATTICE)) {
            value = corput_lattice(n, c.step_low);
        }
    }
    if (KIND_OCCURS(ADDITIVE)) {
        if (kind_is(c.kind, ADDITIVE)) {
            value = corput_additive(n, uvec2(c.step_low, c.step_high));
        }
    }
    return corput_rotate(value, c.shift);
}

#include "cursor.glsl"

float column_unit(uint fraction, Column c) {
    // Multiples of 1/N are rounded up, as k/N of Hammersley's set is.
    return c.kind == KOROBOV ? corput_unit_ceil(fraction) : corput_unit_floor(fraction);
}

// Of kernels without a loop.
#define WIDE_CURSOR(c)
#define WIDE_FRACTION(c, p) column_value(first + uint(p), COLUMN(COLUMN##c))
#define WIDE_NEXT(c, p)
#define WIDE_UNIT(c, fraction) column_unit(fraction, COLUMN(COLUMN##c))

#endif
