// A cursor of columns whose points follow from their indices alone: column_value(n, c).
#ifndef KERNEL_CURSOR_GLSL
#define KERNEL_CURSOR_GLSL

struct Cursor {
    uint index;
};

Cursor cursor_start(uint index, Column c) {
    return Cursor(index);
}

uint cursor_value(Cursor cursor, Column c) {
    return column_value(cursor.index, c);
}

Cursor cursor_next(Cursor cursor, Column c) {
    return Cursor(cursor.index + 1u);
}

#endif
