// what:   vectors of three reals.
// source: the definitions.
// domain: as real.glsl. A sum that cancels is as exact as the products in it: relative to
//         the largest of them, 2^-29.
// cost:   a scalar product 70, a vector product 130 integer instructions. tier I.
// hooks:  none.
// mirror: src/reference/real_vector.rs
#ifndef CORPUT_REAL_VECTOR_GLSL
#define CORPUT_REAL_VECTOR_GLSL

#include "corput/real.glsl"

struct CorputReal3 {
    CorputReal x;
    CorputReal y;
    CorputReal z;
};

// v, exactly.
CorputReal3 corput_real3(vec3 v) {
    return CorputReal3(corput_real(v.x), corput_real(v.y), corput_real(v.z));
}

// v + w.
CorputReal3 corput_real3_add(CorputReal3 v, CorputReal3 w) {
    return CorputReal3(corput_real_add(v.x, w.x), corput_real_add(v.y, w.y), corput_real_add(v.z, w.z));
}

// v - w.
CorputReal3 corput_real3_subtract(CorputReal3 v, CorputReal3 w) {
    return CorputReal3(corput_real_subtract(v.x, w.x), corput_real_subtract(v.y, w.y),
        corput_real_subtract(v.z, w.z));
}

// v * a.
CorputReal3 corput_real3_scale(CorputReal3 v, CorputReal a) {
    return CorputReal3(corput_real_multiply(v.x, a), corput_real_multiply(v.y, a),
        corput_real_multiply(v.z, a));
}

// The scalar product of v and w.
CorputReal corput_real3_dot(CorputReal3 v, CorputReal3 w) {
    return corput_real_add(corput_real_add(corput_real_multiply(v.x, w.x), corput_real_multiply(v.y, w.y)),
        corput_real_multiply(v.z, w.z));
}

// The vector product of v and w.
CorputReal3 corput_real3_cross(CorputReal3 v, CorputReal3 w) {
    return CorputReal3(
        corput_real_subtract(corput_real_multiply(v.y, w.z), corput_real_multiply(v.z, w.y)),
        corput_real_subtract(corput_real_multiply(v.z, w.x), corput_real_multiply(v.x, w.z)),
        corput_real_subtract(corput_real_multiply(v.x, w.y), corput_real_multiply(v.y, w.x)));
}

// |v|.
CorputReal corput_real3_length(CorputReal3 v) {
    return corput_real_sqrt(corput_real3_dot(v, v));
}

// v / |v|; 0 for v = 0.
CorputReal3 corput_real3_normalize(CorputReal3 v) {
    CorputReal length = corput_real3_length(v);
    return CorputReal3(corput_real_divide(v.x, length), corput_real_divide(v.y, length),
        corput_real_divide(v.z, length));
}

// The nearest floats.
vec3 corput_real3_floats(CorputReal3 v) {
    return vec3(corput_real_float(v.x), corput_real_float(v.y), corput_real_float(v.z));
}

#endif
