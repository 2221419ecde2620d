// what:   the coordinate k/N of the Hammersley set; its other coordinates are the
//         radical inverses of k in the first primes.
// source: Hammersley 1960, Monte Carlo methods for solving multivariable problems.
// domain: k < N, 1 <= N <= 2^32; N = 2^32 is written as 0.
// range:  exactly ceil(2^32 k / N), at most 2^32 - 1.
// cost:   32 steps of long division, a shift for powers of two; corput_hammersley_next
//         5 instructions.
// hooks:  none.
// mirror: src/reference/hammersley.rs
#ifndef CORPUT_HAMMERSLEY_GLSL
#define CORPUT_HAMMERSLEY_GLSL

#include "corput/bits.glsl"

// The fraction floor(2^32 k / N), and the remainder of that division.
struct CorputGridPoint {
    uint fraction;
    uint remainder;
};

// 2^32 k / N by long division, which a power of two does not need.
CorputGridPoint corput_hammersley_start(uint k, uint count) {
    if (count == 0u) {
        return CorputGridPoint(k, 0u);
    }
    if ((count & (count - 1u)) == 0u) {
        // In two steps: N = 1 shifts by 32.
        return CorputGridPoint((k << (31u - corput_find_msb(count))) << 1u, 0u);
    }
    uint fraction = 0u;
    uint remainder = k;
    for (uint i = 0u; i < 32u; i++) {
        bool carry = (remainder >> 31) != 0u;
        remainder <<= 1;
        fraction <<= 1;
        if (carry || remainder >= count) {
            remainder -= count;
            fraction += 1u;
        }
    }
    return CorputGridPoint(fraction, remainder);
}

// The grid point of k + 1 from that of k; `step` is the grid point of 1 (for N = 1,
// where there is no k = 1, it is not called).
CorputGridPoint corput_hammersley_next(CorputGridPoint p, CorputGridPoint step, uint count) {
    uint remainder = p.remainder + step.remainder;
    bool carry = remainder < p.remainder || (count != 0u && remainder >= count);
    return CorputGridPoint(p.fraction + step.fraction + (carry ? 1u : 0u),
        carry ? remainder - count : remainder);
}

// ceil(2^32 k / N).
uint corput_hammersley_value(CorputGridPoint p) {
    return p.fraction + (p.remainder != 0u ? 1u : 0u);
}

// ceil(2^32 k / N), from k and N.
uint corput_hammersley(uint k, uint count) {
    return corput_hammersley_value(corput_hammersley_start(k, count));
}

#endif
