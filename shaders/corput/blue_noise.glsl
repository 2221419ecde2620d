// what:   look-ups of a dither mask: rank, fraction, animation and further dimensions.
// source: Ulichney 1993, The void-and-cluster method for dither array generation; golden
//         ratio over time: Wolfe 2017; shifts by R2: Roberts 2018, The unreasonable
//         effectiveness of quasirandom sequences; masks over time: Wolfe et al. 2022.
// domain: any pixel, frame and dimension; masks of sides from 1 to 2^16 with at most
//         2^16 pixels, all frames together.
// range:  fractions of 2^32.
// cost:   2 remainders, 2 divisions and the look-up.
// hooks:  CORPUT_BLUE_NOISE(x, y): the rank of the mask's pixel in column x and row y,
//         each rank from 0 to the number of pixels less one once. Row y of frame f of a
//         mask over time is row f * height + y.
// mirror: src/reference/blue_noise.rs
#ifndef CORPUT_BLUE_NOISE_GLSL
#define CORPUT_BLUE_NOISE_GLSL

#ifndef CORPUT_BLUE_NOISE
#error define CORPUT_BLUE_NOISE(x, y), the rank of the mask in column x and row y, before this header
#endif

#include "corput/fixed.glsl"

// floor(2^32 (rank + 1/2) / count): the middle of the rank-th of `count` equal parts.
// 1 <= count <= 2^16, rank < count.
uint corput_blue_noise_fraction(uint rank, uint count) {
    // Long division by digits of 16 bits: 2 rank + 1 < 2 count, so the first quotient
    // has 16 bits, and remainders are below 2^16.
    uint high = (2u * rank + 1u) << 15;
    return ((high / count) << 16) + ((high % count) << 16) / count;
}

// The rank of a pixel, with the mask repeated over the plane.
uint corput_blue_noise_rank(uvec2 pixel, uvec2 size) {
    return CORPUT_BLUE_NOISE(pixel.x % size.x, pixel.y % size.y);
}

// The fraction of a pixel in a still mask.
uint corput_blue_noise(uvec2 pixel, uvec2 size) {
    return corput_blue_noise_fraction(corput_blue_noise_rank(pixel, size), size.x * size.y);
}

// The fraction of a pixel and frame in a mask over time of size.z frames.
uint corput_blue_noise_frame(uvec2 pixel, uint frame, uvec3 size) {
    uint row = frame % size.z * size.y + pixel.y % size.y;
    return corput_blue_noise_fraction(CORPUT_BLUE_NOISE(pixel.x % size.x, row),
        size.x * size.y * size.z);
}

// A still mask over time: each pixel goes round by the golden ratio from frame to frame,
// so its values fill [0, 1) evenly, and each frame remains blue where it does not wrap.
uint corput_blue_noise_animate(uint fraction, uint frame) {
    return fraction + frame * 0x9e3779b9u;
}

// The pixel to look up for another dimension: shifts of the mask as far apart as R2 is.
// size.x and size.y at most 2^16.
uvec2 corput_blue_noise_shift(uvec2 pixel, uint dimension, uvec2 size) {
    return uvec2(pixel.x % size.x + corput_mulhi(dimension * 0xc13fa9a9u, size.x),
        pixel.y % size.y + corput_mulhi(dimension * 0x91e10da6u, size.y));
}

#endif
