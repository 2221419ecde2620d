//! What the program says of itself, and warns of.

use super::{Desk, Run, repository, skips};
use corput::catalog::{SCRAMBLES, SEQUENCES, maps};

#[test]
fn help_names_everything_there_is() {
    let desk = Desk::new();
    let help = desk.say("generate --help");
    let words = help.split_whitespace().collect::<Vec<_>>().join(" ");
    // The README's rows: a name, what it is, its use, its source, its points.
    let readme = std::fs::read_to_string(repository("README.md")).unwrap();
    let (_, table) = readme.split_once("| sequence |").unwrap();
    let rows = table
        .lines()
        .skip(2)
        .take_while(|line| line.starts_with("| `"));
    let mut names = Vec::new();
    for row in rows {
        let cells: Vec<&str> = row.trim_matches(['|', ' ']).split(" | ").collect();
        let [name, what, purpose, _, points] = cells[..] else {
            panic!("a row of other cells: {row}")
        };
        let name = name.trim_matches('`');
        for text in [&format!("{name} {what}"), purpose, points] {
            assert!(words.contains(text), "{name}: no `{text}`");
        }
        names.push(name);
    }
    let known = SEQUENCES.iter().map(|sequence| sequence.name());
    assert!(known.chain(["blue-noise", "blue-noise-mask"]).eq(names));
    for scramble in SCRAMBLES {
        let text = format!("{} {}", scramble.name(), scramble.summary());
        assert!(words.contains(&text), "no `{text}`");
    }
    for map in maps() {
        let text = format!("{} {}", map.name, map.summary);
        assert!(words.contains(&text), "no `{text}`");
    }
    assert!(help.lines().all(|line| line.len() <= 100), "{help}");
    let short = desk.say("generate -h");
    assert!(
        SEQUENCES.iter().all(|s| short.contains(s.name())),
        "{short}"
    );
    assert!(short.contains("corput generate --help"), "{short}");
}

#[test]
fn examples_of_the_help_work() {
    if skips() {
        return;
    }
    let desk = Desk::new();
    for (help, least) in [("--help", 3), ("generate --help", 5)] {
        let help = desk.say(help);
        let examples = help
            .lines()
            .filter_map(|line| line.strip_prefix("  corput "));
        // The last is a check of everything, which has tests of its own.
        let examples: Vec<&str> = examples.filter(|line| *line != "check").collect();
        assert!(examples.len() >= least, "{help}");
        for line in examples {
            let run = desk.run(line);
            run.expect(0, &[]);
            assert_eq!(run.stderr, "", "`{line}`");
        }
    }
}

/// Runs a `generate` that warns once, and writes what it writes without a warning.
fn assert_warns(line: &str, words: &[&str]) {
    let desk = Desk::new();
    let once = |run: &Run| {
        run.expect(0, words);
        let said: Vec<&str> = run.stderr.lines().collect();
        assert!(
            said.len() == 1 && said[0].starts_with("corput: warning: "),
            "{said:?}"
        );
    };
    let run = desk.run(&format!("generate {line} --device cpu --out p.npy"));
    once(&run);
    assert_eq!(run.stdout, b"", "`{line}` wrote to standard output");
    let piped = desk.run(&format!("generate {line} --device cpu --out -"));
    once(&piped);
    assert!(
        piped.stdout == desk.bytes("p.npy"),
        "`{line}` differs in a pipe"
    );
    assert_eq!(desk.names(), ["p.npy", "p.npy.json"]);
}

#[test]
fn what_may_disappoint_is_said_once_and_done() {
    for (line, words) in [
        (
            "stratified --count 1021 --seed 1",
            &["1021 is prime", "one axis", "--grid"][..],
        ),
        (
            "halton --count 4086 --dims 19",
            &[
                "4086 points are fewer than 67 x 61 = 4087",
                "lines",
                "--scramble owen",
            ],
        ),
        (
            "hammersley --count 100 --dims 7",
            &[
                "100 points are fewer than 13 x 11 = 143",
                "more points, or fewer dimensions",
            ],
        ),
        (
            "sobol --count 16 --seed 3",
            &[
                "--seed changes nothing",
                "sobol",
                "--scramble shift, matrix, owen or owen-hash",
            ],
        ),
        (
            "halton --count 16 --scramble faure --seed 3",
            &[
                "--seed changes nothing",
                "--scramble permute, owen or start",
            ],
        ),
        (
            "lattice --count 16 --scramble none --seed 3",
            &["--seed changes nothing", "--scramble rotate"],
        ),
        (
            "hammersley --count 16 --seed 3",
            &["--seed changes nothing", "; drop it"],
        ),
    ] {
        assert_warns(line, words);
    }
    let desk = Desk::new();
    for line in [
        "stratified --count 1000 --seed 1",
        "stratified --count 1021 --dims 1",
        "stratified --count 1021 --grid 1x1021",
        "halton --count 4087 --dims 19",
        "halton --first 4000 --count 87 --dims 19",
        "halton --count 10 --dims 19 --scramble owen --seed 3",
        "sobol --count 16 --scramble owen --seed 3",
        "lattice --count 16 --seed 3",
        "random --count 16 --seed 3",
    ] {
        desk.make(&format!("{line} --device cpu"), "q.npy");
    }
}
