// what:   directions around an axis, for surfaces that face along one.
// source: the definitions.
// domain: axes 0 to 5: +x, -x, +y, -y, +z, -z. Any vectors.
// range:  exact: coordinates change places and signs.
// cost:   20 integer instructions. tier I.
// hooks:  none.
// mirror: src/reference/axis.rs
#ifndef CORPUT_AXIS_GLSL
#define CORPUT_AXIS_GLSL

#include "corput/real.glsl"

// The direction with +z turned to the axis, exactly: coordinates change places, and for a
// negative axis the signs of two, half a turn about an axis across.
vec3 corput_axis_turned(vec3 d, uint axis) {
    vec3 v = d;
    if (axis < 4u) {
        v = d.yzx;
    }
    if (axis < 2u) {
        v = d.zxy;
    }
    uint first = uint(axis == 1u);
    uint second = uint(axis == 3u);
    uint third = uint(axis == 5u);
    return vec3(uintBitsToFloat(floatBitsToUint(v.x) ^ ((first | third) << 31)),
        uintBitsToFloat(floatBitsToUint(v.y) ^ ((first | second) << 31)),
        uintBitsToFloat(floatBitsToUint(v.z) ^ ((second | third) << 31)));
}

// The cosine of the angle to the axis, 0 for more than a right one.
CorputReal corput_axis_cosine(vec3 d, uint axis) {
    float along = d.z;
    if (axis < 4u) {
        along = d.y;
    }
    if (axis < 2u) {
        along = d.x;
    }
    CorputReal cosine = corput_real(uintBitsToFloat(floatBitsToUint(along) ^ (axis << 31)));
    if (cosine.negative) {
        cosine = corput_real_zero();
    }
    return cosine;
}

#endif
