#version 450
#extension GL_GOOGLE_include_directive : require
// Scattering distributions, of points in memory.
#include "interface.glsl"
#ifdef KERNEL_NATIVE
#include "corput/native/beckmann.glsl"
#include "corput/native/ggx_vndf.glsl"
#include "corput/native/ggx_vndf_bounded.glsl"
#include "corput/native/henyey_greenstein.glsl"
#define MAP_FUNCTION(name) corput_native_##name
#define MAP_STRUCT(name) CorputNative##name
#else
#include "corput/beckmann.glsl"
#include "corput/ggx_vndf.glsl"
#include "corput/ggx_vndf_bounded.glsl"
#include "corput/henyey_greenstein.glsl"
#define MAP_FUNCTION(name) corput_##name
#define MAP_STRUCT(name) Corput##name
#endif

const uint HENYEY_GREENSTEIN = 64u;
const uint GGX_VNDF = 65u;
const uint GGX_VNDF_NORMAL = 66u;
const uint GGX_VNDF_CAP = 67u;
const uint GGX_VNDF_BOUNDED = 68u;
const uint BECKMANN_NORMAL = 69u;
const uint BECKMANN = 70u;

vec2 alpha() {
    return uintBitsToFloat(uvec2(push.p0, push.p1));
}

vec3 wo() {
    return uintBitsToFloat(uvec3(push.p2, push.p3, push.p4));
}

MAP_STRUCT(HenyeyGreenstein) phase() {
    return MAP_FUNCTION(henyey_greenstein_complement)(uintBitsToFloat(push.p0), push.p1 != 0u);
}

MAP_STRUCT(Ggx) lobe() {
    if (MAP == GGX_VNDF_BOUNDED) {
        return MAP_FUNCTION(ggx_vndf_bounded_prepare)(alpha(), wo());
    }
    return MAP_FUNCTION(ggx_prepare)(alpha(), wo());
}

MAP_STRUCT(Scattered) scattered(uvec2 u) {
    if (MAP == HENYEY_GREENSTEIN) {
        return MAP_FUNCTION(henyey_greenstein)(phase(), u);
    }
    if (MAP == GGX_VNDF) {
        return MAP_FUNCTION(ggx_vndf)(lobe(), u);
    }
    if (MAP == GGX_VNDF_NORMAL) {
        return MAP_FUNCTION(ggx_vndf_normal)(lobe(), u);
    }
    if (MAP == GGX_VNDF_CAP) {
        return MAP_FUNCTION(ggx_vndf_cap)(lobe(), u);
    }
    if (MAP == GGX_VNDF_BOUNDED) {
        return MAP_FUNCTION(ggx_vndf_bounded)(lobe(), u);
    }
    if (MAP == BECKMANN_NORMAL) {
        return MAP_FUNCTION(beckmann_normal)(alpha(), u);
    }
    return MAP_FUNCTION(beckmann)(alpha(), wo(), u);
}

uvec4 map_sample(uvec3 u) {
    MAP_STRUCT(Scattered) made = scattered(u.xy);
    return floatBitsToUint(vec4(made.direction, made.pdf));
}

uint map_pdf(uvec4 s) {
    vec3 d = uintBitsToFloat(s.xyz);
    if (MAP == HENYEY_GREENSTEIN) {
        return floatBitsToUint(MAP_FUNCTION(henyey_greenstein_pdf)(phase(), d));
    }
    if (MAP == GGX_VNDF_NORMAL) {
        return floatBitsToUint(MAP_FUNCTION(ggx_vndf_normal_pdf)(lobe(), d));
    }
    if (MAP == BECKMANN_NORMAL) {
        return floatBitsToUint(MAP_FUNCTION(beckmann_normal_pdf)(alpha(), d));
    }
    if (MAP == BECKMANN) {
        return floatBitsToUint(MAP_FUNCTION(beckmann_pdf)(alpha(), wo(), d));
    }
    return floatBitsToUint(MAP_FUNCTION(ggx_pdf)(lobe(), d));
}

uvec3 map_invert(uvec4 s) {
    vec3 d = uintBitsToFloat(s.xyz);
    if (MAP == HENYEY_GREENSTEIN) {
        return uvec3(MAP_FUNCTION(henyey_greenstein_invert)(phase(), d), 0u);
    }
    if (MAP == GGX_VNDF) {
        return uvec3(MAP_FUNCTION(ggx_vndf_invert)(lobe(), d), 0u);
    }
    if (MAP == GGX_VNDF_NORMAL) {
        return uvec3(MAP_FUNCTION(ggx_vndf_normal_invert)(lobe(), d), 0u);
    }
    if (MAP == BECKMANN_NORMAL) {
        return uvec3(MAP_FUNCTION(beckmann_normal_invert)(alpha(), d), 0u);
    }
    if (MAP == BECKMANN) {
        return uvec3(MAP_FUNCTION(beckmann_invert)(alpha(), wo(), d), 0u);
    }
    return uvec3(MAP_FUNCTION(ggx_vndf_cap_invert)(lobe(), d), 0u);
}

#include "map_main.glsl"
