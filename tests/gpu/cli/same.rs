//! The same bytes on the device and on the CPU, and fused as apart.

use super::parse::npy;
use super::{Desk, skips};
use corput::bulk;
use corput::catalog::{Map, Mapping, Profile, maps};

/// The start, the middle, and up to 2^32.
const RANGES: [&str; 3] = [
    "--count 100000",
    "--first 123457 --count 99991",
    "--first 4294867296 --count 100000",
];

fn assert_same(desk: &Desk, line: &str) {
    let device = desk.make(line, "device.npy");
    let cpu = desk.make(&format!("{line} --device cpu"), "cpu.npy");
    assert!(device == cpu, "`{line}` differs from the CPU's");
}

#[test]
fn points_are_those_of_the_cpu() {
    if skips() {
        return;
    }
    let desk = Desk::new();
    for points in [
        "vdc",
        "vdc --bases 3",
        "halton",
        "halton --dims 1",
        "halton --dims 3",
        "halton --dims 7",
        "halton --bases 2,3,8161",
        "halton --bases 8161,2",
        "hammersley",
        "hammersley --index-first",
        "hammersley --dims 1",
        "hammersley --dims 5 --index-first",
        "hammersley --bases 3,8161 --total 4294967296",
    ] {
        for range in RANGES {
            for output in ["", "--fractions"] {
                assert_same(&desk, &format!("{points} {range} {output}"));
            }
        }
    }
    assert_same(&desk, "vdc --count 1");
    assert_same(&desk, "halton --count 6 --dims 2");
    assert_same(&desk, "halton --count 1000 --dims 1024 --first 4294966296");
    // A dispatch per four columns, each with runs of its own length.
    assert_same(&desk, "halton --count 600011 --dims 12 --first 4294367285");
}

#[test]
fn samples_of_maps_are_those_of_the_cpu() {
    if skips() {
        return;
    }
    let desk = Desk::new();
    for map in fused_maps() {
        for points in [
            "halton",
            "halton --bases 8161,3",
            "hammersley",
            "hammersley --index-first",
        ] {
            for (range, pdf) in [(RANGES[0], ""), (RANGES[1], ""), (RANGES[2], "--with-pdf")] {
                assert_same(&desk, &format!("{points} {range} --map {} {pdf}", map.name));
            }
        }
    }
}

#[test]
fn fused_equals_fractions_and_then_the_map() {
    if skips() {
        return;
    }
    let desk = Desk::new();
    for points in [
        "halton --count 100000 --first 1000003",
        "hammersley --count 65537",
    ] {
        assert_fused(&desk, points, &fused_maps());
    }
    for (i, points) in [
        "halton --count 9973 --scramble owen --seed 3",
        "sobol --count 9973 --scramble owen --seed 3",
        "sobol --count 9973 --scramble matrix --order gray --seed 3",
        "random --count 9973 --seed 3",
        "stratified --count 9972 --seed 3",
        "latin-hypercube --count 9973 --seed 3",
        "cmj --count 9972 --seed 3",
        "pmj02 --count 9973 --seed 3",
        "lattice --count 9973 --seed 3",
        "korobov --count 8191",
        "r2 --count 9973",
    ]
    .into_iter()
    .enumerate()
    {
        let maps = fused_maps();
        let other = 1 + i % (maps.len() - 1);
        assert_fused(&desk, points, &[maps[0], maps[other]]);
    }
}

/// The maps that kernels of points know; they take no parameters.
fn fused_maps() -> Vec<&'static Map> {
    maps().filter(|map| map.group.fused()).collect()
}

fn assert_fused(desk: &Desk, points: &str, maps: &[&'static Map]) {
    let fractions = npy(&desk.make(&format!("{points} --fractions"), "u.npy"));
    for map in maps {
        let line = format!("{points} --map {} --with-pdf", map.name);
        let fused = npy(&desk.make(&line, "d.npy"));
        let width = map.coordinates as usize + 1;
        let mapping = Mapping::new(map, &[]).expect("no parameters");
        fused.assert_is("<f4", fractions.rows, width);
        for row in 0..fractions.rows {
            let u = fractions.row(row);
            let expected = bulk::map_sample(&mapping, Profile::Exact, [u[0], u[1], 0]);
            assert_eq!(fused.row(row), &expected[..width], "`{line}`, row {row}");
        }
    }
}
