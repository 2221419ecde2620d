// what:   a permutation of 0 .. length - 1 chosen by a seed, one element at a time.
// source: Kensler 2013, Correlated multi-jittered sampling, Pixar TM 13-01: a bijection
//         within the next power of two, and cycle walking. His rounds favour some
//         permutations of few elements; here up to 16 elements are ranked by hashes, and
//         above that each round is a quadratic permutation polynomial (Rivest 2001,
//         Permutation polynomials modulo 2^w) and a reversal of bits, which takes the
//         high bits where the next product spreads them. Mixer: Wellons 2018,
//         Prospecting for hash functions (lowbias32).
// domain: i < length, 1 <= length <= 2^32; length = 2^32 is written as 0. Larger i count
//         as length - 1.
// range:  0 to length - 1.
// cost:   9 instructions per element up to 16 elements; else about 110 per walk,
//         of which there are less than 2 on average.
// hooks:  none.
// mirror: src/reference/permute.rs
#ifndef CORPUT_PERMUTE_GLSL
#define CORPUT_PERMUTE_GLSL

#include "corput/fixed.glsl"

// A bijection of 32 bits in which each bit of x moves each bit of the result.
uint corput_permute_mix(uint x) {
    x ^= x >> 16;
    x *= 0x7feb352du;
    x ^= x >> 15;
    x *= 0x846ca68bu;
    return x ^ (x >> 16);
}

// Key `index` of a seed; different keys for different indices.
uint corput_permute_key(uint seed, uint index) {
    return corput_permute_mix(corput_permute_mix(seed) + index * 0x9e3779b9u);
}

// The rank of key i among the first `length` keys of the seed.
uint corput_permute_rank(uint i, uint length, uint seed) {
    uint stream = corput_permute_mix(seed);
    uint own = corput_permute_mix(stream + i * 0x9e3779b9u);
    uint rank = 0u;
    for (uint j = 0u; j < length; j++) {
        rank += corput_permute_mix(stream + j * 0x9e3779b9u) < own ? 1u : 0u;
    }
    return rank;
}

// A bijection of the low 32 - shift bits, where x has no others.
uint corput_permute_round(uint x, uint shift, uint key) {
    x ^= key;
    // x (b + 2 a x) with odd b; each part of the key has bits of its own up to 2^8.
    x *= ((key >> 16) | (key << 16) | 1u) + 2u * (key >> 8) * x;
    return corput_reverse_bits(x) >> shift;
}

// Where the permutation of `seed` takes i.
uint corput_permute(uint i, uint length, uint seed) {
    // 2^32 - 1 for 2^32, which is written as 0.
    uint last = length - 1u;
    uint x = min(i, last);
    if (last < 16u) {
        return corput_permute_rank(x, length, seed);
    }
    uint stream = corput_permute_mix(seed);
    uint shift = 31u - corput_find_msb(last);
    // The cycle of an element leads back to it, so the walk ends.
    bool outside = true;
    while (outside) {
        for (uint j = 0u; j < 8u; j++) {
            x = corput_permute_round(x, shift, corput_permute_mix(stream + j * 0x9e3779b9u));
        }
        outside = x > last;
    }
    // A rotation makes each position uniform, whatever the rounds do.
    uint key = corput_permute_mix(stream + 8u * 0x9e3779b9u);
    uint offset = length == 0u ? key : corput_mulhi(key, length);
    uint room = last - offset;
    return x > room ? x - room - 1u : x + offset;
}

#endif
