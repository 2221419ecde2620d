// what:   reflection at the visible normals of a GGX lobe by spherical caps, with pdf and
//         inverse.
// source: Dupuy and Benyoub 2023, Sampling visible GGX normals with spherical caps, CGF
//         42(8): seen from V, the reflections V' of a unit sphere's visible normals fill the
//         cap z > -b uniformly, b = V.z. Their 1 - z^2 cancels; here 1 - z = u (1 + b) and
//         1 + z = (1 - u)(1 + b) + (1 - b), and the z of V + V' is (1 - u)(1 + b) + V.z - b.
// domain: two fractions of 2^32: u.x height, u.y angle around +z. Lobes as ggx_lobe.glsl.
// range:  unit vectors to 2^-23.
// pdf:    with respect to solid angle. A direction of the rim may be rounded out of the cap.
// errors: a coordinate half a ULP and 2^-26 + 2^-31 k / V.n, k the largest of alpha_x, alpha_y
//         and 1 over the least. The pdf 0.9 ULP and 2^-30 k where V.n is above 1/64, and
//         2^-28 k / V.n of it where the sampled normal is nearer to perpendicular to wo, for V + V'
//         is then a small sum of two unit vectors. The inverse agrees with the sample to
//         2^-20 + 2^-21 / (alpha |wo + wi|).
// cost:   1300 integer instructions, and 1200 for the lobe. tier I.
// hooks:  none.
// mirror: src/reference/ggx_vndf_cap.rs
#ifndef CORPUT_GGX_VNDF_CAP_GLSL
#define CORPUT_GGX_VNDF_CAP_GLSL

#include "corput/ggx_lobe.glsl"

// V + V' for a point V' of the cap.
CorputReal3 corput_ggx_cap_sum(CorputGgx g, uvec2 u) {
    CorputReal height = corput_real_multiply(corput_real_complement(u.x), g.cap_above);
    CorputReal below = corput_real_multiply(corput_real_uint(u.x, -32), g.cap_above);
    CorputReal above = corput_real_add(height, g.cap_below);
    CorputReal radius = corput_real_sqrt(corput_real_multiply(below, above));
    CorputReal3 around = corput_real3_around(radius, u.y, corput_real_add(height, g.excess));
    return CorputReal3(corput_real_add(around.x, g.view.x), corput_real_add(around.y, g.view.y), around.z);
}

// Direction and pdf.
CorputScattered corput_ggx_vndf_cap(CorputGgx g, uvec2 u) {
    CorputReal3 n = corput_ggx_cap_sum(g, u);
    CorputReal square = corput_real3_dot(n, n);
    CorputReal3 s = corput_ggx_stretched(g.alpha_x, g.alpha_y, n);
    CorputReal s_square = corput_real3_dot(s, s);
    // Of a small n half its square is not V.n to all its digits.
    CorputReal3 wi = corput_real3_normalize(corput_ggx_reflected(g, s, s_square, corput_real_shift(square, -1)));
    return corput_scattered(wi, corput_ggx_reflected_pdf(g, s_square, square));
}

// The pdf of a direction.
float corput_ggx_vndf_cap_pdf(CorputGgx g, vec3 wi) {
    return corput_ggx_pdf(g, wi);
}

// The fractions that give this direction.
uvec2 corput_ggx_vndf_cap_invert(CorputGgx g, vec3 wi) {
    CorputReal3 n = corput_ggx_sphere_sum(g, corput_ggx_half(g, wi));
    CorputReal x = corput_real_subtract(n.x, g.view.x);
    CorputReal y = corput_real_subtract(n.y, g.view.y);
    CorputReal height = corput_real_subtract(n.z, g.excess);
    CorputReal above = corput_real_add(height, g.cap_below);
    CorputReal square = corput_real_add(corput_real_square(x), corput_real_square(y));
    CorputReal below = corput_real_divide(square, above);
    return uvec2(corput_real_fraction_of(corput_real_divide(below, g.cap_above),
        corput_real_divide(height, g.cap_above)), corput_real_turns(y, x));
}

#endif
