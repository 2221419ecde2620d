// what:   distances of fractions of 2^32, in the interval or on the circle, and sums of
//         their squares as 96-bit integers (x low, z high).
// source: schoolbook arithmetic.
// domain: any uint; sums of up to 2^32 squares.
// range:  exact.
// cost:   1 to 3 integer instructions for a distance, 10 for a square and its sum.
// hooks:  none.
// mirror: src/reference/distance.rs
#ifndef CORPUT_DISTANCE_GLSL
#define CORPUT_DISTANCE_GLSL

#include "corput/fixed.glsl"

// |x - y|.
uint corput_apart(uint x, uint y) {
    return x > y ? x - y : y - x;
}

// The way from x to y around the circle, the shorter of the two.
uint corput_apart_toroidal(uint x, uint y) {
    return min(x - y, y - x);
}

// sum + d^2.
uvec3 corput_add_square(uvec3 sum, uint d) {
    uvec2 square = corput_mul64(d, d);
    uvec2 low = corput_addc(sum.x, square.x);
    uvec2 middle = corput_addc(sum.y, square.y);
    uvec2 carried = corput_addc(middle.x, low.y);
    return uvec3(low.x, carried.x, sum.z + middle.y + carried.y);
}

// a < b.
bool corput_less96(uvec3 a, uvec3 b) {
    if (a.z != b.z) {
        return a.z < b.z;
    }
    if (a.y != b.y) {
        return a.y < b.y;
    }
    return a.x < b.x;
}

#endif
