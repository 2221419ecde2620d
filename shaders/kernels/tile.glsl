// The columns of a tile, from specialization constants.
#ifndef KERNEL_TILE_GLSL
#define KERNEL_TILE_GLSL

#include "column.glsl"

#define TILE_COLUMN(P)                                                                       \
    Column(P##_KIND,                                                                         \
        CorputOdometerBase(                                                                  \
            CorputBase(P##_BASE, P##_DIGITS, P##_GROUP_POWER, P##_BASE_MAGIC, P##_BASE_SHIFT, \
                P##_POWER_MAGIC, P##_POWER_SHIFT),                                           \
            P##_POWER, P##_QUOTIENT, P##_FRACTION))

// Cursors of up to four columns; those past TILE_COLUMNS stand still.
struct Tile {
    Cursor c0;
    Cursor c1;
    Cursor c2;
    Cursor c3;
};

Tile tile_start(uint index) {
    Cursor none = Cursor(0u, CorputOdometer(0u, 0u, 0u, 0u, 0u), CorputGridPoint(0u, 0u));
    Tile tile = Tile(cursor_start(index, TILE_COLUMN(COLUMN0)), none, none, none);
#if TILE_COLUMNS > 1
    tile.c1 = cursor_start(index, TILE_COLUMN(COLUMN1));
#endif
#if TILE_COLUMNS > 2
    tile.c2 = cursor_start(index, TILE_COLUMN(COLUMN2));
#endif
#if TILE_COLUMNS > 3
    tile.c3 = cursor_start(index, TILE_COLUMN(COLUMN3));
#endif
    return tile;
}

// The fractions of the point where the tile stands.
uvec4 tile_fractions(Tile tile) {
    uvec4 point = uvec4(cursor_value(tile.c0, TILE_COLUMN(COLUMN0)), 0u, 0u, 0u);
#if TILE_COLUMNS > 1
    point.y = cursor_value(tile.c1, TILE_COLUMN(COLUMN1));
#endif
#if TILE_COLUMNS > 2
    point.z = cursor_value(tile.c2, TILE_COLUMN(COLUMN2));
#endif
#if TILE_COLUMNS > 3
    point.w = cursor_value(tile.c3, TILE_COLUMN(COLUMN3));
#endif
    return point;
}

// The same point as the file holds it.
uvec4 tile_output(uvec4 point, uint kind_of_output) {
    point.x = column_output(point.x, TILE_COLUMN(COLUMN0), kind_of_output);
#if TILE_COLUMNS > 1
    point.y = column_output(point.y, TILE_COLUMN(COLUMN1), kind_of_output);
#endif
#if TILE_COLUMNS > 2
    point.z = column_output(point.z, TILE_COLUMN(COLUMN2), kind_of_output);
#endif
#if TILE_COLUMNS > 3
    point.w = column_output(point.w, TILE_COLUMN(COLUMN3), kind_of_output);
#endif
    return point;
}

Tile tile_next(Tile tile) {
    tile.c0 = cursor_next(tile.c0, TILE_COLUMN(COLUMN0));
#if TILE_COLUMNS > 1
    tile.c1 = cursor_next(tile.c1, TILE_COLUMN(COLUMN1));
#endif
#if TILE_COLUMNS > 2
    tile.c2 = cursor_next(tile.c2, TILE_COLUMN(COLUMN2));
#endif
#if TILE_COLUMNS > 3
    tile.c3 = cursor_next(tile.c3, TILE_COLUMN(COLUMN3));
#endif
    return tile;
}

#endif
