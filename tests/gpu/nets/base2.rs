//! Sobol pairs and pmj02: one point in every elementary interval, under every scramble, in
//! either order; Sobol in any dimension against the recurrence.

use std::sync::Arc;

use corput::catalog::{Options, Order, Request, Sequence};
use corput::interface::{Column, NetScramble};
use corput::judge;
use corput::tables::sobol_initial;
use corput::vulkan::Device;

use crate::cells::{By, Kind, WAYS, points_by, requested, wrong};
use crate::support;

/// The largest net, of 2^16 points.
const MOST: u32 = 16;

/// Elementary intervals of 2^m points, for all m, that do not hold exactly one: of the first
/// points, or of the last.
fn faults(rows: &[Vec<u64>], kind: Kind, last: bool) -> usize {
    assert_eq!(rows.len(), 1 << MOST);
    let shapes = (0..=MOST).flat_map(|m| (0..=m).map(move |i| (m, i)));
    shapes
        .map(|(m, i)| {
            let part = if last {
                &rows[rows.len() - (1 << m)..]
            } else {
                &rows[..1 << m]
            };
            wrong(part, kind.bits(), [1 << i, 1 << (m - i)])
        })
        .sum()
}

fn net(sequence: Sequence, first: u64) -> Options {
    let mut options = Options::new(sequence, 1 << MOST);
    options.first = first;
    options.seed = Some(0x0123_4567_89ab_cdef);
    options
}

/// Prefixes, and the aligned blocks that end with the last index of all.
fn assert_nets(device: &Arc<Device>, name: &str, make: impl Fn(u64) -> Options) {
    for way in WAYS {
        for (first, last) in [(0, false), ((1 << 32) - (1 << MOST), true)] {
            let rows = points_by(device, way, make(first));
            assert_eq!(faults(&rows, way.0, last), 0, "{name} {way:?} from {first}");
        }
    }
    println!("{name}: one point in each elementary interval");
}

#[test]
fn sobol_pairs_are_nets_under_every_scramble_and_in_either_order() {
    support::on_each_device(|device| {
        for &scramble in Sequence::Sobol.scrambles() {
            for order in [Order::Natural, Order::Gray] {
                let name = format!("{} {}", scramble.name(), order.name());
                assert_nets(device, &name, |first| {
                    let mut options = net(Sequence::Sobol, first);
                    options.scramble = Some(scramble);
                    options.order = order;
                    options
                });
            }
        }
    });
}

#[test]
fn pmj02_points_are_nets() {
    support::on_each_device(|device| {
        for seed in [0, u64::MAX] {
            assert_nets(device, &format!("pmj02 {seed}"), |first| {
                let mut options = net(Sequence::Pmj02, first);
                options.seed = Some(seed);
                options
            });
        }
    });
}

#[test]
fn other_points_are_no_nets() {
    support::on_each_device(|device| {
        let way = (Kind::Fractions, By::Plan);
        let unaligned = points_by(device, way, net(Sequence::Sobol, 3));
        assert!(faults(&unaligned, way.0, false) > 0);
        for sequence in [Sequence::Random, Sequence::R2, Sequence::MultiJittered] {
            let rows = points_by(device, way, net(sequence, 0));
            assert!(faults(&rows, way.0, false) > 0, "{sequence:?}");
        }
    });
}

/// Dimensions all over the table.
const DIMENSIONS: [u32; 6] = [0, 1, 7, 63, 1000, 21_200];

/// Starts of blocks of indices, the last one among them.
const STARTS: [u64; 5] = [
    0,
    65_536 - 50,
    (1 << 24) - 7,
    3_486_784_401,
    (1 << 32) - (1 << 14),
];

/// The sum of direction numbers that the recurrence gives, bit by bit.
fn judged(n: u64, dimension: u32) -> u64 {
    let directions = match sobol_initial(dimension) {
        Some((polynomial, initial)) => judge::sobol_directions(polynomial, &initial),
        None => std::array::from_fn(|bit| 0x8000_0000 >> bit),
    };
    let odd = |bit: &usize| (n >> bit) % 2 == 1;
    let sum = (0..32).filter(odd).fold(0, |x, bit| x ^ directions[bit]);
    u64::from(sum)
}

/// Points of these dimensions, which a tile kernel has four of.
fn of_dimensions(first: u64, dimensions: &[u32], kind: Kind, gray: bool) -> Request {
    let mut options = net(Sequence::Sobol, first);
    options.count = 1 << 14;
    options.seed = None;
    options.dimensions = Some(dimensions.len() as u64);
    options.fractions = kind == Kind::Fractions;
    let mut request = Request::new(&options).unwrap_or_else(|error| panic!("{error}"));
    let column = |&dimension: &u32| Column::Sobol {
        dimension,
        gray,
        scramble: NetScramble::None,
        seed: [0, 0],
    };
    request.columns = dimensions.iter().map(column).collect();
    request
}

#[test]
fn dimensions_follow_their_recurrence_to_the_last_index() {
    support::on_each_device(|device| {
        for dimensions in [&DIMENSIONS[..4], &DIMENSIONS[2..]] {
            for first in STARTS {
                for way in WAYS {
                    for gray in [false, true] {
                        let request = of_dimensions(first, dimensions, way.0, gray);
                        let rows = requested(device, way, &request);
                        let tested = |i: &usize| i.is_multiple_of(61) || i + 9 > rows.len();
                        for i in (0..rows.len()).filter(tested) {
                            let n = first + i as u64;
                            let index = if gray { n ^ (n >> 1) } else { n };
                            for (&dimension, &x) in dimensions.iter().zip(&rows[i]) {
                                let truth = judged(index, dimension) >> (32 - way.0.bits());
                                assert_eq!(x, truth, "{dimension} {n} {way:?}");
                            }
                        }
                    }
                }
            }
        }
        // A neighbour's numbers are seen.
        let request = of_dimensions(0, &[1000], Kind::Fractions, false);
        let rows = requested(device, (Kind::Fractions, By::Table), &request);
        assert!((0..).zip(&rows).any(|(n, row)| row[0] != judged(n, 1001)));
    });
}
