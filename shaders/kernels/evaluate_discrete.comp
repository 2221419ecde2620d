#version 450
#extension GL_GOOGLE_include_directive : require
// One function of discrete distributions or of combined techniques, over a buffer of
// arguments, or over indices.
#include "interface.glsl"

// The alias table of the weights 3, 1, 0, 10 and 2.
const uint ALIAS_TABLE[15] = uint[15](
    4026531840u, 3u, 805306368u, 1342177285u, 3u, 268435457u, 0u, 3u, 0u, 0u, 3u, 2684354559u,
    2684354560u, 3u, 536870912u);

// A CDF of 16 items, the even and the last three without weight, and the alias table.
uint table_word(uint i) {
    uint cdf = i == 0u ? 13u : (i & 14u) << 28;
    return i < 16u ? cdf : ALIAS_TABLE[min(i - 16u, 14u)];
}
#define CORPUT_DISCRETE(i) table_word(i)
#include "corput/discrete.glsl"
#include "corput/mis.glsl"

// Words of the CDF.
const uint ALIAS = 16u;
const uint ITEMS = 5u;

uvec4 evaluate(uvec4 a) {
    vec4 pdfs = uintBitsToFloat(a);
    uvec4 counts = uvec4(a.z & 7u, a.w & 3u, a.w >> 30, a.z >> 30);
    switch (FUNCTION) {
    case 0u:
        uint width = max(a.z, 1u);
        uint part = a.x % width;
        return uvec4(corput_discrete_divide(uvec2(a.y, part), width), corput_discrete_rest(part, width),
            corput_discrete_part(a.x, a.w), corput_discrete_scale(a.xy, a.z).y);
    case 1u:
        CorputChoice choice = corput_cdf(0u, a.x);
        return uvec4(choice.index, choice.rest, choice.weight.x ^ (choice.weight.y << 31),
            corput_cdf_invert(0u, choice.index, choice.rest));
    case 2u:
        return uvec4(corput_alias_index(ALIAS, ITEMS, a.x), corput_alias_rest(ALIAS, ITEMS, a.xy),
            corput_alias_weight(ALIAS, a.z % ITEMS));
    case 3u:
        CorputReservoir r = CorputReservoir(a.x & 1023u, a.y, a.zw >> 1);
        CorputReservoir more = corput_reservoir_add(r, 1024u, a.y >> (a.x & 31u), a.z);
        CorputReservoir both = corput_reservoir_merge(more, CorputReservoir(1025u, a.x, a.wz >> 1), a.y);
        return uvec4(both.index, more.index, both.total.y, floatBitsToUint(corput_reservoir_pdf(both)));
    case 4u:
        return floatBitsToUint(vec4(corput_mis_balance(counts.x, pdfs.x, counts.y, pdfs.y),
            corput_mis_power(counts.x, pdfs.x, counts.y, pdfs.y),
            corput_mis_maximum(counts.x, pdfs.x, counts.y, pdfs.y),
            corput_mis_one_sample(counts, pdfs)));
    case 5u:
        CorputTechnique technique = corput_mis_choose(a >> 2, a.x ^ a.w);
        return uvec4(floatBitsToUint(corput_mis_balance4(counts, pdfs)),
            floatBitsToUint(corput_mis_power4(counts, pdfs)), technique.index, technique.rest);
    default:
        CorputRoulette roulette = corput_roulette(a.x, a.y);
        return uvec4(roulette.survives ? 1u : 0u, floatBitsToUint(roulette.weight), roulette.rest,
            corput_roulette_survival(pdfs.z));
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
