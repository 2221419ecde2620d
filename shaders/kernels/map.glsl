// The map that MAP names, in the profile of the module, and the store of four results.
#ifndef KERNEL_MAP_GLSL
#define KERNEL_MAP_GLSL

#ifdef KERNEL_NATIVE
#include "corput/native/hemisphere.glsl"
#define MAP_FUNCTION(name) corput_native_##name
#define MAP_DISK_PDF 0.31830989
#else
#include "corput/hemisphere.glsl"
#define MAP_FUNCTION(name) corput_##name
#define MAP_DISK_PDF corput_concentric_disk_pdf()
#endif

const uint CONCENTRIC_DISK = 0u;
const uint POLAR_DISK = 1u;
const uint UNIFORM_HEMISPHERE = 2u;
const uint COSINE_HEMISPHERE = 3u;
const uint COSINE_HEMISPHERE_POLAR = 4u;

// Coordinates of the sample, then its pdf where there is room: (x, y, pdf, 0) for a
// disk, (x, y, z, pdf) for a hemisphere, as float bits.
uvec4 map_sample(uvec2 u) {
    if (MAP == CONCENTRIC_DISK) {
        return floatBitsToUint(vec4(MAP_FUNCTION(concentric_disk)(u), MAP_DISK_PDF, 0.0));
    }
    if (MAP == POLAR_DISK) {
        return floatBitsToUint(vec4(MAP_FUNCTION(polar_disk)(u), MAP_DISK_PDF, 0.0));
    }
    if (MAP == UNIFORM_HEMISPHERE) {
        vec3 d = MAP_FUNCTION(uniform_hemisphere)(u);
        return floatBitsToUint(vec4(d, MAP_FUNCTION(uniform_hemisphere_pdf)(d)));
    }
    if (MAP == COSINE_HEMISPHERE) {
        vec3 d = MAP_FUNCTION(cosine_hemisphere)(u);
        return floatBitsToUint(vec4(d, WITH_PDF != 0u ? MAP_FUNCTION(cosine_hemisphere_pdf)(d) : 0.0));
    }
    vec3 d = MAP_FUNCTION(cosine_hemisphere_polar)(u);
    return floatBitsToUint(vec4(d, WITH_PDF != 0u ? MAP_FUNCTION(cosine_hemisphere_polar_pdf)(d) : 0.0));
}

// Words of a result: 2 or 3 coordinates, and the pdf if it is asked for.
uint map_width() {
    return (MAP == CONCENTRIC_DISK || MAP == POLAR_DISK ? 2u : 3u) + WITH_PDF;
}

// Stores four results from results[at] on.
void map_store(uint at, uvec4 p0, uvec4 p1, uvec4 p2, uvec4 p3) {
    uint width = map_width();
    if (width == 2u) {
        results[at] = uvec4(p0.xy, p1.xy);
        results[at + 1u] = uvec4(p2.xy, p3.xy);
    } else if (width == 3u) {
        results[at] = uvec4(p0.xyz, p1.x);
        results[at + 1u] = uvec4(p1.yz, p2.xy);
        results[at + 2u] = uvec4(p2.z, p3.xyz);
    } else {
        results[at] = p0;
        results[at + 1u] = p1;
        results[at + 2u] = p2;
        results[at + 3u] = p3;
    }
}

#endif
