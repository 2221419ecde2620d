#version 450
#extension GL_GOOGLE_include_directive : require
// Uniform directions of solid angles, of points in memory.
#include "interface.glsl"
#ifdef KERNEL_NATIVE
#include "corput/native/cone.glsl"
#define MAP_FUNCTION(name) corput_native_##name
#else
#include "corput/cone.glsl"
#define MAP_FUNCTION(name) corput_##name
#endif

const uint UNIFORM_SPHERE = 32u;
const uint CONE = 33u;

// The bits of a direction, and of its pdf.
uvec4 words(vec3 d, float pdf) {
    return floatBitsToUint(vec4(d, pdf));
}

uvec4 map_sample(uvec3 u) {
    if (MAP == UNIFORM_SPHERE) {
        return words(MAP_FUNCTION(uniform_sphere)(u.xy), MAP_FUNCTION(uniform_sphere_pdf)());
    }
    if (MAP == CONE) {
        float h = uintBitsToFloat(push.p0);
        vec3 d = MAP_FUNCTION(cone)(h, u.xy);
        return words(d, WITH_PDF != 0u ? MAP_FUNCTION(cone_pdf)(h, d) : 0.0);
    }
    return uvec4(0u);
}

uint map_pdf(uvec4 s) {
    vec3 d = uintBitsToFloat(s.xyz);
    if (MAP == UNIFORM_SPHERE) {
        return floatBitsToUint(MAP_FUNCTION(uniform_sphere_pdf)());
    }
    if (MAP == CONE) {
        return floatBitsToUint(MAP_FUNCTION(cone_pdf)(uintBitsToFloat(push.p0), d));
    }
    return 0u;
}

uvec3 map_invert(uvec4 s) {
    vec3 d = uintBitsToFloat(s.xyz);
    if (MAP == UNIFORM_SPHERE) {
        return uvec3(MAP_FUNCTION(uniform_sphere_invert)(d), 0u);
    }
    if (MAP == CONE) {
        return uvec3(MAP_FUNCTION(cone_invert)(uintBitsToFloat(push.p0), d), 0u);
    }
    return uvec3(0u);
}

#include "map_main.glsl"
