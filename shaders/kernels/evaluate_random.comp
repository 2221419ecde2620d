#version 450
#extension GL_GOOGLE_include_directive : require
// One function of the random headers over a buffer of arguments, or over indices.
#include "interface.glsl"
#include "corput/hash.glsl"
#include "corput/owen.glsl"
#include "corput/random.glsl"

uvec4 one(uint x) {
    return uvec4(x, 0u, 0u, 0u);
}

uvec4 evaluate(uvec4 a) {
    CorputPcg32 p = corput_pcg32_seed(a.xy, a.zw);
    CorputPcg32 q;
    switch (FUNCTION) {
    case 0u:
        return uvec4(corput_hash(a.x), corput_hash(a.y), corput_hash(a.z), corput_hash(a.w));
    case 1u:
        return corput_pcg4d(a);
    case 2u:
        return one(corput_seed(a.xy, a.z, a.w));
    case 3u:
        return corput_philox(a, uvec2(~a.x, a.y + a.z));
    case 4u:
        return one(corput_random(a.x, a.y, a.zw));
    case 5u:
        return one(corput_random_fast(a.x, a.y, a.zw));
    case 6u:
        q = corput_pcg32_next(p);
        return uvec4(corput_pcg32_value(p), corput_pcg32_value(q), q.state);
    case 7u:
        q = corput_pcg32_advance(p, a.yw);
        return uvec4(corput_pcg32_value(q), corput_pcg32_advance(p, a.xy).state, q.increment.x);
    case 8u:
        return one(corput_digital_shift(a.x, a.y));
    case 9u:
        return one(corput_owen(a.x, a.y, a.zw));
    case 10u:
        return one(corput_owen_hash(a.x, a.y));
    case 12u:
        return corput_mix4(a);
    default:
        return one(corput_matrix_scramble(a.x, a.y, a.zw));
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
