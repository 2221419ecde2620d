#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
// Visible normals of GGX by Heitz's disk, of points in memory.
#include "interface.glsl"
#ifdef KERNEL_NATIVE
#include "corput/native/ggx_vndf.glsl"
#define MAP_FUNCTION(name) corput_native_##name
#define MAP_STRUCT(name) CorputNative##name
#else
#include "corput/ggx_vndf.glsl"
#define MAP_FUNCTION(name) corput_##name
#define MAP_STRUCT(name) Corput##name
#endif

const uint GGX_VNDF = 65u;
const uint GGX_VNDF_NORMAL = 66u;

// The lobe; compilers inline each call before they know MAP, so there are few.
MAP_STRUCT(Ggx) lobe() {
    return MAP_FUNCTION(ggx_prepare)(uintBitsToFloat(uvec2(push.p0, push.p1)),
        uintBitsToFloat(uvec3(push.p2, push.p3, push.p4)));
}

uvec4 map_sample(uvec3 u) {
    MAP_STRUCT(Ggx) g = lobe();
    MAP_STRUCT(Scattered) made;
    if (MAP == GGX_VNDF) {
        made = MAP_FUNCTION(ggx_vndf)(g, u.xy);
    } else {
        made = MAP_FUNCTION(ggx_vndf_normal)(g, u.xy);
    }
    return floatBitsToUint(vec4(made.direction, made.pdf));
}

uint map_pdf(uvec4 s) {
    MAP_STRUCT(Ggx) g = lobe();
    if (MAP == GGX_VNDF_NORMAL) {
        return floatBitsToUint(MAP_FUNCTION(ggx_vndf_normal_pdf)(g, uintBitsToFloat(s.xyz)));
    }
    return floatBitsToUint(MAP_FUNCTION(ggx_vndf_pdf)(g, uintBitsToFloat(s.xyz)));
}

uvec3 map_invert(uvec4 s) {
    MAP_STRUCT(Ggx) g = lobe();
    if (MAP == GGX_VNDF) {
        return uvec3(MAP_FUNCTION(ggx_vndf_invert)(g, uintBitsToFloat(s.xyz)), 0u);
    }
    return uvec3(MAP_FUNCTION(ggx_vndf_normal_invert)(g, uintBitsToFloat(s.xyz)), 0u);
}

// Four copies of so long a body take drivers seconds.
#define MAP_LOOP [[dont_unroll]]
#include "map_main.glsl"
