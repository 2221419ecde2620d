#version 450
#extension GL_GOOGLE_include_directive : require
// One function of permutations, strata, scrambled digits or lattices over a buffer of
// arguments, or over indices.
#include "interface.glsl"
// Dimensions are named by their bases, so that any can be asked for.
#define CORPUT_PRIME(d) (d)
#include "corput/halton_scrambled.glsl"
#include "corput/lattice.glsl"
#include "corput/lattice_vector.glsl"
#include "corput/stratified.glsl"

// The fraction in a stratum, and its float.
uvec4 stratum(uint u, uint strata) {
    return uvec4(u, floatBitsToUint(corput_unit_stratum(u, strata)), 0u, 0u);
}

// Kensler's set on grids of all shapes, of less than 2^27 points.
uvec4 multi_jittered(uvec4 a) {
    uint shift = (a.y & 3u) * 8u;
    uvec2 grid = max(uvec2(a.y >> (31u - shift), a.z >> (7u + shift)), uvec2(1u));
    return uvec4(corput_cmj(a.x % (grid.x * grid.y), grid, a.z, a.wy), grid);
}

uvec4 evaluate(uvec4 a) {
    switch (FUNCTION) {
    case 0u:
        return uvec4(corput_permute(a.x, a.y, a.z), corput_permute_key(a.z, a.w), 0u, 0u);
    case 1u:
        return stratum(corput_stratum(a.x, a.y, a.w), a.y);
    case 2u:
        return stratum(a.z, a.y);
    case 3u:
        return stratum(corput_stratified(a.z, (a.w >> 8) & 0xfffu, a.y, a.w), a.y);
    case 4u:
        return stratum(corput_latin_hypercube(a.x, a.y, a.z, a.w), a.y);
    case 5u:
        return multi_jittered(a);
    case 6u:
        return uvec4(corput_radical_inverse_faure(a.x, a.y), corput_faure_digit(a.x % max(a.y, 1u), a.y), 0u, 0u);
    case 7u:
        return uvec4(corput_radical_inverse_permuted(a.x, a.y, a.z), 0u, 0u, 0u);
    case 8u:
        return uvec4(corput_radical_inverse_owen(a.x, a.y, a.z), 0u, 0u, 0u);
    case 9u:
        return uvec4(corput_radical_inverse_started(a.x, a.y, a.z), 0u, 0u, 0u);
    case 10u:
        return uvec4(corput_halton_faure(a.x, a.y), corput_halton_permuted(a.x, a.y, a.z),
            corput_halton_owen(a.x, a.y, a.z), corput_halton_started(a.x, a.y, a.z));
    case 11u:
        return uvec4(corput_lattice(a.x, a.y), corput_lattice(a.x, corput_lattice_vector(a.y % 260u)),
            corput_rotate(a.x, a.y), 0u);
    case 12u:
        return uvec4(corput_korobov(a.x, a.y == 0u ? a.z : a.z % a.y, a.y), 0u, 0u, 0u);
    default:
        return uvec4(corput_additive(a.x, a.yz), 0u, 0u, 0u);
    }
}

void main() {
    uint i = kernel_invocation();
    if (i >= push.invocations) {
        return;
    }
    uint n = push.first + i * push.stride;
    results[i] = evaluate(INDEXED != 0u ? uvec4(n) : arguments[i]);
}
