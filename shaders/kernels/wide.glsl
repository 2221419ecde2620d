// The words of consecutive points without a loop over them: a macro per column and point.
#ifndef KERNEL_WIDE_GLSL
#define KERNEL_WIDE_GLSL

#include "column.glsl"

// What a family has for them: WIDE_CURSOR(c), WIDE_FRACTION(c, p) of point p, WIDE_NEXT(c, p)
// from it to the next, and WIDE_UNIT(c, fraction).
#define WIDE_START(c, p) WIDE_CURSOR(c)
#define WIDE_WORD(c, p)                                                               \
    fraction = WIDE_FRACTION(c, p);                                                   \
    words[(p) * WIDE_COLUMNS + c] =                                                   \
        OUTPUT == 0u ? fraction : floatBitsToUint(WIDE_UNIT(c, fraction));            \
    WIDE_NEXT(c, p)

#if WIDE_COLUMNS == 1
#define WIDE_EACH(M, p) M(0, p)
#elif WIDE_COLUMNS == 2
#define WIDE_EACH(M, p) M(0, p) M(1, p)
#elif WIDE_COLUMNS == 3
#define WIDE_EACH(M, p) M(0, p) M(1, p) M(2, p)
#elif WIDE_COLUMNS == 4
#define WIDE_EACH(M, p) M(0, p) M(1, p) M(2, p) M(3, p)
#elif WIDE_COLUMNS == 8
#define WIDE_EACH(M, p) M(0, p) M(1, p) M(2, p) M(3, p) M(4, p) M(5, p) M(6, p) M(7, p)
#elif WIDE_COLUMNS == 16
#define WIDE_EACH(M, p)                                                         \
    M(0, p) M(1, p) M(2, p) M(3, p) M(4, p) M(5, p) M(6, p) M(7, p)             \
    M(8, p) M(9, p) M(10, p) M(11, p) M(12, p) M(13, p) M(14, p) M(15, p)
#else
#error no list of so many columns
#endif

#define WIDE_FOUR(p) \
    WIDE_EACH(WIDE_WORD, p) WIDE_EACH(WIDE_WORD, p + 1) WIDE_EACH(WIDE_WORD, p + 2) WIDE_EACH(WIDE_WORD, p + 3)
#define WIDE_EIGHT(p) WIDE_FOUR(p) WIDE_FOUR(p + 4)

#if WIDE_POINTS == 4
#define WIDE_ALL WIDE_FOUR(0)
#elif WIDE_POINTS == 8
#define WIDE_ALL WIDE_EIGHT(0)
#elif WIDE_POINTS == 16
#define WIDE_ALL WIDE_EIGHT(0) WIDE_EIGHT(8)
#elif WIDE_POINTS == 32
#define WIDE_ALL WIDE_EIGHT(0) WIDE_EIGHT(8) WIDE_EIGHT(16) WIDE_EIGHT(24)
#else
#error no list of so many points
#endif

#endif
