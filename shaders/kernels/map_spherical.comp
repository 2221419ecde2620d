#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
// Uniform directions of solid angles, of points in memory.
#include "interface.glsl"
#ifdef KERNEL_NATIVE
#include "corput/native/cone.glsl"
#include "corput/native/disk_light.glsl"
#include "corput/native/sphere_light.glsl"
#include "corput/native/spherical_rectangle.glsl"
#define MAP_FUNCTION(name) corput_native_##name
#define MAP_STRUCT(name) CorputNative##name
#else
#include "corput/cone.glsl"
#include "prepared_spherical.glsl"
#define MAP_FUNCTION(name) corput_##name
#define MAP_STRUCT(name) Corput##name
#endif

const uint UNIFORM_SPHERE = 32u;
const uint CONE = 33u;
const uint SPHERICAL_TRIANGLE = 34u;
const uint SPHERICAL_RECTANGLE = 35u;
const uint SPHERE_LIGHT = 36u;
const uint DISK_LIGHT = 37u;

// The bits of a direction, and of its pdf.
uvec4 words(vec3 d, float pdf) {
    return floatBitsToUint(vec4(d, pdf));
}

// The first three vectors of the parameters.
vec3 first() {
    return uintBitsToFloat(uvec3(push.p0, push.p1, push.p2));
}

vec3 second() {
    return uintBitsToFloat(uvec3(push.p3, push.p4, push.p5));
}

vec3 third() {
    return uintBitsToFloat(uvec3(push.p6, push.p7, push.p8));
}

MAP_STRUCT(SphericalTriangle) prepare_triangle() {
    return MAP_FUNCTION(spherical_triangle_prepare)(first(), second(), third());
}

MAP_STRUCT(SphericalRectangle) prepare_rectangle() {
    return MAP_FUNCTION(spherical_rectangle_prepare)(first(), second(), third());
}

MAP_STRUCT(SphereLight) prepare_sphere() {
    return MAP_FUNCTION(sphere_light_prepare)(first(), uintBitsToFloat(push.p3));
}

MAP_STRUCT(DiskLight) prepare_disk() {
    return MAP_FUNCTION(disk_light_prepare)(first(), second(), uintBitsToFloat(push.p6));
}

#ifdef KERNEL_NATIVE
MAP_STRUCT(SphericalTriangle) triangle() {
    return prepare_triangle();
}

MAP_STRUCT(SphericalRectangle) rectangle() {
    return prepare_rectangle();
}

MAP_STRUCT(SphereLight) sphere() {
    return prepare_sphere();
}

MAP_STRUCT(DiskLight) disk() {
    return prepare_disk();
}
#else
MAP_STRUCT(SphericalTriangle) triangle() {
    return prepared_triangle(0u);
}

MAP_STRUCT(SphericalRectangle) rectangle() {
    return prepared_rectangle();
}

MAP_STRUCT(SphereLight) sphere() {
    return prepared_sphere(0u);
}

MAP_STRUCT(DiskLight) disk() {
    return prepared_disk();
}

void map_prepare() {
    if (MAP == SPHERICAL_TRIANGLE) {
        store_triangle(0u, prepare_triangle());
    } else if (MAP == SPHERICAL_RECTANGLE) {
        store_rectangle(prepare_rectangle());
    } else if (MAP == SPHERE_LIGHT) {
        store_sphere(prepare_sphere());
    } else if (MAP == DISK_LIGHT) {
        store_disk(prepare_disk());
    }
}
#define MAP_PREPARED map_prepare();
#endif

uvec4 map_sample(uvec3 u) {
    if (MAP == UNIFORM_SPHERE) {
        return words(MAP_FUNCTION(uniform_sphere)(u.xy), MAP_FUNCTION(uniform_sphere_pdf)());
    }
    if (MAP == CONE) {
        float h = uintBitsToFloat(push.p0);
        vec3 d = MAP_FUNCTION(cone)(h, u.xy);
        return words(d, WITH_PDF != 0u ? MAP_FUNCTION(cone_pdf)(h, d) : 0.0);
    }
    if (MAP == SPHERICAL_TRIANGLE) {
        MAP_STRUCT(SphericalTriangle) seen = triangle();
        vec3 d = MAP_FUNCTION(spherical_triangle)(seen, u.xy);
        return words(d, WITH_PDF != 0u ? MAP_FUNCTION(spherical_triangle_density)(seen) : 0.0);
    }
    if (MAP == SPHERICAL_RECTANGLE) {
        MAP_STRUCT(SphericalRectangle) seen = rectangle();
        vec3 d = MAP_FUNCTION(spherical_rectangle)(seen, u.xy);
        return words(d, WITH_PDF != 0u ? MAP_FUNCTION(spherical_rectangle_density)(seen) : 0.0);
    }
    if (MAP == SPHERE_LIGHT) {
        MAP_STRUCT(SphereLight) seen = sphere();
        vec3 d = MAP_FUNCTION(sphere_light)(seen, u.xy);
        return words(d, WITH_PDF != 0u ? MAP_FUNCTION(sphere_light_pdf)(seen, d) : 0.0);
    }
    if (MAP == DISK_LIGHT) {
        MAP_STRUCT(LightSample) made = MAP_FUNCTION(disk_light)(disk(), u.xy);
        return words(made.direction, made.pdf);
    }
    return uvec4(0u);
}

uint map_pdf(uvec4 s) {
    vec3 d = uintBitsToFloat(s.xyz);
    if (MAP == UNIFORM_SPHERE) {
        return floatBitsToUint(MAP_FUNCTION(uniform_sphere_pdf)());
    }
    if (MAP == CONE) {
        return floatBitsToUint(MAP_FUNCTION(cone_pdf)(uintBitsToFloat(push.p0), d));
    }
    if (MAP == SPHERICAL_TRIANGLE) {
        return floatBitsToUint(MAP_FUNCTION(spherical_triangle_pdf)(triangle(), d));
    }
    if (MAP == SPHERICAL_RECTANGLE) {
        return floatBitsToUint(MAP_FUNCTION(spherical_rectangle_pdf)(rectangle(), d));
    }
    if (MAP == SPHERE_LIGHT) {
        return floatBitsToUint(MAP_FUNCTION(sphere_light_pdf)(sphere(), d));
    }
    if (MAP == DISK_LIGHT) {
        return floatBitsToUint(MAP_FUNCTION(disk_light_pdf)(disk(), d));
    }
    return 0u;
}

uvec3 map_invert(uvec4 s) {
    vec3 d = uintBitsToFloat(s.xyz);
    if (MAP == UNIFORM_SPHERE) {
        return uvec3(MAP_FUNCTION(uniform_sphere_invert)(d), 0u);
    }
    if (MAP == CONE) {
        return uvec3(MAP_FUNCTION(cone_invert)(uintBitsToFloat(push.p0), d), 0u);
    }
    if (MAP == SPHERICAL_TRIANGLE) {
        return uvec3(MAP_FUNCTION(spherical_triangle_invert)(triangle(), d), 0u);
    }
    if (MAP == SPHERICAL_RECTANGLE) {
        return uvec3(MAP_FUNCTION(spherical_rectangle_invert)(rectangle(), d), 0u);
    }
    if (MAP == SPHERE_LIGHT) {
        return uvec3(MAP_FUNCTION(sphere_light_invert)(sphere(), d), 0u);
    }
    if (MAP == DISK_LIGHT) {
        return uvec3(MAP_FUNCTION(disk_light_invert)(disk(), d), 0u);
    }
    return uvec3(0u);
}

// Unrolled, long bodies take compilers minutes.
#define MAP_LOOP [[dont_unroll]]
#include "map_main.glsl"
