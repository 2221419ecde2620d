#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
// Powers of the cosine, of points in memory.
#include "interface.glsl"
#ifdef KERNEL_NATIVE
#include "corput/native/cosine_power.glsl"
#define MAP_FUNCTION(name) corput_native_##name
#define MAP_STRUCT(name) CorputNative##name
#else
#include "corput/cosine_power.glsl"
#define MAP_FUNCTION(name) corput_##name
#define MAP_STRUCT(name) Corput##name
#endif

const uint COSINE_POWER_HEMISPHERE = 38u;

// One for all tasks: compilers inline each call before they know which is asked for.
MAP_STRUCT(CosinePower) lobe;

uvec4 map_sample(uvec3 u) {
    if (MAP == COSINE_POWER_HEMISPHERE) {
        MAP_STRUCT(Scattered) made = MAP_FUNCTION(cosine_power)(lobe, u.xy);
        return floatBitsToUint(vec4(made.direction, made.pdf));
    }
    return uvec4(0u);
}

uint map_pdf(uvec4 s) {
    return floatBitsToUint(MAP_FUNCTION(cosine_power_pdf)(lobe, uintBitsToFloat(s.xyz)));
}

uvec3 map_invert(uvec4 s) {
    return uvec3(MAP_FUNCTION(cosine_power_invert)(lobe, uintBitsToFloat(s.xyz)), 0u);
}

// Four copies of so long a body take drivers seconds.
#define MAP_PREPARE lobe = MAP_FUNCTION(cosine_power_prepare)(uintBitsToFloat(push.p0));
#define MAP_LOOP [[dont_unroll]]
#include "map_main.glsl"
