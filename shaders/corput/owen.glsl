// what:   randomisations of a fraction in base 2: nested uniform scrambling, exact and by
//         a fast hash, random linear matrix scrambling, and the digital shift.
// source: owen: Owen 1995, Randomly Permuted (t,m,s)-Nets and (t,s)-Sequences.
//         owen_hash: Laine and Karras 2011, Stratified Sampling for Stochastic
//         Transparency, with the constants of Vegdahl 2021, Building a Better
//         LK Hash. matrix_scramble: Matousek 1998, On the L2-Discrepancy for Anchored
//         Boxes (without the shift). digital_shift: Cranley and Patterson 1976, in base
//         2; L'Ecuyer and Lemieux 2002.
// domain: x any uint, a fraction of 2^32: its highest bit is the first digit.
// range:  every uint. Each is a bijection that keeps every elementary interval: the first
//         k digits of the result depend on the first k digits of x alone. owen flips
//         each of the 2^32 - 1 nodes of the binary tree by a bit of its own. owen_hash has
//         only 2^32 scrambles and wants a random seed, such as corput_seed gives; its
//         flips are independent in pairs, but the four of the third level sum to the
//         same parity in 5 cases of 8. matrix_scramble is linear: 0 stays 0, and with a
//         digital shift its flips are independent in pairs alone. digital_shift has one
//         flip for each level.
// cost:   owen 5 Philox blocks, matrix_scramble 8, owen_hash 4 multiplications and 8 other
//         instructions, digital_shift one.
// hooks:  none.
// mirror: src/reference/owen.rs
#ifndef CORPUT_OWEN_GLSL
#define CORPUT_OWEN_GLSL

#include "corput/bits.glsl"
#include "corput/random.glsl"

// Flips each digit by a digit of `shift`.
uint corput_digital_shift(uint x, uint shift) {
    return x ^ shift;
}

// The flips of seven levels. Of the 128 bits of the block, bit n (of word n / 32) belongs
// to node n of the subtree, where the root is node 1 and the children of node n are 2n and
// 2n + 1; bit 0 is unused. `digits` are the seven digits that lead down, the highest first.
uint corput_owen_flips(uvec4 block, uint digits) {
    uint flips = 0u;
    for (uint level = 0u; level < 5u; level++) {
        uint node = (1u << level) | (digits >> (7u - level));
        flips = (flips << 1) | ((block.x >> node) & 1u);
    }
    // Level 5 is nodes 32 to 63, level 6 nodes 64 to 127.
    uint last = (digits >> 6) != 0u ? block.w : block.z;
    flips = (flips << 1) | ((block.y >> (digits >> 2)) & 1u);
    return (flips << 1) | ((last >> ((digits >> 1) & 31u)) & 1u);
}

// Nested uniform scrambling. The subtrees of levels 0, 7, 14, 21 and 28 on have each their
// Philox block, whose counter is the digits above, the number of the level's subtree (0 to
// 4), the dimension, and the purpose 1.
uint corput_owen(uint x, uint dimension, uvec2 seed) {
    uint flips = 0u;
    for (uint subtree = 0u; subtree < 4u; subtree++) {
        uint below = 25u - 7u * subtree;
        uint prefix = (x >> below) >> 7;
        uvec4 block = corput_philox(uvec4(prefix, subtree, dimension, 1u), seed);
        flips |= corput_owen_flips(block, (x >> below) & 127u) << below;
    }
    uvec4 block = corput_philox(uvec4(x >> 4, 4u, dimension, 1u), seed);
    flips |= corput_owen_flips(block, (x & 15u) << 3) >> 3;
    return x ^ flips;
}

// The permutation of Laine and Karras of a fraction whose digits are in reverse order, so
// that a digit changes only by those before it, which products carry upwards.
uint corput_owen_hash_reversed(uint x, uint seed) {
    x ^= x * 0x3d20adeau;
    x += seed;
    x *= (seed >> 16) | 1u;
    x ^= x * 0x05526c56u;
    x ^= x * 0x53a22864u;
    return corput_reverse_bits(x);
}

// The same of a fraction.
uint corput_owen_hash(uint x, uint seed) {
    return corput_owen_hash_reversed(corput_reverse_bits(x), seed);
}

// The digits of x times a random lower triangular matrix over {0, 1} with ones on its
// diagonal. Column j, for digit j of x from the highest, is word j % 4 of the Philox block
// of counter (j / 4, 0, dimension, 2): its bits below the diagonal.
uint corput_matrix_scramble(uint x, uint dimension, uvec2 seed) {
    uint y = x;
    uint below = 0x7fffffffu;
    for (uint quarter = 0u; quarter < 8u; quarter++) {
        uvec4 block = corput_philox(uvec4(quarter, 0u, dimension, 2u), seed);
        for (uint i = 0u; i < 4u; i++) {
            y ^= (x >> 31) != 0u ? block.x & below : 0u;
            block = block.yzwx;
            below >>= 1;
            x <<= 1;
        }
    }
    return y;
}

#endif
