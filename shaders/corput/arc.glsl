// what:   arcs between directions, without the differences that cancel in short and long ones.
// source: the half-angle formulas; for unit vectors u, v with the unit normal n of u x v,
//         u + v = (v - u) x n / tan(half the angle).
// domain: vectors of any length, exact floats.
// range:  cosines and sines of half angles within 2^-28 of themselves.
// cost:   an arc 900, a sum 700 integer instructions. tier I.
// hooks:  none.
// mirror: src/reference/arc.rs
#ifndef CORPUT_ARC_GLSL
#define CORPUT_ARC_GLSL

#include "corput/wide.glsl"

// Half the angle between two vectors.
struct CorputArc {
    CorputReal cosine;
    CorputReal sine;
};

// A vector with the other sign if so told.
CorputReal3 corput_real3_signed(CorputReal3 v, bool negative) {
    if (!negative) {
        return v;
    }
    return CorputReal3(corput_real_negate(v.x), corput_real_negate(v.y), corput_real_negate(v.z));
}

// v x + w y.
CorputReal3 corput_real3_combine(CorputReal3 v, CorputReal x, CorputReal3 w, CorputReal y) {
    return corput_real3_add(corput_real3_scale(v, x), corput_real3_scale(w, y));
}

// The arc between two vectors of any length with this vector product.
CorputArc corput_arc(CorputReal3 a, CorputReal3 b, CorputReal3 normal) {
    CorputReal product = corput_real_multiply(corput_real3_length(a), corput_real3_length(b));
    CorputReal cosine = corput_real3_dot(a, b);
    // The sum that does not cancel, and the other one by the vector product.
    CorputReal large = corput_real_add(product, CorputReal(cosine.m, cosine.e, false));
    CorputReal small = corput_real_divide(corput_real3_dot(normal, normal), large);
    CorputReal twice = corput_real_shift(product, 1);
    CorputReal far = corput_real_sqrt(corput_real_divide(large, twice));
    CorputReal near = corput_real_sqrt(corput_real_divide(small, twice));
    if (cosine.negative) {
        return CorputArc(near, far);
    }
    return CorputArc(far, near);
}

// u + v of unit vectors, each component within 2^-28 of the length of the sum, given their arc
// and the unit normal of u x v.
CorputReal3 corput_arc_sum(CorputReal3 u, CorputReal3 v, CorputArc arc, CorputReal3 normal) {
    if (!corput_real_less(arc.cosine, arc.sine)) {
        return corput_real3_add(u, v);
    }
    CorputReal3 across = corput_real3_cross(corput_real3_subtract(v, u), normal);
    return corput_real3_scale(across, corput_real_divide(arc.cosine, arc.sine));
}

#endif
