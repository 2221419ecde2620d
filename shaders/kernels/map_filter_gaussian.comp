#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
// The truncated Gaussian as a pixel filter, of points in memory.
#include "interface.glsl"
#ifdef KERNEL_NATIVE
#include "corput/native/filter.glsl"
#define MAP_FUNCTION(name) corput_native_##name
#define MAP_STRUCT(name) CorputNative##name
#else
#include "corput/filter.glsl"
#include "prepared.glsl"
#define MAP_FUNCTION(name) corput_##name
#define MAP_STRUCT(name) Corput##name
#endif

const uint FILTER_GAUSSIAN = 102u;

// One for all tasks: compilers inline each call before they know which is asked for.
MAP_STRUCT(FilterGaussian) gaussian;

uvec4 map_sample(uvec3 u) {
    if (MAP == FILTER_GAUSSIAN) {
        MAP_STRUCT(FilterSample) made = MAP_FUNCTION(filter_gaussian)(gaussian, u.xy);
        return floatBitsToUint(vec4(made.p, made.pdf, 0.0));
    }
    return uvec4(0u);
}

uint map_pdf(uvec4 s) {
    return floatBitsToUint(MAP_FUNCTION(filter_gaussian_pdf)(gaussian, uintBitsToFloat(s.xy)));
}

uvec3 map_invert(uvec4 s) {
    return uvec3(MAP_FUNCTION(filter_gaussian_invert)(gaussian, uintBitsToFloat(s.xy)), 0u);
}

MAP_STRUCT(FilterGaussian) prepare_gaussian() {
    return MAP_FUNCTION(filter_gaussian_prepare)(uintBitsToFloat(push.p0), uintBitsToFloat(push.p1));
}

#ifdef KERNEL_NATIVE
#define MAP_PREPARE gaussian = prepare_gaussian();
#else
void map_prepare() {
    CorputFilterGaussian f = prepare_gaussian();
    store_real(0u, f.radius);
    store_real(1u, f.sigma);
    store_real(2u, f.mass);
    store_real(3u, f.tail);
}
#define MAP_PREPARE gaussian = CorputFilterGaussian(prepared_real(0u), prepared_real(1u), prepared_real(2u), prepared_real(3u));
#define MAP_PREPARED map_prepare();
#endif

// Four copies of so long a body take drivers seconds.
#define MAP_LOOP [[dont_unroll]]
#include "map_main.glsl"
