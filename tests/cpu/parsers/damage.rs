//! Seeds of parsers, and what may happen to them.

use proptest::prelude::*;
use proptest::sample::Index;
use std::path::{Path, PathBuf};

/// The folder of a parser's seeds.
pub fn folder(parser: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("tests/data/seeds")
        .join(parser)
}

/// The seeds of a parser, in the order of their names.
pub fn committed(parser: &str) -> Vec<Vec<u8>> {
    let entries = std::fs::read_dir(folder(parser)).expect("a folder of seeds");
    let mut paths: Vec<PathBuf> = entries.map(|entry| entry.expect("a seed").path()).collect();
    paths.sort();
    paths
        .iter()
        .map(|path| std::fs::read(path).expect("a seed"))
        .collect()
}

/// What may happen to a file.
#[derive(Clone, Debug)]
pub enum Damage {
    Flip(Index, u8),
    Set(Index, u8),
    Cut(Index),
    Drop(Index, usize),
    Repeat(Index, usize),
    Number(Index, u32),
}

pub fn damage() -> impl Strategy<Value = Damage> {
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

pub fn apply(bytes: &mut Vec<u8>, damage: &Damage) {
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
