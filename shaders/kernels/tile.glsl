// The columns of a tile: from specialization constants, or, but for their shape, from
// the table.
#ifndef KERNEL_TILE_GLSL
#define KERNEL_TILE_GLSL

#include "column.glsl"

#ifdef COLUMN_TABLE
// Under the names that stand for the constants of a column.
Column COLUMN0;
Column COLUMN1;
Column COLUMN2;
Column COLUMN3;
#define COLUMN(P) P

// Before the first tile. llvmpipe compiles a kernel anew, 2 ms a dispatch, where a branch
// depends on a uniform at an offset that it knows; it does not know that runs are short.
void tile_load() {
    uint zero = push.run >> 31;
    COLUMN0 = column_load(zero);
    COLUMN_SHAPE(COLUMN0);
#if TILE_COLUMNS > 1
    COLUMN1 = column_load(COLUMN_ROWS + zero);
    COLUMN_SHAPE(COLUMN1);
#endif
#if TILE_COLUMNS > 2
    COLUMN2 = column_load(2u * COLUMN_ROWS + zero);
    COLUMN_SHAPE(COLUMN2);
#endif
#if TILE_COLUMNS > 3
    COLUMN3 = column_load(3u * COLUMN_ROWS + zero);
    COLUMN_SHAPE(COLUMN3);
#endif
}
#endif

// Cursors of up to four columns; those past TILE_COLUMNS are not used.
struct Tile {
    Cursor c0;
    Cursor c1;
    Cursor c2;
    Cursor c3;
};

Tile tile_start(uint index) {
    Cursor c0 = cursor_start(index, COLUMN(COLUMN0));
    // Those that are not there cost nothing: no one reads them.
    Tile tile = Tile(c0, c0, c0, c0);
#if TILE_COLUMNS > 1
    tile.c1 = cursor_start(index, COLUMN(COLUMN1));
#endif
#if TILE_COLUMNS > 2
    tile.c2 = cursor_start(index, COLUMN(COLUMN2));
#endif
#if TILE_COLUMNS > 3
    tile.c3 = cursor_start(index, COLUMN(COLUMN3));
#endif
    return tile;
}

// The fractions of the point where the tile stands.
uvec4 tile_fractions(Tile tile) {
    uvec4 point = uvec4(cursor_value(tile.c0, COLUMN(COLUMN0)), 0u, 0u, 0u);
#if TILE_COLUMNS > 1
    point.y = cursor_value(tile.c1, COLUMN(COLUMN1));
#endif
#if TILE_COLUMNS > 2
    point.z = cursor_value(tile.c2, COLUMN(COLUMN2));
#endif
#if TILE_COLUMNS > 3
    point.w = cursor_value(tile.c3, COLUMN(COLUMN3));
#endif
    return point;
}

// The same point as the file holds it.
uvec4 tile_output(uvec4 point, uint kind_of_output) {
    point.x = column_output(point.x, COLUMN(COLUMN0), kind_of_output);
#if TILE_COLUMNS > 1
    point.y = column_output(point.y, COLUMN(COLUMN1), kind_of_output);
#endif
#if TILE_COLUMNS > 2
    point.z = column_output(point.z, COLUMN(COLUMN2), kind_of_output);
#endif
#if TILE_COLUMNS > 3
    point.w = column_output(point.w, COLUMN(COLUMN3), kind_of_output);
#endif
    return point;
}

Tile tile_next(Tile tile) {
    tile.c0 = cursor_next(tile.c0, COLUMN(COLUMN0));
#if TILE_COLUMNS > 1
    tile.c1 = cursor_next(tile.c1, COLUMN(COLUMN1));
#endif
#if TILE_COLUMNS > 2
    tile.c2 = cursor_next(tile.c2, COLUMN(COLUMN2));
#endif
#if TILE_COLUMNS > 3
    tile.c3 = cursor_next(tile.c3, COLUMN(COLUMN3));
#endif
    return tile;
}

// To the next index, which is a multiple of `group`, a power of two.
Tile tile_group(Tile tile, uint group) {
    tile.c0 = cursor_group(tile.c0, COLUMN(COLUMN0), group);
#if TILE_COLUMNS > 1
    tile.c1 = cursor_group(tile.c1, COLUMN(COLUMN1), group);
#endif
#if TILE_COLUMNS > 2
    tile.c2 = cursor_group(tile.c2, COLUMN(COLUMN2), group);
#endif
#if TILE_COLUMNS > 3
    tile.c3 = cursor_group(tile.c3, COLUMN(COLUMN3), group);
#endif
    return tile;
}

// Within such a group, from the point in this place to the next.
Tile tile_beside(Tile tile, uint place) {
    tile.c0 = cursor_beside(tile.c0, COLUMN(COLUMN0), place);
#if TILE_COLUMNS > 1
    tile.c1 = cursor_beside(tile.c1, COLUMN(COLUMN1), place);
#endif
#if TILE_COLUMNS > 2
    tile.c2 = cursor_beside(tile.c2, COLUMN(COLUMN2), place);
#endif
#if TILE_COLUMNS > 3
    tile.c3 = cursor_beside(tile.c3, COLUMN(COLUMN3), place);
#endif
    return tile;
}

#endif
