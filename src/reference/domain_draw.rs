//! Draws of four dimensions from a domain, of the sequences that need no table.
//!
//! Source: those of the sequences' headers; Burley 2020 for shuffled pairs. Domain: every
//! domain; indices below `count` for sets; below 2^20 for the lattice. Range: fractions
//! of 2^32; the same domain gives the same point.
//! Mirror: `shaders/corput/domain_draw.glsl`.

use crate::reference::domain::{Domain, domain_seed};
use crate::reference::hash::mix4;
use crate::reference::lattice::{additive, lattice, rotate};
use crate::reference::owen::owen_hash;
use crate::reference::pmj02::{pmj02, sobol_pair};
use crate::reference::random::philox;
use crate::reference::stratified::{cmj, latin_hypercube};
use glam::{UVec2, UVec4, Vec4Swizzles, uvec2, uvec4};

/// Random numbers, by Philox.
#[inline]
#[must_use]
pub fn draw_random(domain: Domain) -> UVec4 {
    philox(uvec4(domain.index, 0, 0, 4), domain.pattern)
}

/// Random numbers, by the cheaper mixer.
#[inline]
#[must_use]
pub fn draw_random_fast(domain: Domain) -> UVec4 {
    mix4(uvec4(domain.index, 3, domain.pattern.x, domain.pattern.y))
}

/// Two Sobol pairs, shuffled and scrambled by the fast hash.
#[inline]
#[must_use]
pub fn draw_pairs(domain: Domain) -> UVec4 {
    let p = sobol_pair(owen_hash(domain.index, domain_seed(domain, 0)));
    let q = sobol_pair(owen_hash(domain.index, domain_seed(domain, 1)));
    uvec4(
        owen_hash(p.x, domain_seed(domain, 2)),
        owen_hash(p.y, domain_seed(domain, 3)),
        owen_hash(q.x, domain_seed(domain, 4)),
        owen_hash(q.y, domain_seed(domain, 5)),
    )
}

/// Two pairs of the progressive multi-jittered (0,2) sequence, by exact scrambles.
#[inline]
#[must_use]
pub fn draw_pmj02(domain: Domain) -> UVec4 {
    let other = uvec2(domain_seed(domain, 0), domain_seed(domain, 1));
    let p = pmj02(domain.index, domain.pattern);
    let q = pmj02(domain.index, other);
    uvec4(p.x, p.y, q.x, q.y)
}

/// A Latin hypercube of `count` points in four dimensions.
#[inline]
#[must_use]
pub fn draw_latin_hypercube(domain: Domain, count: u32) -> UVec4 {
    let jitter = draw_random(domain);
    uvec4(
        latin_hypercube(domain.index, count, domain_seed(domain, 0), jitter.x),
        latin_hypercube(domain.index, count, domain_seed(domain, 1), jitter.y),
        latin_hypercube(domain.index, count, domain_seed(domain, 2), jitter.z),
        latin_hypercube(domain.index, count, domain_seed(domain, 3), jitter.w),
    )
}

/// Two correlated multi-jittered pairs on a grid of grid.x * grid.y points.
#[inline]
#[must_use]
pub fn draw_cmj(domain: Domain, grid: UVec2) -> UVec4 {
    let jitter = draw_random(domain);
    let p = cmj(domain.index, grid, domain_seed(domain, 0), jitter.xy());
    let q = cmj(domain.index, grid, domain_seed(domain, 1), jitter.zw());
    uvec4(p.x, p.y, q.x, q.y)
}

/// The first four dimensions of the embedded lattice, rotated.
#[inline]
#[must_use]
pub fn draw_lattice(domain: Domain) -> UVec4 {
    uvec4(
        rotate(lattice(domain.index, 1), domain_seed(domain, 0)),
        rotate(lattice(domain.index, 182_667), domain_seed(domain, 1)),
        rotate(lattice(domain.index, 469_891), domain_seed(domain, 2)),
        rotate(lattice(domain.index, 498_753), domain_seed(domain, 3)),
    )
}

/// The additive recurrence of four dimensions, rotated: steps g^-1 ... g^-4, g^5 = g + 1.
#[inline]
#[must_use]
pub fn draw_additive(domain: Domain) -> UVec4 {
    let n = domain.index;
    uvec4(
        rotate(
            additive(n, uvec2(0x75ae_2165, 0xdb4f_0b91)),
            domain_seed(domain, 0),
        ),
        rotate(
            additive(n, uvec2(0x03a4_615f, 0xbbe0_5633)),
            domain_seed(domain, 1),
        ),
        rotate(
            additive(n, uvec2(0xa1fe_1576, 0xa0f2_ec75)),
            domain_seed(domain, 2),
        ),
        rotate(
            additive(n, uvec2(0x7d9e_d689, 0x89e1_8285)),
            domain_seed(domain, 3),
        ),
    )
}
