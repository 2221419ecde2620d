// what:   directions by the light of an environment map in the native profile, with pdf
//         and inverse: the tables of the exact one, the device's own sin, cos and sqrt.
// source: corput/environment.glsl.
// domain: as there. range: unit vectors to the device's precision.
// pdf:    with respect to solid angle, of the texel that was drawn; a lookup of the
//         direction finds another one where the device's sin and cos lead there.
// errors: Vulkan allows sin and cos an absolute error of 2^-11.
// cost:   lookups as the exact one, about 60 integer and 30 float instructions.
// hooks:  none.
// mirror: src/reference/native/environment.rs
#ifndef CORPUT_NATIVE_ENVIRONMENT_GLSL
#define CORPUT_NATIVE_ENVIRONMENT_GLSL

#include "corput/environment.glsl"
#include "corput/native/disk.glsl"

// v in units of 2^-62.
float corput_native_environment_wide(uvec2 v) {
    return float(v.y) * 9.313225746154785e-10 + float(v.x) * 2.168404344971009e-19;
}

// v as a fraction of 2^32, which may be 2^32 itself.
float corput_native_environment_weight(uvec2 v) {
    return v.y != 0u ? 1.0 : corput_native_unit(v.x);
}

// The direction at a place of a texel: fractions from its left and upper edges.
vec3 corput_native_environment_direction(uvec2 size, uvec2 texel, uvec2 place) {
    uvec2 cap = corput_environment_cap(size, texel.y);
    uvec2 extent = corput_sub64(corput_environment_cap(size, texel.y + 1u), cap);
    uvec2 down = corput_add64(cap, corput_discrete_scale(extent, place.y));
    down = corput_add64(down, corput_shr64(extent, 33u));
    uvec2 up = corput_sub64(uvec2(0u, 0x80000000u), down);
    float z = down.y >= 0x40000000u ? corput_native_environment_wide(up) - 1.0
        : 1.0 - corput_native_environment_wide(down);
    float radius = sqrt(corput_native_environment_wide(down) * corput_native_environment_wide(up));
    float phi = 1.4629180792671596e-9 * float(int(corput_discrete_divide(uvec2(place.x, texel.x), size.x)));
    return vec3(radius * cos(phi), radius * sin(phi), corput_environment_z(size, texel.y, z));
}

// Probability over the solid angle of a texel of this row.
float corput_native_environment_density(uvec2 size, uint row, float probability) {
    uvec2 extent = corput_sub64(corput_environment_cap(size, row + 1u), corput_environment_cap(size, row));
    return probability * (0.15915494 * float(size.x)) / corput_native_environment_wide(extent);
}

// Pdf of the hierarchical tables in a texel, as column and row.
float corput_native_environment_texel_pdf(uvec2 size, uvec2 texel) {
    uvec2 row = corput_cdf_weight(corput_environment_first(size), texel.y);
    uvec2 column = corput_cdf_weight(corput_environment_row(size, texel.y), texel.x);
    return corput_native_environment_density(size, texel.y,
        corput_native_environment_weight(row) * corput_native_environment_weight(column));
}

// Direction by the hierarchical tables: u.x gives the row, u.y the column.
CorputEnvironment corput_native_environment(uvec2 size, uvec2 u) {
    CorputChoice row = corput_cdf(corput_environment_first(size), u.x);
    CorputChoice column = corput_cdf(corput_environment_row(size, row.index), u.y);
    float probability = corput_native_environment_weight(row.weight) * corput_native_environment_weight(column.weight);
    return CorputEnvironment(
        corput_native_environment_direction(size, uvec2(column.index, row.index), uvec2(column.rest, row.rest)),
        corput_native_environment_density(size, row.index, probability));
}

// The density with which corput_native_environment draws in the texel of a direction.
float corput_native_environment_pdf(uvec2 size, vec3 direction) {
    return corput_native_environment_texel_pdf(size, corput_envmap_texel(direction, size));
}

// The fractions that give this direction by the hierarchical tables.
uvec2 corput_native_environment_invert(uvec2 size, vec3 direction) {
    return corput_environment_invert(size, direction);
}

// Pdf of the alias table in a texel, as column and row.
float corput_native_environment_alias_texel_pdf(uvec2 size, uvec2 texel) {
    uvec2 weight = corput_alias_weight(corput_environment_first(size), texel.y * size.x + texel.x);
    return corput_native_environment_density(size, texel.y, corput_native_environment_weight(weight));
}

// Direction by the alias table: u.x gives the texel, u.y the place across, u.z down.
CorputEnvironment corput_native_environment_alias(uvec2 size, uvec3 u) {
    uint index = corput_alias_index(corput_environment_first(size), size.x * size.y, u.x);
    uint row = index / size.x;
    uvec2 texel = uvec2(index - row * size.x, row);
    return CorputEnvironment(corput_native_environment_direction(size, texel, u.yz),
        corput_native_environment_alias_texel_pdf(size, texel));
}

// The density with which corput_native_environment_alias draws in the texel of a direction.
float corput_native_environment_alias_pdf(uvec2 size, vec3 direction) {
    return corput_native_environment_alias_texel_pdf(size, corput_envmap_texel(direction, size));
}

#endif
