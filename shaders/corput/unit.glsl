// what:   a fraction of 2^32 as a float in [0, 1), never 1, exact in every rounding
//         direction.
// source: 24 leading bits are what a float holds; float(u) * 2^-32 would give 1.0 for
//         u >= 0xffffff80 (Goualard 2020, Generating random floating-point numbers by
//         dividing integers, ICCS).
// domain: any uint. range: multiples of 2^-24 in [0, 1 - 2^-24].
// cost:   2 to 4 instructions.
// hooks:  none.
// mirror: src/reference/unit.rs
#ifndef CORPUT_UNIT_GLSL
#define CORPUT_UNIT_GLSL

// floor(u / 2^8) * 2^-24: for base 2, Sobol, random and scrambled points.
float corput_unit_floor(uint u) {
    return float(u >> 8) * 5.9604644775390625e-8;
}

// min(ceil(u / 2^8), 2^24 - 1) * 2^-24: for unscrambled radical inverses in other
// bases and for k/N, where rounding up keeps a point on the lower edge of a b-adic
// cell inside that cell.
float corput_unit_ceil(uint u) {
    uint k = (u >> 8) + ((u & 0xffu) != 0u ? 1u : 0u);
    return float(min(k, 0xffffffu)) * 5.9604644775390625e-8;
}

#endif
