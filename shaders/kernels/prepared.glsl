// What the host prepared of a map's parameters, a real in two words: its significand, and
// its exponent twice, plus 1 if it is negative. Drivers inline whatever a kernel calls, and
// preparing is most of some maps.
#ifndef KERNEL_PREPARED_GLSL
#define KERNEL_PREPARED_GLSL

#include "corput/real_frame.glsl"

// Word i of them.
#ifndef PREPARED
#define PREPARED(i) prepared[i]
#endif

// Real i of them.
CorputReal prepared_real(uint i) {
    uint e = PREPARED(2u * i + 1u);
    return CorputReal(PREPARED(2u * i), int(e) >> 1, (e & 1u) != 0u);
}

CorputReal3 prepared_real3(uint i) {
    return CorputReal3(prepared_real(i), prepared_real(i + 1u), prepared_real(i + 2u));
}

CorputRealFrame prepared_frame(uint i) {
    return CorputRealFrame(prepared_real3(i), prepared_real3(i + 3u), prepared_real3(i + 6u));
}

// The same into the results.
void store_real(uint i, CorputReal a) {
    uvec2 words = uvec2(a.m, uint(a.e << 1) | uint(a.negative));
    if ((i & 1u) == 0u) {
        results[i >> 1].xy = words;
    } else {
        results[i >> 1].zw = words;
    }
}

void store_real3(uint i, CorputReal3 v) {
    store_real(i, v.x);
    store_real(i + 1u, v.y);
    store_real(i + 2u, v.z);
}

void store_frame(uint i, CorputRealFrame f) {
    store_real3(i, f.tangent);
    store_real3(i + 3u, f.bitangent);
    store_real3(i + 6u, f.normal);
}

#endif
