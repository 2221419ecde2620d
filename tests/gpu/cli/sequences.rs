//! `generate` for every sequence: shape and range, slices, seeds, and the same bytes on every
//! device and on the CPU.

use super::parse::{Array, npy};
use super::{Desk, skips};
use corput::catalog::{SEQUENCES, Sequence};
use serde_json::Value;

/// Runs a `generate`, which may warn, and returns the array.
pub fn array(desk: &Desk, line: &str) -> Array {
    npy(&bytes(desk, line))
}

fn bytes(desk: &Desk, line: &str) -> Vec<u8> {
    let run = desk.run(&format!("generate {line} --out p.npy"));
    run.expect(0, &[]);
    assert_eq!(run.stdout, b"", "`{line}` wrote to standard output");
    desk.bytes("p.npy")
}

pub fn fractions(desk: &Desk, line: &str) -> Vec<u32> {
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
