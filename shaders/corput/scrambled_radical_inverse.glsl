// what:   radical inverses with permuted digits: Faure's permutations, random permutations
//         of each digit, nested (Owen) scrambling, and a random start.
// source: Faure 1992, Good permutations for extreme discrepancy, J. Number Theory 42;
//         Owen 1995, Randomly permuted (t,m,s)-nets and (t,s)-sequences; Wang and Hickernell
//         2000, Randomized Halton sequences, Math. Comput. Modelling 32. Nested division as
//         in corput/radical_inverse.glsl.
// domain: every n; bases 2 to 65535; other bases give 0.
// range:  fractions of 2^32. Faure keeps zeros, so his inverse has the digits of n and is
//         ceil(2^32 x), at most 2^32 - 1: exact in its b-adic cells for n below the largest
//         b^m <= 2^32. The others have D digits, a whole number of groups, b^D >= 2^32, and
//         are floor(2^32 x): of b^k cells, a point may leave its own over the lower edge
//         with probability below b^k 2^-32.
// cost:   45 digits in base 2, 30 in base 3, 12 in base 11, 9 in base 17: about 15
//         instructions each, and a permutation of `base` elements besides (Faure's: 16 per
//         bit of the base; a random start has none).
// hooks:  none.
// mirror: src/reference/scrambled_radical_inverse.rs
#ifndef CORPUT_SCRAMBLED_RADICAL_INVERSE_GLSL
#define CORPUT_SCRAMBLED_RADICAL_INVERSE_GLSL

#include "corput/permute.glsl"

const uint CORPUT_SCRAMBLE_FAURE = 0u;
const uint CORPUT_SCRAMBLE_PERMUTED = 1u;
const uint CORPUT_SCRAMBLE_OWEN = 2u;
const uint CORPUT_SCRAMBLE_STARTED = 3u;

// Faure's permutation of a digit: for even b that of b/2 doubled, then the same plus 1; for
// odd b that of b - 1 around the middle (b - 1)/2, which stays. So the bases are b >> i.
uint corput_faure_digit(uint digit, uint base) {
    // Bit i: the digit is in the upper half at base b >> i.
    uint upper = 0u;
    uint level = 0u;
    uint value = 0u;
    bool below = base > 1u;
    while (below) {
        uint b = base >> level;
        uint middle = b >> 1;
        if ((b & 1u) != 0u && digit == middle) {
            value = middle;
            below = false;
        } else {
            if (digit >= middle) {
                digit -= middle + (b & 1u);
                upper |= 1u << level;
            }
            level += 1u;
            below = (b >> 1) > 1u;
        }
    }
    while (level > 0u) {
        level -= 1u;
        uint b = base >> level;
        value = 2u * value + ((upper >> level) & 1u);
        value += (b & 1u) != 0u && value >= (b >> 1) ? 1u : 0u;
    }
    return value;
}

// The radical inverse with digits scrambled in one of the four ways. Each way wants a seed of
// its own: with the same one they share permutations, such as that of the first digit.
uint corput_radical_inverse_scrambled(uint n, uint base, uint seed, uint scramble) {
    // No base: 0 is what corput_prime gives past its table.
    if (base < 2u || base > 65535u) {
        return 0u;
    }
    uint power = base;
    while (power * base <= 65535u) {
        power *= base;
    }
    // 1626^3 is the least cube from 2^32 on; four groups always do, for power > 255.
    uint groups = power < 1626u ? 4u : 3u;
    // Each base has keys of its own, so that dimensions may share a seed.
    uint stream = corput_permute_mix(corput_permute_key(seed, base));
    uint position = 0u;
    uint prefix = 0u;
    uint weight = 1u;
    uint carry = 0u;
    // Groups of digits from the lowest up, each reversed: the last is the highest.
    uvec4 group = uvec4(0u);
    for (uint i = 0u; i < groups; i++) {
        uint reversed = 0u;
        for (uint scale = 1u; scale < power; scale *= base) {
            uint rest = n / base;
            uint digit = n - rest * base;
            uint key = corput_permute_mix(stream + position * 0x9e3779b9u);
            uint scrambled;
            if (scramble == CORPUT_SCRAMBLE_FAURE) {
                scrambled = corput_faure_digit(digit, base);
            } else if (scramble == CORPUT_SCRAMBLE_STARTED) {
                scrambled = digit + corput_mulhi(key, base) + carry;
                carry = scrambled >= base ? 1u : 0u;
                scrambled -= carry * base;
            } else {
                uint node = scramble == CORPUT_SCRAMBLE_OWEN ? corput_permute_mix(prefix) : 0u;
                scrambled = corput_permute(digit, base, key ^ node);
            }
            reversed = reversed * base + scrambled;
            // The weight may wrap only past the last digit of n that is not 0.
            prefix += digit * weight;
            weight *= base;
            position += 1u;
            n = rest;
        }
        group = uvec4(group.yzw, reversed);
    }
    uint up = scramble == CORPUT_SCRAMBLE_FAURE ? power - 1u : 0u;
    uint y = 0u;
    for (uint i = 0u; i < groups; i++) {
        uvec2 low = corput_addc(y, up);
        // ceil may reach 2^32 where n is above the largest power of the base.
        if (group.w + low.y >= power) {
            return 0xffffffffu;
        }
        uint high = ((group.w + low.y) << 16) | (low.x >> 16);
        uint q = high / power;
        y = (q << 16) | ((((high - q * power) << 16) | (low.x & 0xffffu)) / power);
        group = uvec4(0u, group.xyz);
    }
    return y;
}

// With Faure's permutation of every digit: no seed.
uint corput_radical_inverse_faure(uint n, uint base) {
    return corput_radical_inverse_scrambled(n, base, 0u, CORPUT_SCRAMBLE_FAURE);
}

// With one random permutation per position of a digit.
uint corput_radical_inverse_permuted(uint n, uint base, uint seed) {
    return corput_radical_inverse_scrambled(n, base, seed, CORPUT_SCRAMBLE_PERMUTED);
}

// With a random permutation per position and digits before it: nested uniform scrambling.
uint corput_radical_inverse_owen(uint n, uint base, uint seed) {
    return corput_radical_inverse_scrambled(n, base, seed, CORPUT_SCRAMBLE_OWEN);
}

// Of n steps of the odometer from a random point, whose D digits are added with carry.
uint corput_radical_inverse_started(uint n, uint base, uint seed) {
    return corput_radical_inverse_scrambled(n, base, seed, CORPUT_SCRAMBLE_STARTED);
}

#endif
