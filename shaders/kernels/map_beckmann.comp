#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
// Normals of Beckmann and reflection at them, of points in memory.
#include "interface.glsl"
#ifdef KERNEL_NATIVE
#include "corput/native/beckmann.glsl"
#define MAP_FUNCTION(name) corput_native_##name
#define MAP_STRUCT(name) CorputNative##name
#else
#include "corput/beckmann.glsl"
#define MAP_FUNCTION(name) corput_##name
#define MAP_STRUCT(name) Corput##name
#endif

const uint BECKMANN_NORMAL = 69u;
const uint BECKMANN = 70u;

vec2 alpha() {
    return uintBitsToFloat(uvec2(push.p0, push.p1));
}

vec3 wo() {
    return uintBitsToFloat(uvec3(push.p2, push.p3, push.p4));
}

uvec4 map_sample(uvec3 u) {
    MAP_STRUCT(Scattered) made;
    if (MAP == BECKMANN_NORMAL) {
        made = MAP_FUNCTION(beckmann_normal)(alpha(), u.xy);
    } else {
        made = MAP_FUNCTION(beckmann)(alpha(), wo(), u.xy);
    }
    return floatBitsToUint(vec4(made.direction, made.pdf));
}

uint map_pdf(uvec4 s) {
    if (MAP == BECKMANN_NORMAL) {
        return floatBitsToUint(MAP_FUNCTION(beckmann_normal_pdf)(alpha(), uintBitsToFloat(s.xyz)));
    }
    return floatBitsToUint(MAP_FUNCTION(beckmann_pdf)(alpha(), wo(), uintBitsToFloat(s.xyz)));
}

uvec3 map_invert(uvec4 s) {
    if (MAP == BECKMANN_NORMAL) {
        return uvec3(MAP_FUNCTION(beckmann_normal_invert)(alpha(), uintBitsToFloat(s.xyz)), 0u);
    }
    return uvec3(MAP_FUNCTION(beckmann_invert)(alpha(), wo(), uintBitsToFloat(s.xyz)), 0u);
}

// Four copies of so long a body take drivers seconds.
#define MAP_LOOP [[dont_unroll]]
#include "map_main.glsl"
