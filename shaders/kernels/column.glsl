// One column of consecutive points: what kind it is, and where it stands. Kinds that do
// not occur are not compiled: KINDS, a constant, has a bit for each that does.
#ifndef KERNEL_COLUMN_GLSL
#define KERNEL_COLUMN_GLSL

#define KIND_OCCURS(KIND) ((KINDS & (1u << KIND)) != 0u)

// Whether a column is of a kind; where no other occurs, that needs no look.
bool kind_is(uint kind, uint wanted) {
    return (uint(kind == wanted) | uint(KINDS == 1u << wanted)) != 0u;
}

#if COLUMN_FAMILY == 0
#include "column_radical.glsl"
#elif COLUMN_FAMILY == 1
#include "column_net.glsl"
#elif COLUMN_FAMILY == 2
#include "column_random.glsl"
#elif COLUMN_FAMILY == 3
#include "column_strata.glsl"
#elif COLUMN_FAMILY == 4
#include "column_digits.glsl"
#elif COLUMN_FAMILY == 5
#include "column_lattice.glsl"
#else
#error this family of columns has no file
#endif

// Families without a shorter way within groups of points.
#if COLUMN_FAMILY != 1
Cursor cursor_group(Cursor cursor, Column c, uint group) {
    return cursor_next(cursor, c);
}

Cursor cursor_beside(Cursor cursor, Column c, uint place) {
    return cursor_next(cursor, c);
}
#endif

// The value as the file holds it.
uint column_output(uint fraction, Column c, uint kind_of_output) {
    if (kind_of_output == 0u) {
        return fraction;
    }
    return floatBitsToUint(column_unit(fraction, c));
}

#endif
