// Coordinates of nets in base 2. What is linear in the index, so Gray order, matrix
// scrambles and the reverse order of digits that the hash wants, is in the direction numbers.
#ifndef KERNEL_COLUMN_NET_GLSL
#define KERNEL_COLUMN_NET_GLSL

#include "corput/owen.glsl"
#include "corput/pmj02.glsl"
#include "corput/unit.glsl"

const uint SOBOL = 4u;
const uint SOBOL_OWEN = 5u;
const uint SOBOL_OWEN_HASH = 6u;
const uint PMJ02 = 7u;

// No array: of constants it would be one that some translators do not know.
struct Directions {
    uint d0, d1, d2, d3, d4, d5, d6, d7;
    uint d8, d9, d10, d11, d12, d13, d14, d15;
    uint d16, d17, d18, d19, d20, d21, d22, d23;
    uint d24, d25, d26, d27, d28, d29, d30, d31;
};

struct Column {
    uint kind;
    uint shift;
    uint dimension;
    uint seed_low;
    uint seed_high;
    uint hash;
    Directions directions;
};

// The coordinate from that of the net; of a column no more than it takes, since compilers copy
// what they are given.
uint net_scrambled(uint x, uint kind, uint shift, uint dimension, uint low, uint high, uint hash) {
    uint value = 0u;
    if (KIND_OCCURS(SOBOL)) {
        value = corput_digital_shift(x, shift);
    }
    if (KIND_OCCURS(SOBOL_OWEN)) {
        if (kind_is(kind, SOBOL_OWEN)) {
            value = corput_owen(x, dimension, uvec2(low, high));
        }
    }
    if (KIND_OCCURS(SOBOL_OWEN_HASH)) {
        if (kind_is(kind, SOBOL_OWEN_HASH)) {
            value = corput_owen_hash_reversed(x, hash);
        }
    }
    return value;
}

uint column_pmj02(uint n, Column c) {
    uvec2 p = corput_sobol_pair(corput_pmj02_index(n, uvec2(c.seed_low, c.seed_high)));
    return corput_pmj02_scramble(c.dimension == 0u ? p.x : p.y, c.dimension, uvec2(c.seed_low, c.seed_high));
}

#ifdef COLUMN_TABLE
Column column_load(uint at) {
    uvec4 a = columns[at];
    uvec4 b = columns[at + 1u];
    uvec4 c = columns[at + 2u];
    uvec4 d = columns[at + 3u];
    uvec4 e = columns[at + 4u];
    uvec4 f = columns[at + 5u];
    uvec4 g = columns[at + 6u];
    uvec4 h = columns[at + 7u];
    uvec4 i = columns[at + 8u];
    uvec4 j = columns[at + 9u];
    return Column(a.x, a.y, a.z, a.w, b.x, b.y,
        Directions(b.z, b.w, c.x, c.y, c.z, c.w, d.x, d.y, d.z, d.w, e.x, e.y, e.z, e.w, f.x, f.y,
            f.z, f.w, g.x, g.y, g.z, g.w, h.x, h.y, h.z, h.w, i.x, i.y, i.z, i.w, j.x, j.y));
}

#define COLUMN_SHAPE(P)  \
    P.kind = P##_KIND;   \
    P.dimension = P##_DIMENSION
#else
#define COLUMN(P)                                                                     \
    Column(P##_KIND, P##_SHIFT, P##_DIMENSION, P##_SEED_LOW, P##_SEED_HIGH, P##_HASH, \
        Directions(P##_D0, P##_D1, P##_D2, P##_D3, P##_D4, P##_D5, P##_D6, P##_D7,    \
            P##_D8, P##_D9, P##_D10, P##_D11, P##_D12, P##_D13, P##_D14, P##_D15,     \
            P##_D16, P##_D17, P##_D18, P##_D19, P##_D20, P##_D21, P##_D22, P##_D23,   \
            P##_D24, P##_D25, P##_D26, P##_D27, P##_D28, P##_D29, P##_D30, P##_D31))
#endif

// What a bit of n contributes: the bit goes to the sign, and fills the word.
#define NET_BIT(n, bit, direction) (uint(int((n) << (31 - (bit))) >> 31) & (direction))

// Of the index's bits the highest 24 stay over the 256 points of a block, and a tile,
// which is shorter, meets two blocks at most.
struct Cursor {
    uint index;
    uint high;
    uint next_high;
    // The coordinate of the net.
    uint x;
};

// What bits 8 to 31 contribute.
uint cursor_high(uint block, Column c) {
    Directions d = c.directions;
    return NET_BIT(block, 0, d.d8) ^ NET_BIT(block, 1, d.d9) ^ NET_BIT(block, 2, d.d10)
        ^ NET_BIT(block, 3, d.d11) ^ NET_BIT(block, 4, d.d12) ^ NET_BIT(block, 5, d.d13)
        ^ NET_BIT(block, 6, d.d14) ^ NET_BIT(block, 7, d.d15) ^ NET_BIT(block, 8, d.d16)
        ^ NET_BIT(block, 9, d.d17) ^ NET_BIT(block, 10, d.d18) ^ NET_BIT(block, 11, d.d19)
        ^ NET_BIT(block, 12, d.d20) ^ NET_BIT(block, 13, d.d21) ^ NET_BIT(block, 14, d.d22)
        ^ NET_BIT(block, 15, d.d23) ^ NET_BIT(block, 16, d.d24) ^ NET_BIT(block, 17, d.d25)
        ^ NET_BIT(block, 18, d.d26) ^ NET_BIT(block, 19, d.d27) ^ NET_BIT(block, 20, d.d28)
        ^ NET_BIT(block, 21, d.d29) ^ NET_BIT(block, 22, d.d30) ^ NET_BIT(block, 23, d.d31);
}

// What bits 0 to 7 contribute; bits of a known number do at once.
uint cursor_low(uint n, Column c) {
    Directions d = c.directions;
    return NET_BIT(n, 0, d.d0) ^ NET_BIT(n, 1, d.d1) ^ NET_BIT(n, 2, d.d2)
        ^ NET_BIT(n, 3, d.d3) ^ NET_BIT(n, 4, d.d4) ^ NET_BIT(n, 5, d.d5)
        ^ NET_BIT(n, 6, d.d6) ^ NET_BIT(n, 7, d.d7);
}

Cursor cursor_start(uint index, Column c) {
    uint block = index >> 8;
    uint high = cursor_high(block, c);
    return Cursor(index, high, cursor_high(block + 1u, c), high ^ cursor_low(index, c));
}

uint cursor_value(Cursor cursor, Column c) {
    uint value = net_scrambled(cursor.x, c.kind, c.shift, c.dimension, c.seed_low, c.seed_high, c.hash);
    if (KIND_OCCURS(PMJ02)) {
        if (kind_is(c.kind, PMJ02)) {
            value = column_pmj02(cursor.index, c);
        }
    }
    return value;
}

// To the next index, which is a multiple of `group`, a power of two.
Cursor cursor_group(Cursor cursor, Column c, uint group) {
    uint index = (cursor.index + 1u) & (0u - group);
    uint high = (index & 255u) == 0u ? cursor.next_high : cursor.high;
    return Cursor(index, high, cursor.next_high, high ^ cursor_low(index, c));
}

Cursor cursor_next(Cursor cursor, Column c) {
    return cursor_group(cursor, c, 1u);
}

// Within such a group, from the point in this place: the bits that change are known.
Cursor cursor_beside(Cursor cursor, Column c, uint place) {
    uint x = cursor.x ^ cursor_low(place ^ (place + 1u), c);
    return Cursor(cursor.index + 1u, cursor.high, cursor.next_high, x);
}

float column_unit(uint fraction, Column c) {
    return corput_unit_floor(fraction);
}

// Kernels without a loop start at a multiple of their number of points, and the bits of the index
// that change to the next point are those of `p`, so known.
#ifdef WIDE_POINTS
uint net_first(uint index, Column c) {
    Directions d = c.directions;
    uint x = cursor_high(index >> 8, c)
        ^ NET_BIT(index, 5, d.d5) ^ NET_BIT(index, 6, d.d6) ^ NET_BIT(index, 7, d.d7);
#if WIDE_POINTS <= 16
    x ^= NET_BIT(index, 4, d.d4);
#endif
#if WIDE_POINTS <= 8
    x ^= NET_BIT(index, 3, d.d3);
#endif
#if WIDE_POINTS <= 4
    x ^= NET_BIT(index, 2, d.d2);
#endif
    return x;
}
#endif

#define WIDE_CURSOR(c) uint x##c = net_first(first, COLUMN(COLUMN##c));
#define WIDE_FRACTION(c, p)                                                        \
    net_scrambled(x##c, COLUMN##c##_KIND, COLUMN##c##_SHIFT, COLUMN##c##_DIMENSION, \
        COLUMN##c##_SEED_LOW, COLUMN##c##_SEED_HIGH, COLUMN##c##_HASH)
#define WIDE_NEXT(c, p)                                                  \
    x##c ^= NET_BIT(CHANGED(p), 0, COLUMN##c##_D0)                       \
        ^ NET_BIT(CHANGED(p), 1, COLUMN##c##_D1) ^ NET_BIT(CHANGED(p), 2, COLUMN##c##_D2) \
        ^ NET_BIT(CHANGED(p), 3, COLUMN##c##_D3) ^ NET_BIT(CHANGED(p), 4, COLUMN##c##_D4);
#define CHANGED(p) (uint(p) ^ (uint(p) + 1u))
#define WIDE_UNIT(c, fraction) corput_unit_floor(fraction)

#endif
