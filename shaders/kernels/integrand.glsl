// The integrands: a point's coordinates one after the other, then the term. INTEGRAND says
// which; the host's words for it are a head of four, and four for each dimension.
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

// What the coordinates so far come to: a sum or product of reals, or a word; and the first
// three of them.
struct Integrand {
    CorputReal real;
    uint word;
    uvec3 point;
};

// A positive real of two words.
CorputReal integrand_real(uint at) {
    return corput_real_or_zero(coefficients[at], int(coefficients[at + 1u]), false);
}

Integrand integrand_start() {
    Integrand state = Integrand(corput_real_zero(), 0u, uvec3(0u));
    if (INTEGRAND == OSCILLATORY) {
        state.word = coefficients[0];
    }
    if (INTEGRAND == PRODUCT_PEAK || INTEGRAND == SOBOL_G) {
        state.real = corput_real_uint(1u, 0);
    }
    return state;
}

Integrand integrand_step(Integrand state, uint dimension, uint u) {
    uint at = 4u + 4u * dimension;
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
        next.word = state.word ^ corput_checkerboard_cell(u, coefficients[0]);
    }
    if (INTEGRAND == OSCILLATORY) {
        next.word = corput_genz_phase(state.word, u, uvec2(coefficients[at], coefficients[at + 1u]));
    }
    if (INTEGRAND == PRODUCT_PEAK) {
        next.real = corput_genz_peak(state.real, u, coefficients[at + 2u], integrand_real(at));
    }
    if (INTEGRAND == CORNER_PEAK || INTEGRAND == DISCONTINUOUS) {
        next.real = corput_genz_linear(state.real, u, integrand_real(at));
    }
    if (INTEGRAND == DISCONTINUOUS) {
        next.word = state.word | uint(u > coefficients[at + 2u]);
    }
    if (INTEGRAND == GAUSSIAN || INTEGRAND == PEAK_UNIFORM) {
        next.real = corput_genz_square(state.real, u, coefficients[at + 2u], integrand_real(at));
    }
    if (INTEGRAND == CONTINUOUS) {
        next.real = corput_genz_kink(state.real, u, coefficients[at + 2u], integrand_real(at));
    }
    if (INTEGRAND == SOBOL_G) {
        next.real = corput_sobol_g(state.real, u, integrand_real(at), integrand_real(at + 2u));
    }
    if (INTEGRAND == PEAK_NORMAL) {
        next.word = state.word | corput_peak_outside(u, coefficients[at + 2u], integrand_real(at));
    }
    if (INTEGRAND == KEISTER) {
        next.real = corput_keister_square(state.real, u);
    }
    return next;
}

CorputTerm integrand_term(Integrand state, int scale) {
    CorputTerm term = CorputTerm(uvec2(0u), false);
    CorputReal real = state.real;
    if (INTEGRAND == X_SQUARED) {
        term = corput_x_squared(state.point.x);
    }
    if (INTEGRAND == OFFSET) {
        term = corput_offset_fraction(state.point.x, coefficients[0]);
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
        real = corput_ishigami(state.point, integrand_real(0u), integrand_real(2u));
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
    if (INTEGRAND == PEAK_NORMAL) {
        real = integrand_real(0u);
        if (state.word != 0u) {
            real = corput_real_zero();
        }
    }
    if (INTEGRAND == KEISTER) {
        real = corput_real_multiply(integrand_real(0u), corput_keister_cosine(state.real));
    }
    if (INTEGRAND == INVERSE_ROOT || INTEGRAND >= ISHIGAMI) {
        term = corput_term(real, scale);
    }
    return term;
}

#endif
