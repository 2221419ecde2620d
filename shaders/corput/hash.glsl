// what:   hashes: a bijection of 32 bits, mixers of four words, and a 32-bit seed per
//         dimension and purpose.
// source: hash: Wellons 2018, hash-prospector, triple32 (bias 0.021). pcg4d:
//         Jarzynski and Olano 2020, Hash Functions for GPU Rendering, JCGT 9(3).
// domain: any uint.
// range:  every uint. corput_hash never repeats a value, so hashes of an index are no
//         random numbers: those collide. The lowest bits of corput_pcg4d are weak: bit k
//         of each word depends on bits 0 to k + 16 of the arguments alone, so it has a
//         period of 2^(k + 17) in each, and the lowest of x may be biased 3 to 1; high
//         bits of the arguments hardly reach the low ones. corput_mix and _mix4 have neither fault.
// cost:   hash 3 multiplications, 8 other instructions; pcg4d 12 and 20; mix4 16 and 36;
//         mix and seed 13 and 29, once what they do not use is gone.
// hooks:  none.
// mirror: src/reference/hash.rs
#ifndef CORPUT_HASH_GLSL
#define CORPUT_HASH_GLSL

// A bijection of 32 bits; it keeps 0.
uint corput_hash(uint x) {
    x ^= x >> 17;
    x *= 0xed5ad4bbu;
    x ^= x >> 11;
    x *= 0xac4c1b51u;
    x ^= x >> 15;
    x *= 0x31848babu;
    return x ^ (x >> 14);
}

// A bijection of 128 bits.
uvec4 corput_pcg4d(uvec4 v) {
    v = v * 1664525u + 1013904223u;
    v.x += v.y * v.w;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v.w += v.y * v.z;
    v ^= v >> 16;
    v.x += v.y * v.w;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v.w += v.y * v.z;
    return v;
}

// Four words of four. Products carry upwards only, so two rounds leave the low bits weak: a
// third round, and its upper halves folded onto the lower, mend that.
uvec4 corput_mix4(uvec4 v) {
    v = corput_pcg4d(v);
    v ^= v >> 16;
    v.x += v.y * v.w;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v.w += v.y * v.z;
    return v ^ (v >> 16);
}

// One word of four: the first of corput_mix4.
uint corput_mix(uvec4 v) {
    return corput_mix4(v).x;
}

// A seed of 32 bits for one dimension and one purpose, which is any number: whoever draws
// several seeds for one dimension gives each use its own.
uint corput_seed(uvec2 seed, uint dimension, uint purpose) {
    return corput_mix(uvec4(seed, dimension, purpose));
}

#endif
