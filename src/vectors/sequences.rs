//! Points of the sequences: the first of each, and the last of those with 2^32.

use super::{Entry, Table, about};
use crate::Result;
use crate::bulk::Reference;
use crate::catalog::{Options, Request, SEQUENCES, Scramble, Sequence};

/// Points of a table; of a Korobov lattice the fewest that it has a generator for.
const POINTS: u64 = 1024;
const KOROBOV: u64 = 1021;

/// Columns at most.
const DIMENSIONS: u32 = 5;

const SEED: u64 = 0x0123_4567_89ab_cdef;

pub fn each(take: &mut dyn FnMut(&Entry) -> Result<()>) -> Result<()> {
    for (sequence, scramble, first) in all() {
        take(&entry(sequence, scramble, first)?)?;
    }
    Ok(())
}

/// Each sequence by each of its scrambles, with the index of the first point.
pub fn all() -> impl Iterator<Item = (Sequence, Scramble, u64)> {
    let scrambles = |sequence: Sequence| match sequence.scrambles() {
        [] => &[Scramble::None],
        scrambles => scrambles,
    };
    SEQUENCES.iter().flat_map(move |&sequence| {
        scrambles(sequence).iter().flat_map(move |&scramble| {
            let last = endless(sequence).then_some((1 << 32) - POINTS);
            let firsts = [Some(0), last].into_iter().flatten();
            firsts.map(move |first| (sequence, scramble, first))
        })
    })
}

/// Whether its points are the same whatever their number, and 2^32.
fn endless(sequence: Sequence) -> bool {
    matches!(
        sequence,
        Sequence::Random
            | Sequence::RandomFast
            | Sequence::Pcg32
            | Sequence::VanDerCorput
            | Sequence::Halton
            | Sequence::Sobol
            | Sequence::Pmj02
            | Sequence::R2
    )
}

/// The file is what the command makes.
fn entry(sequence: Sequence, scramble: Scramble, first: u64) -> Result<Entry> {
    let count = if sequence == Sequence::Korobov {
        KOROBOV
    } else {
        POINTS
    };
    let dimensions = sequence.dimensions().1.min(DIMENSIONS);
    let random = scramble.is_random() || sequence.scrambles().is_empty();
    let named = (scramble != Scramble::None).then(|| scramble.name());
    let request = Request::new(&Options {
        first,
        dimensions: Some(dimensions.into()),
        seed: random.then_some(SEED),
        scramble: named.map(|_| scramble),
        fractions: true,
        ..Options::new(sequence, count)
    })?;
    let mut words = vec![0; (count * u64::from(request.words_per_point())) as usize];
    Reference::new(&request).fill_singly(0, &mut words);
    let mut command = format!(
        "corput generate {} --count {count} --dims {dimensions} --fractions",
        sequence.name()
    );
    let mut file = format!("sequences/{}", sequence.name());
    if let Some(name) = named {
        command += &format!(" --scramble {name}");
        file += &format!("-{name}");
    }
    if random {
        command += &format!(" --seed {SEED}");
    }
    if first > 0 {
        command += &format!(" --first {first}");
        file += "-last";
    }
    Ok(Entry {
        kind: "sequence",
        name: sequence.name().to_owned(),
        about: about([("command", command.into())]),
        table: Some(Table {
            file: format!("{file}.npy"),
            columns: request.words_per_point(),
            words,
            axes: None,
        }),
        tables: Vec::new(),
    })
}
