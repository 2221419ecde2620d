#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
// Directions by the light of an environment map, of points in memory. The tables lie in two
// buffers, since one holds 2^25 words on every device and a map of 8192 x 4096 has more.
#include "interface.glsl"

// Words of the first.
const uint TABLE_WORDS = 0x2000000u;

// Without branches, of which some drivers make a copy of all that follows.
uint table_word(uint i) {
    uint more = 0u - min(i / TABLE_WORDS, 1u);
    uint low = tables[i & ~more];
    uint high = more_tables[(i - TABLE_WORDS) & more];
    return (low & ~more) | (high & more);
}
#define CORPUT_DISCRETE(i) table_word(i)
#ifdef KERNEL_NATIVE
#include "corput/native/environment.glsl"
#define MAP_FUNCTION(name) corput_native_##name
#else
#include "corput/environment.glsl"
#define MAP_FUNCTION(name) corput_##name
#endif

const uint ENVIRONMENT = 128u;
const uint ENVIRONMENT_ALIAS = 129u;

uvec2 map_size() {
    return uvec2(push.p0, push.p1);
}

uvec4 map_sample(uvec3 u) {
    if (MAP == ENVIRONMENT) {
        CorputEnvironment s = MAP_FUNCTION(environment)(map_size(), u.xy);
        return floatBitsToUint(vec4(s.direction, s.pdf));
    }
    if (MAP == ENVIRONMENT_ALIAS) {
        CorputEnvironment s = MAP_FUNCTION(environment_alias)(map_size(), u);
        return floatBitsToUint(vec4(s.direction, s.pdf));
    }
    return uvec4(0u);
}

uint map_pdf(uvec4 s) {
    vec3 d = uintBitsToFloat(s.xyz);
    if (MAP == ENVIRONMENT) {
        return floatBitsToUint(MAP_FUNCTION(environment_pdf)(map_size(), d));
    }
    if (MAP == ENVIRONMENT_ALIAS) {
        return floatBitsToUint(MAP_FUNCTION(environment_alias_pdf)(map_size(), d));
    }
    return 0u;
}

// An alias table has no inverse.
uvec3 map_invert(uvec4 s) {
    if (MAP == ENVIRONMENT) {
        return uvec3(MAP_FUNCTION(environment_invert)(map_size(), uintBitsToFloat(s.xyz)), 0u);
    }
    return uvec3(0u);
}

// Unrolled, long bodies take compilers minutes.
#define MAP_LOOP [[dont_unroll]]
#include "map_main.glsl"
