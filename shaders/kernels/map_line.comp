#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
// Free flight, and one normal distribution, of points in memory.
#include "interface.glsl"
#ifdef KERNEL_NATIVE
#include "corput/native/gaussian.glsl"
#define MAP_FUNCTION(name) corput_native_##name
#define MAP_STRUCT(name) CorputNative##name
#else
#include "corput/gaussian.glsl"
#define MAP_FUNCTION(name) corput_##name
#define MAP_STRUCT(name) Corput##name
#endif

const uint EXPONENTIAL = 96u;
const uint GAUSSIAN = 97u;

float sigma() {
    return uintBitsToFloat(push.p0);
}

uvec4 map_sample(uvec3 u) {
    if (MAP == EXPONENTIAL) {
        MAP_STRUCT(FreeFlight) flight = MAP_FUNCTION(exponential)(sigma(), u.x);
        return floatBitsToUint(vec4(flight.t, flight.pdf, 0.0, 0.0));
    }
    if (MAP == GAUSSIAN) {
        MAP_STRUCT(Gaussian) made = MAP_FUNCTION(gaussian)(sigma(), u.x);
        return floatBitsToUint(vec4(made.x, made.pdf, 0.0, 0.0));
    }
    return uvec4(0u);
}

uint map_pdf(uvec4 s) {
    if (MAP == EXPONENTIAL) {
        return floatBitsToUint(MAP_FUNCTION(exponential_pdf)(sigma(), uintBitsToFloat(s.x)));
    }
    return floatBitsToUint(MAP_FUNCTION(gaussian_pdf)(sigma(), uintBitsToFloat(s.x)));
}

uvec3 map_invert(uvec4 s) {
    if (MAP == EXPONENTIAL) {
        return uvec3(MAP_FUNCTION(exponential_invert)(sigma(), uintBitsToFloat(s.x)), 0u, 0u);
    }
    return uvec3(MAP_FUNCTION(gaussian_invert)(sigma(), uintBitsToFloat(s.x)), 0u, 0u);
}

// Four copies of so long a body take drivers seconds.
#define MAP_LOOP [[dont_unroll]]
#include "map_main.glsl"
