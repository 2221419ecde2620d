// what:   discrete distributions whose probabilities are integers over 2^32: search of a
//         CDF, alias table, and a weighted reservoir.
// source: Walker 1977, An efficient method for generating discrete random variables, ACM
//         TOMS 3(3); Vose 1991, IEEE TSE 17(9); Chao 1982, A general purpose unequal
//         probability sampling plan, Biometrika 69(3). Division: Knuth, TAOCP vol. 2,
//         4.3.1, algorithm D.
// domain: tables as the host's `environment::cdf_table` and `alias_table` make them: the
//         weights of all items sum to exactly 2^32. From 1 to 2^24 items.
// range:  an item is drawn for exactly `weight` of the 2^32 fractions u, so that
//         weight/2^32 is its probability; one of weight 0 never. `rest` is the place of u
//         among its item's, as a fraction. An empty CDF gives item 0.
// cost:   CDF: log2(count) + 2 lookups. Alias: 2 lookups, and two divisions for the rest.
//         tier I.
// hooks:  CORPUT_DISCRETE(i): word i of the tables.
// mirror: src/reference/discrete.rs
#ifndef CORPUT_DISCRETE_GLSL
#define CORPUT_DISCRETE_GLSL

#ifndef CORPUT_DISCRETE
#error define CORPUT_DISCRETE(i), word i of the tables, before this header
#endif

#include "corput/real.glsl"

// An item, the place of u in it, and its weight out of 2^32.
struct CorputChoice {
    uint index;
    uint rest;
    uvec2 weight;
};

// An item of a stream, its weight, and the sum of all weights.
struct CorputReservoir {
    uint index;
    uint weight;
    uvec2 total;
};

// floor((high 2^16 + next) / d), for high < d, next < 2^16, d >= 2^31.
uint corput_discrete_digit(uint high, uint next, uint d) {
    uint divisor = d >> 16;
    uint q = high / divisor;
    uint r = high - q * divisor;
    // The guess is too large by 2 at most.
    for (uint k = 0u; k < 2u; k++) {
        if (r < 65536u && (q >= 65536u || q * (d & 0xffffu) > (r << 16) + next)) {
            q -= 1u;
            r += divisor;
        }
    }
    return q;
}

// floor(n / d), for n < 2^32 d, d > 0.
uint corput_discrete_divide(uvec2 n, uint d) {
    uint shift = 31u - corput_find_msb(max(d, 1u));
    uvec2 v = corput_shl64(n, shift);
    uint divisor = max(d, 1u) << shift;
    uint high = corput_discrete_digit(v.y, v.x >> 16, divisor);
    uint r = (v.y << 16) + (v.x >> 16) - high * divisor;
    return (high << 16) + corput_discrete_digit(r, v.x & 0xffffu, divisor);
}

// floor(v f / 2^32).
uvec2 corput_discrete_scale(uvec2 v, uint f) {
    return corput_add64(corput_mul64(v.y, f), uvec2(corput_mulhi(v.x, f), 0u));
}

// The middle (part + 1/2) / width of one of `width` equal parts, as a fraction of 2^32.
// A width of 2^32 is written as 0.
uint corput_discrete_rest(uint part, uint width) {
    if (width == 0u) {
        return part;
    }
    return corput_discrete_divide(uvec2(0x80000000u, part), width);
}

// The part that holds this fraction's middle, (rest + 1/2) / 2^32.
uint corput_discrete_part(uint rest, uint width) {
    if (width == 0u) {
        return rest;
    }
    return corput_add64(corput_mul64(rest, width), uvec2(width >> 1, 0u)).y;
}

// Sum of the weights before an item of the CDF at word `first`, modulo 2^32.
uint corput_cdf_lower(uint first, uint index) {
    // The first word counts the items up to the last with a weight: 0 goes before it.
    return index == 0u || index >= CORPUT_DISCRETE(first) ? 0u : CORPUT_DISCRETE(first + index);
}

// Weight of an item of the CDF at word `first`, out of 2^32.
uvec2 corput_cdf_weight(uint first, uint index) {
    uint count = CORPUT_DISCRETE(first);
    if (index >= count) {
        return uvec2(0u);
    }
    uint width = corput_cdf_lower(first, index + 1u) - corput_cdf_lower(first, index);
    return uvec2(width, index + 1u == count && width == 0u ? 1u : 0u);
}

// The item that u draws by the CDF at word `first`.
CorputChoice corput_cdf(uint first, uint u) {
    uint low = 0u;
    uint high = max(CORPUT_DISCRETE(first), 1u) - 1u;
    while (low < high) {
        uint middle = (low + high + 1u) >> 1;
        // Strict: the u that equals an item's end belongs to the next.
        if (u < CORPUT_DISCRETE(first + middle)) {
            high = middle - 1u;
        } else {
            low = middle;
        }
    }
    uvec2 weight = corput_cdf_weight(first, low);
    return CorputChoice(low, corput_discrete_rest(u - corput_cdf_lower(first, low), weight.x), weight);
}

// The u that draws this item and place by the CDF at word `first`.
uint corput_cdf_invert(uint first, uint index, uint rest) {
    return corput_cdf_lower(first, index)
        + corput_discrete_part(rest, corput_cdf_weight(first, index).x);
}

// The item that u draws by the alias table of `count` items at word `first`.
uint corput_alias_index(uint first, uint count, uint u) {
    uvec2 product = corput_mul64(u, count);
    uint at = first + 3u * product.y;
    uint other = CORPUT_DISCRETE(at + 1u);
    return product.x < CORPUT_DISCRETE(at) ? product.y : other;
}

// The place of u.x among those of its bin that draw the same item, as a fraction; u.y
// fills in the bits below, of which u.x leaves none for many items.
uint corput_alias_rest(uint first, uint count, uvec2 u) {
    uint bins = max(count, 1u);
    uvec2 product = corput_mul64(u.x, bins);
    uint at = first + 3u * product.y;
    // Place among all u of the bin, how many those are, and how many draw its own item.
    uint place = product.x / bins;
    uint size = (0xffffffffu - (product.x - place * bins)) / bins + 1u;
    uint own = CORPUT_DISCRETE(at) / bins;
    if (CORPUT_DISCRETE(at + 1u) != product.y) {
        bool mine = product.x < CORPUT_DISCRETE(at);
        place -= mine ? 0u : own;
        size = mine ? own : size - own;
    }
    // A bin of all 2^32.
    if (size == 0u) {
        return place;
    }
    return corput_discrete_divide(uvec2(u.y, place), size);
}

// Weight of an item of the alias table at word `first`, out of 2^32.
uvec2 corput_alias_weight(uint first, uint index) {
    uint at = first + 3u * index;
    uint weight = CORPUT_DISCRETE(at + 2u);
    // An item without weight leaves its bin to another; only one with all of it does not.
    return uvec2(weight, weight == 0u && CORPUT_DISCRETE(at + 1u) == index ? 1u : 0u);
}

// A reservoir of nothing.
CorputReservoir corput_reservoir() {
    return CorputReservoir(0u, 0u, uvec2(0u));
}

// The reservoir after another item, which takes the place of the one in it with the
// probability weight / total, rounded up to a multiple of 2^-32; never for weight 0.
CorputReservoir corput_reservoir_add(CorputReservoir r, uint index, uint weight, uint u) {
    uvec2 total = corput_add64(r.total, uvec2(weight, 0u));
    uvec2 place = corput_discrete_scale(total, u);
    if (place.y == 0u && place.x < weight) {
        return CorputReservoir(index, weight, total);
    }
    return CorputReservoir(r.index, r.weight, total);
}

// The reservoir of two streams: `b`'s item with the probability b.total / total.
CorputReservoir corput_reservoir_merge(CorputReservoir a, CorputReservoir b, uint u) {
    uvec2 total = corput_add64(a.total, b.total);
    uvec2 place = corput_discrete_scale(total, u);
    bool other = place.y < b.total.y || (place.y == b.total.y && place.x < b.total.x);
    return CorputReservoir(other ? b.index : a.index, other ? b.weight : a.weight, total);
}

// Probability of the item in the reservoir, weight / total; 0 for none.
float corput_reservoir_pdf(CorputReservoir r) {
    return corput_real_float(corput_real_divide(corput_real_uint(r.weight, 0), corput_real_wide(r.total, 0)));
}

#endif
