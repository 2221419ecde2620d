#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_shader_explicit_arithmetic_types_int64 : require
// WIDE_POINTS consecutive points of an invocation, in stores of eight words and without a loop over points.
// llvmpipe stores lane by lane, so that fewer and wider stores are faster there.
// Sixteen columns may be a part of a wider row, which takes one dispatch per part.
#include "interface.glsl"
#include "wide.glsl"

#define WORDS (WIDE_POINTS * WIDE_COLUMNS)

#define PAIR(w) packUint2x32(uvec2(words[w], words[(w) + 1]))
#define EIGHT(s) u64vec4(PAIR(8 * (s)), PAIR(8 * (s) + 2), PAIR(8 * (s) + 4), PAIR(8 * (s) + 6))

#if WIDE_COLUMNS < 8
#define STORE(s) results[at + uint(s)] = EIGHT(s);
#else
#define STORES_OF_POINT (WIDE_COLUMNS / 8)
#define STORE(s) \
    results[at + uint((s) / STORES_OF_POINT) * ROW + uint((s) % STORES_OF_POINT)] = EIGHT(s);
#endif
#define STORE4(s) STORE(s) STORE(s + 1) STORE(s + 2) STORE(s + 3)

void main() {
    uint i = kernel_invocation();
    if (i >= push.invocations) {
        return;
    }
    uint first = push.first + i * WIDE_POINTS;
    uint words[WORDS];
    uint fraction;
    WIDE_EACH(WIDE_START, 0)
    WIDE_ALL
#if WIDE_COLUMNS < 8
    uint at = i * (WORDS / 8);
#else
    uint at = i * WIDE_POINTS * ROW + PART * STORES_OF_POINT;
#endif
    STORE4(0)
#if WORDS == 48
    STORE(4)
    STORE(5)
#endif
#if WORDS >= 64
    STORE4(4)
#endif
}
