// The integrands: a point's coordinates one after the other, then the term. INTEGRAND says
// which; the host's words for it are a head of four, and four for each dimension. Whoever
// calls loads them, as seldom as may be: some drivers load for each lane by itself.
#ifndef KERNEL_INTEGRAND_GLSL
#define KERNEL_INTEGRAND_GLSL

#include "corput/genz.glsl"
#include "corput/keister.glsl"

const uint X_SQUARED = 0u;
const uint OFFSET = 1u;
const uint INVERSE_ROOT = 2u;
const uint DISK_STEP = 3u;
const uint CHECKERBOARD = 4u;
const uint ISHIGAMI = 5u;
const uint OSCILLATORY = 6u;
const uint PRODUCT_PEAK = 7u;
const uint CORNER_PEAK = 8u;
const uint GAUSSIAN = 9u;
const uint CONTINUOUS = 10u;
const uint DISCONTINUOUS = 11u;
const uint SOBOL_G = 12u;
const uint PEAK_UNIFORM = 13u;
const uint PEAK_NORMAL = 14u;
const uint KEISTER = 15u;
const uint SQUARE_OF_SUM = 16u;
const uint PRODUCT = 17u;

// What the coordinates so far come to: a sum or product of reals, or a word; and the first
// three of them.
struct Integrand {
    CorputReal real;
    uint word;
    uvec3 point;
};

// A positive real of two words.
CorputReal integrand_real(uvec2 words) {
    return corput_real_or_zero(words.x, int(words.y), false);
}

Integrand integrand_start(uvec4 head) {
    Integrand state = Integrand(corput_real_zero(), 0u, uvec3(0u));
    if (INTEGRAND == OSCILLATORY) {
        state.word = head.x;
    }
    if (INTEGRAND == PRODUCT_PEAK || INTEGRAND == SOBOL_G || INTEGRAND == PRODUCT) {
        state.real = corput_real_uint(1u, 0);
    }
    return state;
}

// With one coordinate more; c are the words of its dimension.
Integrand integrand_step(Integrand state, uint dimension, uint u, uvec4 head, uvec4 c) {
    Integrand next = state;
    if (INTEGRAND == X_SQUARED || INTEGRAND == OFFSET || INTEGRAND == INVERSE_ROOT
        || INTEGRAND == DISK_STEP || INTEGRAND == ISHIGAMI) {
        if (dimension == 0u) {
            next.point.x = u;
        }
        if (dimension == 1u) {
            next.point.y = u;
        }
        if (dimension == 2u) {
            next.point.z = u;
        }
    }
    if (INTEGRAND == CHECKERBOARD) {
        next.word = state.word ^ corput_checkerboard_cell(u, head.x);
    }
    if (INTEGRAND == OSCILLATORY) {
        next.word = corput_genz_phase(state.word, u, c.xy);
    }
    if (INTEGRAND == PRODUCT_PEAK) {
        next.real = corput_genz_peak(state.real, u, c.z, integrand_real(c.xy));
    }
    if (INTEGRAND == CORNER_PEAK || INTEGRAND == DISCONTINUOUS) {
        next.real = corput_genz_linear(state.real, u, integrand_real(c.xy));
    }
    if (INTEGRAND == DISCONTINUOUS) {
        next.word = state.word | uint(u > c.z);
    }
    if (INTEGRAND == GAUSSIAN || INTEGRAND == PEAK_UNIFORM) {
        next.real = corput_genz_square(state.real, u, c.z, integrand_real(c.xy));
    }
    if (INTEGRAND == CONTINUOUS) {
        next.real = corput_genz_kink(state.real, u, c.z, integrand_real(c.xy));
    }
    if (INTEGRAND == SOBOL_G) {
        next.real = corput_sobol_g(state.real, u, integrand_real(c.xy), integrand_real(c.zw));
    }
    if (INTEGRAND == PRODUCT) {
        next.real = corput_linear_factor(state.real, u, integrand_real(c.xy), integrand_real(c.zw));
    }
    if (INTEGRAND == SQUARE_OF_SUM) {
        next.real = corput_real_add(state.real, corput_real_uint(u, -32));
    }
    if (INTEGRAND == PEAK_NORMAL) {
        next.word = state.word | corput_peak_outside(u, c.z, integrand_real(c.xy));
    }
    if (INTEGRAND == KEISTER) {
        next.real = corput_keister_square(state.real, u);
    }
    return next;
}

CorputTerm integrand_term(Integrand state, uvec4 head, int scale) {
    CorputTerm term = CorputTerm(uvec2(0u), false);
    CorputReal real = state.real;
    if (INTEGRAND == X_SQUARED) {
        term = corput_x_squared(state.point.x);
    }
    if (INTEGRAND == OFFSET) {
        term = corput_offset_fraction(state.point.x, head.x);
    }
    if (INTEGRAND == DISK_STEP) {
        term = corput_indicator(corput_disk_step(state.point.xy));
    }
    if (INTEGRAND == CHECKERBOARD) {
        term = corput_indicator((state.word & 1u) == 0u);
    }
    if (INTEGRAND == INVERSE_ROOT) {
        real = corput_inverse_root(state.point.x);
    }
    if (INTEGRAND == ISHIGAMI) {
        real = corput_ishigami(state.point, integrand_real(head.xy), integrand_real(head.zw));
    }
    if (INTEGRAND == OSCILLATORY) {
        real = corput_genz_oscillation(state.word);
    }
    if (INTEGRAND == CORNER_PEAK) {
        real = corput_genz_corner(state.real, DIMENSIONS);
    }
    if (INTEGRAND == GAUSSIAN || INTEGRAND == CONTINUOUS || INTEGRAND == PEAK_UNIFORM) {
        real = corput_real_exp(corput_real_negate(state.real));
    }
    if (INTEGRAND == DISCONTINUOUS) {
        real = corput_real_exp(state.real);
        if (state.word != 0u) {
            real = corput_real_zero();
        }
    }
    if (INTEGRAND == SQUARE_OF_SUM) {
        real = corput_real_square(state.real);
    }
    if (INTEGRAND == PEAK_NORMAL) {
        real = integrand_real(head.xy);
        if (state.word != 0u) {
            real = corput_real_zero();
        }
    }
    if (INTEGRAND == KEISTER) {
        real = corput_real_multiply(integrand_real(head.xy), corput_keister_cosine(state.real));
    }
    if (INTEGRAND == INVERSE_ROOT || INTEGRAND >= ISHIGAMI) {
        term = corput_term(real, scale);
    }
    return term;
}

#endif
