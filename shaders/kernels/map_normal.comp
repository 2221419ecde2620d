#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
// Two normal distributions, of points in memory.
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

const uint NORMAL_PAIR = 98u;
const uint BOX_MULLER = 99u;

float sigma() {
    return uintBitsToFloat(push.p0);
}

uvec4 map_sample(uvec3 u) {
    MAP_STRUCT(GaussianPair) made;
    if (MAP == NORMAL_PAIR) {
        made = MAP_FUNCTION(normal_pair)(sigma(), u.xy);
    } else {
        made = MAP_FUNCTION(box_muller)(sigma(), u.xy);
    }
    return floatBitsToUint(vec4(made.p, made.pdf, 0.0));
}

uint map_pdf(uvec4 s) {
    return floatBitsToUint(MAP_FUNCTION(normal_pair_pdf)(sigma(), uintBitsToFloat(s.xy)));
}

uvec3 map_invert(uvec4 s) {
    if (MAP == NORMAL_PAIR) {
        return uvec3(MAP_FUNCTION(normal_pair_invert)(sigma(), uintBitsToFloat(s.xy)), 0u);
    }
    return uvec3(MAP_FUNCTION(box_muller_invert)(sigma(), uintBitsToFloat(s.xy)), 0u);
}

// Four copies of so long a body take drivers seconds.
#define MAP_LOOP [[dont_unroll]]
#include "map_main.glsl"
