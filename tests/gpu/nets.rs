//! Net structure of the points that devices make: which cells hold how many of them,
//! in exact arithmetic, as fractions of 2^32 and as floats.

#[path = "nets/base2.rs"]
mod base2;
#[path = "nets/cells.rs"]
mod cells;
#[path = "nets/digits.rs"]
mod digits;
#[path = "nets/strata.rs"]
mod strata;
mod support;

use cells::{Kind, points, wrong};
use corput::catalog::{Options, Sequence};

/// Powers of 2 and of 3: boxes of 2^-i x 3^-j, and as many points.
const BOXES: [(u32, u32); 9] = [
    (16, 0),
    (13, 1),
    (8, 5),
    (10, 6),
    (5, 7),
    (4, 8),
    (1, 10),
    (0, 11),
    (0, 12),
];

fn halton(first: u64, count: u64, bases: &[u64]) -> Options {
    let mut options = Options::new(Sequence::Halton, count);
    options.first = first;
    options.bases = Some(bases.to_vec());
    options
}

/// The digits of n mirrored, over base^digits.
fn mirrored(mut n: u64, base: u64) -> (u128, u128) {
    let (mut reversed, mut scale) = (0, 1);
    while n != 0 {
        reversed = reversed * u128::from(base) + u128::from(n % base);
        scale *= u128::from(base);
        n /= base;
    }
    (reversed, scale)
}

/// Coordinates of Halton (2, 3), where one base is rounded the wrong way: base 3 down,
/// or base 2 up.
fn rounded_the_wrong_way(first: u64, count: u64, kind: Kind, wrong: u64) -> Vec<Vec<u64>> {
    let coordinate = |n: u64, base: u64| {
        let (reversed, scale) = mirrored(n, base);
        let scaled = reversed << kind.bits();
        if (base == 2) == (base == wrong) {
            scaled.div_ceil(scale).min((1 << kind.bits()) - 1) as u64
        } else {
            (scaled / scale) as u64
        }
    };
    (first..first + count)
        .map(|n| vec![coordinate(n, 2), coordinate(n, 3)])
        .collect()
}

/// The multiple of `count` from which `count` points include `index`.
fn around(index: u64, count: u64) -> u64 {
    index / count * count
}

#[test]
fn halton_points_lie_one_to_a_box() {
    support::on_each_device(|device| {
        for (i, j) in BOXES {
            let across = [2u64.pow(i), 3u64.pow(j)];
            let count = across[0] * across[1];
            for kind in Kind::BOTH {
                // Base 2 has no bound.
                let end = if j == 0 {
                    1 << 32
                } else {
                    kind.bound(across[1]) + 1
                };
                let power = 3u64.pow(if kind == Kind::Fractions { 20 } else { 15 });
                let starts = [0, around(power, count), around(end, count) - count];
                let mut spoiled = 0;
                for first in starts {
                    assert!(first + count <= end, "{i} {j} {kind:?} {first}");
                    let rows = points(device, kind, halton(first, count, &[2, 3]));
                    let bad = wrong(&rows, kind.bits(), across);
                    assert_eq!(bad, 0, "2^{i} x 3^{j} {kind:?} from {first}");
                    let base = if j == 0 { 2 } else { 3 };
                    let other = rounded_the_wrong_way(first, count, kind, base);
                    spoiled += wrong(&other, kind.bits(), across);
                }
                println!("2^{i} x 3^{j} {kind:?}: 0 wrong; rounded the other way {spoiled}");
                // Base 2 is exact in 32 bits, so there is nothing to round.
                assert_eq!(spoiled == 0, j == 0 && kind == Kind::Fractions);
            }
        }
    });
}

/// Whether point n lies in its interval of length base^-k.
fn inside(x: u64, n: u64, base: u64, k: u32, kind: Kind) -> bool {
    let cells = base.pow(k);
    let (reversed, scale) = mirrored(n % cells, base);
    let cell = reversed * (u128::from(cells) / scale);
    (u128::from(x) * u128::from(cells)) >> kind.bits() == cell
}

#[test]
fn every_index_up_to_the_bound_stays_in_its_interval() {
    support::on_each_device(|device| {
        for kind in Kind::BOTH {
            for base in [3u64, 5, 7, 179, 181, 8161] {
                for k in 1.. {
                    let cells = base.pow(k);
                    if cells >= 1 << kind.bits() {
                        break;
                    }
                    let end = kind.bound(cells) + 1;
                    let count = end.min(4096);
                    let first = end - count;
                    let rows = points(device, kind, halton(first, count, &[base]));
                    for (n, row) in (first..).zip(rows) {
                        assert!(inside(row[0], n, base, k, kind), "{base}^{k} {kind:?} {n}");
                    }
                }
            }
        }
    });
}

#[test]
fn above_the_bound_a_point_leaves_its_interval() {
    support::on_each_device(|device| {
        for (kind, n, k) in [
            (Kind::Fractions, 3_486_784_403, 20),
            (Kind::Floats, 14_348_909, 15),
        ] {
            assert!(n > kind.bound(3u64.pow(k)));
            let rows = points(device, kind, halton(n, 1, &[3]));
            assert!(!inside(rows[0][0], n, 3, k, kind), "{n}");
        }
    });
}

#[test]
fn hammersley_sets_are_nets_in_base_2() {
    support::on_each_device(|device| {
        for m in [0, 1, 2, 5, 10, 16, 20] {
            for kind in Kind::BOTH {
                let mut options = Options::new(Sequence::Hammersley, 1 << m);
                options.dimensions = Some(2);
                let rows = points(device, kind, options);
                // On the diagonal no box but the widest would do.
                let diagonal: Vec<Vec<u64>> = rows.iter().map(|row| vec![row[1]; 2]).collect();
                for i in 0..=m {
                    let across = [1 << i, 1 << (m - i)];
                    let bad = wrong(&rows, kind.bits(), across);
                    assert_eq!(bad, 0, "2^{i} of 2^{m} {kind:?}");
                    let spoiled = wrong(&diagonal, kind.bits(), across);
                    assert_eq!(spoiled == 0, i == 0 || i == m, "2^{i} of 2^{m}");
                }
            }
        }
    });
}
