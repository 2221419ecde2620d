// Points in memory through a map, four an invocation, by the three functions of a group:
// map_sample: fractions to coordinates and then the pdf, as float bits;
// map_pdf: coordinates to the bits of the pdf; map_invert: coordinates to fractions.
#ifndef KERNEL_MAP_MAIN_GLSL
#define KERNEL_MAP_MAIN_GLSL

#include "map_store.glsl"
#include "repeat.glsl"

// An attribute of the loop over an invocation's four points.
#ifndef MAP_LOOP
#define MAP_LOOP
#endif

// A statement before it: what the three functions would each compute again.
#ifndef MAP_PREPARE
#define MAP_PREPARE
#endif

// A statement of a single invocation: into the results what the host else prepares.
#ifndef MAP_PREPARED
#define MAP_PREPARED
#endif

const uint SAMPLE = 0u;
const uint PDF = 1u;
const uint INVERT = 2u;
const uint PREPARE = 3u;

// The fractions of point n.
uvec3 map_fractions(uint n) {
    uint at = n * DIMENSIONS;
    uvec3 u = uvec3(points[at], 0u, 0u);
    // No load past the end of the buffer.
    if (DIMENSIONS > 1u) {
        u.y = points[at + 1u];
    }
    if (DIMENSIONS > 2u) {
        u.z = points[at + 2u];
    }
    return u;
}

// The words that the task makes of input n.
uvec4 map_result(uint n) {
    if (TASK == SAMPLE) {
        return map_sample(map_fractions(n));
    }
    uvec4 s = uvec4(points[4u * n], points[4u * n + 1u], points[4u * n + 2u], points[4u * n + 3u]);
    if (TASK == PDF) {
        return uvec4(map_pdf(s), 0u, 0u, 0u);
    }
    if (TASK == INVERT) {
        return uvec4(map_invert(s), 0u);
    }
    return uvec4(0u);
}

// The fractions that the map takes of these; the others are 0.
uvec3 map_taken(uvec3 u) {
    uvec3 taken = uvec3(u.x, 0u, 0u);
    if (DIMENSIONS > 1u) {
        taken.y = u.y;
    }
    if (DIMENSIONS > 2u) {
        taken.z = u.z;
    }
    return taken;
}

// Samples of the recurrence's fractions, folded into one.
uvec4 map_repeated(uint i) {
    uvec3 u = repeat_first(i);
    uvec4 all = uvec4(0u);
    [[dont_unroll]] for (uint k = 0u; k < REPEATS; k++) {
        u = repeat_next(u);
        if (TASK == REPEAT) {
            all ^= map_sample(map_taken(u));
        } else {
            all ^= uvec4(map_taken(u), 0u);
        }
    }
    return all;
}

void main() {
    uint i = kernel_invocation();
    if (i >= push.invocations) {
        return;
    }
    if (TASK == PREPARE) {
        MAP_PREPARED
        return;
    }
    MAP_PREPARE
    if (TASK >= REPEAT) {
        results[i] = map_repeated(i);
        return;
    }
    uvec4 made[4];
    MAP_LOOP for (uint k = 0u; k < 4u; k++) {
        made[k] = map_result(4u * i + k);
    }
    uint width = TASK == SAMPLE ? COORDINATES + WITH_PDF : TASK == PDF ? 1u : 4u;
    map_store(i * width, width, made[0], made[1], made[2], made[3]);
}

#endif
