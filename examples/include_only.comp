#version 450
#extension GL_GOOGLE_include_directive : require
// An engine's own shader, whose names were there before corput's headers: functions, structs and
// macros called as the headers would call theirs, did not everything in them begin with corput_,
// Corput or CORPUT_. It declares its own bindings; the headers declare none.
layout(local_size_x = 64) in;
layout(std430, set = 0, binding = 0) writeonly buffer Samples { uvec4 samples[]; };
layout(std430, set = 0, binding = 1) readonly buffer Directions { uint directions[]; };

// Macros are the hardest neighbours: they reach into what is included after them.
#define PI 3.14159265
#define TAU (2.0 * PI)
#define EPSILON 1e-6
#define SEED 7u
#define LENS 1u
#define saturate(x) clamp((x), 0.0, 1.0)

struct Cursor {
    uint n;
    uint state;
};

struct Domain {
    uvec2 pixel;
};

uint hash(uint x) {
    return (x ^ (x >> 16)) * 0x9e3779b9u;
}

uint random(inout Cursor c) {
    c.state = hash(c.state + c.n);
    return c.state;
}

// Hooks: direction numbers of the Sobol sequence from a buffer, primes of Halton's by number.
#define CORPUT_SOBOL_DIRECTION(dimension, bit) directions[32u * (dimension) + (bit)]
#define CORPUT_PRIME(d) ((d) == 0u ? 2u : 3u)
#include "corput/sobol.glsl"
#include "corput/halton.glsl"
#include "corput/hemisphere.glsl"
#include "corput/domain_draw.glsl"

uint sobol(uint n) {
    return bitfieldReverse(n);
}

uvec2 halton(uint n) {
    return uvec2(sobol(n), n / 3u);
}

uvec2 disk(uvec2 u) {
    return u.yx ^ 1u;
}

uint permute(uint i, uint length, uint seed) {
    return (i + seed) % length;
}

void main() {
    uint i = gl_GlobalInvocationID.x;

    // The headers'.
    uvec2 point = uvec2(corput_sobol(i, 0u), corput_sobol(i, 1u));
    samples[4u * i] = uvec4(point, floatBitsToUint(corput_concentric_disk(point)));
    vec3 direction = corput_cosine_hemisphere(uvec2(corput_halton(i, 0u), corput_halton(i, 1u)));
    float pdf = corput_cosine_hemisphere_pdf(direction);
    samples[4u * i + 1u] = uvec4(floatBitsToUint(direction), floatBitsToUint(pdf));
    Domain own = Domain(uvec2(i % 8u, i / 8u));
    CorputDomain camera = corput_domain(own.pixel, 0u, i, SEED);
    samples[4u * i + 2u] = corput_draw_pairs(corput_domain_child(camera, LENS));

    // The engine's, beside one of the headers'.
    Cursor c = Cursor(i, SEED);
    uvec2 turned = disk(halton(i));
    samples[4u * i + 3u] = uvec4(random(c), turned.x + turned.y, permute(i, 100u, SEED),
        corput_random(i, 0u, uvec2(SEED, 0u)));
}
