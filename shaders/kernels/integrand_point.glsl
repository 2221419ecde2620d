// What integrands of up to four coordinates keep of a point: the coordinates.
#ifndef KERNEL_INTEGRAND_POINT_GLSL
#define KERNEL_INTEGRAND_POINT_GLSL

#include "corput/sum.glsl"

struct Integrand {
    uvec4 point;
};

Integrand integrand_start(uvec4 head) {
    return Integrand(uvec4(0u));
}

Integrand integrand_step(Integrand state, uint dimension, uint u, uvec4 head, uvec4 c) {
    uvec4 mask = uvec4(0u) - uvec4(equal(uvec4(0u, 1u, 2u, 3u), uvec4(dimension)));
    return Integrand(state.point | (mask & uvec4(u)));
}

#endif
