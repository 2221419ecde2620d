//! `generate` for every sequence: shape and range, published first points, strata, slices,
//! and the same bytes on every device and on the CPU.

use super::parse::{Array, npy};
use super::{Desk, skips};
use corput::catalog::{SEQUENCES, Sequence};
use serde_json::Value;

/// Runs a `generate`, which may warn, and returns the array.
fn array(desk: &Desk, line: &str) -> Array {
    npy(&bytes(desk, line))
}

fn bytes(desk: &Desk, line: &str) -> Vec<u8> {
    let run = desk.run(&format!("generate {line} --out p.npy"));
    run.expect(0, &[]);
    assert_eq!(run.stdout, b"", "`{line}` wrote to standard output");
    desk.bytes("p.npy")
}

fn fractions(desk: &Desk, line: &str) -> Vec<u32> {
    let array = array(desk, &format!("{line} --fractions --device cpu"));
    assert_eq!(array.kind, "<u4");
    array.words
}

/// Numbers of the devices present.
fn devices(desk: &Desk) -> usize {
    let said: Value = serde_json::from_str(&desk.say("devices --json")).unwrap();
    said["devices"].as_array().unwrap().len()
}

/// Fails unless so many devices and the CPU write the same bytes, all in [0, 1).
fn assert_same(desk: &Desk, devices: usize, line: &str, [rows, columns]: [usize; 2]) {
    let cpu = bytes(desk, &format!("{line} --device cpu"));
    let array = npy(&cpu);
    if line.contains("--fractions") {
        array.assert_is("<u4", rows, columns);
    } else {
        array.assert_is("<f4", rows, columns);
        assert!(array.floats().all(|x| (0.0..1.0).contains(&x)), "`{line}`");
    }
    for device in 0..devices {
        let there = bytes(desk, &format!("{line} --device {device}"));
        assert!(there == cpu, "`{line}` differs on device {device}");
    }
}

/// Every sequence with every scramble and option, without a number of points, and its
/// dimensions.
const POINTS: [(&str, usize); 36] = [
    ("random --dims 5 --seed 7", 5),
    ("random-fast --dims 3 --seed 7", 3),
    ("pcg32 --dims 3 --seed 7", 3),
    ("stratified --dims 1 --seed 1", 1),
    ("stratified --dims 3 --seed 1", 3),
    ("latin-hypercube --dims 5 --seed 1", 5),
    ("cmj --seed 1", 2),
    ("vdc", 1),
    ("vdc --scramble faure", 1),
    ("vdc --scramble permute --seed 1", 1),
    ("vdc --scramble owen --seed 1", 1),
    ("vdc --scramble start --seed 1", 1),
    ("halton --dims 8", 8),
    ("halton --dims 8 --scramble faure", 8),
    ("halton --dims 8 --scramble permute --seed 3", 8),
    ("halton --dims 8 --scramble owen --seed 3", 8),
    ("halton --dims 8 --scramble start --seed 3", 8),
    (
        "halton --bases 3,8161 --scramble owen --seed 18446744073709551615",
        2,
    ),
    ("hammersley --dims 3", 3),
    ("hammersley --dims 3 --index-first", 3),
    ("sobol --dims 8", 8),
    ("sobol --dims 8 --order gray", 8),
    ("sobol --dims 8 --scramble shift --seed 3", 8),
    ("sobol --dims 8 --scramble matrix --seed 3", 8),
    ("sobol --dims 8 --scramble owen --seed 3", 8),
    ("sobol --dims 8 --scramble owen --order gray --seed 3", 8),
    ("sobol --dims 8 --scramble owen-hash --seed 3", 8),
    ("pmj02 --seed 2", 2),
    ("lattice --dims 8", 8),
    ("lattice --dims 8 --seed 2", 8),
    ("lattice --dims 250 --scramble rotate", 250),
    ("korobov --dims 4", 4),
    ("korobov --dims 4 --seed 2", 4),
    ("korobov --dims 4 --generator 76", 4),
    ("r2", 2),
    ("r2 --dims 16 --seed 2", 16),
];

/// The sequence of a row.
fn sequence(points: &str) -> Sequence {
    Sequence::from_name(points.split(' ').next().unwrap()).unwrap()
}

fn is_set(points: &str) -> bool {
    sequence(points).options().contains(&"--total")
}

#[test]
fn the_rows_have_every_sequence_and_scramble() {
    for known in SEQUENCES {
        let rows = POINTS
            .iter()
            .filter(|(points, _)| sequence(points) == *known);
        let rows: Vec<&str> = rows.map(|(points, _)| *points).collect();
        assert!(!rows.is_empty(), "{}", known.name());
        for scramble in known.scrambles() {
            let words = format!("--scramble {}", scramble.name());
            let seeded = scramble.name() == known.default_scramble(true).name();
            let found = rows
                .iter()
                .any(|row| format!("{row} ").contains(&format!("{words} ")));
            assert!(found || seeded || scramble.name() == "none", "{words}");
        }
    }
}

#[test]
fn commands_as_documented() {
    if skips() {
        return;
    }
    let desk = Desk::new();
    let devices = devices(&desk);
    for (line, rows, columns) in [
        ("random --count 1048576 --dims 4 --seed 7", 1 << 20, 4),
        ("stratified --count 1000 --dims 2 --seed 1", 1000, 2),
        ("latin-hypercube --count 1000 --dims 5 --seed 1", 1000, 5),
        ("cmj --count 1024 --dims 2 --seed 1", 1024, 2),
        ("sobol --count 65536 --dims 8", 65536, 8),
        (
            "sobol --count 1024 --dims 10 --order gray --fractions",
            1024,
            10,
        ),
        ("sobol --count 16 --dims 21201", 16, 21201),
        (
            "sobol --count 65536 --dims 8 --scramble owen --seed 3",
            65536,
            8,
        ),
        (
            "halton --count 65536 --dims 8 --scramble permute --seed 3",
            65536,
            8,
        ),
        ("pmj02 --count 4096 --seed 2", 4096, 2),
        ("lattice --count 4096 --dims 8 --seed 2", 4096, 8),
        ("r2 --count 4096", 4096, 2),
        ("stratified --count 512 --grid 32x16", 512, 2),
        ("stratified --count 60 --grid 3x4x5", 60, 3),
        ("cmj --count 1021 --grid 1x1021", 1021, 2),
        ("korobov --count 65521 --dims 3", 65521, 3),
    ] {
        assert_same(&desk, devices, line, [rows, columns]);
    }
}

#[test]
fn every_sequence_is_the_same_everywhere() {
    if skips() {
        return;
    }
    let desk = Desk::new();
    let devices = devices(&desk);
    for (points, columns) in POINTS {
        // The number of a published Korobov lattice, which cmj has only as a row of cells.
        let start = match sequence(points) {
            Sequence::MultiJittered => "--count 1021 --grid 1x1021",
            _ => "--count 1021",
        };
        assert_same(
            &desk,
            devices,
            &format!("{points} {start}"),
            [1021, columns],
        );
        let (end, rows) = match sequence(points) {
            Sequence::Lattice => ("--first 1047555 --count 1021", 1021),
            Sequence::Korobov if !points.contains("--generator") => {
                ("--first 65000 --count 521", 521)
            }
            _ if is_set(points) => ("--first 4294966274 --count 1021 --total 4294967295", 1021),
            _ => ("--first 4294966275 --count 1021", 1021),
        };
        let line = format!("{points} {end} --fractions");
        assert_same(&desk, devices, &line, [rows, columns]);
    }
}

#[test]
fn a_slice_is_the_tail_of_the_whole() {
    if skips() {
        return;
    }
    let desk = Desk::new();
    for (points, _) in POINTS {
        let (count, first) = match sequence(points) {
            Sequence::Korobov => (1021, 600),
            _ => (1020, 601),
        };
        let rest = count - first;
        let total = match is_set(points) {
            true => format!("--total {count}"),
            false => String::new(),
        };
        for device in ["", "--device cpu"] {
            let whole = array(&desk, &format!("{points} --count {count} {device}"));
            let line = format!("{points} --first {first} --count {rest} {total} {device}");
            let slice = array(&desk, &line);
            assert_eq!((slice.rows, slice.columns), (rest, whole.columns));
            assert!(
                slice.words == whole.words[first * whole.columns..],
                "`{line}`"
            );
        }
    }
}

#[test]
fn seeds_choose_the_points() {
    let desk = Desk::new();
    for (points, _) in POINTS {
        let Some((unseeded, _)) = points.split_once(" --seed") else {
            continue;
        };
        let with = |seed: &str| {
            let count = if points.starts_with("korobov") {
                1021
            } else {
                1020
            };
            fractions(&desk, &format!("{unseeded} --count {count} {seed}"))
        };
        let seeds = ["0", "1", "4294967296", "18446744073709551615"];
        let made = seeds.map(|seed| with(&format!("--seed {seed}")));
        for (i, points) in made.iter().enumerate() {
            for other in &made[..i] {
                assert!(points != other, "`{unseeded}`: {}", seeds[i]);
            }
        }
        assert!(with("--seed 1") == made[1], "`{unseeded}`");
        // Seed 0 is the default, but that only a seed rotates a lattice.
        let rotated = sequence(points).default_scramble(true).is_random();
        assert_eq!(with("") == made[0], !rotated, "`{unseeded}`");
    }
}

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

#[test]
fn sets_have_one_point_in_each_stratum() {
    let desk = Desk::new();
    let made = |line: &str| array(&desk, &format!("{line} --device cpu"));
    let value =
        |array: &Array, row: usize, axis: usize| f64::from(f32::from_bits(array.row(row)[axis]));
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
        let mut seen = vec![0; cells[0] * cells[1]];
        for row in 0..array.rows {
            let [x, y] =
                [0, 1].map(|axis| (value(&array, row, axis) * cells[axis] as f64) as usize);
            seen[y * cells[0] + x] += 1;
        }
        assert!(seen.iter().all(|points| *points == 1), "{line}");
    }
    // By the program's own measure: a (0, 12, 2)-net.
    for line in ["pmj02 --seed 2", "sobol --scramble owen --seed 2"] {
        made(&format!("{line} --count 4096"));
        let said: Value =
            serde_json::from_str(&desk.say("measure p.npy --json --only t-value")).unwrap();
        assert_eq!(said["measures"]["t_value"]["t"], 0, "{line}");
    }
}
