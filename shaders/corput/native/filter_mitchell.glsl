// what:   offsets from a pixel's centre by the magnitude of the filter of Mitchell and
//         Netravali in the native profile, with pdf, inverse and signed weight.
// source: as filter_mitchell.glsl, in float.
// domain: radius from 1e-30 on, below it counts as that; B and C from 0 to 1; two
//         fractions. A host may set tail and lobe, which prepare knows to 2^-22 of
//         themselves: samples next to the change of sign go with the root of that.
// pdf:    with respect to area, of |f|; that of a sample by its fractions.
// errors: 2^-20 of the radius, 2^-16 of the pdf of a sample, for the shares that it has.
// cost:   400 float instructions.
// hooks:  none.
// mirror: src/reference/native/filter_mitchell.rs
#ifndef CORPUT_NATIVE_FILTER_MITCHELL_GLSL
#define CORPUT_NATIVE_FILTER_MITCHELL_GLSL

#include "corput/native/filter.glsl"

// The filter of a radius.
struct CorputNativeFilterMitchell {
    float radius;
    float b;
    float c;
    // B + 6 C.
    float sum;
    // The change of sign, from the edge.
    float zero;
    // The integral of 6 |f| over one side.
    float total;
    // What share of it lies beyond 1/2, beyond 1, and beyond the change of sign.
    uint inner;
    uint tail;
    uint lobe;
};

// A distance z within a part: 0 from the centre, 1 from 1 inwards, 2 from the change of sign
// inwards, 3 from there outwards, 4 from the edge. The integral of 6 |f| up to it is
// terms.x z + terms.y z^2 + terms.z z^3 + terms.w z^4.
struct CorputNativeMitchell {
    uint part;
    float z;
    vec4 terms;
};

// a / b; 1, which no distance exceeds, for b = 0.
float corput_native_mitchell_ratio(float a, float b) {
    return b > 1e-30 ? a / b : 1.0;
}

// A distance within a part.
CorputNativeMitchell corput_native_mitchell(CorputNativeFilterMitchell f, uint part, float z) {
    float bent = 3.0 - 2.25 * f.b - 1.5 * f.c;
    vec4 terms = vec4(6.0 - 2.0 * f.b, 0.0, 4.0 * f.b + 2.0 * f.c - 6.0, bent);
    if (part == 1u) {
        terms = vec4(f.b, 1.5 * f.b + 3.0 * f.c, 6.0 - 5.0 * f.b - 4.0 * f.c, -bent);
    }
    if (part == 2u) {
        terms = vec4(0.0, 3.0 * f.c * f.zero, 4.0 * f.c, 0.25 * f.sum);
    }
    if (part == 3u) {
        terms = vec4(0.0, 3.0 * f.c * f.zero, -4.0 * f.c, 0.25 * f.sum);
    }
    if (part == 4u) {
        terms = vec4(0.0, 0.0, 2.0 * f.c, -0.25 * f.sum);
    }
    return CorputNativeMitchell(part, z, terms);
}

// The integral of 6 |f| over the part up to z.
float corput_native_mitchell_mass(CorputNativeMitchell at) {
    return at.z * (at.terms.x + at.z * (at.terms.y + at.z * (at.terms.z + at.z * at.terms.w)));
}

// 6 |f| there.
float corput_native_mitchell_density(CorputNativeMitchell at) {
    float p = 3.0 * at.terms.z + at.z * (4.0 * at.terms.w);
    return max(at.terms.x + at.z * (2.0 * at.terms.y + at.z * p), 0.0);
}

// A share of the total as an even fraction of 2^32: samples have odd ones.
uint corput_native_mitchell_share(float mass, float total) {
    return corput_native_fraction(0.5 * mass / total) << 1;
}

// The filter of this radius, B and C.
CorputNativeFilterMitchell corput_native_filter_mitchell_prepare(float radius, float b, float c) {
    float first = clamp(b, 0.0, 1.0);
    float second = clamp(c, 0.0, 1.0);
    float sum = first + 6.0 * second;
    float zero = corput_native_mitchell_ratio(6.0 * second, sum);
    float lobe = 0.5 * second * zero * zero * zero;
    float total = 3.0 + 2.0 * lobe;
    float r = corput_native_positive(radius);
    CorputNativeFilterMitchell f = CorputNativeFilterMitchell(r, first, second, sum, zero, total, 0u, 0u, 0u);
    float outer = corput_native_mitchell_mass(corput_native_mitchell(f, 2u, corput_native_mitchell_ratio(first, sum)));
    float core = corput_native_mitchell_mass(corput_native_mitchell(f, 0u, 0.5));
    f.inner = corput_native_mitchell_share(total - core, total);
    f.tail = corput_native_mitchell_share(outer + lobe, total);
    f.lobe = corput_native_mitchell_share(lobe, total);
    return f;
}

// A distance at least that of this mass in the part, and at most twice it; or, of part 0, at
// most that.
float corput_native_mitchell_start(CorputNativeMitchell at, float mass) {
    float scaled = at.part == 3u ? 1.625 * mass : mass;
    float linear = corput_native_mitchell_ratio(mass, at.terms.x);
    float z = min(linear, sqrt(corput_native_mitchell_ratio(scaled, at.terms.y)));
    if (at.part == 1u || at.part == 4u) {
        float cubic = at.part == 1u ? 3.0 : 0.5 * at.terms.z;
        z = min(z, pow(corput_native_mitchell_ratio(mass, cubic), 0.33333334));
    }
    if (at.part == 2u) {
        z = min(z, sqrt(sqrt(corput_native_mitchell_ratio(mass, at.terms.w))));
    }
    return z;
}

// Where this share of one side, an odd fraction of 2^32, lies within.
CorputNativeMitchell corput_native_mitchell_quantile(CorputNativeFilterMitchell f, uint share) {
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
    if (rest < uint(float(f.lobe) * 0.5925926)) {
        part = 4u;
        left = rest;
    }
    float mass = f.total * corput_native_unit(left);
    CorputNativeMitchell at = corput_native_mitchell(f, part, 0.0);
    at.z = corput_native_mitchell_start(at, mass);
    for (uint i = 0u; i < 5u; i++) {
        float excess = corput_native_mitchell_mass(at) - mass;
        at.z = max(at.z - excess / corput_native_mitchell_density(at), 1e-12);
    }
    return at;
}

// |x| over the radius.
float corput_native_mitchell_distance(CorputNativeFilterMitchell f, CorputNativeMitchell at) {
    if (at.part == 0u) {
        return 0.5 * at.z;
    }
    if (at.part == 1u) {
        return 0.5 * (1.0 - at.z);
    }
    float y = at.z;
    if (at.part == 2u) {
        y = f.zero + at.z;
    }
    if (at.part == 3u) {
        y = f.zero - at.z;
    }
    return min(1.0 - 0.5 * y, 1.0);
}

// Where |x| lies, at most the radius.
CorputNativeMitchell corput_native_mitchell_locate(CorputNativeFilterMitchell f, float x) {
    float d = 2.0 * abs(x);
    float y = max(2.0 * f.radius - d, 0.0) / f.radius;
    uint part = 4u;
    float z = y;
    if (y > 0.6666667 * f.zero) {
        part = 3u;
        z = f.zero - y;
    }
    if (y > f.zero) {
        part = 2u;
        z = y - f.zero;
    }
    if (d < f.radius) {
        part = 1u;
        z = (f.radius - d) / f.radius;
    }
    if (2.0 * d < f.radius) {
        part = 0u;
        z = d / f.radius;
    }
    return corput_native_mitchell(f, part, z);
}

// The magnitude of the filter around the centre.
CorputNativeFilterSample corput_native_filter_mitchell(CorputNativeFilterMitchell f, uvec2 u) {
    CorputNativeMitchell x = corput_native_mitchell_quantile(f, corput_native_filter_share(u.x));
    CorputNativeMitchell y = corput_native_mitchell_quantile(f, corput_native_filter_share(u.y));
    float right = f.radius * corput_native_mitchell_distance(f, x);
    float up = f.radius * corput_native_mitchell_distance(f, y);
    float pdf = corput_native_mitchell_density(x) / (f.total * f.radius);
    pdf *= corput_native_mitchell_density(y) / (f.total * f.radius);
    return CorputNativeFilterSample(corput_native_filter_point(right, up, u), pdf);
}

// |f(2 x / r) f(2 y / r)| over its integral, within the square.
float corput_native_filter_mitchell_pdf(CorputNativeFilterMitchell f, vec2 p) {
    if (max(abs(p.x), abs(p.y)) > f.radius) {
        return 0.0;
    }
    float x = corput_native_mitchell_density(corput_native_mitchell_locate(f, p.x));
    float y = corput_native_mitchell_density(corput_native_mitchell_locate(f, p.y));
    return x / (f.total * f.radius) * (y / (f.total * f.radius));
}

// The filter, of integral 1, over the pdf: the integral of its magnitude, with its sign; 0
// beyond the radius.
float corput_native_filter_mitchell_weight(CorputNativeFilterMitchell f, vec2 p) {
    if (max(abs(p.x), abs(p.y)) > f.radius) {
        return 0.0;
    }
    uint x = corput_native_mitchell_locate(f, p.x).part;
    uint y = corput_native_mitchell_locate(f, p.y).part;
    float magnitude = f.total / 3.0;
    return corput_native_filter_side(magnitude * magnitude, (x > 2u) != (y > 2u));
}

// The fraction of one side within |x|.
float corput_native_mitchell_within(CorputNativeFilterMitchell f, float x) {
    CorputNativeMitchell at = corput_native_mitchell_locate(f, x);
    float share = corput_native_mitchell_mass(at) / f.total;
    if (at.part == 0u) {
        return share;
    }
    if (at.part == 1u) {
        return 1.0 - corput_native_unit(f.tail) - share;
    }
    if (at.part == 2u) {
        return 1.0 - corput_native_unit(f.lobe) - share;
    }
    if (at.part == 3u) {
        return 1.0 - corput_native_unit(f.lobe) + share;
    }
    return 1.0 - share;
}

// The fractions that give this offset.
uvec2 corput_native_filter_mitchell_invert(CorputNativeFilterMitchell f, vec2 p) {
    return corput_native_filter_fractions(corput_native_mitchell_within(f, p.x), corput_native_mitchell_within(f, p.y), p);
}

#endif
