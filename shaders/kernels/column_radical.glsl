// Radical inverses and k/N: a column steps from one point to the next.
#ifndef KERNEL_COLUMN_RADICAL_GLSL
#define KERNEL_COLUMN_RADICAL_GLSL

#include "corput/hammersley.glsl"
#include "corput/odometer.glsl"
#include "corput/unit.glsl"

const uint REVERSED = 0u;
const uint ODOMETER = 1u;
const uint GRID = 2u;
const uint RADICAL = 3u;

struct Column {
    uint kind;
    // For GRID: power is N, quotient and fraction the grid point of 1.
    CorputOdometerBase base;
};

#ifdef COLUMN_TABLE
Column column_load(uint at) {
    uvec4 a = columns[at];
    uvec4 b = columns[at + 1u];
    uvec4 c = columns[at + 2u];
    return Column(a.x,
        CorputOdometerBase(CorputBase(a.y, a.z, a.w, b.x, b.y, b.z, b.w), c.x, c.y, c.z));
}

#define COLUMN_SHAPE(P)                                                                  \
    P.kind = P##_KIND;                                                                   \
    P.base.radical = CorputBase(P##_BASE, P##_DIGITS, P##_GROUP_POWER, P##_BASE_MAGIC,   \
        P##_BASE_SHIFT, P##_POWER_MAGIC, P##_POWER_SHIFT)
#else
#define COLUMN(P)                                                                            \
    Column(P##_KIND,                                                                         \
        CorputOdometerBase(                                                                  \
            CorputBase(P##_BASE, P##_DIGITS, P##_GROUP_POWER, P##_BASE_MAGIC, P##_BASE_SHIFT, \
                P##_POWER_MAGIC, P##_POWER_SHIFT),                                           \
            P##_POWER, P##_QUOTIENT, P##_FRACTION))
#endif

struct Cursor {
    uint index;
    CorputOdometer odometer;
    CorputGridPoint grid;
};

Cursor cursor_start(uint index, Column c) {
    Cursor cursor = Cursor(index, CorputOdometer(0u, 0u, 0u, 0u, 0u), CorputGridPoint(0u, 0u));
    if (KIND_OCCURS(ODOMETER)) {
        if (kind_is(c.kind, ODOMETER)) {
            cursor.odometer = corput_odometer_start(index, c.base);
        }
    }
    if (KIND_OCCURS(GRID)) {
        if (kind_is(c.kind, GRID)) {
            cursor.grid = corput_hammersley_start(index, c.base.power);
        }
    }
    return cursor;
}

uint cursor_value(Cursor cursor, Column c) {
    uint value = 0u;
    if (KIND_OCCURS(REVERSED)) {
        value = corput_van_der_corput(cursor.index);
    }
    if (KIND_OCCURS(ODOMETER)) {
        if (kind_is(c.kind, ODOMETER)) {
            value = corput_odometer_value(cursor.odometer, c.base);
        }
    }
    if (KIND_OCCURS(GRID)) {
        if (kind_is(c.kind, GRID)) {
            value = corput_hammersley_value(cursor.grid);
        }
    }
    if (KIND_OCCURS(RADICAL)) {
        if (kind_is(c.kind, RADICAL)) {
            value = corput_radical_inverse_table(cursor.index, c.base.radical);
        }
    }
    return value;
}

Cursor cursor_next(Cursor cursor, Column c) {
    cursor.index += 1u;
    if (KIND_OCCURS(ODOMETER)) {
        if (kind_is(c.kind, ODOMETER)) {
            cursor.odometer = corput_odometer_next(cursor.odometer, c.base);
        }
    }
    if (KIND_OCCURS(GRID)) {
        if (kind_is(c.kind, GRID)) {
            cursor.grid = corput_hammersley_next(cursor.grid,
                CorputGridPoint(c.base.quotient, c.base.fraction), c.base.power);
        }
    }
    return cursor;
}

float column_unit(uint fraction, Column c) {
    return c.kind == REVERSED ? corput_unit_floor(fraction) : corput_unit_ceil(fraction);
}

// Kernels without a loop know no odometers. They start at a multiple of their number of points.
#define WIDE_CURSOR(c)                                                                       \
    uint x##c = corput_van_der_corput(first);                                                \
    CorputGridPoint grid##c = CorputGridPoint(0u, 0u);                                       \
    if (COLUMN##c##_KIND == GRID) {                                                          \
        grid##c = corput_hammersley_start(first, COLUMN##c##_POWER);                         \
    }
#define WIDE_FRACTION(c, p) \
    (COLUMN##c##_KIND == GRID ? corput_hammersley_value(grid##c) : x##c)
#define WIDE_NEXT(c, p)                                                                      \
    x##c ^= corput_van_der_corput(uint(p) ^ (uint(p) + 1u));                                 \
    if (COLUMN##c##_KIND == GRID) {                                                          \
        grid##c = corput_hammersley_next(grid##c,                                            \
            CorputGridPoint(COLUMN##c##_QUOTIENT, COLUMN##c##_FRACTION), COLUMN##c##_POWER); \
    }
#define WIDE_UNIT(c, fraction) \
    (COLUMN##c##_KIND == GRID ? corput_unit_ceil(fraction) : corput_unit_floor(fraction))

#endif
