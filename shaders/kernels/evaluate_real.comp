#version 450
#extension GL_GOOGLE_include_directive : require
// One operation on reals over a buffer of arguments, or over indices.
#include "interface.glsl"
#include "corput/real_vector.glsl"

// A real of any significand, sign and exponent around `base`; 0 for 0.
CorputReal operand(uint m, uint word, int base) {
    CorputReal a = corput_real_uint(m, base - int(word & 63u));
    if ((word & 64u) != 0u) {
        return corput_real_negate(a);
    }
    return a;
}

// Significand; exponent and sign.
uvec2 words(CorputReal a) {
    return uvec2(a.m, (uint(a.e) << 1) | (a.negative ? 1u : 0u));
}

uvec4 evaluate(uvec4 a) {
    CorputReal p = operand(a.x, a.z, 0);
    CorputReal q = operand(a.y, a.z >> 8, 0);
    switch (FUNCTION) {
    case 0u:
        return uvec4(words(corput_real_add(p, q)), words(corput_real_subtract(p, q)));
    case 1u:
        return uvec4(words(corput_real_multiply(p, q)), words(corput_real_divide(p, q)));
    case 2u:
        return uvec4(words(corput_real_sqrt(p)), words(corput_real_square(p)));
    case 3u:
        return uvec4(words(corput_real_min(p, q)), words(corput_real_max(p, q)));
    case 4u:
        // All exponents of float and beyond.
        p = corput_real_shift(p, int(a.w % 320u) - 128);
        return uvec4(floatBitsToUint(corput_real_float(p)), corput_real_fraction(p),
            words(corput_real(uintBitsToFloat(a.w))));
    default:
        CorputReal3 v = corput_real3(uintBitsToFloat(a.xyz & 0xbfffffffu));
        CorputReal3 w = corput_real3_cross(corput_real3_add(v, CorputReal3(p, q, p)), v);
        vec3 d = corput_real3_floats(corput_real3_normalize(corput_real3_subtract(w, corput_real3_scale(v, q))));
        return uvec4(floatBitsToUint(d), 0u);
    }
}

void main() {
    uint i = kernel_invocation();
    if (i >= push.invocations) {
        return;
    }
    uint n = push.first + i * push.stride;
    results[i] = evaluate(INDEXED != 0u ? uvec4(n) : arguments[i]);
}
