// what:   domains: where in a renderer a sample is drawn. From pixel, frame and sample a
//         domain; from a domain its children, by key, split or chain; from any of them up
//         to four dimensions, by the functions corput_draw_* of the headers
//         "corput/domain_draw.glsl", "corput/domain_sobol.glsl", "corput/domain_halton.glsl".
// source: the domain tree of OpenQMC (Framestore); padding of decorrelated low dimensions:
//         Kollig and Keller 2002, Efficient multidimensional sampling. Patterns by corput_mix4.
// domain: every value of every argument; a split's index is taken modulo 2^32.
// range:  12 bytes, by value: 64 bits of pattern, of which two domains share one by chance
//         with probability 2^-64, and the index of the sample in its sequence.
// cost:   one corput_mix4 for a domain and for a child.
// hooks:  none.
// mirror: src/reference/domain.rs
#ifndef CORPUT_DOMAIN_GLSL
#define CORPUT_DOMAIN_GLSL

#include "corput/hash.glsl"

// Which scrambled copy of a sequence is drawn from, and which of its points.
struct CorputDomain {
    uvec2 pattern;
    uint index;
};

// The domain of a pixel: its samples in one frame are the points 0, 1, 2, ... of one copy,
// and any number of them from 0 on is well distributed as far as the sequence's prefixes are.
CorputDomain corput_domain(uvec2 pixel, uint frame, uint index, uint seed) {
    uvec4 v = corput_mix4(uvec4(pixel, frame, seed));
    return CorputDomain(v.xy, index);
}

// The child for a purpose, such as the lens, the time, or the light at a hit: it draws other
// dimensions than its siblings with other keys and than its parent.
CorputDomain corput_domain_child(CorputDomain parent, uint key) {
    uvec4 v = corput_mix4(uvec4(parent.pattern, key, 0u));
    return CorputDomain(v.xy, parent.index);
}

// The child where each sample splits into `size` ones, of which this is number `branch`, such
// as shadow rays of a hit: all branches of all samples together are points 0, 1, 2, ... of one
// copy.
CorputDomain corput_domain_split(CorputDomain parent, uint key, uint size, uint branch) {
    CorputDomain child = corput_domain_child(parent, key);
    return CorputDomain(child.pattern, child.index * size + branch);
}

// The child for one link of a chain, such as a bounce of a path or a step through a volume:
// every link draws from another copy, so their number need not be known.
CorputDomain corput_domain_chain(CorputDomain parent, uint key, uint link) {
    uvec4 v = corput_mix4(uvec4(parent.pattern, key, 1u));
    v = corput_mix4(uvec4(v.xy, link, 2u));
    return CorputDomain(v.xy, parent.index);
}

// A word for dimension d of the draw, different for every pattern.
uint corput_domain_seed(CorputDomain domain, uint d) {
    return corput_seed(domain.pattern, d, 4u);
}

#endif
