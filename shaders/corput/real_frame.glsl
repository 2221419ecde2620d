// what:   an orthonormal frame around a unit normal in reals, and changes to and from it.
// source: Duff et al. 2017, Building an orthonormal basis, revisited, JCGT 6(1), with 1 - x^2
//         / (1 + |z|) as (|z| + z^2 + y^2) / (1 + |z|), which does not cancel.
// domain: unit vectors.
// range:  right-handed, orthonormal to 2^-28.
// cost:   a frame 600, a change 210 integer instructions. tier I.
// hooks:  none.
// mirror: src/reference/real_frame.rs
#ifndef CORPUT_REAL_FRAME_GLSL
#define CORPUT_REAL_FRAME_GLSL

#include "corput/real_vector.glsl"

struct CorputRealFrame {
    CorputReal3 tangent;
    CorputReal3 bitangent;
    CorputReal3 normal;
};

// a, or -a if so told.
CorputReal corput_real_frame_sign(CorputReal a, bool negative) {
    if (negative) {
        return corput_real_negate(a);
    }
    return a;
}

// The frame around a unit normal.
CorputRealFrame corput_real_frame(CorputReal3 normal) {
    bool negative = normal.z.negative;
    CorputReal height = CorputReal(normal.z.m, normal.z.e, false);
    CorputReal below = corput_real_add(corput_real_uint(1u, 0), height);
    CorputReal x_square = corput_real_square(normal.x);
    CorputReal y_square = corput_real_square(normal.y);
    CorputReal both = corput_real_add(height, corput_real_square(height));
    CorputReal xy = corput_real_negate(corput_real_divide(corput_real_multiply(normal.x, normal.y), below));
    return CorputRealFrame(
        CorputReal3(corput_real_divide(corput_real_add(both, y_square), below), xy,
            corput_real_frame_sign(corput_real_negate(normal.x), negative)),
        CorputReal3(corput_real_frame_sign(xy, negative),
            corput_real_frame_sign(corput_real_divide(corput_real_add(both, x_square), below), negative),
            corput_real_negate(normal.y)),
        normal);
}

// The vector with these coordinates in the frame.
CorputReal3 corput_real_frame_to_world(CorputRealFrame f, CorputReal3 local) {
    CorputReal3 side = corput_real3_add(corput_real3_scale(f.tangent, local.x),
        corput_real3_scale(f.bitangent, local.y));
    return corput_real3_add(side, corput_real3_scale(f.normal, local.z));
}

// Coordinates in the frame of this vector.
CorputReal3 corput_real_frame_to_local(CorputRealFrame f, CorputReal3 world) {
    return CorputReal3(corput_real3_dot(world, f.tangent), corput_real3_dot(world, f.bitangent),
        corput_real3_dot(world, f.normal));
}

#endif
