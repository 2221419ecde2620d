#version 450
#extension GL_GOOGLE_include_directive : require
// One function of the headers of nets over a buffer of arguments, or over indices.
#include "interface.glsl"
// Made-up directions: any will do for a sum of them. (A constant array of real ones would
// be copied by every invocation on some drivers.)
#define CORPUT_SOBOL_DIRECTION(dimension, bit) ((((dimension) << 5) + (bit)) * 0x9e3779b9u)
#include "corput/pmj02.glsl"
#include "corput/sobol.glsl"

uvec4 evaluate(uvec4 a) {
    switch (FUNCTION) {
    case 0u:
        return uvec4(corput_sobol(a.x, a.y), corput_gray(a.x), corput_sobol_pair(a.x));
    default:
        return uvec4(corput_pmj02(a.x, a.yz), corput_pmj02_index(a.x, a.yz), 0u);
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
