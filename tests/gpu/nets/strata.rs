//! Jittered grids, Latin hypercubes and multi-jittered sets: one point to a stratum.

use std::sync::Arc;

use corput::catalog::{Options, Sequence};
use corput::vulkan::Device;

use crate::cells::{By, Kind, WAYS, points_by, unfilled, wrong};
use crate::support;

/// Numbers of points, and a grid for each.
const COUNTS: [(u64, [u64; 2]); 5] = [
    (3, [3, 1]),
    (7, [1, 7]),
    (1000, [40, 25]),
    (1024, [32, 32]),
    (1_000_000, [1000, 1000]),
];

/// Both kernels and outputs; of the largest sets, which the general kernel is slow at, those
/// of tiles.
fn ways(count: u64) -> &'static [(Kind, By)] {
    if count > 10_000 { &WAYS[2..] } else { &WAYS }
}

fn set(sequence: Sequence, count: u64) -> Options {
    let mut options = Options::new(sequence, count);
    options.seed = Some(7);
    options
}

/// Strata of both axes, as many as points, that do not hold one each.
fn axes(rows: &[Vec<u64>], kind: Kind) -> usize {
    let axis = |d: usize| {
        unfilled(
            rows.iter().map(|row| row[d]),
            kind.bits(),
            rows.len() as u64,
        )
    };
    axis(0) + axis(1)
}

fn gridded(
    device: &Arc<Device>,
    way: (Kind, By),
    sequence: Sequence,
    count: u64,
    grid: [u64; 2],
) -> Vec<Vec<u64>> {
    let mut options = set(sequence, count);
    options.grid = Some(grid.to_vec());
    points_by(device, way, options)
}

#[test]
fn jittered_grids_hold_one_point_per_cell() {
    support::on_each_device(|device| {
        for (count, grid) in COUNTS {
            for &way in ways(count) {
                let rows = gridded(device, way, Sequence::Stratified, count, grid);
                assert_eq!(wrong(&rows, way.0.bits(), grid), 0, "{count} {way:?}");
                // Cells are jittered: the axes alone have nothing of the kind.
                assert!(count < 1000 || axes(&rows, way.0) > 0, "{count}");
            }
            // All along one axis.
            let line = gridded(device, WAYS[3], Sequence::Stratified, count, [count, 1]);
            let first = line.iter().map(|row| row[0]);
            assert_eq!(unfilled(first, WAYS[3].0.bits(), count), 0, "{count}");
        }
    });
}

#[test]
fn latin_hypercubes_hold_one_point_per_stratum_of_each_axis() {
    support::on_each_device(|device| {
        for (count, grid) in COUNTS {
            for &way in ways(count) {
                let rows = points_by(device, way, set(Sequence::LatinHypercube, count));
                assert_eq!(axes(&rows, way.0), 0, "{count} {way:?}");
                // Cells of the plane have nothing of the kind.
                assert!(
                    count < 1000 || wrong(&rows, way.0.bits(), grid) > 0,
                    "{count}"
                );
            }
        }
    });
}

#[test]
fn multi_jittered_sets_hold_one_point_per_cell_and_stratum() {
    support::on_each_device(|device| {
        for (count, grid) in COUNTS {
            for &way in ways(count) {
                let rows = gridded(device, way, Sequence::MultiJittered, count, grid);
                assert_eq!(wrong(&rows, way.0.bits(), grid), 0, "{count} {way:?}");
                assert_eq!(axes(&rows, way.0), 0, "{count} {way:?}");
            }
        }
    });
}

/// Coordinates cut to 24 bits without regard to strata, as a plain conversion would.
#[test]
fn plain_floats_leave_their_strata() {
    support::on_each_device(|device| {
        let rows = points_by(device, WAYS[0], set(Sequence::LatinHypercube, 1_000_000));
        let cut: Vec<Vec<u64>> = rows
            .iter()
            .map(|row| row.iter().map(|x| x >> 8).collect())
            .collect();
        assert!(axes(&cut, Kind::Floats) > 1000);
    });
}
