#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
// The window of Blackman and Harris as a pixel filter, of points in memory.
#include "interface.glsl"
#ifdef KERNEL_NATIVE
#include "corput/native/filter_blackman_harris.glsl"
#define MAP_FUNCTION(name) corput_native_##name
#define MAP_STRUCT(name) CorputNative##name
#else
#include "corput/filter_blackman_harris.glsl"
#define MAP_FUNCTION(name) corput_##name
#define MAP_STRUCT(name) Corput##name
#endif

const uint FILTER_BLACKMAN_HARRIS = 103u;

float radius() {
    return uintBitsToFloat(push.p0);
}

uvec4 map_sample(uvec3 u) {
    if (MAP == FILTER_BLACKMAN_HARRIS) {
        MAP_STRUCT(FilterSample) made = MAP_FUNCTION(filter_blackman_harris)(radius(), u.xy);
        return floatBitsToUint(vec4(made.p, made.pdf, 0.0));
    }
    return uvec4(0u);
}

uint map_pdf(uvec4 s) {
    return floatBitsToUint(MAP_FUNCTION(filter_blackman_harris_pdf)(radius(), uintBitsToFloat(s.xy)));
}

uvec3 map_invert(uvec4 s) {
    return uvec3(MAP_FUNCTION(filter_blackman_harris_invert)(radius(), uintBitsToFloat(s.xy)), 0u);
}

// Four copies of so long a body take drivers seconds.
#define MAP_LOOP [[dont_unroll]]
#include "map_main.glsl"
