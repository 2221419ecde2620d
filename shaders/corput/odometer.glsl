// what:   radical inverses of consecutive indices, without a division per point.
// source: the von Neumann-Kakutani odometer: phi_b(n + 1) = phi_b(n) + b^-j +
//         b^-(j+1) - 1, where j low digits of n are b - 1. Here on the low digits
//         alone; the chain over the high digits is exact and made once per window.
// domain: a window of at most `power` consecutive indices, bases 3 to 251.
// range:  the same bits as corput_radical_inverse, for every n.
// cost:   two radical inverses per window, about 14 instructions per point.
// hooks:  none.
// mirror: src/reference/odometer.rs
#ifndef CORPUT_ODOMETER_GLSL
#define CORPUT_ODOMETER_GLSL

#include "corput/radical_inverse.glsl"

// A base with the constants of its low digits: power = base^k <= 255, k <= 5.
struct CorputOdometerBase {
    CorputBase radical;
    uint power;
    // 2^32 / power: whole part, and fraction of 2^16 rounded down.
    uint quotient;
    uint fraction;
};

// Where a window stands.
struct CorputOdometer {
    // The low digits of the index, mirrored: 0 to power - 1.
    uint reversed;
    // The chain over the high digits divided by power, in this block of `power` indices
    // and in the next: whole part, and fraction of 2^16 rounded down plus 2^16 - 1.
    uint quotient;
    uint fraction;
    uint next_quotient;
    uint next_fraction;
};

// The window that starts at index n.
CorputOdometer corput_odometer_start(uint n, CorputOdometerBase b) {
    uint block = n / b.power;
    uint low = n - block * b.power;
    uint reversed = 0u;
    for (uint scale = 1u; scale < b.power; scale *= b.radical.base) {
        uint rest = low / b.radical.base;
        reversed = reversed * b.radical.base + (low - rest * b.radical.base);
        low = rest;
    }
    uint y = corput_radical_inverse_table(block, b.radical);
    uint next = corput_radical_inverse_table(block + 1u, b.radical);
    uint quotient = y / b.power;
    uint next_quotient = next / b.power;
    return CorputOdometer(reversed,
        quotient, ((y - quotient * b.power) << 16) / b.power + 0xffffu,
        next_quotient, ((next - next_quotient * b.power) << 16) / b.power + 0xffffu);
}

// ceil(2^32 phi_b(n)) for the index n where the window stands.
uint corput_odometer_value(CorputOdometer o, CorputOdometerBase b) {
    // The ceiling of (reversed * 2^32 + y) / power. Its fraction is a multiple of
    // 1 / power >= (power + 1) / 2^16; the fractions of 2^16 fall short by less than
    // power / 2^16, so adding 1 - 2^-16 carries exactly where the ceiling does.
    return o.reversed * b.quotient + o.quotient + ((o.reversed * b.fraction + o.fraction) >> 16);
}

// The window one index on.
CorputOdometer corput_odometer_next(CorputOdometer o, CorputOdometerBase b) {
    // Weights of the first five digits; past the last digit a weight is 0, and the
    // step of that line is the wrap to 0.
    uint first = b.power / b.radical.base;
    uint second = first / b.radical.base;
    uint third = second / b.radical.base;
    uint fourth = third / b.radical.base;
    uint fifth = fourth / b.radical.base;
    uint step = o.reversed < b.power - first ? first
        : o.reversed < b.power - second ? first + second - b.power
        : o.reversed < b.power - third ? second + third - b.power
        : o.reversed < b.power - fourth ? third + fourth - b.power
        : o.reversed < b.power - fifth ? fourth + fifth - b.power
        : 1u - b.power;
    uint reversed = o.reversed + step;
    bool wrapped = reversed == 0u;
    return CorputOdometer(reversed, wrapped ? o.next_quotient : o.quotient,
        wrapped ? o.next_fraction : o.fraction, o.next_quotient, o.next_fraction);
}

#endif
