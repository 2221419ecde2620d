//! Parsers of outside data against damaged files: the seeds of `tests/data/seeds`, of which a run
//! changes, cuts, repeats and joins pieces. `cargo fuzz` goes on where this ends.

#[path = "parsers/properties.rs"]
mod properties;
#[path = "parsers/seeds.rs"]
mod seeds;

use proptest::prelude::*;
use proptest::sample::Index;
use std::path::{Path, PathBuf};

/// A parser's folder of seeds, and what must hold of it.
type Parser = (&'static str, fn(&[u8]));

const PARSERS: [Parser; 6] = [
    ("exr", properties::exr),
    ("hdr", properties::hdr),
    ("npy", properties::npy),
    ("study", properties::study),
    ("check", properties::check),
    ("scene", properties::scene),
];

fn folder(parser: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("tests/data/seeds")
        .join(parser)
}

/// The seeds of a parser, in the order of their names.
fn committed(parser: &str) -> Vec<Vec<u8>> {
    let entries = std::fs::read_dir(folder(parser)).expect("a folder of seeds");
    let mut paths: Vec<PathBuf> = entries.map(|entry| entry.expect("a seed").path()).collect();
    paths.sort();
    paths
        .iter()
        .map(|path| std::fs::read(path).expect("a seed"))
        .collect()
}

/// Every seed is read, so that what is near it comes far.
#[test]
fn seeds_are_read() {
    if std::env::var_os("CORPUT_WRITE_TABLES").is_some() {
        for (parser, name, bytes) in seeds::seeds() {
            std::fs::write(folder(parser).join(name), bytes).expect("a seed is written");
        }
    }
    let whole = tempfile::tempdir().expect("a folder");
    for (parser, property) in PARSERS {
        let seeds = committed(parser);
        assert!(seeds.len() >= 2, "{parser}");
        for (k, bytes) in seeds.iter().enumerate() {
            property(bytes);
            let path = whole.path().join(format!("{k}.{parser}"));
            std::fs::write(&path, bytes).expect("a copy");
            let read = match parser {
                "exr" | "hdr" => corput::image::load(&path).map(drop),
                "npy" => corput::report::read_points(&path).map(drop),
                "study" => corput::converge::read(&path).map(drop),
                "scene" => properties::read_scene(bytes).map(drop),
                _ => corput::check::compare(&path, &path).map(drop),
            };
            read.unwrap_or_else(|error| panic!("{parser} {k}: {error}"));
        }
    }
}

/// What may happen to a file.
#[derive(Clone, Debug)]
enum Damage {
    Flip(Index, u8),
    Set(Index, u8),
    Cut(Index),
    Drop(Index, usize),
    Repeat(Index, usize),
    Number(Index, u32),
}

fn damage() -> impl Strategy<Value = Damage> {
    let at = || any::<Index>();
    let end = prop_oneof![
        Just(0),
        Just(1),
        Just(u32::MAX),
        Just(0x7fff_ffff),
        Just(0x8000_0000)
    ];
    prop_oneof![
        (at(), 0..8u8).prop_map(|(at, bit)| Damage::Flip(at, bit)),
        (at(), any::<u8>()).prop_map(|(at, byte)| Damage::Set(at, byte)),
        at().prop_map(Damage::Cut),
        (at(), 1..9usize).prop_map(|(at, n)| Damage::Drop(at, n)),
        (at(), 1..64usize).prop_map(|(at, n)| Damage::Repeat(at, n)),
        (at(), end).prop_map(|(at, word)| Damage::Number(at, word)),
    ]
}

fn apply(bytes: &mut Vec<u8>, damage: &Damage) {
    if bytes.is_empty() {
        return;
    }
    let length = bytes.len();
    match *damage {
        Damage::Flip(at, bit) => bytes[at.index(length)] ^= 1 << bit,
        Damage::Set(at, byte) => bytes[at.index(length)] = byte,
        Damage::Cut(at) => bytes.truncate(at.index(length)),
        Damage::Drop(at, n) => {
            let first = at.index(length);
            bytes.drain(first..(first + n).min(length));
        }
        Damage::Repeat(at, n) => {
            let first = at.index(length);
            let piece = bytes[first..(first + n).min(length)].to_vec();
            bytes.splice(first..first, piece);
        }
        Damage::Number(at, word) => {
            let first = at.index(length);
            for (to, from) in bytes[first..].iter_mut().zip(word.to_le_bytes()) {
                *to = from;
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 1500, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn damaged_files_are_read_or_refused(
        parser in 0..PARSERS.len(),
        seed in any::<Index>(),
        // Half of the damage goes to the beginning, where headers are.
        damages in proptest::collection::vec((damage(), any::<bool>()), 1..6),
    ) {
        let (name, property) = PARSERS[parser];
        let seeds = committed(name);
        let mut bytes = seeds[seed.index(seeds.len())].clone();
        for (damage, early) in &damages {
            let mut tail = if *early { bytes.split_off(bytes.len().min(200)) } else { Vec::new() };
            apply(&mut bytes, damage);
            bytes.append(&mut tail);
        }
        property(&bytes);
    }

    #[test]
    fn bytes_alone_are_read_or_refused(bytes in proptest::collection::vec(any::<u8>(), 0..300)) {
        for (_, property) in PARSERS {
            property(&bytes);
        }
    }
}
