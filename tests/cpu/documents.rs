//! JSON documents of outside against damage: the seeds of `tests/data/seeds`, of which a run
//! changes, cuts, repeats and joins pieces. `cargo fuzz` goes on where this ends.

#[path = "parsers/damage.rs"]
mod damage;
#[path = "documents/properties.rs"]
mod properties;
#[path = "documents/seeds.rs"]
mod seeds;

use damage::{apply, committed, damage, folder};
use proptest::prelude::*;
use proptest::sample::Index;

/// A reader's folder of seeds, and what must hold of it.
type Reader = (&'static str, fn(&[u8]));

const READERS: [Reader; 5] = [
    ("file", properties::file),
    ("journal", properties::journal),
    ("zarr", properties::zarr),
    ("estimates", properties::estimates),
    ("baseline", properties::baseline),
];

/// Every seed is read, so that what is near it comes far.
#[test]
fn seeds_are_read() {
    if std::env::var_os("CORPUT_WRITE_TABLES").is_some() {
        for (reader, name, bytes) in seeds::seeds() {
            std::fs::create_dir_all(folder(reader)).expect("a folder of seeds");
            std::fs::write(folder(reader).join(name), bytes).expect("a seed is written");
        }
    }
    for (reader, property) in READERS {
        let seeds = committed(reader);
        assert!(seeds.len() >= 2, "{reader}");
        for (k, bytes) in seeds.iter().enumerate() {
            property(bytes);
            let read = match reader {
                "file" => properties::read_file(bytes),
                "journal" => properties::journal_rows(bytes, true).map(|rows| assert!(rows >= 8)),
                "zarr" => properties::read_store(bytes),
                "estimates" => properties::read_estimates(bytes).map(drop),
                _ => properties::read_baseline(bytes).map(drop),
            };
            read.unwrap_or_else(|error| panic!("{reader} {k}: {error}"));
        }
    }
}

/// The most memory that this process has had, where the system says so: no number of a document
/// decides it.
fn assert_little_memory() {
    const LIMIT: u64 = 256 << 10;
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
    let most = line.and_then(|line| line.trim().strip_suffix(" kB")?.trim().parse().ok());
    assert!(most.is_none_or(|most: u64| most < LIMIT), "{most:?} KiB");
}

/// Numbers that do harm, in the place of one that a seed has.
fn number() -> impl Strategy<Value = &'static str> {
    prop_oneof![
        Just("0"),
        Just("1"),
        Just("-1"),
        Just("4294967295"),
        Just("4294967296"),
        Just("9223372036854775808"),
        Just("18446744073709551615"),
        Just("18446744073709551616"),
        Just("1e308"),
        Just("null"),
        Just("[]"),
    ]
}

/// The text with one of its runs of digits replaced.
fn with_number(bytes: &[u8], at: Index, number: &str) -> Vec<u8> {
    let digit = |at: usize| bytes[at].is_ascii_digit();
    let starts: Vec<usize> = (0..bytes.len())
        .filter(|at| digit(*at) && (*at == 0 || !digit(at - 1)))
        .collect();
    if starts.is_empty() {
        return bytes.to_vec();
    }
    let start = starts[at.index(starts.len())];
    let end = (start..bytes.len()).find(|at| !digit(*at));
    let rest = &bytes[end.unwrap_or(bytes.len())..];
    [&bytes[..start], number.as_bytes(), rest].concat()
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 1000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn damaged_documents_are_read_or_refused(
        reader in 0..READERS.len(),
        seed in any::<Index>(),
        damages in proptest::collection::vec(damage(), 1..4),
    ) {
        let (name, property) = READERS[reader];
        let seeds = committed(name);
        let mut bytes = seeds[seed.index(seeds.len())].clone();
        for damage in &damages {
            apply(&mut bytes, damage);
        }
        property(&bytes);
        assert_little_memory();
    }

    #[test]
    fn documents_of_other_numbers_are_read_or_refused(
        reader in 0..READERS.len(),
        seed in any::<Index>(),
        numbers in proptest::collection::vec((any::<Index>(), number()), 1..4),
    ) {
        let (name, property) = READERS[reader];
        let seeds = committed(name);
        let mut bytes = seeds[seed.index(seeds.len())].clone();
        for (at, number) in numbers {
            bytes = with_number(&bytes, at, number);
        }
        property(&bytes);
        assert_little_memory();
    }

    #[test]
    fn bytes_alone_are_read_or_refused(bytes in proptest::collection::vec(any::<u8>(), 0..300)) {
        for (_, property) in READERS {
            property(&bytes);
        }
    }
}
