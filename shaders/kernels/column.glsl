// One column of consecutive points: what kind it is, and where it stands. Kinds are
// words of the column, so a driver keeps only the one that a constant names.
#ifndef KERNEL_COLUMN_GLSL
#define KERNEL_COLUMN_GLSL

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

// The value as the file holds it.
uint column_output(uint fraction, Column c, uint kind_of_output) {
    if (kind_of_output == 0u) {
        return fraction;
    }
    return floatBitsToUint(column_unit(fraction, c));
}

#endif
