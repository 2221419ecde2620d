// what:   the visible normals of a GGX lobe, and reflection at them, with pdf and inverse.
// source: Heitz 2018, Sampling the GGX distribution of visible normals, JCGT 7(4): with
//         V = (sin e, cos), t1 = sqrt(u) cos phi, A = sqrt(1 - t1^2), s = (1 + V.z) / 2 and
//         t2 = A - s (A - sqrt(u) sin phi), the normal is t1 T1 + t2 T2 + w V, w =
//         sqrt(A^2 - t2^2). By q = s (A - sqrt(u) sin phi), w = sqrt(q (2 A - q)); and
//         (A - sqrt(u) sin phi)(A + sqrt(u) sin phi) = 1 - u, so that neither cancels; nor
//         does the height t2 sin + w cos of the normal, see corput_ggx_vndf_height.
// domain: two fractions of 2^32: u.x radius, u.y angle on the projected area. Lobes as
//         ggx_lobe.glsl, of all visible normals. A V of +z or -z has T1 = +x.
// range:  unit vectors to 2^-23; reflected directions may lie below the horizon.
// pdf:    with respect to solid angle: of normals 2 (wo.h) D / (wo.z + |S wo|), of
//         directions a fourth of that over wo.h.
// errors: a coordinate half a ULP and 2^-26, the pdf 0.9 ULP, also at the edges, and both
//         2^-32 k, k the largest of alpha_x, alpha_y and 1 over the least. The inverse agrees with the sample to 2^-20 + 2^-21 / (alpha |wo + wi|), and leads back
//         to the same direction; where rounding took the normal below the horizon, to the edge.
// cost:   1900 integer instructions, and 1200 for the lobe. tier I.
// hooks:  none.
// mirror: src/reference/ggx_vndf.rs
#ifndef CORPUT_GGX_VNDF_GLSL
#define CORPUT_GGX_VNDF_GLSL

#include "corput/ggx_lobe.glsl"

// A visible normal of the unit sphere.
struct CorputGgxVisible {
    // The normal n.
    CorputReal3 normal;
    // V.n.
    CorputReal cosine;
};

// The sine of V to +z, and the unit vector of its horizontal part: (-y, x) is T1.
CorputReal3 corput_ggx_vndf_axis(CorputGgx g) {
    CorputReal sine = corput_real_sqrt(corput_real_add(corput_real_square(g.view.x), corput_real_square(g.view.y)));
    CorputReal3 axis = CorputReal3(corput_real_divide(g.view.x, sine), corput_real_divide(g.view.y, sine), sine);
    if (sine.m == 0u) {
        axis.y = corput_real_negate(corput_real_uint(1u, 0));
    }
    return axis;
}

// t2 sin + w cos, given rise = t2 + A cos: where the terms differ in sign, the difference of
// their squares is rise (t2 - A cos).
CorputReal corput_ggx_vndf_height(CorputReal sine, CorputReal cosine, CorputReal t2, CorputReal w, CorputReal a,
    CorputReal rise) {
    CorputReal first = corput_real_multiply(t2, sine);
    CorputReal second = corput_real_multiply(w, cosine);
    uint plain = uint(first.negative == second.negative) | uint(first.m == 0u) | uint(second.m == 0u);
    CorputReal other = corput_real_subtract(t2, corput_real_multiply(a, cosine));
    CorputReal product = corput_real_multiply(rise, CorputReal(other.m, other.e, false));
    if (plain == 0u) {
        first.negative = false;
        second.negative = false;
    }
    CorputReal sum = corput_real_add(first, second);
    CorputReal height = corput_real_divide(product, sum);
    if (plain != 0u) {
        height = sum;
    }
    return height;
}

// The visible normal of the unit sphere.
CorputGgxVisible corput_ggx_vndf_visible(CorputGgx g, uvec2 u) {
    CorputReal radius_square = corput_real_uint(u.x, -32);
    CorputReal rest = corput_real_complement(u.x);
    CorputReal3 disk = corput_real3_around(corput_real_sqrt(radius_square), u.y, corput_real_zero());
    CorputReal a = corput_real_sqrt(corput_real_add(rest, corput_real_square(disk.y)));
    // A - y and A + y.
    CorputReal far = corput_real_add(a, CorputReal(disk.y.m, disk.y.e, false));
    CorputReal near = corput_real_divide(rest, far);
    CorputReal less = near;
    CorputReal more = far;
    if (disk.y.negative) {
        less = far;
        more = near;
    }
    CorputReal s = corput_real_shift(g.cap_above, -1);
    CorputReal q = corput_real_multiply(s, less);
    CorputReal rise = corput_real_multiply(s, more);
    CorputReal t2 = corput_real_subtract(a, q);
    // sqrt(q (A + t2)).
    CorputReal w = corput_real_sqrt(corput_real_multiply(q,
        corput_real_add(corput_real_multiply(corput_real_shift(g.cap_below, -1), less), more)));
    CorputReal3 axis = corput_ggx_vndf_axis(g);
    CorputReal along = corput_real_subtract(corput_real_multiply(w, axis.z), corput_real_multiply(t2, g.view.z));
    CorputReal height = corput_ggx_vndf_height(axis.z, g.view.z, t2, w, a, rise);
    CorputReal3 normal = CorputReal3(
        corput_real_subtract(corput_real_multiply(along, axis.x), corput_real_multiply(disk.x, axis.y)),
        corput_real_add(corput_real_multiply(along, axis.y), corput_real_multiply(disk.x, axis.x)), height);
    return CorputGgxVisible(normal, w);
}

// Direction and pdf.
CorputScattered corput_ggx_vndf(CorputGgx g, uvec2 u) {
    CorputGgxVisible v = corput_ggx_vndf_visible(g, u);
    CorputReal3 s = corput_ggx_stretched(g.alpha_x, g.alpha_y, v.normal);
    CorputReal s_square = corput_real3_dot(s, s);
    return corput_scattered(corput_ggx_reflected(g, s, s_square, v.cosine),
        corput_ggx_reflected_pdf(g, s_square, corput_real_uint(1u, 0)));
}

// The pdf of a direction.
float corput_ggx_vndf_pdf(CorputGgx g, vec3 wi) {
    return corput_ggx_pdf(g, wi);
}

// Normal and pdf.
CorputScattered corput_ggx_vndf_normal(CorputGgx g, uvec2 u) {
    CorputGgxVisible v = corput_ggx_vndf_visible(g, u);
    return corput_ggx_normal(g, v.normal, corput_real_uint(1u, 0), v.cosine);
}

// The pdf of a normal.
float corput_ggx_vndf_normal_pdf(CorputGgx g, vec3 normal) {
    CorputReal3 h = corput_real3_normalize(corput_real3(normal));
    CorputReal wo_h = corput_real3_dot(g.wo, h);
    if (wo_h.negative) {
        return 0.0;
    }
    return corput_real_float(corput_ggx_over_area(g, corput_real_multiply(corput_real_shift(wo_h, 1),
        corput_ggx_density(g.alpha_x, g.alpha_y, h))));
}

// t2 + A cos; where the terms differ in sign, by the difference of the squares of t2 sin and
// w cos, which is as exact as the sine.
CorputReal corput_ggx_vndf_rise(CorputReal sine, CorputReal cosine, CorputReal t2, CorputReal w, CorputReal a) {
    CorputReal near = corput_real_multiply(a, cosine);
    if (near.negative == t2.negative) {
        return corput_real_add(t2, near);
    }
    CorputReal first = corput_real_multiply(t2, sine);
    CorputReal second = corput_real_multiply(w, cosine);
    CorputReal height = corput_real_add(first, second);
    first.negative = false;
    second.negative = false;
    CorputReal other = corput_real_subtract(t2, near);
    other.negative = false;
    return corput_real_divide(corput_real_multiply(height, corput_real_add(first, second)), other);
}

// The fractions that give the normal h, of any length, with wo.h.
uvec2 corput_ggx_vndf_fractions(CorputGgx g, CorputReal3 h, CorputReal wo_h) {
    CorputReal area = corput_real_multiply(g.alpha_x, g.alpha_y);
    CorputReal3 shrunk = CorputReal3(corput_real_multiply(h.x, g.alpha_y), corput_real_multiply(h.y, g.alpha_x),
        corput_real_multiply(h.z, area));
    CorputReal length = corput_real3_length(shrunk);
    CorputReal3 n = CorputReal3(corput_real_divide(shrunk.x, length), corput_real_divide(shrunk.y, length),
        corput_real_divide(shrunk.z, length));
    CorputReal3 axis = corput_ggx_vndf_axis(g);
    CorputReal along = corput_real_add(corput_real_multiply(n.x, axis.x), corput_real_multiply(n.y, axis.y));
    CorputReal t1 = corput_real_subtract(corput_real_multiply(n.y, axis.x), corput_real_multiply(n.x, axis.y));
    CorputReal t2 = corput_real_subtract(corput_real_multiply(n.z, axis.z),
        corput_real_multiply(along, g.view.z));
    CorputReal w = corput_real_divide(corput_real_multiply(wo_h, area), corput_real_multiply(g.stretch, length));
    CorputReal t2_square = corput_real_square(t2);
    CorputReal w_square = corput_real_square(w);
    CorputReal a = corput_real_sqrt(corput_real_add(t2_square, w_square));
    // A - t2, from w^2 where it would cancel.
    CorputReal q = corput_real_subtract(a, t2);
    if (!t2.negative) {
        q = corput_real_divide(w_square, corput_real_add(a, t2));
    }
    // A - y and A + y, whose product is 1 - u.
    CorputReal s = corput_real_shift(g.cap_above, -1);
    CorputReal less = corput_real_divide(q, s);
    CorputReal more = corput_real_divide(corput_ggx_vndf_rise(axis.z, g.view.z, t2, w, a), s);
    CorputReal y = corput_real_subtract(a, less);
    CorputReal square = corput_real_add(corput_real_square(t1), corput_real_square(y));
    return uvec2(corput_real_fraction_of(square, corput_real_multiply(less, more)), corput_real_turns(y, t1));
}

// The fractions that give this direction.
uvec2 corput_ggx_vndf_invert(CorputGgx g, vec3 wi) {
    CorputReal3 h = corput_ggx_half(g, wi);
    return corput_ggx_vndf_fractions(g, h, corput_real_shift(corput_real3_dot(h, h), -1));
}

// The fractions that give this normal.
uvec2 corput_ggx_vndf_normal_invert(CorputGgx g, vec3 normal) {
    CorputReal3 h = corput_real3(normal);
    return corput_ggx_vndf_fractions(g, h, corput_real3_dot(g.wo, h));
}

#endif
