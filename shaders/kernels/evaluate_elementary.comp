#version 450
#extension GL_GOOGLE_include_directive : require
// One elementary function over a buffer of arguments, or over indices.
#include "interface.glsl"
#include "corput/normal_quantile.glsl"

// Significand; exponent and sign.
uvec2 words(CorputReal a) {
    return uvec2(a.m, (uint(a.e) << 1) | (a.negative ? 1u : 0u));
}

uint bits(float x) {
    return floatBitsToUint(x);
}

// A float between 2^-24 and 2^8 in magnitude.
float moderate(uint word) {
    return uintBitsToFloat((word & 0x807fffffu) | ((103u + ((word >> 23) & 31u)) << 23));
}

uvec4 evaluate(uvec4 a) {
    float x = uintBitsToFloat(a.x);
    CorputReal p;
    CorputReal q;
    switch (FUNCTION) {
    case 0u:
        return uvec4(bits(corput_negative_log(a.x)), words(corput_real_negative_log(a.x)), 0u);
    case 1u:
        return uvec4(bits(corput_log(x)), bits(corput_log2(x)), words(corput_real_log(corput_real(x))));
    case 2u:
        p = corput_real(moderate(a.y));
        return uvec4(bits(corput_exp2(x)), bits(corput_exp2(moderate(a.y))), bits(corput_exp(moderate(a.y))),
            bits(corput_real_float(corput_real_gaussian(p))));
    case 3u:
        // A base up to 1, and any exponent.
        p = corput_real_uint(a.x, -32);
        q = corput_real(uintBitsToFloat(a.y & 0x7fffffffu));
        return uvec4(words(corput_real_power(p, q)), words(corput_real_power_complement(p, q)));
    case 4u:
        return uvec4(bits(corput_normal_quantile(a.x)), bits(corput_inverse_erf(a.x)),
            corput_normal_fraction(corput_real_normal_quantile(a.x)), 0u);
    default:
        p = corput_real(x);
        q = corput_real(moderate(a.y));
        return uvec4(words(corput_real_normal_masses(q).tail), bits(corput_real_float(corput_real_normal_density(q))),
            corput_normal_fraction(p));
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
