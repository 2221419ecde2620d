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
    return Column(columns[at],
        CorputOdometerBase(
            CorputBase(columns[at + 1u], columns[at + 2u], columns[at + 3u], columns[at + 4u],
                columns[at + 5u], columns[at + 6u], columns[at + 7u]),
            columns[at + 8u], columns[at + 9u], columns[at + 10u]));
}
#endif

#define COLUMN(P)                                                                            \
    Column(P##_KIND,                                                                         \
        CorputOdometerBase(                                                                  \
            CorputBase(P##_BASE, P##_DIGITS, P##_GROUP_POWER, P##_BASE_MAGIC, P##_BASE_SHIFT, \
                P##_POWER_MAGIC, P##_POWER_SHIFT),                                           \
            P##_POWER, P##_QUOTIENT, P##_FRACTION))

struct Cursor {
    uint index;
    CorputOdometer odometer;
    CorputGridPoint grid;
};

Cursor cursor_start(uint index, Column c) {
    Cursor cursor = Cursor(index, CorputOdometer(0u, 0u, 0u, 0u, 0u), CorputGridPoint(0u, 0u));
    if (c.kind == ODOMETER) {
        cursor.odometer = corput_odometer_start(index, c.base);
    } else if (c.kind == GRID) {
        cursor.grid = corput_hammersley_start(index, c.base.power);
    }
    return cursor;
}

uint cursor_value(Cursor cursor, Column c) {
    if (c.kind == ODOMETER) {
        return corput_odometer_value(cursor.odometer, c.base);
    }
    if (c.kind == GRID) {
        return corput_hammersley_value(cursor.grid);
    }
    if (c.kind == RADICAL) {
        return corput_radical_inverse_table(cursor.index, c.base.radical);
    }
    return corput_van_der_corput(cursor.index);
}

Cursor cursor_next(Cursor cursor, Column c) {
    cursor.index += 1u;
    if (c.kind == ODOMETER) {
        cursor.odometer = corput_odometer_next(cursor.odometer, c.base);
    } else if (c.kind == GRID) {
        cursor.grid = corput_hammersley_next(cursor.grid,
            CorputGridPoint(c.base.quotient, c.base.fraction), c.base.power);
    }
    return cursor;
}

float column_unit(uint fraction, Column c) {
    return c.kind == REVERSED ? corput_unit_floor(fraction) : corput_unit_ceil(fraction);
}

#endif
