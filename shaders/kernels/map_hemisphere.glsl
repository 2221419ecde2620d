// The maps of disk and hemisphere, in the profile of the module.
#ifndef KERNEL_MAP_HEMISPHERE_GLSL
#define KERNEL_MAP_HEMISPHERE_GLSL

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

// Coordinates of the sample, then its pdf, as float bits: (x, y, pdf, 0) for a disk,
// (x, y, z, pdf) for a hemisphere.
uvec4 map_sample(uvec3 u) {
    if (MAP == CONCENTRIC_DISK) {
        return floatBitsToUint(vec4(MAP_FUNCTION(concentric_disk)(u.xy), MAP_DISK_PDF, 0.0));
    }
    if (MAP == POLAR_DISK) {
        return floatBitsToUint(vec4(MAP_FUNCTION(polar_disk)(u.xy), MAP_DISK_PDF, 0.0));
    }
    if (MAP == UNIFORM_HEMISPHERE) {
        vec3 d = MAP_FUNCTION(uniform_hemisphere)(u.xy);
        return floatBitsToUint(vec4(d, MAP_FUNCTION(uniform_hemisphere_pdf)(d)));
    }
    if (MAP == COSINE_HEMISPHERE) {
        vec3 d = MAP_FUNCTION(cosine_hemisphere)(u.xy);
        return floatBitsToUint(vec4(d, WITH_PDF != 0u ? MAP_FUNCTION(cosine_hemisphere_pdf)(d) : 0.0));
    }
    if (MAP == COSINE_HEMISPHERE_POLAR) {
        vec3 d = MAP_FUNCTION(cosine_hemisphere_polar)(u.xy);
        return floatBitsToUint(vec4(d, WITH_PDF != 0u ? MAP_FUNCTION(cosine_hemisphere_polar_pdf)(d) : 0.0));
    }
    return uvec4(0u);
}

// Bits of the pdf at these coordinates.
uint map_pdf(uvec4 s) {
    vec3 d = uintBitsToFloat(s.xyz);
    if (MAP == CONCENTRIC_DISK || MAP == POLAR_DISK) {
        return floatBitsToUint(MAP_DISK_PDF);
    }
    if (MAP == UNIFORM_HEMISPHERE) {
        return floatBitsToUint(MAP_FUNCTION(uniform_hemisphere_pdf)(d));
    }
    return floatBitsToUint(MAP_FUNCTION(cosine_hemisphere_pdf)(d));
}

// The fractions that give these coordinates.
uvec3 map_invert(uvec4 s) {
    vec3 d = uintBitsToFloat(s.xyz);
    if (MAP == CONCENTRIC_DISK) {
        return uvec3(MAP_FUNCTION(concentric_disk_invert)(d.xy), 0u);
    }
    if (MAP == POLAR_DISK) {
        return uvec3(MAP_FUNCTION(polar_disk_invert)(d.xy), 0u);
    }
    if (MAP == UNIFORM_HEMISPHERE) {
        return uvec3(MAP_FUNCTION(uniform_hemisphere_invert)(d), 0u);
    }
    if (MAP == COSINE_HEMISPHERE) {
        return uvec3(MAP_FUNCTION(cosine_hemisphere_invert)(d), 0u);
    }
    return uvec3(MAP_FUNCTION(cosine_hemisphere_polar_invert)(d), 0u);
}

#endif
