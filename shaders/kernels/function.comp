#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
// One elementary function in the profile of the module, over a buffer of arguments or many
// times over.
#include "interface.glsl"
#include "repeat.glsl"
#ifdef KERNEL_NATIVE
#include "corput/native/normal_quantile.glsl"
#else
#include "corput/normal_quantile.glsl"
#endif

// A float of either sign from 2^-26 to 2^6, none more likely in one octave than in another.
float moderate(uint word) {
    return uintBitsToFloat((word & 0x807fffffu) | ((101u + ((word >> 23) & 31u)) << 23));
}

float positive(uint word) {
    return moderate(word & 0x7fffffffu);
}

#ifdef KERNEL_NATIVE
vec2 cos_sin(uint u) {
    float phi = 6.2831853 * corput_native_unit(u);
    return vec2(cos(phi), sin(phi));
}

uint turns(float y, float x) {
    return corput_native_fraction(corput_native_turns(vec2(x, y)));
}

#define EXACT_OR(exact, native) (native)
#else
vec2 cos_sin(uint u) {
    return corput_cos_sin(u);
}

uint turns(float y, float x) {
    return corput_atan2(y, x);
}

#define EXACT_OR(exact, native) (exact)
#endif

uint one(float x) {
    return floatBitsToUint(x);
}

uvec2 evaluate(uvec2 a) {
    float x = moderate(a.x);
    float y = moderate(a.y);
    float p = positive(a.x);
    switch (FUNCTION) {
    case 0u:
        return uvec2(one(EXACT_OR(corput_sqrt(p), sqrt(p))), 0u);
    case 1u:
        return uvec2(one(EXACT_OR(corput_divide(x, y), x / y)), 0u);
    case 2u:
        return uvec2(one(EXACT_OR(corput_multiply(x, y), x * y)), 0u);
    case 3u:
        return floatBitsToUint(cos_sin(a.x));
    case 4u:
        return uvec2(turns(y, x), 0u);
    case 5u:
        return uvec2(one(EXACT_OR(corput_log(p), log(p))), 0u);
    case 6u:
        return uvec2(one(EXACT_OR(corput_log2(p), log2(p))), 0u);
    case 7u:
        return uvec2(one(EXACT_OR(corput_negative_log(a.x), corput_native_negative_log(a.x))), 0u);
    case 8u:
        return uvec2(one(EXACT_OR(corput_exp(x), exp(x))), 0u);
    case 9u:
        return uvec2(one(EXACT_OR(corput_exp2(x), exp2(x))), 0u);
    default:
        return uvec2(one(EXACT_OR(corput_normal_quantile(a.x), corput_native_normal_quantile(a.x))), 0u);
    }
}

uvec4 repeated(uint i) {
    uvec3 u = repeat_first(i);
    uvec4 all = uvec4(0u);
    [[dont_unroll]] for (uint k = 0u; k < REPEATS; k++) {
        u = repeat_next(u);
        if (TASK == REPEAT) {
            all ^= uvec4(evaluate(u.xy), 0u, 0u);
        } else {
            all ^= uvec4(u.xy, 0u, 0u);
        }
    }
    return all;
}

void main() {
    uint i = kernel_invocation();
    if (i >= push.invocations) {
        return;
    }
    if (TASK >= REPEAT) {
        results[i] = repeated(i);
        return;
    }
    results[i] = uvec4(evaluate(arguments[i].xy), 0u, 0u);
}
