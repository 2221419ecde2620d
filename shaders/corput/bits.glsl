// what:   bit operations that the other headers build on.
// source: core GLSL 4.00 and ESSL 3.10; no precision is involved.
// domain: any uint.
// cost:   one instruction each on most devices.
// hooks:  none.
// mirror: src/reference/bits.rs
#ifndef CORPUT_BITS_GLSL
#define CORPUT_BITS_GLSL

// Position of the highest set bit, 0 to 31; 0xffffffff for x = 0.
uint corput_find_msb(uint x) {
    // naga accepts findMSB(uint) only inside a uint().
    return uint(findMSB(x));
}

// The bits of x in reverse order: bit i goes to bit 31 - i.
uint corput_reverse_bits(uint x) {
    return bitfieldReverse(x);
}

#endif
