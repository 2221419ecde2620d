#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
// Phase functions, of points in memory.
#include "interface.glsl"
#ifdef KERNEL_NATIVE
#include "corput/native/henyey_greenstein.glsl"
#define MAP_FUNCTION(name) corput_native_##name
#define MAP_STRUCT(name) CorputNative##name
#else
#include "corput/henyey_greenstein.glsl"
#define MAP_FUNCTION(name) corput_##name
#define MAP_STRUCT(name) Corput##name
#endif

const uint HENYEY_GREENSTEIN = 64u;

MAP_STRUCT(HenyeyGreenstein) phase() {
    return MAP_FUNCTION(henyey_greenstein_complement)(uintBitsToFloat(push.p0), push.p1 != 0u);
}

uvec4 map_sample(uvec3 u) {
    if (MAP == HENYEY_GREENSTEIN) {
        MAP_STRUCT(Scattered) made = MAP_FUNCTION(henyey_greenstein)(phase(), u.xy);
        return floatBitsToUint(vec4(made.direction, made.pdf));
    }
    return uvec4(0u);
}

uint map_pdf(uvec4 s) {
    if (MAP == HENYEY_GREENSTEIN) {
        return floatBitsToUint(MAP_FUNCTION(henyey_greenstein_pdf)(phase(), uintBitsToFloat(s.xyz)));
    }
    return 0u;
}

uvec3 map_invert(uvec4 s) {
    if (MAP == HENYEY_GREENSTEIN) {
        return uvec3(MAP_FUNCTION(henyey_greenstein_invert)(phase(), uintBitsToFloat(s.xyz)), 0u);
    }
    return uvec3(0u);
}

// Four copies of so long a body take drivers seconds.
#define MAP_LOOP [[dont_unroll]]
#include "map_main.glsl"
