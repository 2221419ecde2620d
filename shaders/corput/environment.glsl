// what:   directions by the light of an environment map, with pdf and inverse: row and
//         column by CDFs, or the texel by an alias table; within it uniform in solid angle.
// source: Pharr, Jakob and Humphreys, PBRT 4th ed., 12.5, on integer weights times exact
//         solid angles; discrete.glsl.
// domain: fractions of 2^32; tables as the host's `environment::Environment` makes them,
//         1 x 1 to 8192 x 4096 texels. The map's orientation is that of envmap.glsl.
// range:  unit vectors to 2^-23. A direction drawn in a texel is one that
//         corput_envmap_texel finds in it, always: z keeps within the floats of its row
//         and the azimuth 2^-26 of a turn from the column's ends.
// pdf:    with respect to solid angle, constant in a texel: its probability, an integer
//         over 2^64 (alias: 2^32), over its exact solid angle. 0 for texels without light,
//         which are never drawn.
// errors: x, y 0.6 ULP, z 1.5 ULP, pdf 0.6 ULP. Inverses agree within the texel to what the
//         rounding of the direction leaves, 2^-23 over the texel's extent; in the texel
//         of a pole, where 2^-23 passes for all of z, they take 1 - |z| from x and y.
// cost:   log2(width) + log2(height) lookups (alias: 6) and 250 integer instructions; the
//         pdf of a direction log2(height) lookups and 250. tier I.
// hooks:  CORPUT_DISCRETE(i): word i of the environment's tables, all chunks as one;
//         CORPUT_ENVMAP_EDGE(i): that too unless defined, since the edges lie first.
// mirror: src/reference/environment.rs
#ifndef CORPUT_ENVIRONMENT_GLSL
#define CORPUT_ENVIRONMENT_GLSL

#ifndef CORPUT_DISCRETE
#error define CORPUT_DISCRETE(i), word i of the tables, before this header
#endif
#ifndef CORPUT_ENVMAP_EDGE
#define CORPUT_ENVMAP_EDGE(i) CORPUT_DISCRETE(i)
#endif

#include "corput/discrete.glsl"
#include "corput/envmap.glsl"

// A direction and its pdf.
struct CorputEnvironment {
    vec3 direction;
    float pdf;
};

// 1 - z of a row's upper edge, in units of 2^-62; of row `height` it is that of the pole.
uvec2 corput_environment_cap(uvec2 size, uint row) {
    uint at = size.y + 2u * row;
    return uvec2(CORPUT_DISCRETE(at), CORPUT_DISCRETE(at + 1u));
}

// First word of the marginal CDF, or of the alias table.
uint corput_environment_first(uvec2 size) {
    return 3u * size.y + 2u;
}

// First word of a row's CDF.
uint corput_environment_row(uvec2 size, uint row) {
    return 4u * size.y + 2u + row * size.x;
}

// The float nearest to z that lies in the row, by the edges of corput_envmap_texel.
float corput_environment_z(uvec2 size, uint row, float z) {
    uint order = corput_envmap_order(floatBitsToUint(z));
    if (row + 1u < size.y) {
        order = max(order, corput_envmap_order(CORPUT_ENVMAP_EDGE(row + 1u)) + 1u);
    }
    if (row > 0u) {
        order = min(order, corput_envmap_order(CORPUT_ENVMAP_EDGE(row)));
    }
    // The least above an edge at 0 would be a denormal.
    if (order > 0x80000000u && order < 0x80800000u) {
        order = 0x80800000u;
    }
    return uintBitsToFloat((order >> 31) != 0u ? order & 0x7fffffffu : ~order);
}

// The direction at a place of a texel: fractions from its left and upper edges.
vec3 corput_environment_direction(uvec2 size, uvec2 texel, uvec2 place) {
    uvec2 cap = corput_environment_cap(size, texel.y);
    uvec2 extent = corput_sub64(corput_environment_cap(size, texel.y + 1u), cap);
    // 1 - z and 1 + z, neither by a difference that cancels; the fraction's middle, which
    // is never at a pole, where the azimuth would be lost.
    uvec2 down = corput_add64(cap, corput_discrete_scale(extent, place.y));
    down = corput_add64(down, corput_shr64(extent, 33u));
    uvec2 up = corput_sub64(uvec2(0u, 0x80000000u), down);
    bool below = down.y >= 0x40000000u;
    uvec2 rest = corput_sub64(uvec2(0u, 0x40000000u), below ? up : down);
    CorputReal z = corput_real_wide(rest, -62);
    CorputReal radius = corput_real_sqrt(corput_real_multiply(corput_real_wide(down, -62), corput_real_wide(up, -62)));
    // 2^-26 of a turn is more than what rounding x and y to floats can turn them by.
    uint margin = size.x << 6;
    uint across = clamp(place.x, margin, ~margin);
    CorputSinCos phi = corput_sincos_scaled(corput_discrete_divide(uvec2(across, texel.x), size.x));
    return vec3(corput_real_float(corput_real_multiply(radius, corput_real_scaled(phi.cosine, phi.cosine_negative))),
        corput_real_float(corput_real_multiply(radius, corput_real_scaled(phi.sine, phi.sine_negative))),
        corput_environment_z(size, texel.y, corput_real_float(below ? corput_real_negate(z) : z)));
}

// Probability over the solid angle of a texel of this row.
float corput_environment_density(uvec2 size, uint row, CorputReal probability) {
    uvec2 extent = corput_sub64(corput_environment_cap(size, row + 1u), corput_environment_cap(size, row));
    CorputReal texels = corput_real_multiply(probability, corput_real_uint(size.x, 0));
    // width / (2 pi), and 1/(2 pi) to 32 bits.
    CorputReal turn = corput_real_multiply(texels, corput_real_uint(2734261102u, -34));
    return corput_real_float(corput_real_divide(turn, corput_real_wide(extent, -62)));
}

// Pdf of the hierarchical tables in a texel, as column and row.
float corput_environment_texel_pdf(uvec2 size, uvec2 texel) {
    uvec2 row = corput_cdf_weight(corput_environment_first(size), texel.y);
    uvec2 column = corput_cdf_weight(corput_environment_row(size, texel.y), texel.x);
    return corput_environment_density(size, texel.y,
        corput_real_multiply(corput_real_wide(row, -32), corput_real_wide(column, -32)));
}

// Direction by the hierarchical tables: u.x gives the row, u.y the column.
CorputEnvironment corput_environment(uvec2 size, uvec2 u) {
    CorputChoice row = corput_cdf(corput_environment_first(size), u.x);
    CorputChoice column = corput_cdf(corput_environment_row(size, row.index), u.y);
    CorputReal probability = corput_real_multiply(corput_real_wide(row.weight, -32), corput_real_wide(column.weight, -32));
    return CorputEnvironment(
        corput_environment_direction(size, uvec2(column.index, row.index), uvec2(column.rest, row.rest)),
        corput_environment_density(size, row.index, probability));
}

// The density with which corput_environment draws a direction.
float corput_environment_pdf(uvec2 size, vec3 direction) {
    return corput_environment_texel_pdf(size, corput_envmap_texel(direction, size));
}

// Place of a direction in its texel: fractions from the left and upper edges.
uvec2 corput_environment_place(uvec2 size, vec3 direction, uvec2 texel) {
    uint across = corput_mul64(corput_atan2(direction.y, direction.x), size.x).x;
    CorputReal one = corput_real_uint(1u, 0);
    CorputReal z = corput_real(direction.z);
    CorputReal near = corput_real(uintBitsToFloat(floatBitsToUint(direction.z) & 0x7fffffffu));
    CorputReal cap = corput_real_subtract(one, near);
    // Near a pole x and y tell 1 - |z| better than z does.
    if (!corput_real_less(near, corput_real_uint(1u, -1))) {
        CorputReal x = corput_real_square(corput_real(direction.x));
        CorputReal y = corput_real_square(corput_real(direction.y));
        cap = corput_real_divide(corput_real_add(x, y), corput_real_add(one, near));
    }
    // From the upper edge, or from the lower one where the pole below is nearer.
    bool below = z.negative;
    uvec2 upper = corput_environment_cap(size, texel.y);
    uvec2 lower = corput_environment_cap(size, texel.y + 1u);
    uvec2 edge = below ? corput_sub64(uvec2(0u, 0x80000000u), lower) : upper;
    CorputReal extent = corput_real_wide(corput_sub64(lower, upper), -62);
    CorputReal down = corput_real_subtract(cap, corput_real_wide(edge, -62));
    uint fraction = corput_real_fraction(corput_real_divide(down, extent));
    return uvec2(across, below ? ~fraction : fraction);
}

// The fractions that give this direction by the hierarchical tables.
uvec2 corput_environment_invert(uvec2 size, vec3 direction) {
    uvec2 texel = corput_envmap_texel(direction, size);
    uvec2 place = corput_environment_place(size, direction, texel);
    return uvec2(corput_cdf_invert(corput_environment_first(size), texel.y, place.y),
        corput_cdf_invert(corput_environment_row(size, texel.y), texel.x, place.x));
}

// Pdf of the alias table in a texel, as column and row.
float corput_environment_alias_texel_pdf(uvec2 size, uvec2 texel) {
    uvec2 weight = corput_alias_weight(corput_environment_first(size), texel.y * size.x + texel.x);
    return corput_environment_density(size, texel.y, corput_real_wide(weight, -32));
}

// Direction by the alias table: u.x gives the texel, u.y the place across, u.z down.
CorputEnvironment corput_environment_alias(uvec2 size, uvec3 u) {
    uint index = corput_alias_index(corput_environment_first(size), size.x * size.y, u.x);
    uint row = index / size.x;
    uvec2 texel = uvec2(index - row * size.x, row);
    return CorputEnvironment(corput_environment_direction(size, texel, u.yz),
        corput_environment_alias_texel_pdf(size, texel));
}

// The density with which corput_environment_alias draws a direction.
float corput_environment_alias_pdf(uvec2 size, vec3 direction) {
    return corput_environment_alias_texel_pdf(size, corput_envmap_texel(direction, size));
}

#endif
