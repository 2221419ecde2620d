// what:   directions from the origin towards a disk in the native profile, uniformly over its
//         area, with the pdf of the direction, and inverse, by the device's own functions.
// source: PBRT 4th ed., 6.3 and 12.2.3.
// domain: a centre, a normal, a radius, of lengths from 1e-6 to 1e6; two fractions of 2^32. Seen
//         from either side. The origin in the plane of the disk, r <= 0 or a normal of 0:
//         pdf 0.
// range:  unit vectors to the device's precision; +z for a point at the origin.
// pdf:    with respect to solid angle: |p|^3 / (pi r^2 |n . p|); the edge is widened by 2^-10 of
//         the radius and by the rounding of a direction.
// errors: Vulkan allows sin and cos an absolute error of 2^-11.
// cost:   prepare 50, sample 60 float instructions.
// hooks:  none.
// mirror: src/reference/native/disk_light.rs
#ifndef CORPUT_NATIVE_DISK_LIGHT_GLSL
#define CORPUT_NATIVE_DISK_LIGHT_GLSL

#include "corput/native/disk.glsl"
#include "corput/native/frame.glsl"

struct CorputNativeDiskLight {
    vec3 center;
    CorputNativeFrame frame;
    float radius;
    // The distance of the plane.
    float height;
};

// A direction and its pdf.
struct CorputNativeLightSample {
    vec3 direction;
    float pdf;
};

// The disk with this centre, normal and radius.
CorputNativeDiskLight corput_native_disk_light_prepare(vec3 center, vec3 normal, float radius) {
    float size = sqrt(dot(normal, normal));
    vec3 n = vec3(0.0, 0.0, 1.0);
    float height = 0.0;
    if (size > 0.0) {
        n = normal / size;
        height = abs(dot(center, n));
    }
    return CorputNativeDiskLight(center, corput_native_frame(n), max(radius, 0.0), height);
}

// The pdf of the direction to a point at this distance.
float corput_native_disk_light_density(CorputNativeDiskLight light, float distance) {
    float area = light.radius * light.radius * light.height;
    return area >= 1e-37 ? min(0.31830989 * distance * distance * distance / area, 3.4e38) : 0.0;
}

// A point of the disk, as a direction.
CorputNativeLightSample corput_native_disk_light(CorputNativeDiskLight light, uvec2 u) {
    vec2 p = light.radius * corput_native_concentric_disk(u);
    vec3 point = light.center + (p.x * light.frame.tangent + p.y * light.frame.bitangent);
    float distance = sqrt(dot(point, point));
    bool apart = distance > 0.0;
    if (!apart) {
        return CorputNativeLightSample(vec3(0.0, 0.0, 1.0), 0.0);
    }
    return CorputNativeLightSample(point / distance, corput_native_disk_light_density(light, distance));
}

// The distance at which a direction meets the plane of the disk; 0 where it does not.
float corput_native_disk_light_distance(CorputNativeDiskLight light, vec3 direction) {
    float along = dot(direction, light.frame.normal);
    float side = dot(light.center, light.frame.normal);
    float signed_along = side < 0.0 ? -along : along;
    return signed_along > 0.0 ? min(light.height / signed_along, 1e12) : 0.0;
}

// Where a direction meets the plane of the disk, from its centre, over its radius.
vec2 corput_native_disk_light_point(CorputNativeDiskLight light, vec3 direction, float distance) {
    vec3 point = distance * direction - light.center;
    float scale = 1.0 / max(light.radius, 1e-18);
    return scale * vec2(dot(point, light.frame.tangent), dot(point, light.frame.bitangent));
}

// |p|^3 / (pi r^2 |n . p|) for the point p that a direction meets, else 0.
float corput_native_disk_light_pdf(CorputNativeDiskLight light, vec3 direction) {
    float distance = corput_native_disk_light_distance(light, direction);
    vec2 p = corput_native_disk_light_point(light, direction, distance);
    float slack = 9.5367432e-7 * distance * distance / max(light.radius * light.height, 1e-37);
    bool inside = distance > 0.0 && sqrt(dot(p, p)) <= 1.0009766 + slack;
    return inside ? corput_native_disk_light_density(light, distance) : 0.0;
}

// The fractions that give this direction.
uvec2 corput_native_disk_light_invert(CorputNativeDiskLight light, vec3 direction) {
    float distance = corput_native_disk_light_distance(light, direction);
    return corput_native_concentric_disk_invert(corput_native_disk_light_point(light, direction, distance));
}

#endif
