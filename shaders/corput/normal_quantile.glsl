// what:   the normal distribution with one set of bits everywhere: quantile, inverse error
//         function, tail, density, and the fraction that a value stands for.
// source: Giles 2010, "Approximating the erfinv function", 2, for the two ranges: a
//         polynomial in the square of the distance from 1/2, and in sqrt(-2 ln q) for
//         tails q; the tail as Mills' ratio in 4 / (4 + z) (Shepherd and Laframboise
//         1981) times e^(-z^2/2). Coefficients: scripts/elementary_polynomials.py.
// domain: all fractions u of 2^32, which stand for the midpoints (2 u + 1) / 2^33: 0 and 1
//         are not among them, so that nothing is infinite, and ~u gives exactly -z.
// range:  quantiles from -6.33796 to 6.33796, reals within 2^-28 of themselves, floats 0.55
//         ULP; tails within 2^-26 of themselves, densities within 2^-29 for |z| <= 2^5.
//         The fraction of a quantile differs from its own by 4 units at most.
// cost:   260 integer instructions; tail 250. tier I.
// hooks:  none.
// mirror: src/reference/normal_quantile.rs
#ifndef CORPUT_NORMAL_QUANTILE_GLSL
#define CORPUT_NORMAL_QUANTILE_GLSL

#include "corput/exponential.glsl"

// The mass of the normal distribution from 0 to some |z|, and beyond it.
struct CorputNormalMasses {
    CorputReal mass;
    CorputReal tail;
};

// c + x p, for x a fraction of 2^32.
int corput_horner(int c, uint x, int p) {
    uint product = corput_mulhi(x, uint(p));
    if (p < 0) {
        product -= x;
    }
    return c + int(product);
}

// z / (2 m) as a fraction of 2^31, for the mass m from 0 to z, w = 8 m^2 a fraction of 2^32.
uint corput_quantile_centre(uint w) {
    int p = corput_horner(-4005107, w, 1041235);
    p = corput_horner(7802295, w, p);
    p = corput_horner(-7962297, w, p);
    p = corput_horner(6624098, w, p);
    p = corput_horner(-552001, w, p);
    p = corput_horner(5660002, w, p);
    p = corput_horner(12193799, w, p);
    p = corput_horner(32871832, w, p);
    p = corput_horner(96846255, w, p);
    p = corput_horner(352312827, w, p);
    return 2691471616u + corput_mulhi(w, uint(p));
}

// z in units of 2^-30, for t = sqrt(-2 ln q) in units of 2^-30, from 1.9375 to 3.75.
uint corput_quantile_near(uint t) {
    uint s = (t - 2080374784u) << 1;
    int p = corput_horner(-5604921, s, 854037);
    p = corput_horner(17377399, s, p);
    p = corput_horner(-34834799, s, p);
    p = corput_horner(53018350, s, p);
    p = corput_horner(-69188333, s, p);
    p = corput_horner(85256918, s, p);
    p = corput_horner(-105625932, s, p);
    p = corput_horner(135808689, s, p);
    p = corput_horner(-184688656, s, p);
    p = corput_horner(1347462260, s, p);
    return 1098883931u + corput_shl64(corput_mul64(s, uint(p)), 1u).y;
}

// z in units of 2^-29, for t = sqrt(-2 ln q) in units of 2^-29, from 3.75 to 6.8125.
uint corput_quantile_far(uint t) {
    uint s = (t - 2013265920u) << 1;
    int p = corput_horner(7603437, s, -1434311);
    p = corput_horner(-19298240, s, p);
    p = corput_horner(32499054, s, p);
    p = corput_horner(-43216171, s, p);
    p = corput_horner(51443856, s, p);
    p = corput_horner(-59549370, s, p);
    p = corput_horner(69888028, s, p);
    p = corput_horner(-84963774, s, p);
    p = corput_horner(1183881170, s, p);
    return 1678647636u + corput_shl64(corput_mul64(s, uint(p)), 1u).y;
}

// z >= 0 with this mass from 0 to z, and this tail beyond, which is 1/2 - mass and at
// least 2^-33: either may be small, and each is taken where it is.
CorputReal corput_real_quantile(CorputReal mass, CorputReal tail) {
    CorputReal w = corput_real_shift(corput_real_square(mass), 3);
    if (mass.m == 0u || w.e <= -32) {
        uint p = corput_quantile_centre(corput_real_fraction(w));
        return corput_real_multiply(mass, corput_real_uint(p, -30));
    }
    CorputReal t = corput_real_sqrt(corput_real_shift(corput_real_negate(corput_real_log(tail)), 1));
    // From 1.96 to 6.77; at 3.75 the far range begins.
    if (t.e < -30 || (t.e == -30 && t.m < 4026531840u)) {
        return corput_real_uint(corput_quantile_near(t.m >> uint(-30 - t.e)), -30);
    }
    return corput_real_uint(corput_quantile_far(t.m >> uint(-29 - t.e)), -29);
}

// z such that the normal distribution has mass (2 u + 1) / 2^33 below it.
CorputReal corput_real_normal_quantile(uint u) {
    bool negative = u < 0x80000000u;
    // a * 2^-33 lies between 1/2 and the midpoint.
    uint a = ((negative ? ~u : u) << 1) | 1u;
    CorputReal z = corput_real_quantile(corput_real_uint(a, -33), corput_real_uint(0u - a, -33));
    return CorputReal(z.m, z.e, negative);
}

// The mass of the normal distribution from 0 to |z|, for z^2/2 = w < 1.
CorputReal corput_real_normal_near(CorputReal z, CorputReal w) {
    uint x = corput_real_fraction(w);
    uint p = 171074u - corput_mulhi(x, 14679u);
    p = 1288308u - corput_mulhi(x, p);
    p = 7928138u - corput_mulhi(x, p);
    p = 40795163u - corput_mulhi(x, p);
    p = 171344265u - corput_mulhi(x, p);
    p = 571148009u - corput_mulhi(x, p);
    p = 1713444047u - corput_mulhi(x, p);
    return corput_real_multiply(CorputReal(z.m, z.e, false), corput_real_uint(p, -32));
}

// The mass of the normal distribution above |z|, for z^2/2 >= 1.
CorputReal corput_real_normal_far(CorputReal z) {
    CorputReal four = corput_real_uint(4u, 0);
    CorputReal sum = corput_real_add(CorputReal(z.m, z.e, false), four);
    uint s = corput_real_fraction(corput_real_divide(four, sum));
    int p = corput_horner(194367399, s, -137488665);
    p = corput_horner(419245307, s, p);
    p = corput_horner(-148357307, s, p);
    p = corput_horner(670920889, s, p);
    p = corput_horner(260209733, s, p);
    p = corput_horner(465125121, s, p);
    p = corput_horner(423049695, s, p);
    p = corput_horner(329745, s, p);
    return corput_real_multiply(corput_real_gaussian(z), corput_real_uint(uint(p), -32));
}

// The masses of the normal distribution within and beyond |z|.
CorputNormalMasses corput_real_normal_masses(CorputReal z) {
    CorputReal w = corput_real_shift(corput_real_square(z), -1);
    bool near = z.m == 0u || w.e <= -32;
    CorputReal part = corput_real_normal_near(z, w);
    if (!near) {
        part = corput_real_normal_far(z);
    }
    CorputReal rest = corput_real_subtract(corput_real_uint(1u, -1), part);
    if (near) {
        return CorputNormalMasses(part, rest);
    }
    return CorputNormalMasses(rest, part);
}

// The fraction whose midpoint's quantile is z: floor(2^32 Phi(z)), and ~ of it for -z.
uint corput_normal_fraction(CorputReal z) {
    uint tail = corput_real_fraction(corput_real_normal_masses(z).tail);
    return z.negative ? tail : ~tail;
}

// The density at z, e^(-z^2/2) / sqrt(2 pi).
CorputReal corput_real_normal_density(CorputReal z) {
    return corput_real_multiply(corput_real_gaussian(z), CorputReal(3426888095u, -33, false));
}

// z such that the normal distribution has mass (2 u + 1) / 2^33 below it.
float corput_normal_quantile(uint u) {
    return corput_real_float(corput_real_normal_quantile(u));
}

// erf^-1((2 u + 1) / 2^32 - 1), which is the quantile over sqrt(2).
float corput_inverse_erf(uint u) {
    return corput_real_float(corput_real_multiply(corput_real_normal_quantile(u), CorputReal(3037000500u, -32, false)));
}

#endif
