// what:   directions from the origin towards a disk, uniformly over its area, with the pdf
//         of the direction, and inverse.
// source: PBRT 4th ed., 6.3 and 12.2.3: an area element dA at p seen from the origin spans
//         the solid angle |n . p| dA / |p|^3; n . p is that of the centre for the whole disk.
// domain: a centre, a normal of any length, a radius; two fractions of 2^32. Seen from either
//         side. The origin in the plane of the disk, r <= 0 or a normal of 0: pdf 0.
// range:  unit vectors to 2^-23; +z for a point at the origin.
// pdf:    with respect to solid angle: |p|^3 / (pi r^2 |n . p|). That of a sample is of its
//         point, before the direction is rounded; the one of a direction is of the point that
//         the rounded direction meets. The edge is widened by 2^-20 of the radius and of the
//         rounding.
// errors: 1 + 2 r/|p| ULP a coordinate, those below 1/4 in ULP of it, as the point of the unit
//         disk is rounded as well; pdf of a sample as much.
//         The inverse agrees with the sample to 2^-20, more where the rounding of a direction
//         is more of the disk's angle.
// cost:   prepare 1,500, sample 1,300 integer instructions. tier I.
// hooks:  none.
// mirror: src/reference/disk_light.rs
#ifndef CORPUT_DISK_LIGHT_GLSL
#define CORPUT_DISK_LIGHT_GLSL

#include "corput/disk.glsl"
#include "corput/real_frame.glsl"
#include "corput/wide.glsl"

struct CorputDiskLight {
    CorputReal3 center;
    CorputRealFrame frame;
    CorputReal radius;
    // The distance of the plane: |n . center|, n of length 1.
    CorputReal height;
};

// A direction and its pdf.
struct CorputLightSample {
    vec3 direction;
    float pdf;
};

// The disk with this centre, normal and radius.
CorputDiskLight corput_disk_light_prepare(vec3 center, vec3 normal, float radius) {
    CorputReal3 c = corput_real3(center);
    CorputReal3 n = corput_real3(normal);
    CorputWide product = corput_wide_add(
        corput_wide_add(corput_wide_product(c.x, n.x), corput_wide_product(c.y, n.y)), corput_wide_product(c.z, n.z));
    CorputReal height = corput_real_divide(corput_wide_real(product), corput_real3_length(n));
    return CorputDiskLight(
        c,
        corput_real_frame(corput_real3_normalize(n)),
        corput_real_max(corput_real(radius), corput_real_zero()),
        CorputReal(height.m, height.e, false));
}

// The pdf of the direction to a point at this distance.
float corput_disk_light_density(CorputDiskLight light, CorputReal distance) {
    if (light.height.m == 0u || light.radius.m == 0u) {
        return 0.0;
    }
    CorputReal cube = corput_real_multiply(corput_real_square(distance), distance);
    // 1/pi to 32 bits.
    CorputReal part = corput_real_multiply(cube, corput_real_uint(2734261102u, -33));
    return corput_real_float(corput_real_divide(part,
        corput_real_multiply(corput_real_square(light.radius), light.height)));
}

// A point of the disk, as a direction.
CorputLightSample corput_disk_light(CorputDiskLight light, uvec2 u) {
    vec2 p = corput_concentric_disk(u);
    CorputReal3 side = corput_real3_add(
        corput_real3_scale(light.frame.tangent, corput_real_multiply(corput_real(p.x), light.radius)),
        corput_real3_scale(light.frame.bitangent, corput_real_multiply(corput_real(p.y), light.radius)));
    CorputReal3 point = corput_real3_add(light.center, side);
    CorputReal distance = corput_real3_length(point);
    if (distance.m == 0u) {
        return CorputLightSample(vec3(0.0, 0.0, 1.0), 0.0);
    }
    return CorputLightSample(corput_real3_floats(corput_real3_normalize(point)),
        corput_disk_light_density(light, distance));
}

// The distance at which a direction meets the plane of the disk; 0 where it does not.
CorputReal corput_disk_light_distance(CorputDiskLight light, CorputReal3 direction) {
    CorputReal3 n = light.frame.normal;
    CorputReal along = corput_real3_dot(direction, n);
    CorputReal center = corput_real3_dot(light.center, n);
    if (along.m == 0u || along.negative != center.negative) {
        return corput_real_zero();
    }
    return corput_real_divide(light.height, CorputReal(along.m, along.e, false));
}

// Where a direction meets the plane of the disk, from its centre, over its radius.
CorputReal3 corput_disk_light_point(CorputDiskLight light, CorputReal3 direction, CorputReal distance) {
    CorputReal3 point = corput_real3_subtract(corput_real3_scale(direction, distance), light.center);
    CorputReal3 local = corput_real_frame_to_local(light.frame, point);
    return CorputReal3(corput_real_divide(local.x, light.radius), corput_real_divide(local.y, light.radius),
        corput_real_zero());
}

// |p|^3 / (pi r^2 |n . p|) for the point p that a direction meets, else 0.
float corput_disk_light_pdf(CorputDiskLight light, vec3 direction) {
    CorputReal3 d = corput_real3(direction);
    CorputReal distance = corput_disk_light_distance(light, d);
    if (distance.m == 0u || light.radius.m == 0u) {
        return 0.0;
    }
    CorputReal3 p = corput_disk_light_point(light, d, distance);
    CorputReal slope = corput_real_divide(distance, light.height);
    CorputReal one = corput_real_uint(1u, 0);
    // The rounding of d moves the point by 2^-23 of its distance, over the cosine.
    CorputReal slack = corput_real_divide(corput_real_multiply(distance, slope), light.radius);
    CorputReal most = corput_real_add(corput_real_add(one, corput_real_uint(1u, -20)), corput_real_shift(slack, -22));
    if (corput_real_less(most, corput_real3_length(p))) {
        return 0.0;
    }
    return corput_disk_light_density(light, distance);
}

// The fractions that give this direction.
uvec2 corput_disk_light_invert(CorputDiskLight light, vec3 direction) {
    CorputReal3 d = corput_real3(direction);
    CorputReal3 p = corput_disk_light_point(light, d, corput_disk_light_distance(light, d));
    return corput_concentric_disk_invert(vec2(corput_real_float(p.x), corput_real_float(p.y)));
}

#endif
