// what:   radical inverse phi_b(n): the digits of n in base b mirrored at the point.
// source: van der Corput 1935; Halton 1960. Nested division: floor((d + x) / b) =
//         floor((d + floor(x)) / b) for integer d, and the same for ceil, so one
//         division by b (or by a power of b) per digit (or group of digits) is exact.
//         Division by an invariant: Granlund and Montgomery 1994, Division by
//         invariant integers using multiplication, figure 4.1.
// domain: every n; prime bases 2 to 65535 (the table of this project ends at 8161).
// range:  exactly ceil(2^32 phi_b(n)); at most 2^32 - 1, for 1 - phi_b(n) >= 1/(n+1).
// cost:   base 2 one instruction; else 4 groups of digits, about 10 instructions each
//         plus 6 a digit.
// hooks:  none.
// mirror: src/reference/radical_inverse.rs
#ifndef CORPUT_RADICAL_INVERSE_GLSL
#define CORPUT_RADICAL_INVERSE_GLSL

#include "corput/fixed.glsl"

// A base with what division by it needs.
struct CorputBase {
    uint base;
    // Digits of a group, and base^digits: the largest power up to 65535.
    uint digits;
    uint power;
    uint base_magic;
    uint base_shift;
    uint power_magic;
    uint power_shift;
};

// floor(x / d) for any x, where magic and shift belong to d.
uint corput_divide_by(uint x, uint magic, uint shift) {
    uint t = corput_mulhi(x, magic);
    return (t + ((x - t) >> 1)) >> shift;
}

// The van der Corput sequence: phi_2(n) * 2^32, exact.
uint corput_van_der_corput(uint n) {
    return corput_reverse_bits(n);
}

// The lowest b.digits digits of `group` in reverse order.
uint corput_reverse_digits(uint group, CorputBase b) {
    uint reversed = 0u;
    for (uint i = 0u; i < b.digits; i++) {
        uint rest = corput_divide_by(group, b.base_magic, b.base_shift);
        reversed = reversed * b.base + (group - rest * b.base);
        group = rest;
    }
    return reversed;
}

// ceil((digits * 2^32 + y) / b.power), for digits < b.power.
uint corput_prepend_digits(uint digits, uint y, CorputBase b) {
    uvec2 up = corput_addc(y, b.power - 1u);
    uint high = ((digits + up.y) << 16) | (up.x >> 16);
    uint q = corput_divide_by(high, b.power_magic, b.power_shift);
    uint low = ((high - q * b.power) << 16) | (up.x & 0xffffu);
    return (q << 16) | corput_divide_by(low, b.power_magic, b.power_shift);
}

// ceil(2^32 phi_b(n)), with the constants of the base from a table.
uint corput_radical_inverse_table(uint n, CorputBase b) {
    // At most four groups: b.power > 256, since b.power * b.base > 65535.
    uint n1 = corput_divide_by(n, b.power_magic, b.power_shift);
    uint n2 = corput_divide_by(n1, b.power_magic, b.power_shift);
    uint n3 = corput_divide_by(n2, b.power_magic, b.power_shift);
    uint y = corput_prepend_digits(corput_reverse_digits(n3, b), 0u, b);
    y = corput_prepend_digits(corput_reverse_digits(n2 - n3 * b.power, b), y, b);
    y = corput_prepend_digits(corput_reverse_digits(n1 - n2 * b.power, b), y, b);
    return corput_prepend_digits(corput_reverse_digits(n - n1 * b.power, b), y, b);
}

// ceil(2^32 phi_b(n)) from the base alone, by the device's integer division; 0 for
// bases below 2 and above 65535.
uint corput_radical_inverse(uint n, uint base) {
    if (base == 2u) {
        return corput_van_der_corput(n);
    }
    // No base: 0 is what corput_prime gives past its table.
    if (base < 2u || base > 65535u) {
        return 0u;
    }
    uint power = base;
    while (power * base <= 65535u) {
        power *= base;
    }
    // Groups of digits from the lowest up, each reversed: group 3 is the highest.
    uvec4 group = uvec4(0u);
    for (uint i = 0u; i < 4u; i++) {
        uint rest = n / power;
        uint digits = n - rest * power;
        uint reversed = 0u;
        for (uint scale = 1u; scale < power; scale *= base) {
            uint q = digits / base;
            reversed = reversed * base + (digits - q * base);
            digits = q;
        }
        group = uvec4(group.yzw, reversed);
        n = rest;
    }
    uint y = 0u;
    for (uint i = 0u; i < 4u; i++) {
        uvec2 up = corput_addc(y, power - 1u);
        uint high = ((group.w + up.y) << 16) | (up.x >> 16);
        uint q = high / power;
        uint low = ((high - q * power) << 16) | (up.x & 0xffffu);
        y = (q << 16) | (low / power);
        group = uvec4(0u, group.xyz);
    }
    return y;
}

#endif
