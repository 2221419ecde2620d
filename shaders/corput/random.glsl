// what:   random numbers without a state in memory, from index, dimension and seed; and
//         the sequential generator PCG32.
// source: Philox-4x32-10: Salmon, Moraes, Dror and Shaw 2011, Parallel Random Numbers: As
//         Easy as 1, 2, 3. PCG32 (XSH-RR 64/32): O'Neill 2014, PCG: A Family of Simple
//         Fast Space-Efficient Statistically Good Algorithms for Random Number
//         Generation. Jump ahead: Brown 1994, Random Number Generation with Arbitrary
//         Strides.
// domain: any uint. The last word of a Philox counter is its purpose, so that no two uses
//         of one seed share a block: 0 random numbers, 1 nested uniform scrambling, 2
//         matrix scrambling. Headers take numbers below 2^16, a host those from there on.
// range:  every uint; results are fractions of 2^32.
// cost:   Philox 20 wide products and 60 other instructions, for four numbers; random_fast
//         13 products and 29; pcg32_next 3 products, pcg32_advance up to 9 for each bit
//         of the distance.
// hooks:  none.
// mirror: src/reference/random.rs
#ifndef CORPUT_RANDOM_GLSL
#define CORPUT_RANDOM_GLSL

#include "corput/fixed.glsl"
#include "corput/hash.glsl"

// PCG32: 64 bits of state, and an odd increment that selects the stream.
struct CorputPcg32 {
    uvec2 state;
    uvec2 increment;
};

// 128 random bits of a counter; a bijection for each key.
uvec4 corput_philox(uvec4 counter, uvec2 key) {
    for (uint i = 0u; i < 10u; i++) {
        uvec2 a = corput_mul64(0xd2511f53u, counter.x);
        uvec2 b = corput_mul64(0xcd9e8d57u, counter.z);
        counter = uvec4(b.y ^ counter.y ^ key.x, b.x, a.y ^ counter.w ^ key.y, a.x);
        key += uvec2(0x9e3779b9u, 0xbb67ae85u);
    }
    return counter;
}

// A random number: dimension d of point `index`. Four dimensions share a block.
uint corput_random(uint index, uint dimension, uvec2 seed) {
    uvec4 block = corput_philox(uvec4(index, dimension >> 2, 0u, 0u), seed);
    return block[dimension & 3u];
}

// The same by the cheaper mixer.
uint corput_random_fast(uint index, uint dimension, uvec2 seed) {
    return corput_mix(uvec4(index, dimension, seed));
}

// state * multiplier + increment modulo 2^64.
uvec2 corput_pcg32_affine(uvec2 state, uvec2 multiplier, uvec2 increment) {
    uvec2 product = corput_mul64(state.x, multiplier.x);
    product.y += state.x * multiplier.y + state.y * multiplier.x;
    return corput_add64(product, increment);
}

// The generator after this one.
CorputPcg32 corput_pcg32_next(CorputPcg32 p) {
    return CorputPcg32(
        corput_pcg32_affine(p.state, uvec2(0x4c957f2du, 0x5851f42du), p.increment), p.increment);
}

// A generator, seeded as its author does. The highest bit of `stream` is ignored. Generators
// of successive seeds or streams start out alike: give each a state from corput_random.
CorputPcg32 corput_pcg32_seed(uvec2 state, uvec2 stream) {
    uvec2 increment = uvec2((stream.x << 1) | 1u, (stream.y << 1) | (stream.x >> 31));
    CorputPcg32 p = corput_pcg32_next(CorputPcg32(uvec2(0u), increment));
    return corput_pcg32_next(CorputPcg32(corput_add64(p.state, state), increment));
}

// The random number of a state.
uint corput_pcg32_value(CorputPcg32 p) {
    uint turn = p.state.y >> 27;
    uvec2 mixed = corput_shr64(p.state, 18u) ^ p.state;
    uint x = corput_shr64(mixed, 27u).x;
    return (x >> turn) | (x << ((32u - turn) & 31u));
}

// The generator `delta` steps ahead, modulo 2^64: 2^64 - n steps go back by n.
CorputPcg32 corput_pcg32_advance(CorputPcg32 p, uvec2 delta) {
    // The step of 2^i, composed with itself at each bit.
    uvec2 multiplier = uvec2(0x4c957f2du, 0x5851f42du);
    uvec2 increment = p.increment;
    uvec2 state = p.state;
    while ((delta.x | delta.y) != 0u) {
        if ((delta.x & 1u) != 0u) {
            state = corput_pcg32_affine(state, multiplier, increment);
        }
        increment = corput_pcg32_affine(increment, multiplier, increment);
        multiplier = corput_pcg32_affine(multiplier, multiplier, uvec2(0u));
        delta = corput_shr64(delta, 1u);
    }
    return CorputPcg32(state, p.increment);
}

#endif
