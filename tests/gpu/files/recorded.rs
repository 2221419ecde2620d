//! Recorded arguments make the same points again: of every sequence, scramble and map.

use super::Desk;
use super::desk::repository;
use corput::catalog::{Group, SEQUENCES, maps};
use corput::check::examples;

/// Makes points and verifies them.
fn round_trip(desk: &Desk, points: &str) {
    let run = desk.run(&format!("generate {points} --device cpu --out p.npy"));
    assert_eq!(run.code, Some(0), "`{points}`: {}", run.stderr);
    let run = desk.run("verify p.npy --device cpu");
    assert_eq!(run.code, Some(0), "`{points}`: {}", run.stderr);
    assert!(run.text().contains("rows are equal"), "{}", run.text());
}

#[test]
fn of_every_sequence_and_scramble() {
    let desk = Desk::new();
    let mut number = 0;
    for sequence in SEQUENCES {
        let name = sequence.name();
        // Composite and in the table of generators.
        let count = if name == "korobov" { 1021 } else { 60 };
        let points = format!("{name} --count {count}");
        round_trip(&desk, &points);
        round_trip(&desk, &format!("{points} --seed 18446744073709551615"));
        for scramble in sequence.scrambles() {
            round_trip(
                &desk,
                &format!("{points} --seed 3 --scramble {}", scramble.name()),
            );
            number += 1;
        }
    }
    assert!(number > 20, "only {number} scrambles");
}

#[test]
fn of_every_option() {
    let desk = Desk::new();
    for points in [
        "halton --count 60 --bases 8161,3 --first 1000 --fractions",
        "hammersley --count 60 --total 1000 --index-first --first 7",
        "sobol --count 60 --dims 7 --order gray",
        "stratified --count 60 --grid 10x6 --seed 5",
        "korobov --count 60 --generator 7",
        "blue-noise --count 60 --seed 4",
        "blue-noise --count 60 --fractions",
        "halton --count 60 --map cosine-hemisphere --profile native",
    ] {
        round_trip(&desk, points);
    }
}

#[test]
fn of_every_map() {
    let desk = Desk::new();
    let sky = repository("tests/data/sunrise.exr");
    std::fs::copy(&sky, desk.path("sky.exr")).unwrap();
    let mut parameters = 0;
    for map in maps() {
        let mut line = format!("sobol --count 60 --map {} --with-pdf", map.name);
        if map.group == Group::Environment {
            line += " --env sky.exr --env-weight max --compensated";
        } else {
            let mapping = examples(map).unwrap().into_iter().next().unwrap();
            let mut values = mapping.values();
            for parameter in map.parameters {
                let (own, rest) = values.split_at(parameter.size);
                let numbers: Vec<String> = own.iter().map(f64::to_string).collect();
                line += &format!(" --param {}={}", parameter.name, numbers.join(","));
                values = rest;
                parameters += 1;
            }
        }
        round_trip(&desk, &line);
    }
    assert!(parameters > 20, "only {parameters} parameters");
}

/// The picture lies elsewhere than when the samples were made of it, or is another.
#[test]
fn pictures_are_found_and_held_to_their_hash() {
    let desk = Desk::new();
    let sky = repository("tests/data/sunrise.exr");
    let studio = repository("tests/data/studio.exr");
    let (sub, sub_sky) = (desk.path("sub"), desk.path("sub/sky.exr"));
    std::fs::create_dir(&sub).unwrap();
    std::fs::copy(&sky, desk.path("sky.exr")).unwrap();
    let line = "generate sobol --count 60 --map environment --env sky.exr --device cpu --out";
    for out in ["sub/p.npy", "sub/s.zarr"] {
        desk.run(&format!("{line} {out}")).expect(0, &[]);
    }
    let verify = |options: &str, code: i32, words: &[&str]| {
        for out in ["sub/p.npy", "sub/s.zarr"] {
            desk.run(&format!("verify {out} --device cpu {options}"))
                .expect(code, words);
        }
    };
    verify("", 0, &[]);
    // Another picture is no longer the origin.
    std::fs::copy(&studio, desk.path("sky.exr")).unwrap();
    let words = ["sky.exr", "SHA-256", "put that picture back", "--env"];
    verify("", 2, &words);
    // In the folder of the file, though another of that name is here.
    std::fs::copy(&sky, &sub_sky).unwrap();
    verify("", 0, &[]);
    std::fs::remove_file(desk.path("sky.exr")).unwrap();
    verify("", 0, &[]);
    std::fs::rename(&sub_sky, desk.path("else.exr")).unwrap();
    verify("", 2, &["sky.exr", "check the path", "--env"]);
    verify("--env else.exr", 0, &[]);
    verify("--env none.exr", 2, &["none.exr", "cannot be read"]);
    std::fs::copy(&studio, desk.path("else.exr")).unwrap();
    verify("--env else.exr", 2, &["else.exr", "SHA-256"]);
    desk.run("generate halton --count 5 --device cpu --out h.npy")
        .expect(0, &[]);
    desk.run("verify h.npy --device cpu --env else.exr")
        .expect(2, &["no picture is recorded", "drop --env"]);
}
