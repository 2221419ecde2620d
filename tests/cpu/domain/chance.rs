//! Draws as random variables: uniform over pixels, and independent of other domains' and
//! of each other.

use corput::reference::domain::Domain;
use glam::{UVec2, UVec4, uvec2};

use crate::significance::{critical, deviate};
use crate::{DRAWS, TREE, Tree, at};

/// Pixels are a square of so many along each side, two apart: between them lie others.
const SIDE: u32 = 64;

/// Indices at which samples are compared.
const INDICES: [u32; 3] = [0, 1, 777];

/// The intervals into which joint tests cut an axis.
const CELLS: u32 = 8;

fn pixels(side: u32) -> impl Iterator<Item = UVec2> {
    (0..side * side).map(move |i| 2 * uvec2(i % side, i / side))
}

/// Two domains of a pixel that must have nothing to do with each other.
type Relation = (&'static str, fn(&Tree, UVec2) -> [Domain; 2]);

fn root(tree: &Tree, pixel: UVec2) -> Domain {
    (tree.domain)(pixel, 0, 0, 0)
}

const RELATIONS: [Relation; 12] = [
    ("neighbours along x", |t, p| {
        [p, p + UVec2::X].map(|p| root(t, p))
    }),
    ("neighbours along y", |t, p| {
        [p, p + UVec2::Y].map(|p| root(t, p))
    }),
    ("x and y in turn", |t, p| {
        [p, uvec2(p.y, p.x + 1)].map(|p| root(t, p))
    }),
    ("frames", |t, p| {
        [6, 7].map(|frame| (t.domain)(p, frame, 0, 0))
    }),
    ("seeds", |t, p| [6, 7].map(|seed| (t.domain)(p, 0, 0, seed))),
    ("a frame and a seed", |t, p| {
        [(t.domain)(p, 1, 0, 0), (t.domain)(p, 0, 0, 1)]
    }),
    ("parent and child", |t, p| {
        [root(t, p), (t.child)(root(t, p), 0)]
    }),
    ("keys", |t, p| [0, 1].map(|key| (t.child)(root(t, p), key))),
    ("keys apart in their highest bit", |t, p| {
        [5, 0x8000_0005].map(|key| (t.child)(root(t, p), key))
    }),
    ("links", |t, p| {
        [0, 1].map(|link| (t.chain)(root(t, p), 3, link))
    }),
    ("a child and a link", |t, p| {
        [(t.child)(root(t, p), 3), (t.chain)(root(t, p), 3, 0)]
    }),
    ("key and link in turn", |t, p| {
        [(t.chain)(root(t, p), 3, 4), (t.chain)(root(t, p), 4, 3)]
    }),
];

/// The deviate of the joint counts of two coordinates: any dependence that 8 x 8 cells show,
/// of which correlation is one.
fn joint(pairs: impl Iterator<Item = [u32; 2]>) -> f64 {
    let mut counts = vec![0; (CELLS * CELLS) as usize];
    let mut all = 0u32;
    for [x, y] in pairs {
        counts[((x >> 29) * CELLS + (y >> 29)) as usize] += 1;
        all += 1;
    }
    deviate(&counts, f64::from(all) / f64::from(CELLS * CELLS))
}

/// The deviate of the correlation coefficient of two uniform variables, of either sign.
fn correlation(pairs: impl Iterator<Item = [u32; 2]>) -> f64 {
    let centred = |x: u32| (f64::from(x) + 0.5) / 4_294_967_296.0 - 0.5;
    let (mut sum, mut all) = (0.0, 0.0f64);
    for [x, y] in pairs {
        sum += centred(x) * centred(y);
        all += 1.0;
    }
    (12.0 * sum / all.sqrt()).abs()
}

/// The largest deviates of each draw over a relation.
fn related(tree: &Tree, (_, relation): Relation) -> Vec<f64> {
    let pairs: Vec<[Domain; 2]> = pixels(SIDE).map(|pixel| relation(tree, pixel)).collect();
    let mut found = Vec::new();
    for (_, draw) in DRAWS {
        for index in INDICES {
            let drawn: Vec<[UVec4; 2]> = pairs
                .iter()
                .map(|pair| pair.map(|domain| draw(at(domain, index))))
                .collect();
            for (a, b) in (0..16).map(|i| (i / 4, i % 4)) {
                let of = || drawn.iter().map(|[p, q]| [p[a], q[b]]);
                found.extend([joint(of()), correlation(of())]);
            }
        }
    }
    found
}

/// Correlations have two tails.
fn bound(tests: usize) -> f64 {
    critical(2 * tests)
}

fn largest(found: &[f64]) -> f64 {
    found.iter().copied().fold(f64::NEG_INFINITY, f64::max)
}

#[test]
fn draws_of_different_domains_are_independent() {
    let found: Vec<Vec<f64>> = RELATIONS.map(|relation| related(&TREE, relation)).to_vec();
    let tests = found.iter().map(Vec::len).sum();
    for ((name, _), found) in RELATIONS.iter().zip(&found) {
        println!("{name}: {:.2} of {:.2}", largest(found), bound(tests));
        assert!(largest(found) < bound(tests), "{name}: {}", largest(found));
    }
}

#[test]
fn domains_that_know_each_other_are_refused() {
    let refused = |tree: &Tree, name: &str| {
        let relation = RELATIONS.into_iter().find(|(other, _)| *other == name);
        let found = related(tree, relation.expect("a relation"));
        println!("{name}: {:.1}", largest(&found));
        largest(&found) > bound(RELATIONS.len() * found.len())
    };
    let deaf = Tree {
        child: |parent, _| (TREE.child)(parent, 0),
        ..TREE
    };
    assert!(refused(&deaf, "keys"));
    let same = Tree {
        chain: |parent, key, _| (TREE.child)(parent, key),
        ..TREE
    };
    assert!(refused(&same, "links") && refused(&same, "a child and a link"));
    let symmetric = Tree {
        chain: |parent, key, link| (TREE.chain)(parent, key ^ link, 0),
        ..TREE
    };
    assert!(refused(&symmetric, "key and link in turn"));
    let still = Tree {
        domain: |pixel, _, index, seed| (TREE.domain)(pixel, 0, index, seed),
        ..TREE
    };
    assert!(refused(&still, "frames"));
    let coarse = Tree {
        domain: |pixel, frame, index, seed| {
            (TREE.domain)(uvec2(pixel.x >> 1, pixel.y), frame, index, seed)
        },
        ..TREE
    };
    assert!(refused(&coarse, "neighbours along x"));
}

/// The four coordinates of one sample, in pairs, over pixels.
fn coordinates(draw: impl Fn(Domain) -> UVec4) -> Vec<f64> {
    let mut found = Vec::new();
    for index in INDICES {
        for key in [None, Some(1)] {
            let sample = |pixel| {
                let parent = root(&TREE, pixel);
                let domain = key.map_or(parent, |key| (TREE.child)(parent, key));
                draw(at(domain, index))
            };
            let drawn: Vec<UVec4> = pixels(SIDE).map(sample).collect();
            for (a, b) in [(0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)] {
                let of = || drawn.iter().map(|p| [p[a], p[b]]);
                found.extend([joint(of()), correlation(of())]);
            }
        }
    }
    found
}

#[test]
fn coordinates_of_a_draw_are_independent_over_pixels() {
    let found = DRAWS.map(|(_, draw)| coordinates(draw));
    let tests = found.iter().map(Vec::len).sum();
    for ((name, draw), found) in DRAWS.iter().zip(&found) {
        println!("{name}: {:.2} of {:.2}", largest(found), bound(tests));
        assert!(largest(found) < bound(tests), "{name}: {}", largest(found));
        // The first pair twice.
        let twice = coordinates(|domain| {
            let p = draw(domain);
            UVec4::new(p.x, p.y, p.x, p.y)
        });
        assert!(largest(&twice) > bound(tests), "{name}");
    }
}

/// One coordinate over 1,024 pixels, by the counts of 64 intervals, at each index.
fn marginals(draw: impl Fn(Domain) -> UVec4) -> Vec<f64> {
    let mut found = Vec::new();
    for index in INDICES {
        for frame in 0..4 {
            let domains = pixels(32).map(|pixel| (TREE.domain)(pixel, frame, index, 0));
            let drawn: Vec<UVec4> = domains.map(&draw).collect();
            assert_eq!(drawn.len(), 1024);
            for axis in 0..4 {
                let mut counts = vec![0; 64];
                drawn
                    .iter()
                    .for_each(|p| counts[(p[axis] >> 26) as usize] += 1);
                found.push(deviate(&counts, 1024.0 / 64.0));
            }
        }
    }
    found
}

#[test]
fn every_coordinate_is_uniform_over_pixels() {
    let found = DRAWS.map(|(_, draw)| marginals(draw));
    let tests = found.iter().map(Vec::len).sum();
    for ((name, draw), found) in DRAWS.iter().zip(&found) {
        println!("{name}: {:.2} of {:.2}", largest(found), critical(tests));
        assert!(
            largest(found) < critical(tests),
            "{name}: {}",
            largest(found)
        );
        // A square root, and one copy for all pixels.
        let bent = marginals(|domain| {
            draw(domain).map(|x| (f64::from(x) * 4_294_967_296.0).sqrt() as u32)
        });
        assert!(largest(&bent) > critical(tests), "{name}");
        let one = marginals(|domain| draw(at(root(&TREE, UVec2::ZERO), domain.index)));
        assert!(largest(&one) > critical(tests), "{name}");
    }
}
