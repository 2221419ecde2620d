//! Parsers of outside data against damaged files: the seeds of `tests/data/seeds`, of which a run
//! changes, cuts, repeats and joins pieces. `cargo fuzz` goes on where this ends.

#[path = "parsers/damage.rs"]
mod damage;
#[path = "parsers/properties.rs"]
mod properties;
#[path = "parsers/seeds.rs"]
mod seeds;

use damage::{apply, committed, damage, folder};
use proptest::prelude::*;
use proptest::sample::Index;

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
