// Loops that measure the speed of a function: an invocation evaluates it REPEATS times and
// stores four words for all results, so that memory is hardly touched. BARE is the same loop
// without the function.
#ifndef KERNEL_REPEAT_GLSL
#define KERNEL_REPEAT_GLSL

const uint REPEAT = 4u;
const uint BARE = 5u;

#define REPEATS 64u

// Arguments before the first evaluation of invocation i. An additive recurrence takes three
// additions, and comes everywhere.
uvec3 repeat_first(uint i) {
    return i * uvec3(0xd1b54a33u, 0xabc98389u, 0x8cb92ba7u);
}

// The arguments after these.
uvec3 repeat_next(uvec3 u) {
    return u + uvec3(0x9e3779b9u, 0xc13fa9a9u, 0x91e10da5u);
}

#endif
