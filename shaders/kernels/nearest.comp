#version 450
#extension GL_GOOGLE_include_directive : require
// For each point of a range the nearest of the later points of a range: the squared
// distance and its row, all bits set where there is none. Columns of coordinates lie one
// after the other.
#include "interface.glsl"
#include "corput/distance.glsl"

void main() {
    uint i = kernel_invocation();
    if (i >= push.rows) {
        return;
    }
    uint row = push.first_row + i;
    uvec3 least = uvec3(0xffffffffu);
    uint nearest = 0xffffffffu;
    for (uint other = max(push.first_other, row + 1u); other < push.end_other; other++) {
        uvec3 sum = uvec3(0u);
        for (uint k = 0u; k < push.dimensions; k++) {
            uint x = words[k * push.count + row];
            uint y = words[k * push.count + other];
            sum = corput_add_square(sum, TOROIDAL != 0u ? corput_apart_toroidal(x, y) : corput_apart(x, y));
        }
        if (corput_less96(sum, least)) {
            least = sum;
            nearest = other;
        }
    }
    results[i] = uvec4(least, nearest);
}
