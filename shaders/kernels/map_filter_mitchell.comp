#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
// The filter of Mitchell and Netravali, of points in memory.
#include "interface.glsl"
#ifdef KERNEL_NATIVE
#include "corput/native/filter_mitchell.glsl"
#define MAP_FUNCTION(name) corput_native_##name
#define MAP_STRUCT(name) CorputNative##name
#else
#include "corput/filter_mitchell.glsl"
#define MAP_FUNCTION(name) corput_##name
#define MAP_STRUCT(name) Corput##name
#endif

const uint FILTER_MITCHELL = 104u;

// One for all tasks: compilers inline each call before they know which is asked for.
MAP_STRUCT(FilterMitchell) mitchell;

void prepare() {
    mitchell = MAP_FUNCTION(filter_mitchell_prepare)(uintBitsToFloat(push.p0), uintBitsToFloat(push.p1), uintBitsToFloat(push.p2));
#ifdef KERNEL_NATIVE
    // The host knows the shares exactly.
    mitchell.tail = push.p3;
    mitchell.lobe = push.p4;
#endif
}

uvec4 map_sample(uvec3 u) {
    if (MAP == FILTER_MITCHELL) {
        MAP_STRUCT(FilterSample) made = MAP_FUNCTION(filter_mitchell)(mitchell, u.xy);
        return floatBitsToUint(vec4(made.p, made.pdf, 0.0));
    }
    return uvec4(0u);
}

uint map_pdf(uvec4 s) {
    return floatBitsToUint(MAP_FUNCTION(filter_mitchell_pdf)(mitchell, uintBitsToFloat(s.xy)));
}

uvec3 map_invert(uvec4 s) {
    return uvec3(MAP_FUNCTION(filter_mitchell_invert)(mitchell, uintBitsToFloat(s.xy)), 0u);
}

// Four copies of so long a body take drivers seconds.
#define MAP_PREPARE prepare();
#define MAP_LOOP [[dont_unroll]]
#include "map_main.glsl"
