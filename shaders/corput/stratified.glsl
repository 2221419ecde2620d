// what:   stratified points: a jittered fraction of a stratum, jittered grids, Latin
//         hypercubes and correlated multi-jittered sets.
// source: Cook 1986, Stochastic sampling in computer graphics (jitter); McKay, Beckman and
//         Conover 1979 (Latin hypercube); Kensler 2013, Correlated multi-jittered
//         sampling, Pixar TM 13-01.
// domain: cell < strata, 1 <= strata <= 2^32; strata = 2^32 is written as 0.
// range:  fractions of 2^32 in the stratum [2^32 cell/strata, 2^32 (cell + 1)/strata),
//         exactly, for every number of strata.
// cost:   a long division of 32 steps; Latin hypercubes a permutation besides, cmj three.
// hooks:  none.
// mirror: src/reference/stratified.rs
#ifndef CORPUT_STRATIFIED_GLSL
#define CORPUT_STRATIFIED_GLSL

#include "corput/hammersley.glsl"
#include "corput/permute.glsl"
#include "corput/unit.glsl"

// A fraction of stratum `cell` among `strata` equal ones; `jitter` says where in it.
uint corput_stratum(uint cell, uint strata, uint jitter) {
    // The width 2^32 of one stratum has no uint; 2^32 strata hold one fraction each.
    if (strata <= 1u) {
        return strata == 1u ? jitter : cell;
    }
    CorputGridPoint lower = corput_hammersley_start(cell, strata);
    // 2^32 / strata. A remainder of `strata` in place of 0 carries in the step below.
    uint quotient = 0xffffffffu / strata;
    CorputGridPoint step = CorputGridPoint(quotient, 0xffffffffu - quotient * strata + 1u);
    uint first = corput_hammersley_value(lower);
    // The end of the last stratum is 2^32, of which 0 is left.
    uint end = corput_hammersley_value(corput_hammersley_next(lower, step, strata));
    return first + corput_mulhi(jitter, end - first);
}

// The float of u that stays in u's stratum among `strata` equal ones: u cut to 24 bits,
// or the next one up if the cut leaves the stratum. Exact for strata <= 2^24; above, floats
// are too few.
float corput_unit_stratum(uint u, uint strata) {
    uint cut = u & 0xffffff00u;
    bool left = strata == 0u ? cut != u : corput_mulhi(cut, strata) != corput_mulhi(u, strata);
    return corput_unit_floor(left && cut != 0xffffff00u ? cut + 256u : cut);
}

// The coordinate of point n of a jittered grid along an axis of `strata` strata; `stride`
// is the product of the strata of the axes before it, at least 1.
uint corput_stratified(uint n, uint stride, uint strata, uint jitter) {
    uint cell = n / max(stride, 1u);
    return corput_stratum(strata == 0u ? cell : cell % strata, strata, jitter);
}

// The coordinate of point n of a Latin hypercube of `count` points; each dimension has a
// seed of its own.
uint corput_latin_hypercube(uint n, uint count, uint seed, uint jitter) {
    return corput_stratum(corput_permute(n, count, seed), count, jitter);
}

// Point n of a correlated multi-jittered set of grid.x * grid.y points, at most 2^32: alone
// in its cell of the grid, and in its stratum of either axis among as many as points.
uvec2 corput_cmj(uint n, uvec2 grid, uint seed, uvec2 jitter) {
    grid = max(grid, uvec2(1u));
    uint count = grid.x * grid.y;
    uint cell = corput_permute(n, count, corput_permute_key(seed, 0u));
    uint row = cell / grid.x;
    uint column = cell - row * grid.x;
    uint x = column * grid.y + corput_permute(row, grid.y, corput_permute_key(seed, 1u));
    uint y = row * grid.x + corput_permute(column, grid.x, corput_permute_key(seed, 2u));
    return uvec2(corput_stratum(x, count, jitter.x), corput_stratum(y, count, jitter.y));
}

#endif
