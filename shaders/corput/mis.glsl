// what:   combining techniques: balance, power and maximum heuristics, one-sample and
//         multi-sample multiple importance sampling, and Russian roulette.
// source: Veach and Guibas 1995, Optimally combining sampling techniques for Monte Carlo
//         rendering, SIGGRAPH; Veach 1997, thesis, 9.2; Arvo and Kirk 1990, Particle
//         transport and image synthesis, SIGGRAPH.
// domain: any floats as pdfs; any counts of samples. A pdf that is negative, denormal or
//         NaN counts as 0. An infinite one, of a delta distribution, outweighs all finite
//         ones, and shares with other infinite ones by the counts.
// range:  rests to 2^-30. Weights in [0, 1]; those of one heuristic sum to 1 within 2 ULP, or are all 0
//         where all pdfs are. Never NaN: products and squares are formed with exponents of
//         32 bits, so nothing overflows or vanishes.
// errors: weights 0.6 ULP.
// cost:   100 to 200 integer instructions. tier I.
// hooks:  none.
// mirror: src/reference/mis.rs
#ifndef CORPUT_MIS_GLSL
#define CORPUT_MIS_GLSL

#include "corput/real.glsl"

// Which technique, and the rest of the fraction that chose it.
struct CorputTechnique {
    uint index;
    uint rest;
};

// Whether a path goes on, by which factor it then counts, and the rest of the fraction.
struct CorputRoulette {
    bool survives;
    float weight;
    uint rest;
};

// Expected samples of a technique here: count * pdf.
CorputReal corput_mis_term(uint count, float pdf) {
    uint bits = floatBitsToUint(pdf);
    if (bits < 0x00800000u || bits > 0x7f800000u) {
        return corput_real_zero();
    }
    CorputReal samples = corput_real_multiply(corput_real_uint(count, 0), corput_real(pdf));
    // 2^4096 is beyond the squares of all that is finite.
    return corput_real_shift(samples, bits == 0x7f800000u ? 4096 : 0);
}

// Balance heuristic: weight of a sample of technique `a`, beside technique `b`.
float corput_mis_balance(uint count_a, float pdf_a, uint count_b, float pdf_b) {
    CorputReal a = corput_mis_term(count_a, pdf_a);
    CorputReal b = corput_mis_term(count_b, pdf_b);
    return corput_real_float(corput_real_divide(a, corput_real_add(a, b)));
}

// Power heuristic with exponent 2.
float corput_mis_power(uint count_a, float pdf_a, uint count_b, float pdf_b) {
    CorputReal a = corput_real_square(corput_mis_term(count_a, pdf_a));
    CorputReal b = corput_real_square(corput_mis_term(count_b, pdf_b));
    return corput_real_float(corput_real_divide(a, corput_real_add(a, b)));
}

// Maximum heuristic: 1 for the larger, 1/2 for equal ones.
float corput_mis_maximum(uint count_a, float pdf_a, uint count_b, float pdf_b) {
    CorputReal a = corput_mis_term(count_a, pdf_a);
    CorputReal b = corput_mis_term(count_b, pdf_b);
    if (a.m == 0u || corput_real_less(a, b)) {
        return 0.0;
    }
    return corput_real_less(b, a) ? 1.0 : 0.5;
}

// Balance heuristic over four techniques: weight of a sample of the first, .x. A technique
// that is not there has the count 0.
float corput_mis_balance4(uvec4 counts, vec4 pdfs) {
    CorputReal x = corput_mis_term(counts.x, pdfs.x);
    CorputReal y = corput_mis_term(counts.y, pdfs.y);
    CorputReal z = corput_mis_term(counts.z, pdfs.z);
    CorputReal w = corput_mis_term(counts.w, pdfs.w);
    return corput_real_float(corput_real_divide(x, corput_real_add(corput_real_add(x, y), corput_real_add(z, w))));
}

// Power heuristic with exponent 2 over four techniques.
float corput_mis_power4(uvec4 counts, vec4 pdfs) {
    CorputReal x = corput_real_square(corput_mis_term(counts.x, pdfs.x));
    CorputReal y = corput_real_square(corput_mis_term(counts.y, pdfs.y));
    CorputReal z = corput_real_square(corput_mis_term(counts.z, pdfs.z));
    CorputReal w = corput_real_square(corput_mis_term(counts.w, pdfs.w));
    return corput_real_float(corput_real_divide(x, corput_real_add(corput_real_add(x, y), corput_real_add(z, w))));
}

// One of four techniques, in proportion to weights that sum to less than 2^32: to each
// belong floor or ceil of its share of the 2^32 fractions, to weight 0 none. Where all are
// 0, the last.
CorputTechnique corput_mis_choose(uvec4 weights, uint u) {
    uint total = weights.x + weights.y + weights.z + weights.w;
    uvec2 product = corput_mul64(u, total);
    uint place = product.y;
    uint index = 0u;
    uint width = weights.x;
    if (place >= width) {
        place -= width;
        index = 1u;
        width = weights.y;
        if (place >= width) {
            place -= width;
            index = 2u;
            width = weights.z;
            if (place >= width) {
                place -= width;
                index = 3u;
                width = weights.w;
            }
        }
    }
    // (place + the fraction below it) / width.
    CorputReal rest = corput_real_divide(corput_real_wide(uvec2(product.x, place), -32), corput_real_uint(width, 0));
    return CorputTechnique(index, corput_real_fraction(rest));
}

// Density of a sample of the technique that corput_mis_choose picks, whichever it was: the
// mean of the pdfs by these weights. f over it is the one-sample estimator with the balance
// heuristic. Saturates at the largest float.
float corput_mis_one_sample(uvec4 weights, vec4 pdfs) {
    CorputReal x = corput_mis_term(weights.x, pdfs.x);
    CorputReal y = corput_mis_term(weights.y, pdfs.y);
    CorputReal z = corput_mis_term(weights.z, pdfs.z);
    CorputReal w = corput_mis_term(weights.w, pdfs.w);
    CorputReal sum = corput_real_add(corput_real_add(x, y), corput_real_add(z, w));
    uint total = weights.x + weights.y + weights.z + weights.w;
    return corput_real_float(corput_real_divide(sum, corput_real_uint(total, 0)));
}

// Probability, as a fraction of 2^32, with which a path of this throughput survives:
// the throughput itself, at most 1, which is written as 2^32 - 1; 0 for NaN.
uint corput_roulette_survival(float throughput) {
    uint bits = floatBitsToUint(throughput);
    if (bits > 0x7f800000u) {
        return 0u;
    }
    return corput_real_fraction(corput_real(throughput));
}

// Whether u lets a path of this survival go on: for `survival` of the 2^32 fractions, with
// 2^32 - 1 for all of them.
CorputRoulette corput_roulette(uint survival, uint u) {
    if (survival == 0xffffffffu) {
        return CorputRoulette(true, 1.0, u);
    }
    if (u < survival) {
        CorputReal kept = corput_real_uint(survival, 0);
        return CorputRoulette(true, corput_real_float(corput_real_divide(corput_real_uint(1u, 32), kept)),
            corput_real_fraction(corput_real_divide(corput_real_uint(u, 0), kept)));
    }
    if (survival == 0u) {
        return CorputRoulette(false, 0.0, u);
    }
    CorputReal place = corput_real_uint(u - survival, 0);
    CorputReal lost = corput_real_uint(0u - survival, 0);
    return CorputRoulette(false, 0.0, corput_real_fraction(corput_real_divide(place, lost)));
}

#endif
