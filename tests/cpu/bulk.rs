//! Points by blocks against the same points one by one.

use corput::bulk::Reference;
use corput::catalog::{
    Engine, Map, Mapping, Options, Order, Request, SCRAMBLES, SEQUENCES, Scramble, Sequence,
};
use proptest::prelude::*;
use std::num::NonZero;

/// The first word in which the points of a window differ from those made singly.
fn fault(request: &Request, start: u64, count: u64, threads: usize) -> Option<String> {
    let width = request.words_per_point() as usize;
    let mut reference = Reference::with_threads(request, NonZero::new(threads).unwrap());
    let words = || vec![0x5555_5555; count as usize * width];
    let (mut made, mut wanted) = (words(), words());
    reference.fill(start, &mut made).unwrap();
    reference.fill_singly(start, &mut wanted);
    let at = made.iter().zip(&wanted).position(|(a, b)| a != b)?;
    Some(format!(
        "{:?} {:?} of {width} words from {} on by {threads} threads: point {start} + {}, word {}: {:#x}, not {:#x}",
        request.sequence,
        request.scramble,
        request.first,
        at / width,
        at % width,
        made[at],
        wanted[at],
    ))
}

/// Windows of a request: its beginning, odd places, and its end.
fn windows(request: &Request, points: u64) -> Vec<(u64, u64)> {
    let points = points.min(request.count);
    let last = request.count - points;
    let places = [0, 1, 1023, 4097, (request.count / 3) | 1, last];
    let mut windows: Vec<_> = places
        .into_iter()
        .map(|start| (start.min(last), points))
        .collect();
    windows.push((request.count - 1, 1));
    windows
}

/// Options as a sequence takes them: with a seed, or without where it has no use for one.
fn accepted(options: &Options, seed: u64) -> Option<Request> {
    let with = |seed| {
        Request::new(&Options {
            seed,
            ..options.clone()
        })
    };
    with(Some(seed)).or_else(|_| with(None)).ok()
}

/// Every request that a sequence takes of these settings.
fn requests(sequence: Sequence, dimensions: u64, fractions: bool) -> Vec<Request> {
    let mut found = Vec::new();
    let scrambles = SCRAMBLES.iter().copied().map(Some).chain([None]);
    for scramble in scrambles {
        for order in [Order::Natural, Order::Gray] {
            for (first, count) in [
                (0, 1 << 32),
                (0xffff_0001, 0xffff),
                (777, (1 << 31) + 1),
                (0, 1_000_003),
                (0, 1 << 20),
                (0, 65_537),
                (0, 4096),
            ] {
                let options = Options {
                    first,
                    dimensions: Some(dimensions),
                    scramble,
                    order,
                    fractions,
                    // Published generators serve few numbers of points.
                    generator: (sequence == Sequence::Korobov).then_some(5),
                    ..Options::new(sequence, count)
                };
                found.extend(accepted(&options, 7));
            }
        }
    }
    found
}

#[test]
fn every_sequence_with_every_scramble_has_the_words_of_single_values() {
    for &sequence in SEQUENCES {
        let mut tried = 0;
        for (dimensions, points) in [(1, 2311), (2, 2311), (3, 1500), (8, 700), (32, 200)] {
            for fractions in [false, true] {
                for request in requests(sequence, dimensions, fractions) {
                    for (i, (start, count)) in windows(&request, points).into_iter().enumerate() {
                        let threads = [1, 2, 3, 7][i % 4];
                        assert_eq!(fault(&request, start, count, threads), None);
                        tried += 1;
                    }
                }
            }
        }
        assert!(tried >= 7, "{sequence:?}: {tried} windows");
    }
}

#[test]
fn bases_of_every_size_have_the_words_of_single_values() {
    let scrambles = [
        Scramble::None,
        Scramble::Faure,
        Scramble::Permute,
        Scramble::Start,
    ];
    // The last that two, one and no digits of have a table, and the largest.
    for base in [
        2, 3, 17, 29, 61, 67, 73, 251, 257, 1621, 1627, 4093, 4099, 8161,
    ] {
        for scramble in scrambles {
            for (first, count) in [(0, 1 << 32), (0, 3 * base)] {
                let options = Options {
                    first,
                    bases: Some(vec![base]),
                    scramble: Some(scramble),
                    fractions: true,
                    ..Options::new(Sequence::Halton, count)
                };
                let request = accepted(&options, base).unwrap();
                // Two of them are those where Faure's ceiling would be 2^32.
                let places = [4_163_760_000, 4_146_140_000].map(|place| (place, 9001));
                let places = places.into_iter().filter(|_| count == 1 << 32);
                for (start, count) in windows(&request, 9001).into_iter().chain(places) {
                    assert_eq!(fault(&request, start, count, 2), None);
                }
            }
        }
    }
}

#[test]
fn rows_of_many_columns_are_whole() {
    for (sequence, dimensions) in [
        (Sequence::Sobol, 65),
        (Sequence::Sobol, 200),
        (Sequence::Halton, 130),
        (Sequence::Random, 67),
        (Sequence::Sobol, 5000),
    ] {
        let request = Request::new(&Options {
            first: 99,
            dimensions: Some(dimensions),
            ..Options::new(sequence, 1 << 20)
        })
        .unwrap();
        for (start, count) in [(0, 150), (12_345, 77)] {
            assert_eq!(fault(&request, start, count, 3), None);
        }
    }
}

#[test]
fn maps_take_the_fractions_of_blocks() {
    for name in ["cosine-hemisphere", "cone", "normal-pair"] {
        for (sequence, with_pdf) in [(Sequence::Halton, true), (Sequence::Sobol, false)] {
            let map = Map::from_name(name).unwrap();
            let values: &[f64] = if name == "cone" { &[0.1] } else { &[] };
            let mapping = match values {
                [] => Mapping::new(map, &[]),
                values => Mapping::with_values(map, values),
            };
            let request = Request::new(&Options {
                dimensions: Some(2),
                map: Some(mapping.unwrap()),
                with_pdf,
                ..Options::new(sequence, 1 << 24)
            })
            .unwrap();
            for (start, count) in windows(&request, 3001) {
                assert_eq!(fault(&request, start, count, 2), None);
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(256))]

    #[test]
    fn any_window_of_any_request_has_the_words_of_single_values(
        which in 0..SEQUENCES.len(),
        scramble in 0..=SCRAMBLES.len(),
        gray: bool,
        dimensions in 1u64..20,
        first in prop_oneof![0u64..10_000, (1u64 << 32) - 10_000..(1 << 32) - 5000],
        count in 1u64..5000,
        seed: u64,
        fractions: bool,
        threads in 1usize..9,
        (start, length) in (0u64..5000, 1u64..1500),
    ) {
        let options = Options {
            first,
            dimensions: Some(dimensions),
            scramble: SCRAMBLES.get(scramble).copied(),
            order: if gray { Order::Gray } else { Order::Natural },
            fractions,
            generator: (SEQUENCES[which] == Sequence::Korobov).then_some(5),
            ..Options::new(SEQUENCES[which], count)
        };
        let Some(request) = accepted(&options, seed) else { return Ok(()) };
        let start = start % request.count;
        let length = length.min(request.count - start);
        prop_assert_eq!(fault(&request, start, length, threads), None);
    }
}
