//! What is in the way of a file: other runs, what they left, and what is finished.

use super::{Desk, SMALL};

#[test]
fn two_runs_of_one_file_are_refused() {
    let desk = Desk::new();
    let line = format!("{SMALL} --device cpu --out p.npy");
    let running = desk.start(&line, 1);
    for resume in ["", " --resume"] {
        let words = [
            "p.npy: another run is writing this file",
            "wait for that run",
        ];
        desk.run(&format!("{line}{resume}")).expect(2, &words);
    }
    running.end(&line).expect(0, &[]);
    assert_eq!(desk.names(), ["p.npy", "p.npy.json"]);
}

#[test]
fn a_partial_of_other_arguments_is_refused_or_discarded() {
    let desk = Desk::new();
    let line = format!("{SMALL} --device cpu --out p.npy");
    drop(desk.start(&line, 3));
    for (other, words) in [
        (
            line.replace("--seed 1", "--seed 2"),
            "arguments.seed is 1 there and 2 here",
        ),
        (
            line.replace("20000", "30000"),
            "chunk_rows is 20000 there and 30000 here",
        ),
        (format!("{line} --fractions"), "there and"),
    ] {
        let run = desk.run(&format!("{other} --resume"));
        run.expect(2, &["p.npy", words, "drop --resume"]);
        assert_eq!(desk.names(), [".p.npy.partial", ".p.npy.partial.json"]);
    }
    desk.run(&line.replace("--seed 1", "--seed 2"))
        .expect(0, &[]);
    assert_eq!(desk.names(), ["p.npy", "p.npy.json"]);
}

#[test]
fn a_partial_of_another_version_says_what_to_do() {
    let desk = Desk::new();
    let line = format!("{SMALL} --device cpu --out p.npy");
    drop(desk.start(&line, 3));
    let journal = String::from_utf8(desk.bytes(".p.npy.partial.json")).unwrap();
    let own = env!("CARGO_PKG_VERSION");
    let said = format!("\"version\":\"{own}\"");
    let older = journal.replace(&said, "\"version\":\"0.0.9\"");
    assert_ne!(older, journal);
    std::fs::write(desk.path(".p.npy.partial.json"), older).unwrap();
    let words = [
        "is of version \"0.0.9\" of corput, and this is",
        "go on with that version, or drop --resume",
    ];
    desk.run(&format!("{line} --resume")).expect(2, &words);
    assert_eq!(desk.names(), [".p.npy.partial", ".p.npy.partial.json"]);
    desk.run(&line).expect(0, &[]);
}

#[test]
fn a_finished_file_is_not_made_again() {
    let desk = Desk::new();
    let line = "generate halton --count 1000 --device cpu --out p.npy --resume";
    desk.run(line).expect(0, &[]);
    let time = |desk: &Desk| {
        std::fs::metadata(desk.path("p.npy"))
            .unwrap()
            .modified()
            .unwrap()
    };
    let made = time(&desk);
    desk.run(line)
        .expect(0, &["p.npy is finished", "corput verify p.npy"]);
    assert_eq!(time(&desk), made);
    // With other arguments it is none of this run.
    let before = desk.bytes("p.npy");
    desk.run(&line.replace("1000", "1001")).expect(0, &[]);
    assert_ne!(desk.bytes("p.npy"), before);
}

#[test]
fn what_another_version_finished_is_not_discarded() {
    let desk = Desk::new();
    let line = "generate halton --count 1000 --device cpu --out p.npy";
    desk.run(line).expect(0, &[]);
    let sidecar = String::from_utf8(desk.bytes("p.npy.json")).unwrap();
    let own = env!("CARGO_PKG_VERSION");
    let older = sidecar.replace(&format!("\"version\": \"{own}\""), "\"version\": \"0.0.9\"");
    assert_ne!(older, sidecar);
    // Bytes that only that version makes.
    let mut bytes = desk.bytes("p.npy");
    *bytes.last_mut().unwrap() ^= 1;
    std::fs::write(desk.path("p.npy"), &bytes).unwrap();
    std::fs::write(desk.path("p.npy.json"), &older).unwrap();
    let run = desk.run(&format!("{line} --resume"));
    let said = format!("version 0.0.9 of corput finished it, and this is {own}");
    run.expect(2, &["p.npy: ", &said, "corput verify", "drop --resume"]);
    assert_eq!(desk.bytes("p.npy"), bytes);
    assert_eq!(desk.bytes("p.npy.json"), older.as_bytes());
    assert_eq!(desk.names(), ["p.npy", "p.npy.json"]);
    // Without --resume it is made again.
    desk.run(line).expect(0, &[]);
    assert_eq!(desk.bytes("p.npy.json"), sidecar.as_bytes());
}

#[test]
fn chunks_are_those_of_files() {
    let desk = Desk::new();
    for option in ["--resume", "--chunk-rows 5"] {
        let line = format!("generate halton --count 10 --device cpu --out - {option}");
        desk.run(&line)
            .expect(2, &["standard output", "regular file", "drop"]);
    }
    for (rows, words) in [
        ("0", "at least 1 row"),
        ("1", "65536 chunks"),
        ("x", "whole number"),
    ] {
        let line =
            format!("generate halton --count 65537 --device cpu --out p.npy --chunk-rows {rows}");
        desk.run(&line).expect(2, &[words]);
    }
    assert!(desk.names().is_empty());
    let line =
        "generate halton --count 10 --device cpu --out p.npy --chunk-rows 18446744073709551615";
    desk.run(line).expect(0, &[]);
}
