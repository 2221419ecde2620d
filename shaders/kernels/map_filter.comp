#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
// Pixel filters of polynomials, of points in memory.
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

const uint FILTER_BOX = 100u;
const uint FILTER_TENT = 101u;

float radius() {
    return uintBitsToFloat(push.p0);
}

uvec4 map_sample(uvec3 u) {
    MAP_STRUCT(FilterSample) made;
    if (MAP == FILTER_BOX) {
        made = MAP_FUNCTION(filter_box)(radius(), u.xy);
    } else {
        made = MAP_FUNCTION(filter_tent)(radius(), u.xy);
    }
    return floatBitsToUint(vec4(made.p, made.pdf, 0.0));
}

uint map_pdf(uvec4 s) {
    if (MAP == FILTER_BOX) {
        return floatBitsToUint(MAP_FUNCTION(filter_box_pdf)(radius(), uintBitsToFloat(s.xy)));
    }
    return floatBitsToUint(MAP_FUNCTION(filter_tent_pdf)(radius(), uintBitsToFloat(s.xy)));
}

uvec3 map_invert(uvec4 s) {
    if (MAP == FILTER_BOX) {
        return uvec3(MAP_FUNCTION(filter_box_invert)(radius(), uintBitsToFloat(s.xy)), 0u);
    }
    return uvec3(MAP_FUNCTION(filter_tent_invert)(radius(), uintBitsToFloat(s.xy)), 0u);
}

// Four copies of so long a body take drivers seconds.
#define MAP_LOOP [[dont_unroll]]
#include "map_main.glsl"
