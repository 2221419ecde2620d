// Integrands that an environment map lights: the coordinates of a point, then the term. The
// head of the host's words is the map's width and height, and the axis.
#ifndef KERNEL_INTEGRAND_ENVIRONMENT_GLSL
#define KERNEL_INTEGRAND_ENVIRONMENT_GLSL

#include "integrand_point.glsl"
#define CORPUT_DISCRETE(i) tables[i]
#include "corput/irradiance.glsl"

const uint IRRADIANCE_UNIFORM = 64u;
const uint IRRADIANCE_COSINE = 65u;
const uint IRRADIANCE_ENVIRONMENT = 66u;
const uint IRRADIANCE_MIS = 67u;

CorputTerm integrand_term(Integrand state, uvec4 head, int scale) {
    uvec2 size = head.xy;
    uint axis = head.z;
    CorputReal real = corput_real_zero();
    if (INTEGRAND == IRRADIANCE_UNIFORM) {
        real = corput_irradiance_uniform(size, axis, state.point.xy);
    }
    if (INTEGRAND == IRRADIANCE_COSINE) {
        real = corput_irradiance_cosine(size, axis, state.point.xy);
    }
    if (INTEGRAND == IRRADIANCE_ENVIRONMENT) {
        real = corput_irradiance_environment(size, axis, state.point.xy);
    }
    if (INTEGRAND == IRRADIANCE_MIS) {
        real = corput_irradiance_mis(size, axis, state.point.xyz);
    }
    return corput_term(real, scale);
}

#endif
