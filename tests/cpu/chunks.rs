//! Points chunk by chunk are those that are made at once, in any chunks of any range.

use corput::bulk::{Reference, Stored};
use corput::catalog::{
    Chunks, Engine, Map, Mapping, Options, Output, Profile, Request, Scramble, Sequence,
};
use corput::{Error, Result};
use proptest::prelude::*;

fn request(sequence: Sequence, count: u64, dimensions: u64) -> Request {
    let mut options = Options::new(sequence, count);
    options.dimensions = Some(dimensions);
    options.first = 77;
    Request::new(&options).unwrap()
}

fn all(request: &Request) -> Vec<u32> {
    let mut words = vec![0; request.count as usize * request.words_per_point() as usize];
    Reference::new(request).fill(0, &mut words).unwrap();
    words
}

fn mapped() -> Request {
    let mut options = Options::new(Sequence::Sobol, 3000);
    options.dimensions = Some(2);
    options.scramble = Some(Scramble::Owen);
    options.map = Some(Mapping::new(Map::from_name("uniform-sphere").unwrap(), &[]).unwrap());
    options.with_pdf = true;
    Request::new(&options).unwrap()
}

proptest! {
    #[test]
    fn chunks_of_any_length_and_range_are_the_points(
        which in 0usize..3, a in 0u64..=3000, b in 0u64..=3000, rows in 1u64..5000,
    ) {
        let requests = [request(Sequence::Halton, 3000, 3), request(Sequence::R2, 3000, 2), mapped()];
        let request = &requests[which];
        let width = request.words_per_point() as usize;
        let (start, end) = (a.min(b), a.max(b));
        let wanted = &all(request)[start as usize * width..end as usize * width];
        let mut engine = Reference::new(request);
        let mut lent = Vec::new();
        let mut chunks = Chunks::new(&mut engine, start..end, rows).unwrap();
        let mut left = chunks.len();
        prop_assert_eq!(left as u64, (end - start).div_ceil(rows));
        while let Some(words) = chunks.next_words() {
            let words = words.unwrap();
            prop_assert!(words.len() == rows as usize * width || left == 1);
            lent.extend_from_slice(words);
            left -= 1;
            prop_assert_eq!(chunks.size_hint(), (left, Some(left)));
        }
        prop_assert!(chunks.next_words().is_none() && chunks.next().is_none());
        prop_assert_eq!(&lent, wanted);
        let owned = Chunks::new(&mut engine, start..end, rows).unwrap();
        let owned: Vec<Vec<u32>> = owned.collect::<Result<_>>().unwrap();
        prop_assert_eq!(owned.concat(), wanted);
    }
}

#[test]
fn lent_chunks_lie_in_the_same_memory() {
    let request = request(Sequence::Halton, 1000, 2);
    let mut engine = Reference::new(&request);
    let mut chunks = Chunks::new(&mut engine, 0..1000, 64).unwrap();
    let mut places = Vec::new();
    while let Some(words) = chunks.next_words() {
        places.push(words.unwrap().as_ptr());
    }
    places.dedup();
    assert_eq!(places.len(), 1);
}

/// What points that are there serve, by the same trait and behind a pointer.
#[test]
fn every_engine_has_chunks() {
    let points = vec![[1, 2], [3, 4], [5, 6]];
    let stored = Stored {
        points,
        output: Output::Fractions,
        map: None,
        with_pdf: false,
        profile: Profile::Exact,
    };
    let mut boxed: Box<dyn Engine> = Box::new(stored);
    let chunks = Chunks::new(boxed.as_mut(), 1..3, 1).unwrap();
    let words: Vec<_> = chunks.map(|words| words.unwrap()).collect();
    assert_eq!(words, [[3, 4], [5, 6]]);
    let mut words = [0; 6];
    boxed.fill(0, &mut words).unwrap();
    assert_eq!(words, [1, 2, 3, 4, 5, 6]);
}

#[test]
fn what_cannot_be_made_is_refused() {
    let request = request(Sequence::Halton, 100, 3);
    let mut engine = Reference::new(&request);
    let zero = Chunks::new(&mut engine, 0..10, 0).unwrap_err();
    assert!(matches!(zero, Error::ZeroCount { .. }), "{zero}");
    for range in [0..101, 100..101, 101..101, 0..u64::MAX, u64::MAX..u64::MAX] {
        let error = Chunks::new(&mut engine, range.clone(), 7).unwrap_err();
        assert!(
            matches!(error, Error::Arguments { .. }),
            "{range:?}: {error}"
        );
        assert!(error.to_string().contains("the request has 100"), "{error}");
    }
    #[expect(clippy::reversed_empty_ranges, reason = "a range of none")]
    for range in [0..0, 100..100, 9..3] {
        assert_eq!(Chunks::new(&mut engine, range, 7).unwrap().count(), 0);
    }
    // By the trait, whose lengths are checked.
    let engine: &mut dyn Engine = &mut engine;
    for (start, words) in [(0, 4), (0, 303), (99, 6), (u64::MAX, 3), (101, 0)] {
        let error = engine.fill(start, &mut vec![9; words]).unwrap_err();
        assert!(matches!(error, Error::Arguments { .. }), "{error}");
    }
    engine.fill(100, &mut []).unwrap();
    let mut words = [9; 300];
    engine.fill(0, &mut words).unwrap();
    assert_eq!(words[..], all(&request));
}

/// Fails at one of its points.
#[derive(Debug)]
struct Faulty(u64);

impl Engine for Faulty {
    fn count(&self) -> u64 {
        u64::MAX
    }

    fn words_per_point(&self) -> u32 {
        2
    }

    fn make(
        &mut self,
        start: u64,
        count: u64,
        take: &mut dyn FnMut(&[u32]) -> Result<()>,
    ) -> Result<()> {
        if (start..start + count).contains(&self.0) {
            return Err(Error::ZeroCount { what: "patience" });
        }
        // In pieces of a point.
        (start..start + count).try_for_each(|n| take(&[n as u32, !n as u32]))
    }

    fn chunk(&self) -> u64 {
        1
    }
}

#[test]
fn an_error_ends_the_chunks() {
    let mut engine = Faulty(25);
    let mut chunks = Chunks::new(&mut engine, 0..100, 10).unwrap();
    assert_eq!(chunks.next_words().unwrap().unwrap()[18..], [9, !9]);
    assert_eq!(chunks.next().unwrap().unwrap()[..2], [10, !10]);
    assert_eq!(chunks.len(), 8);
    let error = chunks.next().unwrap().unwrap_err();
    assert!(matches!(error, Error::ZeroCount { what: "patience" }));
    assert_eq!(chunks.size_hint(), (0, Some(0)));
    for _ in 0..3 {
        assert!(chunks.next().is_none() && chunks.next_words().is_none());
    }
    // What no memory holds is an error too.
    let mut chunks = Chunks::new(&mut engine, 0..u64::MAX, u64::MAX).unwrap();
    let error = chunks.next_words().unwrap().unwrap_err();
    assert!(error.to_string().contains("memory has no room"), "{error}");
    assert!(chunks.next_words().is_none());
}
