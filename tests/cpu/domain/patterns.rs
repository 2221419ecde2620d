//! Patterns: 64 bits that no two domains share.

use corput::reference::domain::{Domain, domain_child};
use glam::{UVec2, uvec2};

use crate::{TREE, Tree};

/// Domains of each kind. Among all of them any two share their 64 bits by chance with a
/// probability of 2^-17.
const EACH: u32 = 1 << 20;

/// Patterns of domains that are all different.
fn patterns(tree: &Tree, each: u32) -> Vec<u64> {
    let high = |i: u32| i << 12;
    let (row, column) = (|i: u32| i >> 10, |i: u32| i & 1023);
    let pixel = |i| uvec2(column(i), row(i));
    let root = |x| (tree.domain)(uvec2(x, 5000), 0, 0, 0);
    let kinds: [&dyn Fn(u32) -> Domain; 12] = [
        // Pixels, frames and seeds; whatever counts in its upper bits as well.
        &|i| (tree.domain)(pixel(i), 0, 0, 0),
        &|i| (tree.domain)(uvec2(high(i), 6000), 0, 0, 0),
        &|i| (tree.domain)(uvec2(1, 5000), i + 1, 0, 0),
        &|i| (tree.domain)(uvec2(2, 5000), high(i) + 1, 0, 0),
        &|i| (tree.domain)(uvec2(1, 5000), 0, 0, i + 1),
        &|i| (tree.domain)(uvec2(2, 5000), 0, 0, high(i) + 1),
        // Keys.
        &|i| (tree.child)(root(5), i),
        &|i| (tree.child)(root(6), high(i)),
        // Keys of keys, and links: of one root, so that they must differ from each other
        // and from the children.
        &|i| (tree.child)((tree.child)(root(5), row(i)), column(i)),
        &|i| (tree.chain)(root(5), row(i), column(i)),
        &|i| (tree.chain)(root(5), 4096, i),
        &|i| (tree.chain)(root(6), high(i), high(i)),
    ];
    let word = |domain: Domain| u64::from(domain.pattern.x) << 32 | u64::from(domain.pattern.y);
    let of = |kind: &&dyn Fn(u32) -> Domain| (0..each).map(|i| word(kind(i))).collect::<Vec<_>>();
    kinds.iter().flat_map(of).collect()
}

/// How many of them another one has as well.
fn shared(mut patterns: Vec<u64>) -> usize {
    let all = patterns.len();
    patterns.sort_unstable();
    patterns.dedup();
    all - patterns.len()
}

#[test]
fn no_two_domains_share_a_pattern() {
    let found = patterns(&TREE, EACH);
    assert_eq!(found.len(), 12 << 20);
    assert_eq!(shared(found), 0);
}

#[test]
fn trees_whose_domains_meet_are_refused() {
    let broken: [(&str, Tree); 8] = [
        (
            "a domain ignores its frame",
            Tree {
                domain: |pixel, _, index, seed| (TREE.domain)(pixel, 0, index, seed),
                ..TREE
            },
        ),
        (
            "a domain adds frame and seed",
            Tree {
                domain: |pixel, frame, index, seed| {
                    (TREE.domain)(pixel, frame.wrapping_add(seed), index, 0)
                },
                ..TREE
            },
        ),
        (
            "a child ignores its key",
            Tree {
                child: |parent, _| domain_child(parent, 0),
                ..TREE
            },
        ),
        (
            "a chain ignores its link",
            Tree {
                chain: |parent, key, _| (TREE.chain)(parent, key, 0),
                ..TREE
            },
        ),
        (
            "a chain is a child",
            Tree {
                chain: |parent, key, link| domain_child(parent, key ^ link),
                ..TREE
            },
        ),
        (
            "a chain is a child's child",
            Tree {
                chain: |parent, key, link| domain_child(domain_child(parent, key), link),
                ..TREE
            },
        ),
        (
            "a child adds its key",
            Tree {
                child: |parent, key| Domain {
                    pattern: parent.pattern.wrapping_add(UVec2::X * key),
                    ..parent
                },
                ..TREE
            },
        ),
        (
            "patterns of 32 bits",
            Tree {
                child: |parent, key| Domain {
                    pattern: domain_child(parent, key).pattern * UVec2::X,
                    ..parent
                },
                ..TREE
            },
        ),
    ];
    for (name, tree) in broken {
        let found = shared(patterns(&tree, EACH / 4));
        println!("{name}: {found}");
        assert!(found > 0, "{name}");
    }
}

/// What a split shares is the pattern of the child with its key, and nothing else.
#[test]
fn branches_share_one_pattern() {
    let parent = (TREE.domain)(uvec2(3, 4), 5, 6, 7);
    for key in [0, 1, u32::MAX] {
        for (size, branch) in [(1, 0), (4, 0), (4, 3), (1000, 999)] {
            let split = (TREE.split)(parent, key, size, branch);
            assert_eq!(split.pattern, (TREE.child)(parent, key).pattern);
        }
    }
}
