#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
// Uniform points of plane figures, of points in memory.
#include "interface.glsl"
#ifdef KERNEL_NATIVE
#include "corput/native/annulus.glsl"
#include "corput/native/regular_polygon.glsl"
#include "corput/native/triangle.glsl"
#define MAP_FUNCTION(name) corput_native_##name
#else
#include "corput/annulus.glsl"
#include "corput/regular_polygon.glsl"
#include "corput/triangle.glsl"
#define MAP_FUNCTION(name) corput_##name
#endif

const uint TRIANGLE = 16u;
const uint REGULAR_POLYGON = 17u;
const uint ANNULUS = 18u;

vec2 vertex(uint x, uint y) {
    return uintBitsToFloat(uvec2(x, y));
}

// The pdf at a point.
float density(vec2 p) {
    if (MAP == TRIANGLE) {
        return MAP_FUNCTION(triangle_pdf)(vertex(push.p0, push.p1), vertex(push.p2, push.p3),
            vertex(push.p4, push.p5), p);
    }
    if (MAP == REGULAR_POLYGON) {
        return MAP_FUNCTION(regular_polygon_pdf)(push.p0, p);
    }
    if (MAP == ANNULUS) {
        return MAP_FUNCTION(annulus_pdf)(uintBitsToFloat(push.p0), p);
    }
    return 0.0;
}

vec2 point(uvec2 u) {
    if (MAP == TRIANGLE) {
        return MAP_FUNCTION(triangle)(vertex(push.p0, push.p1), vertex(push.p2, push.p3),
            vertex(push.p4, push.p5), u);
    }
    if (MAP == REGULAR_POLYGON) {
        return MAP_FUNCTION(regular_polygon)(push.p0, u);
    }
    if (MAP == ANNULUS) {
        return MAP_FUNCTION(annulus)(uintBitsToFloat(push.p0), u);
    }
    return vec2(0.0);
}

uvec4 map_sample(uvec3 u) {
    vec2 p = point(u.xy);
    return floatBitsToUint(vec4(p, WITH_PDF != 0u ? density(p) : 0.0, 0.0));
}

uint map_pdf(uvec4 s) {
    return floatBitsToUint(density(uintBitsToFloat(s.xy)));
}

uvec3 map_invert(uvec4 s) {
    vec2 p = uintBitsToFloat(s.xy);
    if (MAP == TRIANGLE) {
        return uvec3(MAP_FUNCTION(triangle_invert)(vertex(push.p0, push.p1), vertex(push.p2, push.p3),
            vertex(push.p4, push.p5), p), 0u);
    }
    if (MAP == REGULAR_POLYGON) {
        return uvec3(MAP_FUNCTION(regular_polygon_invert)(push.p0, p), 0u);
    }
    if (MAP == ANNULUS) {
        return uvec3(MAP_FUNCTION(annulus_invert)(uintBitsToFloat(push.p0), p), 0u);
    }
    return uvec3(0u);
}

// Unrolled, long bodies take compilers minutes.
#define MAP_LOOP [[dont_unroll]]
#include "map_main.glsl"
