#version 450
#extension GL_GOOGLE_include_directive : require
// Free flight, normal distributions and pixel filters, of points in memory.
#include "interface.glsl"
#ifdef KERNEL_NATIVE
#include "corput/native/filter.glsl"
#define MAP_FUNCTION(name) corput_native_##name
#define MAP_STRUCT(name) CorputNative##name
#else
#include "corput/filter.glsl"
#define MAP_FUNCTION(name) corput_##name
#define MAP_STRUCT(name) Corput##name
#endif

const uint EXPONENTIAL = 96u;
const uint GAUSSIAN = 97u;
const uint NORMAL_PAIR = 98u;
const uint BOX_MULLER = 99u;
const uint FILTER_BOX = 100u;
const uint FILTER_TENT = 101u;
const uint FILTER_GAUSSIAN = 102u;

// The bits of a coordinate or a point, and of its pdf.
uvec4 words(float x, float pdf) {
    return floatBitsToUint(vec4(x, pdf, 0.0, 0.0));
}

uvec4 words(vec2 p, float pdf) {
    return floatBitsToUint(vec4(p, pdf, 0.0));
}

// The first parameter: sigma, or the radius of a filter.
float first() {
    return uintBitsToFloat(push.p0);
}

MAP_STRUCT(FilterGaussian) filter_gaussian() {
    return MAP_FUNCTION(filter_gaussian_prepare)(first(), uintBitsToFloat(push.p1));
}

uvec4 map_sample(uvec3 u) {
    if (MAP == EXPONENTIAL) {
        MAP_STRUCT(FreeFlight) s = MAP_FUNCTION(exponential)(first(), u.x);
        return words(s.t, s.pdf);
    }
    if (MAP == GAUSSIAN) {
        MAP_STRUCT(Gaussian) s = MAP_FUNCTION(gaussian)(first(), u.x);
        return words(s.x, s.pdf);
    }
    if (MAP == NORMAL_PAIR) {
        MAP_STRUCT(GaussianPair) s = MAP_FUNCTION(normal_pair)(first(), u.xy);
        return words(s.p, s.pdf);
    }
    if (MAP == BOX_MULLER) {
        MAP_STRUCT(GaussianPair) s = MAP_FUNCTION(box_muller)(first(), u.xy);
        return words(s.p, s.pdf);
    }
    if (MAP == FILTER_BOX) {
        MAP_STRUCT(FilterSample) s = MAP_FUNCTION(filter_box)(first(), u.xy);
        return words(s.p, s.pdf);
    }
    if (MAP == FILTER_TENT) {
        MAP_STRUCT(FilterSample) s = MAP_FUNCTION(filter_tent)(first(), u.xy);
        return words(s.p, s.pdf);
    }
    if (MAP == FILTER_GAUSSIAN) {
        MAP_STRUCT(FilterSample) s = MAP_FUNCTION(filter_gaussian)(filter_gaussian(), u.xy);
        return words(s.p, s.pdf);
    }
    return uvec4(0u);
}

uint map_pdf(uvec4 s) {
    vec2 p = uintBitsToFloat(s.xy);
    if (MAP == EXPONENTIAL) {
        return floatBitsToUint(MAP_FUNCTION(exponential_pdf)(first(), p.x));
    }
    if (MAP == GAUSSIAN) {
        return floatBitsToUint(MAP_FUNCTION(gaussian_pdf)(first(), p.x));
    }
    if (MAP == NORMAL_PAIR || MAP == BOX_MULLER) {
        return floatBitsToUint(MAP_FUNCTION(normal_pair_pdf)(first(), p));
    }
    if (MAP == FILTER_BOX) {
        return floatBitsToUint(MAP_FUNCTION(filter_box_pdf)(first(), p));
    }
    if (MAP == FILTER_TENT) {
        return floatBitsToUint(MAP_FUNCTION(filter_tent_pdf)(first(), p));
    }
    if (MAP == FILTER_GAUSSIAN) {
        return floatBitsToUint(MAP_FUNCTION(filter_gaussian_pdf)(filter_gaussian(), p));
    }
    return 0u;
}

uvec3 map_invert(uvec4 s) {
    vec2 p = uintBitsToFloat(s.xy);
    if (MAP == EXPONENTIAL) {
        return uvec3(MAP_FUNCTION(exponential_invert)(first(), p.x), 0u, 0u);
    }
    if (MAP == GAUSSIAN) {
        return uvec3(MAP_FUNCTION(gaussian_invert)(first(), p.x), 0u, 0u);
    }
    if (MAP == NORMAL_PAIR) {
        return uvec3(MAP_FUNCTION(normal_pair_invert)(first(), p), 0u);
    }
    if (MAP == BOX_MULLER) {
        return uvec3(MAP_FUNCTION(box_muller_invert)(first(), p), 0u);
    }
    if (MAP == FILTER_BOX) {
        return uvec3(MAP_FUNCTION(filter_box_invert)(first(), p), 0u);
    }
    if (MAP == FILTER_TENT) {
        return uvec3(MAP_FUNCTION(filter_tent_invert)(first(), p), 0u);
    }
    if (MAP == FILTER_GAUSSIAN) {
        return uvec3(MAP_FUNCTION(filter_gaussian_invert)(filter_gaussian(), p), 0u);
    }
    return uvec3(0u);
}

#include "map_main.glsl"
