// what:   reflection and refraction at a microfacet, with their Jacobians: what turns the pdf
//         of a normal into that of a direction.
// source: Walter et al. 2007, Microfacet models for refraction through rough surfaces,
//         eq. 13 to 17, 39, 40. With c = |w.h|, c' = |t.h|: c / eta - c' =
//         (1 - eta^2) / (eta (c + eta c')), and the Jacobian eta^2 c' / (c - eta c')^2 =
//         c' (eta (c + eta c') / (1 - eta^2))^2, neither of which cancels as eta nears 1;
//         1 - c^2 is |w x h|^2, which does not cancel at normal incidence.
// domain: w points away from the surface, h to either side; both are normalised. eta is the
//         index of refraction beyond the surface over that on the side of w. Beyond total
//         internal reflection, for eta <= 0 and for w or h = 0 nothing is refracted: direction
//         and Jacobian are 0.
// range:  unit vectors to 2^-23; a Jacobian from 0 to the largest float, which stands for
//         infinity: reflection at h perpendicular to w, refraction for eta = 1.
// errors: directions 0.6 ULP, or 2^-28; the Jacobian of reflection 0.6 ULP or 2^-29 / |w.h|,
//         of refraction 2^-22 or 2^-26 (1 + |w x h|^2 / (eta c')^2).
// cost:   500 and 1200 integer instructions. tier I.
// hooks:  none.
// mirror: src/reference/reflect.rs
#ifndef CORPUT_REFLECT_GLSL
#define CORPUT_REFLECT_GLSL

#include "corput/real_vector.glsl"

// A direction beyond a microfacet.
struct CorputBent {
    // The unit vector; 0 where there is none.
    vec3 direction;
    // Solid angle of normals per solid angle of directions.
    float jacobian;
};

// w reflected at h, and the Jacobian 1 / (4 |w.h|).
CorputBent corput_reflect(vec3 w, vec3 h) {
    CorputReal3 o = corput_real3_normalize(corput_real3(w));
    CorputReal3 n = corput_real3_normalize(corput_real3(h));
    CorputReal cosine = corput_real3_dot(o, n);
    CorputReal3 direction = corput_real3_subtract(corput_real3_scale(n, corput_real_shift(cosine, 1)), o);
    CorputReal jacobian = corput_real_divide(corput_real_uint(1u, -2), CorputReal(cosine.m, cosine.e, false));
    return CorputBent(corput_real3_floats(direction), corput_real_float(jacobian));
}

// w refracted at h, and the Jacobian eta^2 |t.h| / (|w.h| - eta |t.h|)^2.
CorputBent corput_refract(vec3 w, vec3 h, float eta) {
    CorputReal3 o = corput_real3_normalize(corput_real3(w));
    CorputReal3 n = corput_real3_normalize(corput_real3(h));
    CorputReal index = corput_real(eta);
    CorputReal cosine = corput_real3_dot(o, n);
    if (cosine.negative) {
        cosine = corput_real_negate(cosine);
        n = corput_real3_subtract(CorputReal3(corput_real_zero(), corput_real_zero(), corput_real_zero()), n);
    }
    CorputReal3 across = corput_real3_cross(o, n);
    CorputReal sine_square = corput_real3_dot(across, across);
    CorputReal rest = corput_real_subtract(corput_real_square(index), sine_square);
    if (index.negative || rest.negative || rest.m == 0u || (cosine.m == 0u && sine_square.m == 0u)) {
        return CorputBent(vec3(0.0), 0.0);
    }
    // eta c', and eta (c / eta - c').
    CorputReal beyond = corput_real_sqrt(rest);
    CorputReal one = corput_real_uint(1u, 0);
    CorputReal sum = corput_real_add(cosine, beyond);
    CorputReal step = corput_real_multiply(corput_real_subtract(one, index), corput_real_add(one, index));
    CorputReal along = corput_real_divide(step, sum);
    CorputReal3 bent = corput_real3_subtract(corput_real3_scale(n, along), o);
    CorputReal3 direction = CorputReal3(corput_real_divide(bent.x, index), corput_real_divide(bent.y, index),
        corput_real_divide(bent.z, index));
    // eta c' eta / (eta c' - c)^2.
    CorputReal jacobian = corput_real_divide(corput_real_multiply(beyond, index), corput_real_square(along));
    return CorputBent(corput_real3_floats(direction), corput_real_float(jacobian));
}

#endif
