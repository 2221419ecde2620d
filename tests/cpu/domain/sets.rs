//! Points of one domain: prefixes are nets, sets fill their strata, branches of a split are
//! one sequence.

use corput::reference::domain::Domain;
use corput::reference::domain_draw::{
    draw_additive, draw_cmj, draw_latin_hypercube, draw_lattice, draw_pairs, draw_pmj02,
};
use corput::reference::domain_halton::draw_halton;
use glam::{UVec2, UVec4, uvec2, uvec4};

use crate::nets::{is_net, wrong_intervals};
use crate::{Draw, TREE, at, domains, sobol_hashed, sobol_nested};

/// Draws in base 2, and which of (x, y) and (z, w) are (0,2)-sequences.
const NETS: [(&str, Draw, [bool; 2]); 4] = [
    ("pairs", draw_pairs, [true, true]),
    ("pmj02", draw_pmj02, [true, true]),
    ("sobol", sobol_hashed, [true, false]),
    ("sobol_owen", sobol_nested, [true, false]),
];

fn drawn(draw: impl Fn(Domain) -> UVec4, samples: impl Iterator<Item = Domain>) -> Vec<UVec4> {
    samples.map(draw).collect()
}

/// Intervals of two coordinates of 2^m points that do not hold exactly one.
fn spoiled(points: &[UVec4], axes: [usize; 2]) -> usize {
    wrong_intervals(&pairs(points, axes), points.len().ilog2())
}

fn pairs(points: &[UVec4], [a, b]: [usize; 2]) -> Vec<[u32; 2]> {
    points.iter().map(|p| [p[a], p[b]]).collect()
}

/// Intervals of width 2^-m of each coordinate that do not hold exactly one of 2^m points.
fn uneven(points: &[UVec4]) -> usize {
    let m = points.len().ilog2();
    (0..4)
        .map(|axis| {
            not_one(
                points.len(),
                points.iter().map(|p| u64::from(p[axis]) >> (32 - m)),
            )
        })
        .sum()
}

/// How many of `cells` cells do not hold exactly one of these.
fn not_one(cells: usize, of: impl Iterator<Item = u64>) -> usize {
    let mut held = vec![0u32; cells];
    of.for_each(|cell| held[cell as usize] += 1);
    held.iter().filter(|&&count| count != 1).count()
}

#[test]
fn prefixes_and_aligned_blocks_are_nets() {
    for (name, draw, nets) in NETS {
        for (number, domain) in domains().into_iter().enumerate() {
            for m in 0..=12 {
                let size = 1u32 << m;
                for first in [0, 5 << m, u32::MAX - (size - 1)] {
                    let samples = (0..size).map(|i| at(domain, first + i));
                    let points = drawn(draw, samples);
                    for (pair, _) in nets.iter().enumerate().filter(|(_, net)| **net) {
                        let wrong = spoiled(&points, [2 * pair, 2 * pair + 1]);
                        assert_eq!(wrong, 0, "{name} {number}: 2^{m} from {first}");
                    }
                    assert_eq!(uneven(&points), 0, "{name} {number}: 2^{m} from {first}");
                }
            }
        }
    }
}

#[test]
fn coordinates_of_different_pairs_are_no_nets() {
    for (name, draw, _) in &NETS[..2] {
        for domain in domains() {
            let points = drawn(draw, (0..256).map(|i| at(domain, i)));
            assert!(spoiled(&points, [0, 2]) > 0, "{name}");
            assert!(spoiled(&points, [1, 3]) > 0, "{name}");
        }
    }
}

#[test]
fn what_scatters_indices_is_refused() {
    let domain = domains()[3];
    let hashed = |i: u32| at(domain, i.wrapping_mul(0x9e37_79b9));
    for (name, draw, _) in NETS {
        let scattered = drawn(draw, (0..256).map(hashed));
        assert!(
            spoiled(&scattered, [0, 1]) > 0 && uneven(&scattered) > 0,
            "{name}"
        );
        let unaligned = drawn(draw, (3..259).map(|i| at(domain, i)));
        assert!(spoiled(&unaligned, [0, 1]) > 0, "{name}");
    }
}

/// Samples and branches whose indices end where the 32 bits do, and elsewhere.
const SPLITS: [(u32, u32, u32); 8] = [
    // First sample, samples, branches.
    (0, 1, 1),
    (0, 64, 16),
    (0, 1024, 4),
    (0, 1, 4096),
    (65_536, 256, 16),
    (1 << 20, 1024, 4),
    ((1 << 28) - 256, 256, 16),
    ((1 << 31) - 2048, 2048, 2),
];

fn split_indices(
    split: fn(Domain, u32, u32, u32) -> Domain,
    (first, samples, branches): (u32, u32, u32),
) -> Vec<Domain> {
    let parent = domains()[6];
    (first..first + samples)
        .flat_map(|n| (0..branches).map(move |branch| (n, branch)))
        .map(|(n, branch)| split(at(parent, n), 9, branches, branch))
        .collect()
}

/// Whether the branches are the points of one copy in order, and nets of it.
fn is_one_sequence(split: fn(Domain, u32, u32, u32) -> Domain, of: (u32, u32, u32)) -> bool {
    let (first, _, branches) = of;
    let found = split_indices(split, of);
    let start = u64::from(first) * u64::from(branches);
    let in_order = (start..)
        .zip(&found)
        .all(|(n, d)| u64::from(d.index) == n && d.pattern == found[0].pattern);
    let nets = NETS.iter().all(|(_, draw, _)| {
        let points = drawn(draw, found.iter().copied());
        is_net(&pairs(&points, [0, 1]), points.len().ilog2()) && uneven(&points) == 0
    });
    in_order && nets
}

#[test]
fn branches_of_all_samples_are_one_sequence() {
    for of in SPLITS {
        assert!(is_one_sequence(TREE.split, of), "{of:?}");
    }
    // The last point of all, and past it the first one again.
    let last = split_indices(TREE.split, ((1 << 30) - 1, 1, 4));
    assert_eq!(last[3].index, u32::MAX);
    assert_eq!(split_indices(TREE.split, (1 << 30, 1, 4))[0].index, 0);
    // Any number of branches counts on without a gap.
    let odd = split_indices(TREE.split, (30_000, 100, 3));
    assert!((90_000..90_300).eq(odd.iter().map(|d| d.index)));
}

/// A way to split a domain: domain, key, size, branch.
type Split = fn(Domain, u32, u32, u32) -> Domain;

#[test]
fn splits_that_are_no_sequence_are_refused() {
    let broken: [(&str, Split); 4] = [
        ("without size", |d, key, _, branch| {
            (TREE.split)(d, key, 1, branch)
        }),
        ("without branch", |d, key, size, _| {
            (TREE.split)(d, key, size, 0)
        }),
        ("a copy per branch", |d, key, size, branch| {
            at((TREE.child)(d, key ^ branch), d.index * size + branch)
        }),
        ("16 bits of index", |d, key, size, branch| {
            let split = (TREE.split)(d, key, size, branch);
            at(split, split.index & 0xffff)
        }),
    ];
    for (name, split) in broken {
        assert!(
            SPLITS.iter().any(|of| !is_one_sequence(split, *of)),
            "{name}"
        );
    }
}

/// The stratum of a coordinate among `strata`.
fn stratum(x: u32, strata: u32) -> u64 {
    (u64::from(x) * u64::from(strata)) >> 32
}

/// Strata of any axis that `count` points do not fill one each.
fn unfilled(points: &[UVec4]) -> usize {
    let count = points.len() as u32;
    let axis = |axis| {
        not_one(
            points.len(),
            points.iter().map(move |p| stratum(p[axis], count)),
        )
    };
    (0..4).map(axis).sum()
}

#[test]
fn latin_hypercubes_fill_their_strata() {
    for count in [1u32, 2, 3, 7, 16, 17, 1000, 1024] {
        for domain in domains() {
            let of = |total| {
                drawn(
                    |d| draw_latin_hypercube(d, total),
                    (0..count).map(|i| at(domain, i)),
                )
            };
            assert_eq!(unfilled(&of(count)), 0, "{count}");
            // A part of a larger set.
            assert!(count < 16 || unfilled(&of(2 * count)) > 0, "{count}");
        }
    }
}

/// Cells of a grid that two coordinates do not fill one each.
fn empty_cells(points: &[UVec4], [a, b]: [usize; 2], grid: UVec2) -> usize {
    let cell = |p: &UVec4| stratum(p[a], grid.x) * u64::from(grid.y) + stratum(p[b], grid.y);
    not_one(points.len(), points.iter().map(cell))
}

#[test]
fn multi_jittered_pairs_fill_cells_and_strata() {
    for grid in [[1, 1], [1, 7], [3, 2], [5, 5], [27, 37], [32, 32]].map(UVec2::from) {
        let count = grid.x * grid.y;
        for domain in domains() {
            let points = drawn(|d| draw_cmj(d, grid), (0..count).map(|i| at(domain, i)));
            assert_eq!(unfilled(&points), 0, "{grid}");
            for pair in [[0, 1], [2, 3]] {
                assert_eq!(empty_cells(&points, pair, grid), 0, "{grid}");
            }
            // Of different pairs.
            assert!(
                count < 25 || empty_cells(&points, [0, 2], grid) > 0,
                "{grid}"
            );
        }
    }
}

/// Without its rotation a prefix of 2^k points is the multiples of 2^-k, in each coordinate.
#[test]
fn lattices_fill_their_strata_but_for_a_rotation() {
    for domain in domains() {
        for m in [0, 1, 5, 10] {
            let points = drawn(draw_lattice, (0..1 << m).map(|i| at(domain, i)));
            let moved: Vec<UVec4> = points.iter().map(|p| p.wrapping_sub(points[0])).collect();
            assert!(moved.iter().all(|p| (p << m) == UVec4::ZERO), "2^{m}");
            assert_eq!(uneven(&moved), 0, "2^{m}");
        }
    }
}

/// Steps of g^-1 to g^-4 with g^5 = g + 1, whose root is found here by iteration.
#[test]
fn the_recurrence_steps_by_powers_of_its_root() {
    let root = (0..200).fold(1.2f64, |g, _| (g + 1.0).powf(0.2));
    let step = [1, 2, 3, 4].map(|k| (root.powi(-k) * 4_294_967_296.0).round() as u32);
    for domain in domains() {
        for n in [0, 1, 1000, 0x8000_0000, u32::MAX - 1] {
            let moved = draw_additive(at(domain, n + 1)).wrapping_sub(draw_additive(at(domain, n)));
            let off = moved
                .wrapping_sub(UVec4::from(step))
                .wrapping_add(UVec4::ONE);
            assert!(off.max_element() <= 2, "{n}: {moved} {step:?}");
        }
    }
}

/// The cells of 2^a x 3^b points, where cuts to 2^-32 do not matter.
#[test]
fn halton_prefixes_fill_boxes() {
    for domain in domains() {
        for (a, b) in [(0, 0), (3, 0), (0, 4), (4, 3), (5, 3)] {
            let grid = uvec2(2u32.pow(a), 3u32.pow(b));
            for first in [0, 7 * grid.x * grid.y] {
                let samples = (first..first + grid.x * grid.y).map(|i| at(domain, i));
                let points = drawn(|d| draw_halton(d, uvec4(2, 3, 5, 7)), samples);
                assert_eq!(empty_cells(&points, [0, 1], grid), 0, "{grid} from {first}");
            }
        }
        let points = drawn(
            |d| draw_halton(d, uvec4(2, 3, 5, 7)),
            (0..35).map(|i| at(domain, i)),
        );
        assert_eq!(empty_cells(&points, [2, 3], uvec2(5, 7)), 0);
        // Of one base twice.
        let twice = drawn(
            |d| draw_halton(d, uvec4(2, 2, 5, 7)),
            (0..36).map(|i| at(domain, i)),
        );
        assert!(empty_cells(&twice, [0, 1], uvec2(4, 9)) > 0);
    }
}
