// what:   the factor of one coordinate in the product over two points that the closed
//         forms of the mean-square discrepancies sum: p K(x, y), for p a fixed-point
//         number of 64 bits (x low, y high).
// source: the kernels K of Warnock 1972 (star), Hickernell 1998 (centred, wrap-around,
//         modified) and Zhou, Fang and Ning 2013 (mixture).
// domain: x and y fractions of 2^32; p and p K(x, y) below 2^63.
// range:  at most 1 unit of p off for star, centred and modified, 3 for wrap-around, 7
//         for mixture.
// cost:   2 multiplications of 32 bits to 64 for star, centred and modified, 4 for
//         wrap-around, 8 for mixture.
// hooks:  none.
// mirror: src/reference/discrepancy.rs
#ifndef CORPUT_DISCREPANCY_GLSL
#define CORPUT_DISCREPANCY_GLSL

#include "corput/distance.glsl"
#include "corput/fixed.glsl"

// floor(p f / 2^32).
uvec2 corput_scale64(uvec2 p, uint f) {
    return corput_add64(corput_mul64(p.y, f), uvec2(corput_mulhi(p.x, f), 0u));
}

// |x - 1/2|.
uint corput_off_centre(uint x) {
    return corput_apart(x, 0x80000000u);
}

// p (1 - max(x, y)).
uvec2 corput_star_factor(uvec2 p, uint x, uint y) {
    return corput_sub64(p, corput_scale64(p, max(x, y)));
}

// p (1 + (|x - 1/2| + |y - 1/2| - |x - y|) / 2).
uvec2 corput_centred_factor(uvec2 p, uint x, uint y) {
    // On one side of the middle the sum is twice the lesser distance, else 0.
    uint nearer = min(corput_off_centre(x), corput_off_centre(y));
    uint both = ((x ^ y) >> 31) == 0u ? nearer : 0u;
    return corput_add64(p, corput_scale64(p, both));
}

// p (3/2 - |x - y| (1 - |x - y|)).
uvec2 corput_wrap_around_factor(uvec2 p, uint x, uint y) {
    // That is 5/4 + (1/2 - |x - y|)^2.
    uint h = corput_off_centre(corput_apart(x, y));
    uvec2 square = corput_scale64(corput_scale64(p, h), h);
    return corput_add64(corput_add64(p, corput_shr64(p, 2u)), square);
}

// p (15/8 - |x - 1/2| / 4 - |y - 1/2| / 4 - 3 |x - y| / 4 + |x - y|^2 / 2).
uvec2 corput_mixture_factor(uvec2 p, uint x, uint y) {
    uint z = corput_apart(x, y);
    uvec2 once = corput_scale64(p, z);
    uvec2 twice = corput_scale64(once, z);
    uvec2 centres = corput_add64(corput_scale64(p, corput_off_centre(x)),
        corput_scale64(p, corput_off_centre(y)));
    uvec2 more = corput_sub64(corput_shl64(p, 1u), corput_shr64(p, 3u));
    uvec2 less = corput_add64(corput_shr64(centres, 2u), corput_sub64(once, corput_shr64(once, 2u)));
    return corput_add64(corput_sub64(more, less), corput_shr64(twice, 1u));
}

// p (2 - max(x, y)).
uvec2 corput_modified_factor(uvec2 p, uint x, uint y) {
    return corput_add64(p, corput_star_factor(p, x, y));
}

#endif
