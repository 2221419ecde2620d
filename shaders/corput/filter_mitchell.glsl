// what:   offsets from a pixel's centre by the magnitude of the filter of Mitchell and
//         Netravali, as a product of two coordinates, with pdf, inverse and signed weight.
// source: Mitchell and Netravali 1988, Reconstruction filters in computer graphics, eq. 8;
//         PBRT 4th ed., 8.8.5 and 8.8.6: the weight of a sample is f / pdf. In terms of y =
//         2 - |t|, the lobe outside 1 is y^2 ((B + 6 C) y - 6 C) / 6, whose sign changes
//         at y = 6 C / (B + 6 C). Each part is a quartic from the end where its density
//         is least, without cancellation, inverted by 5 steps of Newton's method.
// domain: radius > 0, B and C from 0 to 1, what is beyond counts as the end; two fractions
//         of 2^32, which stand for midpoints of their parts. radius <= 0 gives the centre; a
//         NaN counts as an infinity.
// range:  coordinates from -radius to radius.
// pdf:    with respect to area, of |f| over its integral, f(t) at t = 2 x / r: 0 beyond the
//         radius. That of a sample is the one before its coordinates are rounded. The
//         filter itself is pdf times the weight, which is one of two numbers of equal
//         magnitude, and whose mean is 1.
// errors: coordinates 0.6 ULP, pdf of a sample 1 ULP, for shares of the parts that are
//         rounded to even fractions of 2^32: samples are those of fractions 2^-31 away.
//         The weight 0.51 ULP; next to the change of sign it is that of the rounded offset.
// cost:   4500 integer instructions. tier I.
// hooks:  none.
// mirror: src/reference/filter_mitchell.rs
#ifndef CORPUT_FILTER_MITCHELL_GLSL
#define CORPUT_FILTER_MITCHELL_GLSL

#include "corput/filter.glsl"

// The filter of a radius.
struct CorputFilterMitchell {
    CorputReal radius;
    CorputReal b;
    CorputReal c;
    // B + 6 C.
    CorputReal sum;
    // The change of sign, from the edge.
    CorputReal zero;
    // The integral of 6 |f| over one side.
    CorputReal total;
    // What share of it lies beyond 1/2, beyond 1, and beyond the change of sign.
    uint inner;
    uint tail;
    uint lobe;
};

// A distance z within a part: 0 from the centre, 1 from 1 inwards, 2 from the change of sign
// inwards, 3 from there outwards, 4 from the edge. The integral of 6 |f| up to it is
// c1 z + c2 z^2 + c3 z^3 + c4 z^4.
struct CorputMitchell {
    uint part;
    CorputReal z;
    CorputReal c1;
    CorputReal c2;
    CorputReal c3;
    CorputReal c4;
};

// x within 0 and 1.
CorputReal corput_mitchell_unit(float x) {
    return corput_real_min(corput_real_positive(x), corput_real_uint(1u, 0));
}

// A distance within a part.
CorputMitchell corput_mitchell(CorputFilterMitchell f, uint part, CorputReal z) {
    CorputReal c1 = corput_real_zero();
    CorputReal c2 = corput_real_zero();
    CorputReal c3 = corput_real_shift(f.c, 2);
    CorputReal c4 = corput_real_shift(f.sum, -2);
    if (part < 2u) {
        // 3 - 9/4 B - 3/2 C.
        CorputReal bent = corput_real_add(corput_real_multiply(f.b, corput_real_uint(9u, -2)), corput_real_multiply(f.c, corput_real_uint(3u, -1)));
        c4 = corput_real_subtract(corput_real_uint(3u, 0), bent);
        c3 = corput_real_subtract(corput_real_add(corput_real_shift(f.b, 2), corput_real_shift(f.c, 1)), corput_real_uint(6u, 0));
        c1 = corput_real_subtract(corput_real_uint(6u, 0), corput_real_shift(f.b, 1));
    }
    if (part == 1u) {
        c4 = corput_real_negate(c4);
        c3 = corput_real_negate(corput_real_add(c3, corput_real_add(f.b, corput_real_shift(f.c, 1))));
        c2 = corput_real_multiply(corput_real_add(f.b, corput_real_shift(f.c, 1)), corput_real_uint(3u, -1));
        c1 = f.b;
    }
    if (part == 2u || part == 3u) {
        c2 = corput_real_multiply(corput_real_multiply(f.c, f.zero), corput_real_uint(3u, 0));
    }
    if (part == 3u) {
        c3 = corput_real_negate(c3);
    }
    if (part == 4u) {
        c3 = corput_real_shift(f.c, 1);
        c4 = corput_real_negate(c4);
    }
    return CorputMitchell(part, z, c1, c2, c3, c4);
}

// The integral of 6 |f| over the part up to z.
CorputReal corput_mitchell_mass(CorputMitchell at) {
    CorputReal p = corput_real_add(corput_real_multiply(at.z, at.c4), at.c3);
    p = corput_real_add(corput_real_multiply(at.z, p), at.c2);
    p = corput_real_add(corput_real_multiply(at.z, p), at.c1);
    return corput_real_multiply(at.z, p);
}

// 6 |f| there.
CorputReal corput_mitchell_density(CorputMitchell at) {
    CorputReal three = corput_real_multiply(at.c3, corput_real_uint(3u, 0));
    CorputReal p = corput_real_add(corput_real_multiply(at.z, corput_real_shift(at.c4, 2)), three);
    p = corput_real_add(corput_real_multiply(at.z, p), corput_real_shift(at.c2, 1));
    return corput_real_max(corput_real_add(corput_real_multiply(at.z, p), at.c1), corput_real_zero());
}

// A share of the total as an even fraction of 2^32: samples have odd ones.
uint corput_mitchell_share(CorputReal mass, CorputReal total) {
    CorputReal half_share = corput_real_shift(corput_real_divide(mass, total), -1);
    return corput_real_fraction(corput_real_add(half_share, corput_real_uint(1u, -33))) << 1;
}

// The filter of this radius, B and C.
CorputFilterMitchell corput_filter_mitchell_prepare(float radius, float b, float c) {
    CorputReal r = corput_real_positive(radius);
    CorputReal first = corput_mitchell_unit(b);
    CorputReal second = corput_mitchell_unit(c);
    CorputReal six = corput_real_multiply(second, corput_real_uint(6u, 0));
    CorputReal sum = corput_real_add(first, six);
    CorputReal zero = corput_real_divide(six, sum);
    // C y^3 / 2; all parts, signs counted, are 3.
    CorputReal lobe = corput_real_shift(corput_real_multiply(second, corput_real_multiply(zero, corput_real_square(zero))), -1);
    CorputReal total = corput_real_add(corput_real_uint(3u, 0), corput_real_shift(lobe, 1));
    CorputFilterMitchell f = CorputFilterMitchell(r, first, second, sum, zero, total, 0u, 0u, 0u);
    CorputReal outer = corput_mitchell_mass(corput_mitchell(f, 2u, corput_real_divide(first, sum)));
    CorputReal core = corput_mitchell_mass(corput_mitchell(f, 0u, corput_real_uint(1u, -1)));
    f.inner = corput_mitchell_share(corput_real_subtract(total, core), total);
    f.tail = corput_mitchell_share(corput_real_add(outer, lobe), total);
    f.lobe = corput_mitchell_share(lobe, total);
    return f;
}

// A distance at least that of this mass in the part, and at most twice it; or, of part 0, at
// most that.
CorputReal corput_mitchell_start(CorputMitchell at, CorputReal mass) {
    CorputReal scaled = mass;
    if (at.part == 3u) {
        // 1 / (1 - 4/3 z + z^2/2) at its end, the third of the lobe.
        scaled = corput_real_multiply(mass, corput_real_uint(13u, -3));
    }
    CorputReal z = corput_real_min(corput_real_divide(mass, at.c1), corput_real_sqrt(corput_real_divide(scaled, at.c2)));
    if (at.part == 1u || at.part == 4u) {
        CorputReal cubic = corput_real_shift(at.c3, -1);
        if (at.part == 1u) {
            cubic = corput_real_uint(3u, 0);
        }
        CorputReal third = CorputReal(0xaaaaaaabu, -33, false);
        z = corput_real_min(z, corput_real_power(corput_real_divide(mass, cubic), third));
    }
    if (at.part == 2u) {
        z = corput_real_min(z, corput_real_sqrt(corput_real_sqrt(corput_real_divide(mass, at.c4))));
    }
    return z;
}

// Where this share of one side, an odd fraction of 2^32, lies within.
CorputMitchell corput_mitchell_quantile(CorputFilterMitchell f, uint share) {
    uint rest = 0u - share;
    uint part = 0u;
    uint left = share;
    if (rest < f.inner) {
        part = 1u;
        left = rest - f.tail;
    }
    if (rest < f.tail) {
        part = 2u;
        left = rest - f.lobe;
    }
    if (rest < f.lobe) {
        part = 3u;
        left = f.lobe - rest;
    }
    // 16/27 of the lobe are beyond its peak.
    if (rest < corput_mulhi(f.lobe, 2545165805u)) {
        part = 4u;
        left = rest;
    }
    CorputReal mass = corput_real_multiply(f.total, corput_real_uint(left, -32));
    CorputMitchell at = corput_mitchell(f, part, corput_real_zero());
    at.z = corput_mitchell_start(at, mass);
    // From there on 2^-39 of z in five steps.
    for (uint i = 0u; i < 5u; i++) {
        CorputReal excess = corput_real_subtract(corput_mitchell_mass(at), mass);
        at.z = corput_real_subtract(at.z, corput_real_divide(excess, corput_mitchell_density(at)));
    }
    return at;
}

// |x| over the radius.
CorputReal corput_mitchell_distance(CorputFilterMitchell f, CorputMitchell at) {
    CorputReal one = corput_real_uint(1u, 0);
    if (at.part == 0u) {
        return corput_real_shift(at.z, -1);
    }
    if (at.part == 1u) {
        return corput_real_shift(corput_real_subtract(one, at.z), -1);
    }
    CorputReal y = at.z;
    if (at.part == 2u) {
        y = corput_real_add(f.zero, at.z);
    }
    if (at.part == 3u) {
        y = corput_real_subtract(f.zero, at.z);
    }
    return corput_real_subtract(one, corput_real_shift(y, -1));
}

// Where |x| lies, at most the radius.
CorputMitchell corput_mitchell_locate(CorputFilterMitchell f, float x) {
    CorputReal d = corput_real_shift(corput_filter_distance(x), 1);
    CorputReal y = corput_real_subtract(corput_real_shift(f.radius, 1), d);
    y = corput_real_divide(corput_real_max(y, corput_real_zero()), f.radius);
    uint part = 4u;
    CorputReal z = y;
    // Two thirds of the lobe's width.
    if (corput_real_less(corput_real_multiply(f.zero, CorputReal(0xaaaaaaabu, -32, false)), y)) {
        part = 3u;
        z = corput_real_subtract(f.zero, y);
    }
    if (corput_real_less(f.zero, y)) {
        part = 2u;
        z = corput_real_subtract(y, f.zero);
    }
    if (corput_real_less(d, f.radius)) {
        part = 1u;
        z = corput_real_divide(corput_real_subtract(f.radius, d), f.radius);
    }
    if (corput_real_less(corput_real_shift(d, 1), f.radius)) {
        part = 0u;
        z = corput_real_divide(d, f.radius);
    }
    return corput_mitchell(f, part, z);
}

// The magnitude of the filter around the centre.
CorputFilterSample corput_filter_mitchell(CorputFilterMitchell f, uvec2 u) {
    CorputReal density = corput_real_uint(1u, 0);
    vec2 p = vec2(0.0);
    for (uint i = 0u; i < 2u; i++) {
        CorputMitchell at = corput_mitchell_quantile(f, corput_filter_share(u[i]));
        density = corput_real_multiply(density, corput_real_divide(corput_mitchell_density(at), f.total));
        CorputReal d = corput_real_multiply(f.radius, corput_mitchell_distance(f, at));
        p[i] = corput_filter_offset(d, f.radius, u[i]);
    }
    return CorputFilterSample(p, corput_gaussian_area_pdf(density, f.radius));
}

// |f(2 x / r) f(2 y / r)| over its integral, within the square.
float corput_filter_mitchell_pdf(CorputFilterMitchell f, vec2 p) {
    if (corput_real_less(f.radius, corput_real_max(corput_filter_distance(p.x), corput_filter_distance(p.y)))) {
        return 0.0;
    }
    CorputReal density = corput_real_uint(1u, 0);
    for (uint i = 0u; i < 2u; i++) {
        CorputReal own = corput_mitchell_density(corput_mitchell_locate(f, p[i]));
        density = corput_real_multiply(density, corput_real_divide(own, f.total));
    }
    return corput_gaussian_area_pdf(density, f.radius);
}

// The filter, of integral 1, over the pdf: the integral of its magnitude, with its sign; 0
// beyond the radius.
float corput_filter_mitchell_weight(CorputFilterMitchell f, vec2 p) {
    if (corput_real_less(f.radius, corput_real_max(corput_filter_distance(p.x), corput_filter_distance(p.y)))) {
        return 0.0;
    }
    bool negative = false;
    for (uint i = 0u; i < 2u; i++) {
        if (corput_mitchell_locate(f, p[i]).part > 2u) {
            negative = !negative;
        }
    }
    CorputReal magnitude = corput_real_square(corput_real_divide(f.total, corput_real_uint(3u, 0)));
    return corput_real_float(CorputReal(magnitude.m, magnitude.e, negative));
}

// The fractions that give this offset.
uvec2 corput_filter_mitchell_invert(CorputFilterMitchell f, vec2 p) {
    uvec2 u = uvec2(0u);
    for (uint i = 0u; i < 2u; i++) {
        CorputMitchell at = corput_mitchell_locate(f, p[i]);
        CorputReal share = corput_real_divide(corput_mitchell_mass(at), f.total);
        uint beyond = 0u;
        if (at.part == 1u) {
            beyond = f.tail;
        }
        if (at.part == 2u || at.part == 3u) {
            beyond = f.lobe;
        }
        if (at.part == 3u) {
            share = corput_real_negate(share);
        }
        if (at.part != 0u) {
            share = corput_real_subtract(corput_real_complement(beyond), share);
        }
        u[i] = corput_filter_fraction(share, p[i]);
    }
    return u;
}

#endif
