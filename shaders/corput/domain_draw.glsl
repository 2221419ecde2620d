// what:   draws of four dimensions from a domain, of the sequences that need no table:
//         random numbers, Sobol pairs, Latin hypercubes, correlated multi-jittered pairs,
//         lattices and the additive recurrence. Components that are not used cost nothing.
// source: those of the sequences' headers; shuffling the index of a padded pair: Burley 2020,
//         Practical hash-based Owen scrambling.
// domain: every domain; indices below `count` for sets; below 2^20 for the lattice.
// range:  fractions of 2^32. The same domain gives the same point; draw other dimensions
//         from its children. Pairs (x, y) and (z, w) are each a (0,2)-sequence in `index`,
//         and decorrelated from each other; the lattice and the recurrence are good in all
//         four together; Latin hypercubes are stratified per dimension.
// cost:   corput_draw_random one Philox block, _random_fast one corput_mix4, _pairs per pair one
//         shuffle and two hash scrambles, _pmj02 per pair 15 Philox blocks.
// hooks:  none.
// mirror: src/reference/domain_draw.rs
#ifndef CORPUT_DOMAIN_DRAW_GLSL
#define CORPUT_DOMAIN_DRAW_GLSL

#include "corput/domain.glsl"
#include "corput/lattice.glsl"
#include "corput/owen.glsl"
#include "corput/pmj02.glsl"
#include "corput/random.glsl"
#include "corput/stratified.glsl"

// Random numbers, by Philox.
uvec4 corput_draw_random(CorputDomain domain) {
    return corput_philox(uvec4(domain.index, 0u, 0u, 4u), domain.pattern);
}

// Random numbers, by the cheaper mixer.
uvec4 corput_draw_random_fast(CorputDomain domain) {
    return corput_mix4(uvec4(domain.index, 3u, domain.pattern));
}

// Two Sobol pairs, shuffled and scrambled by the fast hash.
uvec4 corput_draw_pairs(CorputDomain domain) {
    uvec2 p = corput_sobol_pair(corput_owen_hash(domain.index, corput_domain_seed(domain, 0u)));
    uvec2 q = corput_sobol_pair(corput_owen_hash(domain.index, corput_domain_seed(domain, 1u)));
    return uvec4(corput_owen_hash(p.x, corput_domain_seed(domain, 2u)),
        corput_owen_hash(p.y, corput_domain_seed(domain, 3u)),
        corput_owen_hash(q.x, corput_domain_seed(domain, 4u)),
        corput_owen_hash(q.y, corput_domain_seed(domain, 5u)));
}

// Two pairs of the progressive multi-jittered (0,2) sequence, by exact scrambles.
uvec4 corput_draw_pmj02(CorputDomain domain) {
    uvec2 other = uvec2(corput_domain_seed(domain, 0u), corput_domain_seed(domain, 1u));
    return uvec4(corput_pmj02(domain.index, domain.pattern), corput_pmj02(domain.index, other));
}

// A Latin hypercube of `count` points in four dimensions.
uvec4 corput_draw_latin_hypercube(CorputDomain domain, uint count) {
    uvec4 jitter = corput_draw_random(domain);
    return uvec4(
        corput_latin_hypercube(domain.index, count, corput_domain_seed(domain, 0u), jitter.x),
        corput_latin_hypercube(domain.index, count, corput_domain_seed(domain, 1u), jitter.y),
        corput_latin_hypercube(domain.index, count, corput_domain_seed(domain, 2u), jitter.z),
        corput_latin_hypercube(domain.index, count, corput_domain_seed(domain, 3u), jitter.w));
}

// Two correlated multi-jittered pairs on a grid of grid.x * grid.y points.
uvec4 corput_draw_cmj(CorputDomain domain, uvec2 grid) {
    uvec4 jitter = corput_draw_random(domain);
    return uvec4(corput_cmj(domain.index, grid, corput_domain_seed(domain, 0u), jitter.xy),
        corput_cmj(domain.index, grid, corput_domain_seed(domain, 1u), jitter.zw));
}

// The first four dimensions of the embedded lattice of "corput/lattice_vector.glsl", rotated.
uvec4 corput_draw_lattice(CorputDomain domain) {
    return uvec4(
        corput_rotate(corput_lattice(domain.index, 1u), corput_domain_seed(domain, 0u)),
        corput_rotate(corput_lattice(domain.index, 182667u), corput_domain_seed(domain, 1u)),
        corput_rotate(corput_lattice(domain.index, 469891u), corput_domain_seed(domain, 2u)),
        corput_rotate(corput_lattice(domain.index, 498753u), corput_domain_seed(domain, 3u)));
}

// The additive recurrence of four dimensions, rotated: steps g^-1 ... g^-4, g^5 = g + 1.
uvec4 corput_draw_additive(CorputDomain domain) {
    uint n = domain.index;
    return uvec4(
        corput_rotate(corput_additive(n, uvec2(0x75ae2165u, 0xdb4f0b91u)), corput_domain_seed(domain, 0u)),
        corput_rotate(corput_additive(n, uvec2(0x03a4615fu, 0xbbe05633u)), corput_domain_seed(domain, 1u)),
        corput_rotate(corput_additive(n, uvec2(0xa1fe1576u, 0xa0f2ec75u)), corput_domain_seed(domain, 2u)),
        corput_rotate(corput_additive(n, uvec2(0x7d9ed689u, 0x89e18285u)), corput_domain_seed(domain, 3u)));
}

#endif
