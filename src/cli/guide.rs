//! What `generate --help` says of sequences, scrambles and maps, from the catalogue.

use super::{mask, points};
use corput::catalog::{Guide, SCRAMBLES, SEQUENCES, Scramble, Sequence, maps as all_maps};

/// Names in a row.
fn names<'a>(names: impl IntoIterator<Item = &'a str>) -> String {
    names.into_iter().collect::<Vec<_>>().join(", ")
}

fn scrambles_of(sequence: Sequence) -> String {
    names(sequence.scrambles().iter().map(|scramble| scramble.name()))
}

/// What can be generated: the sequences, and what the host makes whole.
pub fn known() -> Vec<&'static str> {
    let sequences = SEQUENCES.iter().map(|sequence| sequence.name());
    sequences.chain([points::NAME, mask::NAME]).collect()
}

/// Help for the sequence.
pub fn sequences() -> String {
    names(known())
}

/// Help for `--total`.
pub fn total() -> String {
    let sets = SEQUENCES
        .iter()
        .filter(|s| s.options().contains(&"--total"));
    let sets = names(sets.map(|sequence| sequence.name()));
    format!("Points of the whole set: {sets} [default: first + count]")
}

/// Help for `--scramble`: sequences that have the same ones stand together.
pub fn scrambles() -> String {
    let mut groups: Vec<(&[Scramble], Vec<&str>)> = Vec::new();
    for sequence in SEQUENCES {
        let known = sequence.scrambles();
        // The sequence as it is needs no option.
        if known.len() < 2 {
            continue;
        }
        match groups.iter_mut().find(|(group, _)| *group == known) {
            Some((_, members)) => members.push(sequence.name()),
            None => groups.push((known, vec![sequence.name()])),
        }
    }
    let groups = groups.iter().map(|(known, members)| {
        let known = names(known.iter().map(|scramble| scramble.name()));
        format!("{}: {known}", members.join(", "))
    });
    groups.collect::<Vec<_>>().join(". ")
}

/// Help for `--map`.
pub fn maps() -> String {
    let names = names(all_maps().map(|map| map.name));
    format!("Map each point: {names}. +z is the normal; `corput maps` says more")
}

/// Below the options: everything by name.
pub fn generate() -> String {
    let mut lines = vec![
        "In doubt take sobol --scramble owen, and a number of points that is a power of two."
            .to_owned(),
        String::new(),
        "Sequences, and what each takes besides --count, --first, --dims and --seed:".to_owned(),
    ];
    for sequence in SEQUENCES {
        section(
            &mut lines,
            sequence.name(),
            sequence.guide(),
            &takes(*sequence),
        );
    }
    section(&mut lines, points::NAME, points::GUIDE, "2 dimensions");
    section(
        &mut lines,
        mask::NAME,
        mask::GUIDE,
        "instead of --count and --first: --size; --channels; --frames",
    );
    lines.push("\nScrambles:".to_owned());
    let scrambles = SCRAMBLES.iter();
    lines.extend(scrambles.map(|s| format!("  {:<10} {}", s.name(), s.summary())));
    lines.push("\nMaps:".to_owned());
    lines.extend(
        all_maps().map(|map| format!("  {:<24} {}; pdf {}", map.name, map.summary, map.pdf)),
    );
    lines.push("\nExamples:".to_owned());
    lines.extend(EXAMPLES.map(|example| format!("  corput generate {example}")));
    lines.join("\n")
}

const EXAMPLES: [&str; 5] = [
    "sobol --count 65536 --dims 8 --scramble owen --seed 3 --out points.npy",
    "halton --count 1000 --dims 2 --out points.csv",
    "stratified --count 512 --grid 32x16 --seed 1 --out points.npy",
    "pmj02 --count 4096 --seed 2 --map cosine-hemisphere --with-pdf --out d.npy",
    "hammersley --first 100 --count 100 --total 1000 --fractions --device cpu --out -",
];

fn takes(sequence: Sequence) -> String {
    let dimensions = match sequence.dimensions() {
        (1, 1) => "1 dimension".to_owned(),
        (least, most) if least == most => format!("{least} dimensions"),
        (least, most) => format!("{least} to {most} dimensions"),
    };
    let mut takes = vec![dimensions];
    takes.extend(sequence.options().iter().map(|&option| option.to_owned()));
    if sequence.scrambles().len() > 1 {
        takes.push(format!("--scramble {}", scrambles_of(sequence)));
    }
    takes.join("; ")
}

fn section(lines: &mut Vec<String>, name: &str, guide: Guide, takes: &str) {
    lines.push(format!("  {name:<15} {}", guide.what));
    for what in [
        &format!("for: {}", guide.purpose),
        &format!("points: {}", guide.points),
        takes,
    ] {
        lines.push(format!("  {:<15} {what}", ""));
    }
}
