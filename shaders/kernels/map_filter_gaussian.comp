#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
// The truncated Gaussian as a pixel filter, of points in memory.
#include "interface.glsl"
#ifdef KERNEL_NATIVE
#include "corput/native/filter.glsl"
#define MAP_FUNCTION(name) corput_native_##name
#define MAP_STRUCT(name) CorputNative##name
#else
#include "corput/filter.glsl"
#define MAP_FUNCTION(name) corput_##name
#define MAP_STRUCT(name) Corput##name
#endif

const uint FILTER_GAUSSIAN = 102u;

// One for all tasks: compilers inline each call before they know which is asked for.
MAP_STRUCT(FilterGaussian) gaussian;

uvec4 map_sample(uvec3 u) {
    if (MAP == FILTER_GAUSSIAN) {
        MAP_STRUCT(FilterSample) made = MAP_FUNCTION(filter_gaussian)(gaussian, u.xy);
        return floatBitsToUint(vec4(made.p, made.pdf, 0.0));
    }
    return uvec4(0u);
}

uint map_pdf(uvec4 s) {
    return floatBitsToUint(MAP_FUNCTION(filter_gaussian_pdf)(gaussian, uintBitsToFloat(s.xy)));
}

uvec3 map_invert(uvec4 s) {
    return uvec3(MAP_FUNCTION(filter_gaussian_invert)(gaussian, uintBitsToFloat(s.xy)), 0u);
}

// Four copies of so long a body take drivers seconds.
#define MAP_PREPARE gaussian = MAP_FUNCTION(filter_gaussian_prepare)(uintBitsToFloat(push.p0), uintBitsToFloat(push.p1));
#define MAP_LOOP [[dont_unroll]]
#include "map_main.glsl"
