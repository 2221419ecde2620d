// what:   the texel of an equirectangular environment map that a direction meets.
// source: row 0 lies at +z; column c has its centre at azimuth 2 pi (c + 1/2) / width;
//         nearest texel. Rows are found by binary search over the host's row edges, so
//         no arc cosine is needed.
// domain: unit directions; widths and heights from 1 to 65536.
// range:  x: column, below the width; y: row, below the height.
// cost:   log2(height) lookups and one corput_atan2. tier I.
// hooks:  CORPUT_ENVMAP_EDGE(i): bits of the float cos(pi i / height), 1 <= i < height.
// mirror: src/reference/envmap.rs
#ifndef CORPUT_ENVMAP_GLSL
#define CORPUT_ENVMAP_GLSL

#ifndef CORPUT_ENVMAP_EDGE
#error define CORPUT_ENVMAP_EDGE(i), the bits of the float cos(pi i / height), before this header
#endif

#include "corput/elementary.glsl"

// A word that grows with the float of these bits.
uint corput_envmap_order(uint bits) {
    return (bits >> 31) != 0u ? ~bits : bits | 0x80000000u;
}

// Column and row of the texel in this direction.
uvec2 corput_envmap_texel(vec3 direction, uvec2 size) {
    uint z = corput_envmap_order(floatBitsToUint(direction.z));
    uint low = 0u;
    uint high = size.y - 1u;
    while (low < high) {
        uint middle = (low + high + 1u) >> 1;
        if (z <= corput_envmap_order(CORPUT_ENVMAP_EDGE(middle))) {
            low = middle;
        } else {
            high = middle - 1u;
        }
    }
    return uvec2(corput_mulhi(corput_atan2(direction.y, direction.x), size.x), low);
}

#endif
