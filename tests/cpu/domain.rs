//! Domains: the judge, patterns that never meet, points that fill their cells, and draws
//! that know nothing of each other.

#[path = "domain/chance.rs"]
mod chance;
#[path = "domain/judged.rs"]
mod judged;
mod nets;
#[path = "domain/patterns.rs"]
mod patterns;
#[path = "domain/sets.rs"]
mod sets;
mod significance;

use std::sync::LazyLock;

use corput::reference::domain::{Domain, domain, domain_chain, domain_child, domain_split};
use corput::reference::domain_draw::{
    draw_additive, draw_cmj, draw_latin_hypercube, draw_lattice, draw_pairs, draw_pmj02,
    draw_random, draw_random_fast,
};
use corput::reference::domain_halton::draw_halton;
use corput::reference::domain_sobol::{draw_sobol, draw_sobol_owen};
use corput::tables::sobol_directions;
use glam::{UVec2, UVec4, uvec2, uvec4};

/// The functions of the header, any of which a broken variant replaces.
#[derive(Clone, Copy)]
struct Tree {
    domain: fn(UVec2, u32, u32, u32) -> Domain,
    child: fn(Domain, u32) -> Domain,
    split: fn(Domain, u32, u32, u32) -> Domain,
    chain: fn(Domain, u32, u32) -> Domain,
}

const TREE: Tree = Tree {
    domain,
    child: domain_child,
    split: domain_split,
    chain: domain_chain,
};

/// Four dimensions of a domain.
type Draw = fn(Domain) -> UVec4;

/// Points of the sets among the draws, which have a fixed number of them.
const COUNT: u32 = 1024;

const DRAWS: [(&str, Draw); 11] = [
    ("random", draw_random),
    ("random_fast", draw_random_fast),
    ("pairs", draw_pairs),
    ("pmj02", draw_pmj02),
    ("latin_hypercube", |d| draw_latin_hypercube(d, COUNT)),
    ("cmj", |d| draw_cmj(d, uvec2(32, 32))),
    ("lattice", draw_lattice),
    ("additive", draw_additive),
    ("sobol", sobol_hashed),
    ("sobol_owen", sobol_nested),
    ("halton", |d| draw_halton(d, uvec4(2, 3, 5, 7))),
];

/// Direction numbers of four dimensions.
static DIRECTIONS: LazyLock<Vec<u32>> =
    LazyLock::new(|| (0..4).flat_map(sobol_directions).collect());

fn sobol_hashed(domain: Domain) -> UVec4 {
    draw_sobol(domain, &DIRECTIONS)
}

fn sobol_nested(domain: Domain) -> UVec4 {
    draw_sobol_owen(domain, &DIRECTIONS)
}

/// Domains of all kinds, at index 0.
fn domains() -> Vec<Domain> {
    let root = domain(uvec2(0, 0), 0, 0, 0);
    let far = domain(uvec2(1919, 1079), 7, 0, 0xdead_beef);
    let child = domain_child(far, 3);
    vec![
        root,
        domain(uvec2(1, 0), 0, 0, 0),
        domain(uvec2(0, 0), 1, 0, 0),
        far,
        domain_child(root, 0),
        domain_child(root, u32::MAX),
        child,
        domain_child(child, 0x8000_0000),
        domain_chain(child, 1, 9),
        domain_chain(domain_chain(root, 0, 0), 0, 1),
        domain_split(child, 5, 4, 0),
    ]
}

/// The sample of this index.
fn at(domain: Domain, index: u32) -> Domain {
    Domain { index, ..domain }
}

/// Engines keep one per path.
#[test]
fn a_domain_has_twelve_bytes() {
    assert_eq!(size_of::<Domain>(), 12);
}
