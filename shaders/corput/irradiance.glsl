// what:   estimators of the irradiance of an environment map on a surface that faces along
//         an axis: for each sample, the light that it meets times cos t over its pdf.
// source: Veach and Guibas 1995, Optimally combining sampling techniques for Monte Carlo
//         rendering, SIGGRAPH; Pharr, Jakob and Humphreys, PBRT 4th ed., 2.2 and 12.5.
// domain: fractions of 2^32; axes 0 to 5: +x, -x, +y, -y, +z, -z; the words of
//         environment.glsl, followed by the bits of each texel's luminance, a float that is
//         0 or normal.
// range:  each sample within 2^-22 of itself but for directions that lie within 2^-23 of a
//         texel's edge, which may meet its neighbour. The mean over all fractions is the sum
//         of luminance times projected solid angle.
// cost:   as the directions, and log2(height) + 1 lookups; together 300 (uniform, cosine),
//         600 (environment) or 900 (mis) integer instructions. tier I.
// hooks:  CORPUT_DISCRETE(i): word i of the tables, then of the luminances; and that of
//         envmap.glsl.
// mirror: src/reference/irradiance.rs
#ifndef CORPUT_IRRADIANCE_GLSL
#define CORPUT_IRRADIANCE_GLSL

#ifndef CORPUT_DISCRETE
#error define CORPUT_DISCRETE(i), word i of the tables, before this header
#endif

#include "corput/axis.glsl"
#include "corput/environment.glsl"
#include "corput/hemisphere.glsl"

// The luminance of a texel, as column and row.
CorputReal corput_irradiance_light(uvec2 size, uvec2 texel) {
    uint first = corput_environment_row(size, size.y);
    return corput_real(uintBitsToFloat(CORPUT_DISCRETE(first + texel.y * size.x + texel.x)));
}

// A uniform direction of the hemisphere: 2 pi L cos t.
CorputReal corput_irradiance_uniform(uvec2 size, uint axis, uvec2 u) {
    vec3 d = corput_uniform_hemisphere(u);
    uvec2 texel = corput_envmap_texel(corput_axis_turned(d, axis), size);
    CorputReal weight = corput_real_multiply(corput_real(d.z), corput_real_uint(3373259426u, -29));
    return corput_real_multiply(corput_irradiance_light(size, texel), weight);
}

// A cosine-weighted direction: pi L.
CorputReal corput_irradiance_cosine(uvec2 size, uint axis, uvec2 u) {
    vec3 d = corput_cosine_hemisphere(u);
    uvec2 texel = corput_envmap_texel(corput_axis_turned(d, axis), size);
    return corput_real_multiply(corput_irradiance_light(size, texel), corput_real_uint(3373259426u, -30));
}

// A direction by the map's light: L cos t / pdf.
CorputReal corput_irradiance_environment(uvec2 size, uint axis, uvec2 u) {
    CorputEnvironment s = corput_environment(size, u);
    CorputReal light = corput_irradiance_light(size, corput_envmap_texel(s.direction, size));
    CorputReal flow = corput_real_multiply(light, corput_axis_cosine(s.direction, axis));
    return corput_real_divide(flow, corput_real(s.pdf));
}

// A cosine-weighted direction for half of all u.z and one by the map's light for the others,
// with the balance heuristic: L cos t over the mean of both pdfs.
CorputReal corput_irradiance_mis(uvec2 size, uint axis, uvec3 u) {
    vec3 d = corput_axis_turned(corput_cosine_hemisphere(u.xy), axis);
    vec3 other = corput_environment(size, u.xy).direction;
    if (u.z >= 0x80000000u) {
        d = other;
    }
    uvec2 texel = corput_envmap_texel(d, size);
    CorputReal cosine = corput_axis_cosine(d, axis);
    // 1/pi to 32 bits.
    CorputReal pdf = corput_real_multiply(cosine, corput_real_uint(2734261102u, -33));
    CorputReal both = corput_real_add(pdf, corput_real(corput_environment_texel_pdf(size, texel)));
    CorputReal flow = corput_real_multiply(corput_irradiance_light(size, texel), cosine);
    return corput_real_divide(flow, corput_real_shift(both, -1));
}

#endif
