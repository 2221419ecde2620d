// Radical inverses with permuted digits.
#ifndef KERNEL_COLUMN_DIGITS_GLSL
#define KERNEL_COLUMN_DIGITS_GLSL

#include "corput/radical_inverse.glsl"
#include "corput/scrambled_radical_inverse.glsl"
#include "corput/unit.glsl"

const uint FAURE = 14u;
const uint PERMUTED = 15u;
const uint OWEN = 16u;
const uint STARTED = 17u;

struct Column {
    uint kind;
    uint seed;
    // So many of the lowest digits are permuted for each point, the others for blocks of
    // `window` = base^low indices.
    uint low;
    uint window;
    // Where the table of its places begins, in kernels that have one.
    uint places;
    CorputBase base;
};

#ifdef COLUMN_TABLE
Column column_load(uint at) {
    uvec4 a = columns[at];
    uvec4 b = columns[at + 1u];
    uvec4 c = columns[at + 2u];
    return Column(a.x, a.y, a.z, a.w, b.x, CorputBase(b.y, b.z, b.w, c.x, c.y, c.z, c.w));
}

#define COLUMN_SHAPE(P)                                                                   \
    P.kind = P##_KIND;                                                                    \
    P.low = P##_LOW;                                                                      \
    P.window = P##_WINDOW;                                                                \
    P.base = CorputBase(P##_BASE, P##_DIGITS, P##_GROUP_POWER, P##_BASE_MAGIC,            \
        P##_BASE_SHIFT, P##_POWER_MAGIC, P##_POWER_SHIFT)
#else
#define COLUMN(P)                                                                         \
    Column(P##_KIND, P##_SEED, P##_LOW, P##_WINDOW, P##_PLACES,                           \
        CorputBase(P##_BASE, P##_DIGITS, P##_GROUP_POWER, P##_BASE_MAGIC, P##_BASE_SHIFT, \
            P##_POWER_MAGIC, P##_POWER_SHIFT))
#endif

// A tile meets two blocks at most. Of each, what its digits contribute: a fraction of 2^32 and
// what the last division by the group's power left.
struct Cursor {
    uint index;
    // Within the block.
    uint place;
    uvec2 high;
    uvec2 next_high;
};

// The random permutation of the digit at a position, where all positions have one stream.
uint digit_permuted(uint digit, uint position, uint stream, uint base) {
    return corput_permute(digit, base, corput_permute_mix(stream + position * 0x9e3779b9u));
}

uint digits_stream(Column c) {
    return corput_permute_mix(corput_permute_key(c.seed, c.base.base));
}

// floor((digits * 2^32 + y) / power).
uint digits_prepend(uint digits, uint y, CorputBase b) {
    uint high = (digits << 16) | (y >> 16);
    uint q = corput_divide_by(high, b.power_magic, b.power_shift);
    uint low = ((high - q * b.power) << 16) | (y & 0xffffu);
    return (q << 16) | corput_divide_by(low, b.power_magic, b.power_shift);
}

// The same with what the division leaves, which is below 2^32 and so needs no upper word.
uvec2 digits_divided(uint digits, uint y, CorputBase b) {
    uint fraction = digits_prepend(digits, y, b);
    return uvec2(fraction, y - fraction * b.power);
}

// The blocks that an index and the next ones lie in.
Cursor permuted_start(uint index, Column c) {
    CorputBase b = c.base;
    uint stream = digits_stream(c);
    uint block = index / c.window;
    uint n = block;
    uint position = c.low;
    uint groups = b.power < 1626u ? 4u : 3u;
    // Groups of digits from the lowest up: the last is the highest.
    uvec4 own = uvec4(0u);
    uint scale = c.window;
    [[dont_unroll]] for (uint i = 0u; i < groups; i++) {
        uint reversed = 0u;
        [[dont_unroll]] while (scale < b.power) {
            uint rest = corput_divide_by(n, b.base_magic, b.base_shift);
            reversed = reversed * b.base + digit_permuted(n - rest * b.base, position, stream, b.base);
            position += 1u;
            n = rest;
            scale *= b.base;
        }
        own = uvec4(own.yzw, reversed);
        scale = 1u;
    }
    // Only the digits that the 1 is carried to are others in the next block.
    uvec4 next = own;
    uint at = 4u - groups;
    uint weight = corput_divide_by(b.power / c.window, b.base_magic, b.base_shift);
    bool carried = c.window > 1u;
    n = block;
    position = c.low;
    [[dont_unroll]] while (carried) {
        if (weight == 0u) {
            weight = corput_divide_by(b.power, b.base_magic, b.base_shift);
            at += 1u;
        }
        uint rest = corput_divide_by(n, b.base_magic, b.base_shift);
        uint digit = n - rest * b.base;
        carried = digit + 1u == b.base;
        uint change = digit_permuted(carried ? 0u : digit + 1u, position, stream, b.base)
            - digit_permuted(digit, position, stream, b.base);
        next += uvec4(equal(uvec4(at), uvec4(0u, 1u, 2u, 3u))) * (change * weight);
        weight = corput_divide_by(weight, b.base_magic, b.base_shift);
        position += 1u;
        n = rest;
    }
    uvec2 y = uvec2(0u);
    [[dont_unroll]] for (uint i = 1u; i < groups; i++) {
        y = uvec2(digits_prepend(own.w, y.x, b), digits_prepend(next.w, y.y, b));
        own = uvec4(0u, own.xyz);
        next = uvec4(0u, next.xyz);
    }
    return Cursor(index, index - block * c.window, digits_divided(own.w, y.x, b),
        digits_divided(next.w, y.y, b));
}

// What the low digits of a place in its block contribute.
uint permuted_low(uint place, Column c) {
#ifdef TILE_PLACES
    return places[c.places + place];
#else
    CorputBase b = c.base;
    uint stream = digits_stream(c);
    uint n = place;
    uint reversed = 0u;
    [[dont_unroll]] for (uint position = 0u; position < c.low; position++) {
        uint rest = corput_divide_by(n, b.base_magic, b.base_shift);
        reversed = reversed * b.base + digit_permuted(n - rest * b.base, position, stream, b.base);
        n = rest;
    }
    return digits_prepend(reversed * (b.power / c.window), 0u, b);
#endif
}

uint permuted_value(Cursor cursor, Column c) {
    uint low = permuted_low(cursor.place, c);
    // Of both divisions by the power, what they leave.
    uint rest = cursor.high.y - low * c.base.power;
    return low + cursor.high.x + (rest >= c.base.power ? 1u : 0u);
}

Cursor cursor_start(uint index, Column c) {
    Cursor cursor = Cursor(index, 0u, uvec2(0u), uvec2(0u));
    if (KIND_OCCURS(PERMUTED)) {
        if (kind_is(c.kind, PERMUTED)) {
            cursor = permuted_start(index, c);
        }
    }
    return cursor;
}

uint cursor_value(Cursor cursor, Column c) {
    uint value = 0u;
    if (KIND_OCCURS(FAURE)) {
        value = corput_radical_inverse_faure(cursor.index, c.base.base);
    }
    if (KIND_OCCURS(PERMUTED)) {
        if (kind_is(c.kind, PERMUTED)) {
            value = permuted_value(cursor, c);
        }
    }
    if (KIND_OCCURS(OWEN)) {
        if (kind_is(c.kind, OWEN)) {
            value = corput_radical_inverse_owen(cursor.index, c.base.base, c.seed);
        }
    }
    if (KIND_OCCURS(STARTED)) {
        if (kind_is(c.kind, STARTED)) {
            value = corput_radical_inverse_started(cursor.index, c.base.base, c.seed);
        }
    }
    return value;
}

Cursor cursor_next(Cursor cursor, Column c) {
    cursor.index += 1u;
    cursor.place += 1u;
    if (cursor.place == c.window) {
        cursor.place = 0u;
        cursor.high = cursor.next_high;
    }
    return cursor;
}

float column_unit(uint fraction, Column c) {
    // Faure's permutations keep 0, so that points lie on lower edges, as unscrambled ones do.
    // In base 2 floats are cut at digits, and none may go up.
    return c.kind == FAURE && c.base.base != 2u ? corput_unit_ceil(fraction) : corput_unit_floor(fraction);
}

#endif
