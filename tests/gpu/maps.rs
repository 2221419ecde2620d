//! Samples of every map on every device, word for word, over long runs of points.

mod support;

use corput::bulk::Reference;
use corput::catalog::{Engine, Mapping, Options, Request, Scramble, Sequence, maps};
use corput::check::examples;
use corput::kernels::Generator;

fn request(mapping: &Mapping, count: u64) -> Request {
    let mut options = Options::new(Sequence::Sobol, count);
    options.dimensions = Some(mapping.map().dimensions.into());
    options.scramble = Some(Scramble::Owen);
    options.seed = Some(17);
    options.map = Some(mapping.clone());
    options.with_pdf = true;
    Request::new(&options).unwrap_or_else(|error| panic!("{error}"))
}

/// The words that differ, of all the words of a request.
fn mismatches(engine: &mut Generator, request: &Request) -> (u64, u64) {
    let mut reference = Reference::new(request);
    let width = u64::from(request.words_per_point());
    let (mut done, mut differ) = (0, 0);
    engine
        .make(0, request.count, &mut |words| {
            let mut expected = vec![0; words.len()];
            reference.fill(done, &mut expected)?;
            differ += words.iter().zip(&expected).filter(|(a, b)| a != b).count() as u64;
            done += words.len() as u64 / width;
            Ok(())
        })
        .unwrap_or_else(|error| panic!("{error}"));
    (differ, done * width)
}

fn equal_the_reference(count: u64) {
    support::on_each_device(|device| {
        // The examples of a map share a pipeline.
        device.keep_pipelines();
        let all: Vec<_> = maps().map(examples).collect();
        support::at_once(&all, |mappings| {
            let mappings = mappings.as_ref().unwrap_or_else(|error| panic!("{error}"));
            for mapping in mappings {
                let request = request(mapping, count);
                let mut engine =
                    Generator::new(device, &request).unwrap_or_else(|error| panic!("{error}"));
                let (differ, words) = mismatches(&mut engine, &request);
                let label = format!("{} {:?}", mapping.map().name, mapping.values());
                println!("{label}: {differ} of {words} words differ");
                assert_eq!(differ, 0, "{label}");
                assert_eq!(words, count * u64::from(request.words_per_point()));
            }
        });
    });
}

#[test]
fn sixteen_thousand_samples_of_each_map_equal_the_reference() {
    equal_the_reference(1 << 14);
}

#[test]
#[ignore = "some minutes on each device"]
fn four_million_samples_of_each_map_equal_the_reference() {
    equal_the_reference(1 << 22);
}

/// The comparison itself: samples of other parameters, or of another map, are seen.
#[test]
fn other_samples_are_seen() {
    support::on_one_device(|device| {
        let all: Vec<Mapping> = maps()
            .filter(|map| (map.dimensions, map.coordinates) == (2, 3))
            .flat_map(|map| examples(map).unwrap_or_else(|error| panic!("{error}")))
            .collect();
        device.keep_pipelines();
        let pairs: Vec<_> = all.windows(2).collect();
        support::at_once(&pairs, |pair| {
            let made = request(&pair[0], 1 << 10);
            let mut engine =
                Generator::new(device, &made).unwrap_or_else(|error| panic!("{error}"));
            let (differ, _) = mismatches(&mut engine, &request(&pair[1], 1 << 10));
            assert!(differ > 0, "{:?} and {:?}", pair[0], pair[1]);
        });
    });
}
