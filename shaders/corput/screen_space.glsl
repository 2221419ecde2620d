// what:   the index of a pixel's samples in one sequence for the whole image, so that the
//         error is blue noise in screen space: neighbours share a stretch of the
//         sequence, and so each other's error.
// source: Ahmed and Wonka 2020, Screen-space blue-noise diffusion of Monte Carlo sampling
//         error via hierarchical ordering of pixels, ACM TOG 39(6): the Z-order of the
//         pixels, its base-4 digits shuffled by permutations that the higher digits choose.
// domain: pixels below 2^d in x and y, d = floor((32 - samples_log2) / 2); samples_log2
//         at most 32; sample_index below 2^samples_log2.
// range:  each index at most once; each aligned tile of 2^k x 2^k pixels has all indices
//         of one aligned block of 4^k 2^samples_log2.
// cost:   d hashes, of some 12 instructions each.
// hooks:  none.
// mirror: src/reference/screen_space.rs
#ifndef CORPUT_SCREEN_SPACE_GLSL
#define CORPUT_SCREEN_SPACE_GLSL

#include "corput/fixed.glsl"

// The permutations of 0 to 3 in lexicographic order: two bits for each image, that of 0
// lowest.
const uint CORPUT_SCREEN_SPACE_PERMUTATIONS[24] = uint[24](
    0xe4u, 0xb4u, 0xd8u, 0x78u, 0x9cu, 0x6cu, 0xe1u, 0xb1u,
    0xc9u, 0x39u, 0x8du, 0x2du, 0xd2u, 0x72u, 0xc6u, 0x36u,
    0x4eu, 0x1eu, 0x93u, 0x63u, 0x87u, 0x27u, 0x4bu, 0x1bu);

// The even bits of the result are the low 16 bits of x.
uint corput_screen_space_spread(uint x) {
    uint y = x & 0xffffu;
    y = (y | (y << 8)) & 0x00ff00ffu;
    y = (y | (y << 4)) & 0x0f0f0f0fu;
    y = (y | (y << 2)) & 0x33333333u;
    return (y | (y << 1)) & 0x55555555u;
}

// The place of a pixel in Z-order, x and y below 2^16.
uint corput_screen_space_morton(uvec2 pixel) {
    return corput_screen_space_spread(pixel.x) | (corput_screen_space_spread(pixel.y) << 1);
}

// A word from a prefix of a code, its length and a seed: two rounds of multiply and xor
// (lowbias32 by Wellons) around the seed.
uint corput_screen_space_hash(uint prefix, uint level, uint seed) {
    uint x = prefix * 0x9e3779b9u + level * 0x85ebca6bu;
    x = (x ^ (x >> 16) ^ seed) * 0x7feb352du;
    x = (x ^ (x >> 15)) * 0x846ca68bu;
    return x ^ (x >> 16);
}

// A code of `digits` base-4 digits, at most 16, with each digit permuted by the digits
// above it. Bits above are dropped.
uint corput_screen_space_shuffle(uint code, uint digits, uint seed) {
    uint result = 0u;
    for (uint level = 0u; level < digits; level++) {
        uint shift = 2u * (digits - 1u - level);
        // Shifted twice, since by 32 is not defined.
        uint prefix = ((code >> shift) >> 2) & ((1u << (2u * level)) - 1u);
        uint hash = corput_screen_space_hash(prefix, level, seed);
        uint permutation = CORPUT_SCREEN_SPACE_PERMUTATIONS[corput_mulhi(hash, 24u)];
        uint digit = (code >> shift) & 3u;
        result |= ((permutation >> (2u * digit)) & 3u) << shift;
    }
    return result;
}

// The index of a pixel's sample in the sequence of the image.
uint corput_screen_space_index(uvec2 pixel, uint sample_index, uint samples_log2, uint seed) {
    if (samples_log2 >= 32u) {
        return sample_index;
    }
    uint digits = (32u - samples_log2) >> 1;
    uint code = corput_screen_space_morton(pixel);
    return (corput_screen_space_shuffle(code, digits, seed) << samples_log2) | sample_index;
}

#endif
