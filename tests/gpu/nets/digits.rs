//! Halton points with permuted digits: boxes of 2^-i x 3^-j and as many points.
//!
//! Faure's permutations keep zeros, and coordinates are rounded up as unscrambled ones are:
//! each box holds one point up to the largest power of the base that a coordinate can tell
//! apart. Random permutations go on through infinitely many digits, and coordinates are cut:
//! what a coordinate stands for lies within one unit above it, and that point has its box.

use corput::catalog::{Options, Scramble, Sequence};

use crate::cells::{Kind, WAYS, points_by, wrong};
use crate::support;

const BOXES: [(u32, u32); 6] = [(16, 0), (10, 4), (8, 5), (4, 3), (1, 9), (0, 10)];

const RANDOM: [Scramble; 3] = [Scramble::Permute, Scramble::Owen, Scramble::Start];

fn halton(scramble: Scramble, first: u64, count: u64) -> Options {
    let mut options = Options::new(Sequence::Halton, count);
    options.first = first;
    options.scramble = Some(scramble);
    options.seed = scramble.is_random().then_some(3);
    options
}

/// Cells of an axis in which what a coordinate stands for may lie.
fn candidates(x: u64, bits: u32, cells: u64) -> [u64; 2] {
    // The unit above x ends where the next one begins.
    [(x * cells) >> bits, ((x + 1) * cells - 1) >> bits]
}

/// Boxes that cannot hold exactly one of the points that the coordinates stand for, and how
/// many points lie so near an edge that their box is open.
fn impossible(rows: &[Vec<u64>], bits: u32, across: [u64; 2]) -> (usize, usize) {
    let mut sure = vec![0u32; (across[0] * across[1]) as usize];
    let mut maybe = sure.clone();
    let mut open = 0;
    for row in rows {
        let [x, y] = [0, 1].map(|d| candidates(row[d], bits, across[d]));
        let certain = x[0] == x[1] && y[0] == y[1];
        open += usize::from(!certain);
        for a in x[0]..=x[1] {
            for b in y[0]..=y[1] {
                let held = if certain { &mut sure } else { &mut maybe };
                held[(a * across[1] + b) as usize] += 1;
            }
        }
    }
    let empty = sure.iter().filter(|&&held| held == 0).count();
    let bad = sure
        .iter()
        .zip(&maybe)
        .filter(|(sure, maybe)| **sure > 1 || (**sure == 0 && **maybe == 0))
        .count();
    (bad + usize::from(empty != open), open)
}

/// Where indices end for which boxes are promised: 3^20 and 3^15 are the largest powers that
/// 32 and 24 bits tell apart; base 2 has no end.
fn end(kind: Kind, j: u32) -> u64 {
    match kind {
        _ if j == 0 => 1 << 32,
        Kind::Fractions => 3u64.pow(20),
        Kind::Floats => 3u64.pow(15),
    }
}

#[test]
fn faure_points_lie_one_to_a_box() {
    support::on_each_device(|device| {
        for (i, j) in BOXES {
            let across = [2u64.pow(i), 3u64.pow(j)];
            let count = across[0] * across[1];
            for way in WAYS {
                let bits = way.0.bits();
                for first in [0, end(way.0, j) / count * count - count] {
                    let rows = points_by(device, way, halton(Scramble::Faure, first, count));
                    assert_eq!(
                        wrong(&rows, bits, across),
                        0,
                        "2^{i} x 3^{j} {way:?} from {first}"
                    );
                }
            }
        }
    });
}

#[test]
fn random_digits_lie_one_to_a_box_but_for_what_is_cut() {
    support::on_each_device(|device| {
        for scramble in RANDOM {
            let mut open = [0; 2];
            for (i, j) in BOXES {
                let across = [2u64.pow(i), 3u64.pow(j)];
                let count = across[0] * across[1];
                for way in WAYS {
                    for first in [0, (1 << 32) / count * count - count] {
                        let rows = points_by(device, way, halton(scramble, first, count));
                        let (bad, near) = impossible(&rows, way.0.bits(), across);
                        assert_eq!(bad, 0, "{scramble:?} 2^{i} x 3^{j} {way:?} from {first}");
                        // Base 2 is cut at its own digits.
                        assert!(near == 0 || j > 0);
                        open[usize::from(way.0 == Kind::Floats)] += near;
                    }
                }
            }
            println!("{}: open boxes {open:?} in 32 and 24 bits", scramble.name());
            assert!(open[0] < 10 && open[1] < 1000, "{open:?}");
        }
    });
}

#[test]
fn boxes_of_other_bases_are_refused() {
    support::on_each_device(|device| {
        for scramble in RANDOM {
            let mut options = halton(scramble, 0, 256 * 243);
            options.bases = Some(vec![2, 5]);
            let rows = points_by(device, WAYS[0], options);
            assert!(impossible(&rows, 32, [256, 243]).0 > 0, "{scramble:?}");
        }
    });
}
