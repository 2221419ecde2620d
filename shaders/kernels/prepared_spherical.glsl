// Prepared triangles, rectangles, spheres and disks: reals in the order of their structs.
#ifndef KERNEL_PREPARED_SPHERICAL_GLSL
#define KERNEL_PREPARED_SPHERICAL_GLSL

#include "corput/disk_light.glsl"
#include "corput/sphere_light.glsl"
#include "corput/spherical_rectangle.glsl"
#include "prepared.glsl"

CorputArc prepared_arc(uint i) {
    return CorputArc(prepared_real(i), prepared_real(i + 1u));
}

CorputSphericalTriangle prepared_triangle(uint i) {
    return CorputSphericalTriangle(prepared_real3(i), prepared_real3(i + 3u), prepared_real3(i + 6u),
        prepared_arc(i + 9u), prepared_arc(i + 11u), prepared_arc(i + 13u),
        prepared_real(i + 15u), prepared_real(i + 16u),
        prepared_real3(i + 17u), prepared_real3(i + 20u), prepared_real3(i + 23u), prepared_real3(i + 26u),
        prepared_real(i + 29u));
}

CorputSphericalRectangle prepared_rectangle() {
    return CorputSphericalRectangle(prepared_triangle(0u), prepared_triangle(30u), prepared_real(60u));
}

CorputSphereLight prepared_sphere(uint i) {
    return CorputSphereLight(prepared_frame(i), prepared_real(i + 9u), prepared_real(i + 10u));
}

CorputDiskLight prepared_disk() {
    return CorputDiskLight(prepared_real3(0u), prepared_frame(3u), prepared_real(12u), prepared_real(13u));
}

void store_arc(uint i, CorputArc arc) {
    store_real(i, arc.cosine);
    store_real(i + 1u, arc.sine);
}

void store_triangle(uint i, CorputSphericalTriangle t) {
    store_real3(i, t.a);
    store_real3(i + 3u, t.b);
    store_real3(i + 6u, t.c);
    store_arc(i + 9u, t.ab);
    store_arc(i + 11u, t.bc);
    store_arc(i + 13u, t.ca);
    store_real(i + 15u, t.area);
    store_real(i + 16u, t.rest);
    store_real3(i + 17u, t.ab_normal);
    store_real3(i + 20u, t.bc_normal);
    store_real3(i + 23u, t.ca_normal);
    store_real3(i + 26u, t.tangent);
    store_real(i + 29u, t.height);
}

void store_rectangle(CorputSphericalRectangle r) {
    store_triangle(0u, r.first);
    store_triangle(30u, r.second);
    store_real(60u, r.area);
}

void store_sphere(CorputSphereLight light) {
    store_frame(0u, light.frame);
    store_real(9u, light.h);
    store_real(10u, light.sine);
}

void store_disk(CorputDiskLight light) {
    store_real3(0u, light.center);
    store_frame(3u, light.frame);
    store_real(12u, light.radius);
    store_real(13u, light.height);
}

#endif
