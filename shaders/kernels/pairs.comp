#version 450
#extension GL_GOOGLE_include_directive : require
// For each point of a range the sum over later points of a range of the products that a
// mean-square discrepancy is made of. Columns of coordinates lie one after the other.
#include "interface.glsl"
#include "corput/discrepancy.glsl"

const uint STAR = 0u;
const uint CENTRED = 1u;
const uint WRAP_AROUND = 2u;
const uint MIXTURE = 3u;
const uint MODIFIED = 4u;

uvec2 factor(uvec2 p, uint x, uint y) {
    switch (KIND) {
    case STAR:
        return corput_star_factor(p, x, y);
    case CENTRED:
        return corput_centred_factor(p, x, y);
    case WRAP_AROUND:
        return corput_wrap_around_factor(p, x, y);
    case MIXTURE:
        return corput_mixture_factor(p, x, y);
    case MODIFIED:
        return corput_modified_factor(p, x, y);
    default:
        return uvec2(0u);
    }
}

void main() {
    uint i = kernel_invocation();
    if (i >= push.rows) {
        return;
    }
    uint row = push.first_row + i;
    // The words of the products are summed apart, each below 2^32: no sum of up to 2^32
    // overflows.
    uvec2 low = uvec2(0u);
    uvec2 high = uvec2(0u);
    for (uint other = max(push.first_other, row + 1u); other < push.end_other; other++) {
        uvec2 p = corput_shl64(uvec2(1u, 0u), push.scale);
        for (uint k = 0u; k < push.dimensions; k++) {
            uint at = k * push.count;
            p = factor(p, words[at + row], words[at + other]);
        }
        low = corput_add64(low, uvec2(p.x, 0u));
        high = corput_add64(high, uvec2(p.y, 0u));
    }
    results[i] = uvec4(low, high);
}
