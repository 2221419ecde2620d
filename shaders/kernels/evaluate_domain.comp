#version 450
#extension GL_GOOGLE_include_directive : require
// One function of the headers of domains over a buffer of arguments, or over indices.
#include "interface.glsl"
#define CORPUT_PRIME(d) ((d) == 0u ? 2u : 2u * (d) + 1u)
#define CORPUT_SOBOL_DIRECTION(dimension, bit) ((((dimension) << 5) + (bit)) * 0x9e3779b9u)
#include "corput/domain_draw.glsl"
#include "corput/domain_halton.glsl"
#include "corput/domain_sobol.glsl"

uvec4 evaluate(uvec4 a) {
    CorputDomain root = corput_domain(a.xy, a.z & 3u, a.w, a.z);
    CorputDomain other = corput_domain_chain(root, a.x, a.y);
    CorputDomain split = corput_domain_split(root, a.z, a.y, a.x);
    switch (FUNCTION) {
    case 0u:
        return uvec4(root.pattern, root.index, corput_domain_seed(root, a.x));
    case 1u:
        return uvec4(corput_domain_child(root, a.x).pattern, corput_domain_child(other, a.y).pattern);
    case 2u:
        return uvec4(other.pattern, split.pattern.x, split.index);
    case 3u:
        return corput_draw_random(root);
    case 4u:
        return corput_draw_random_fast(root);
    case 5u:
        return corput_draw_pairs(root);
    case 6u:
        return corput_draw_pmj02(root);
    case 7u:
        root.index = a.w % 1000u;
        return corput_draw_latin_hypercube(root, 1000u);
    case 8u:
        root.index = a.w % 999u;
        return corput_draw_cmj(root, uvec2(27u, 37u));
    case 9u:
        return corput_draw_lattice(root);
    case 10u:
        return corput_draw_additive(root);
    case 11u:
        return corput_draw_sobol(root);
    case 12u:
        return corput_draw_sobol_owen(root);
    case 13u:
        return corput_draw_halton(root);
    case 14u:
        return corput_draw_halton_permuted(root);
    case 15u:
        return corput_draw_halton_started(root);
    case 16u:
        root.index = a.w % 999u;
        return corput_draw_stratified(root, uvec2(27u, 37u));
    case 17u:
        root.index = a.w % 65521u;
        return corput_draw_korobov(root, uvec4(1u, 8950u, 35838u, 24805u), 65521u);
    default:
        return uvec4(corput_draw_r2(root), 0u, 0u);
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
