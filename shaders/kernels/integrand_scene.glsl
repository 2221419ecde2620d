// Integrands of rendering without tables: the coordinates of a point, then the term. The
// host's words are a head of four, which are two reals, and what it prepared of the parameters.
#ifndef KERNEL_INTEGRAND_SCENE_GLSL
#define KERNEL_INTEGRAND_SCENE_GLSL

#include "integrand_point.glsl"
#include "corput/defocus.glsl"
#include "corput/ggx_furnace.glsl"
#include "corput/highlight.glsl"
#include "corput/lambert.glsl"
#include "corput/pixel_edge.glsl"
#include "corput/single_scattering.glsl"
#include "corput/soft_shadow.glsl"
#define PREPARED(i) COEFFICIENT((i) >> 2u)[(i) & 3u]
#include "prepared_spherical.glsl"

const uint SKY_UNIFORM = 128u;
const uint SKY_COSINE = 129u;
const uint POLYGON_UNIFORM = 132u;
const uint POLYGON_COSINE = 133u;
const uint POLYGON_LIGHT = 134u;
const uint POLYGON_MIS = 135u;
const uint FURNACE_UNIFORM = 136u;
const uint FURNACE_COSINE = 137u;
const uint FURNACE_VISIBLE = 138u;
const uint LENS_SQUARE = 140u;
const uint LENS_POLAR = 141u;
const uint LENS_CONCENTRIC = 142u;
const uint SCATTERING_UNIFORM = 144u;
const uint SCATTERING_PHASE = 145u;
const uint SHADOW_UNIFORM = 148u;
const uint SHADOW_COSINE = 149u;
const uint SHADOW_LIGHT = 150u;
const uint SHADOW_MIS = 151u;
const uint LOBE_UNIFORM = 152u;
const uint LOBE_GGX = 153u;
const uint LOBE_LIGHT = 154u;
const uint LOBE_MIS = 155u;
const uint PIXEL_UNIFORM = 156u;
const uint PIXEL_FILTER = 157u;

CorputGgx prepared_ggx(uint i) {
    return CorputGgx(prepared_real(i), prepared_real(i + 1u), prepared_real3(i + 2u), prepared_real3(i + 5u),
        prepared_real(i + 8u), prepared_real(i + 9u), prepared_real(i + 10u), prepared_real(i + 11u),
        prepared_real(i + 12u));
}

CorputReal integrand_sky(uvec2 u) {
    CorputReal gradient = prepared_real(2u);
    if (INTEGRAND == SKY_UNIFORM) {
        return corput_sky_uniform(gradient, u);
    }
    return corput_sky_cosine(gradient, u);
}

CorputReal integrand_polygon(uvec3 u) {
    CorputSphericalTriangle t = prepared_triangle(2u);
    if (INTEGRAND == POLYGON_UNIFORM) {
        return corput_lambert_uniform(t, u.xy);
    }
    if (INTEGRAND == POLYGON_COSINE) {
        return corput_lambert_cosine(t, u.xy);
    }
    if (INTEGRAND == POLYGON_LIGHT) {
        return corput_lambert_light(t, u.xy);
    }
    return corput_lambert_mis(t, u);
}

CorputReal integrand_furnace(uvec2 u) {
    CorputGgx g = prepared_ggx(2u);
    if (INTEGRAND == FURNACE_UNIFORM) {
        return corput_furnace_uniform(g, u);
    }
    if (INTEGRAND == FURNACE_COSINE) {
        return corput_furnace_cosine(g, u);
    }
    return corput_furnace_visible(g, u);
}

CorputReal integrand_lens(uvec2 u) {
    CorputReal3 edge = prepared_real3(2u);
    if (INTEGRAND == LENS_SQUARE) {
        return corput_defocus_square(edge, u);
    }
    if (INTEGRAND == LENS_POLAR) {
        return corput_defocus_polar(edge, u);
    }
    return corput_defocus_concentric(edge, u);
}

CorputReal integrand_scattering(uvec3 u) {
    CorputReal depth = prepared_real(2u);
    float g = uintBitsToFloat(COEFFICIENT(0u).x);
    CorputHenyeyGreenstein h = corput_henyey_greenstein_prepare(g);
    if (INTEGRAND == SCATTERING_UNIFORM) {
        return corput_scattering_uniform(h, depth, u);
    }
    return corput_scattering_phase(h, depth, u);
}

CorputReal integrand_shadow(uvec3 u) {
    CorputSphereLight light = prepared_sphere(2u);
    CorputReal3 edge = prepared_real3(13u);
    if (INTEGRAND == SHADOW_UNIFORM) {
        return corput_shadow_uniform(light, edge, u.xy);
    }
    if (INTEGRAND == SHADOW_COSINE) {
        return corput_shadow_cosine(light, edge, u.xy);
    }
    if (INTEGRAND == SHADOW_LIGHT) {
        return corput_shadow_light(light, edge, u.xy);
    }
    return corput_shadow_mis(light, edge, u);
}

CorputReal integrand_lobe(uvec3 u) {
    CorputGgx g = prepared_ggx(2u);
    CorputSphereLight light = prepared_sphere(15u);
    if (INTEGRAND == LOBE_UNIFORM) {
        return corput_highlight_uniform(g, light, u.xy);
    }
    if (INTEGRAND == LOBE_GGX) {
        return corput_highlight_visible(g, light, u.xy);
    }
    if (INTEGRAND == LOBE_LIGHT) {
        return corput_highlight_light(g, light, u.xy);
    }
    return corput_highlight_mis(g, light, u);
}

CorputReal integrand_pixel(uvec2 u) {
    CorputReal3 edge = prepared_real3(2u);
    if (INTEGRAND == PIXEL_UNIFORM) {
        return corput_pixel_uniform(edge, u);
    }
    return corput_pixel_filter(edge, u);
}

CorputTerm integrand_term(Integrand state, uvec4 head, int scale) {
    CorputReal real = corput_real_zero();
    if (INTEGRAND < POLYGON_UNIFORM) {
        real = integrand_sky(state.point.xy);
    }
    if (INTEGRAND >= POLYGON_UNIFORM && INTEGRAND < FURNACE_UNIFORM) {
        real = integrand_polygon(state.point.xyz);
    }
    if (INTEGRAND >= FURNACE_UNIFORM && INTEGRAND < LENS_SQUARE) {
        real = integrand_furnace(state.point.xy);
    }
    if (INTEGRAND >= LENS_SQUARE && INTEGRAND < SCATTERING_UNIFORM) {
        real = integrand_lens(state.point.xy);
    }
    if (INTEGRAND >= SCATTERING_UNIFORM && INTEGRAND < SHADOW_UNIFORM) {
        real = integrand_scattering(state.point.xyz);
    }
    if (INTEGRAND >= SHADOW_UNIFORM && INTEGRAND < LOBE_UNIFORM) {
        real = integrand_shadow(state.point.xyz);
    }
    if (INTEGRAND >= LOBE_UNIFORM && INTEGRAND < PIXEL_UNIFORM) {
        real = integrand_lobe(state.point.xyz);
    }
    if (INTEGRAND >= PIXEL_UNIFORM) {
        real = integrand_pixel(state.point.xy);
    }
    return corput_term(real, scale);
}

#endif
