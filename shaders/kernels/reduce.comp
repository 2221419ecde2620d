#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
// Exact sums of floats in memory: a record for each run of terms and each window of exponents,
// so no size of a group and no split shows in the bits.
#include "interface.glsl"
#include "corput/sum.glsl"

void main() {
    uint i = kernel_invocation();
    if (i >= push.invocations) {
        return;
    }
    uint window = i / push.parts;
    uint start = (i - window * push.parts) * push.run;
    uint count = min(push.run, push.count - start);
    CorputTally tally = corput_tally_zero();
    uint special = 0u;
    [[dont_unroll]] for (uint k = 0u; k < count; k++) {
        uint bits = words[push.first + start + k];
        tally = corput_tally_add(tally, corput_term_window(bits, window));
        special += uint((bits & 0x7f800000u) == 0x7f800000u);
    }
    CorputSum sum = corput_tally_sum(tally);
    results[3u * i] = sum.total;
    results[3u * i + 1u] = sum.squares;
    results[3u * i + 2u] = uvec4(sum.squares_high, count, special);
}
