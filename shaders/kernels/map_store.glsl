// The store of four rows of one to four words.
#ifndef KERNEL_MAP_STORE_GLSL
#define KERNEL_MAP_STORE_GLSL

// Stores the first `width` words of each from results[at] on.
void map_store(uint at, uint width, uvec4 p0, uvec4 p1, uvec4 p2, uvec4 p3) {
    if (width == 1u) {
        results[at] = uvec4(p0.x, p1.x, p2.x, p3.x);
    } else if (width == 2u) {
        results[at] = uvec4(p0.xy, p1.xy);
        results[at + 1u] = uvec4(p2.xy, p3.xy);
    } else if (width == 3u) {
        results[at] = uvec4(p0.xyz, p1.x);
        results[at + 1u] = uvec4(p1.yz, p2.xy);
        results[at + 2u] = uvec4(p2.z, p3.xyz);
    } else {
        results[at] = p0;
        results[at + 1u] = p1;
        results[at + 2u] = p2;
        results[at + 3u] = p3;
    }
}

#endif
