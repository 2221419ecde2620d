//! Every function from its definition, by parts of the judge.

use corput::judge::{self, random as by_chance};
use corput::reference::domain::{Domain, domain_seed};
use corput::reference::permute::permute_key;
use corput::tables::{additive_alphas, lattice_vector, sobol_initial};
use glam::{UVec2, UVec4, uvec2};

use crate::{COUNT, DRAWS, TREE, at, domains};

/// Small indices, those around 2^16 where other trees of domains end, and the last ones.
fn indices() -> impl Iterator<Item = u32> {
    (0..20)
        .chain(65_530..65_550)
        .chain((0..200).map(by_chance::hash))
        .chain(u32::MAX - 5..=u32::MAX)
}

fn pattern(words: [u32; 4]) -> UVec2 {
    let [x, y, ..] = by_chance::mix4(words);
    uvec2(x, y)
}

#[test]
fn trees_are_those_of_the_definition() {
    for pixel in [uvec2(0, 0), uvec2(3, 1), uvec2(u32::MAX, 1 << 31)] {
        for (frame, seed) in [(0, 0), (1, 2), (u32::MAX, 7)] {
            let root = (TREE.domain)(pixel, frame, 11, seed);
            assert_eq!(root.pattern, pattern([pixel.x, pixel.y, frame, seed]));
            assert_eq!(root.index, 11);
        }
    }
    for parent in domains().into_iter().map(|d| at(d, 0x1234_5678)) {
        let UVec2 { x, y } = parent.pattern;
        for key in [0, 1, 77, u32::MAX] {
            let child = (TREE.child)(parent, key);
            assert_eq!(
                child,
                at(
                    Domain {
                        pattern: pattern([x, y, key, 0]),
                        index: 0
                    },
                    parent.index
                )
            );
            let first = pattern([x, y, key, 1]);
            for link in [0, 1, u32::MAX] {
                let chain = (TREE.chain)(parent, key, link);
                assert_eq!(chain.pattern, pattern([first.x, first.y, link, 2]));
                assert_eq!(chain.index, parent.index);
            }
            for (size, branch) in [(1, 0), (3, 2), (16, 15), (u32::MAX, 7)] {
                let split = (TREE.split)(parent, key, size, branch);
                let place = u64::from(parent.index) * u64::from(size) + u64::from(branch);
                assert_eq!(split.pattern, child.pattern);
                assert_eq!(u64::from(split.index), place % (1 << 32));
            }
        }
    }
}

/// A sum of direction numbers, which the judge makes from the recurrence.
fn sobol(n: u32, dimension: u32) -> u32 {
    let directions = match sobol_initial(dimension) {
        Some((polynomial, initial)) => judge::sobol_directions(polynomial, &initial),
        None => std::array::from_fn(|bit| 0x8000_0000 >> bit),
    };
    let odd = |bit: &usize| (n >> bit) % 2 == 1;
    (0..32).filter(odd).fold(0, |x, bit| x ^ directions[bit])
}

/// A draw from its definition.
fn judged(name: &str, domain: Domain) -> [u32; 4] {
    let n = domain.index;
    let key = [domain.pattern.x, domain.pattern.y];
    let seed = |d: u32| by_chance::mix4([key[0], key[1], d, 4])[0];
    let hashed = |x, d| by_chance::owen_hash(x, seed(d));
    let random = by_chance::philox([n, 0, 0, 4], key, 10);
    let each = |of: &dyn Fn(u32) -> u32| [0, 1, 2, 3].map(of);
    let pmj02 = |key: [u32; 2]| {
        let scrambled = |x, which| by_chance::owen(x, (1 << 31) + which, key);
        [0, 1].map(|d| scrambled(sobol(scrambled(n, 2), d), d))
    };
    match name {
        "random" => random,
        "random_fast" => by_chance::mix4([n, 3, key[0], key[1]]),
        "pairs" => each(&|d| hashed(sobol(hashed(n, d / 2), d % 2), d + 2)),
        "pmj02" => {
            let ([x, y], [z, w]) = (pmj02(key), pmj02([seed(0), seed(1)]));
            [x, y, z, w]
        }
        "latin_hypercube" => each(&|d| {
            let cell = judge::permutation(COUNT as usize, seed(d))[n as usize];
            judge::stratum(cell.into(), COUNT.into(), random[d as usize]) as u32
        }),
        "cmj" => {
            let pair = |d| {
                let keys = [0, 1, 2].map(|role| permute_key(seed(d), role));
                let jitter = [random[2 * d as usize], random[2 * d as usize + 1]];
                judge::cmj(n as usize, [32, 32], keys, jitter).map(|x| x as u32)
            };
            let ([x, y], [z, w]) = (pair(0), pair(1));
            [x, y, z, w]
        }
        "lattice" => each(&|d| {
            let multiple = u64::from(n.reverse_bits()) * u64::from(lattice_vector()[d as usize]);
            (multiple + u64::from(seed(d))) as u32
        }),
        "additive" => each(&|d| {
            let place = judge::additive(n, additive_alphas(4)[d as usize]);
            (place + u64::from(seed(d))) as u32
        }),
        "sobol" => each(&|d| hashed(sobol(hashed(n, 0), d), d + 1)),
        "sobol_owen" => each(&|d| by_chance::owen(sobol(by_chance::owen(n, 4, key), d), d, key)),
        "halton" => each(&|d| judge::owen(n, [2, 3, 5, 7][d as usize], seed(d)).floor() as u32),
        _ => panic!("no draw {name}"),
    }
}

#[test]
fn draws_are_those_of_the_definition() {
    for domain in domains() {
        for d in [0, 1, u32::MAX] {
            let words = by_chance::mix4([domain.pattern.x, domain.pattern.y, d, 4]);
            assert_eq!(domain_seed(domain, d), words[0]);
        }
        for (name, draw) in DRAWS {
            let set = matches!(name, "latin_hypercube" | "cmj");
            for n in indices().map(|n| if set { n % COUNT } else { n }) {
                let sample = at(domain, n);
                assert_eq!(
                    draw(sample),
                    UVec4::from(judged(name, sample)),
                    "{name} {n}"
                );
            }
        }
    }
}
