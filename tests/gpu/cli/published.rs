//! Points of files against published values, and strata against their definition.

use super::Desk;
use super::parse::Array;
use super::sequences::{array, fractions};
use serde_json::Value;

#[test]
fn first_points_are_the_published_ones() {
    let desk = Desk::new();
    // Sobol by Joe and Kuo, four dimensions, in units of 1/8 and in the order of SciPy:
    // qmc.Sobol(4, scramble=False).random(8).
    let gray = [
        [0, 0, 0, 0],
        [4, 4, 4, 4],
        [6, 2, 2, 2],
        [2, 6, 6, 6],
        [3, 3, 5, 7],
        [7, 7, 1, 3],
        [5, 1, 7, 5],
        [1, 5, 3, 1],
    ];
    let found = fractions(&desk, "sobol --count 8 --dims 4 --order gray");
    assert_eq!(
        found,
        gray.as_flattened()
            .iter()
            .map(|n| n << 29)
            .collect::<Vec<u32>>()
    );
    // Its place n has the point n ^ (n >> 1) of the natural order.
    let found = fractions(&desk, "sobol --count 8 --dims 4");
    for (place, row) in gray.iter().enumerate() {
        let natural = &found[(place ^ (place >> 1)) * 4..][..4];
        assert_eq!(natural, row.map(|n| n << 29), "place {place}");
    }
    // The demonstration of PCG32, seeded with 42.
    assert_eq!(
        fractions(&desk, "pcg32 --count 6 --dims 1 --seed 42"),
        [
            0xa15c_02b7,
            0x7b47_f409,
            0xba1d_3330,
            0x83d2_f293,
            0xbfa4_784b,
            0xcbed_606e
        ]
    );
    // The known answer of Philox-4x32-10 for a counter and a key of zeros.
    assert_eq!(
        fractions(&desk, "random --count 1 --dims 4 --seed 0"),
        [0x6627_e8d5, 0xe169_c58d, 0xbc57_ac4c, 0x9b00_dbd8]
    );
    // Faure's permutation of base 5 is (0 3 2 1 4).
    let fifths = [0, 3, 2, 1, 4].map(|digit| (digit * (1u64 << 32)).div_ceil(5) as u32);
    let found = fractions(&desk, "halton --bases 5 --count 5 --scramble faure");
    assert_eq!(found, fifths);
    // 1/2 + n / rho and 1/2 + n / rho^2, rho the plastic number.
    let found = array(&desk, "r2 --count 1000 --device cpu");
    let rho = 1.324_717_957_244_746_f64;
    for n in 0..1000 {
        for (word, step) in found.row(n).iter().zip([rho.recip(), rho.powi(-2)]) {
            let expected = (0.5 + n as f64 * step).fract();
            assert!(
                (f64::from(f32::from_bits(*word)) - expected).abs() < 1e-6,
                "{n}"
            );
        }
    }
    // Point 1 of the Korobov lattice of generator 76 is (1, 76) / 1021.
    let found = fractions(&desk, "korobov --count 1021");
    assert_eq!(
        found[2..4],
        [1u64, 76].map(|k| (k << 32).div_ceil(1021) as u32)
    );
}

/// Fails unless each of `strata` equal parts holds one of the values.
fn assert_one_each(values: impl Iterator<Item = f64>, strata: usize, what: &str) {
    let mut seen = vec![false; strata];
    for value in values {
        let stratum = (value * strata as f64) as usize;
        assert!(
            !std::mem::replace(&mut seen[stratum], true),
            "{what}: {value}"
        );
    }
    assert!(seen.iter().all(|seen| *seen), "{what}");
}

/// Whether each cell of a grid holds one point.
fn one_in_each(array: &Array, cells: [usize; 2]) -> bool {
    let mut seen = vec![0; cells[0] * cells[1]];
    for row in 0..array.rows {
        let [x, y] = [0, 1].map(|axis| (value(array, row, axis) * cells[axis] as f64) as usize);
        seen[y * cells[0] + x] += 1;
    }
    seen.iter().all(|points| *points == 1)
}

fn value(array: &Array, row: usize, axis: usize) -> f64 {
    f64::from(f32::from_bits(array.row(row)[axis]))
}

#[test]
fn sets_have_one_point_in_each_stratum() {
    let desk = Desk::new();
    let made = |line: &str| array(&desk, &format!("{line} --device cpu"));
    for (line, rows) in [
        ("latin-hypercube --count 1000 --dims 5 --seed 1", 1000),
        ("cmj --count 1024 --seed 1", 1024),
        ("cmj --count 1000 --seed 5", 1000),
    ] {
        let array = made(line);
        for axis in 0..array.columns {
            assert_one_each((0..rows).map(|row| value(&array, row, axis)), rows, line);
        }
    }
    for (line, cells) in [
        ("stratified --count 1000 --seed 1", [40, 25]),
        ("stratified --count 512 --grid 32x16 --seed 1", [32, 16]),
        ("cmj --count 1024 --seed 1", [32, 32]),
        ("cmj --count 1000 --grid 10x100 --seed 1", [10, 100]),
    ] {
        let array = made(line);
        assert!(one_in_each(&array, cells), "{line}");
    }
    assert!(!one_in_each(
        &made("random --count 1024 --seed 1"),
        [32, 32]
    ));
    // By the program's own measure: a (0, 12, 2)-net.
    for line in ["pmj02 --seed 2", "sobol --scramble owen --seed 2"] {
        made(&format!("{line} --count 4096"));
        let said: Value =
            serde_json::from_str(&desk.say("measure p.npy --json --only t-value")).unwrap();
        assert_eq!(said["measures"]["t_value"]["t"], 0, "{line}");
    }
}
