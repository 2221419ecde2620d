#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
// Visible normals of GGX by spherical caps, of points in memory.
#include "interface.glsl"
#ifdef KERNEL_NATIVE
#include "corput/native/ggx_vndf_bounded.glsl"
#define MAP_FUNCTION(name) corput_native_##name
#define MAP_STRUCT(name) CorputNative##name
#else
#include "corput/ggx_vndf_bounded.glsl"
#define MAP_FUNCTION(name) corput_##name
#define MAP_STRUCT(name) Corput##name
#endif

const uint GGX_VNDF_CAP = 67u;
const uint GGX_VNDF_BOUNDED = 68u;

// The lobe: bounded caps differ by nothing else.
MAP_STRUCT(Ggx) lobe() {
    MAP_STRUCT(Ggx) g = MAP_FUNCTION(ggx_prepare)(uintBitsToFloat(uvec2(push.p0, push.p1)),
        uintBitsToFloat(uvec3(push.p2, push.p3, push.p4)));
    if (MAP == GGX_VNDF_BOUNDED) {
        return MAP_FUNCTION(ggx_vndf_bound)(g);
    }
    return g;
}

uvec4 map_sample(uvec3 u) {
    MAP_STRUCT(Scattered) made = MAP_FUNCTION(ggx_vndf_cap)(lobe(), u.xy);
    return floatBitsToUint(vec4(made.direction, made.pdf));
}

uint map_pdf(uvec4 s) {
    return floatBitsToUint(MAP_FUNCTION(ggx_vndf_cap_pdf)(lobe(), uintBitsToFloat(s.xyz)));
}

uvec3 map_invert(uvec4 s) {
    return uvec3(MAP_FUNCTION(ggx_vndf_cap_invert)(lobe(), uintBitsToFloat(s.xyz)), 0u);
}

// Four copies of so long a body take drivers seconds.
#define MAP_LOOP [[dont_unroll]]
#include "map_main.glsl"
