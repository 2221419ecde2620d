//! Points in bulk by the library: chunks, slices, buffers and submissions on every device, each
//! word compared with the CPU's.

mod support;

#[path = "library/buffers.rs"]
mod buffers;
#[path = "library/flight.rs"]
mod flight;

#[cfg(target_os = "linux")]
#[path = "library/windows.rs"]
mod windows;

use corput::Error;
use corput::bulk::Reference;
use corput::catalog::{Chunks, Engine, Map, Mapping, Options, Request, Scramble, Sequence};
use corput::kernels::Generator;
use support::on_each_device;

/// A map, and its parameters.
type Mapped<'a> = (&'a str, &'a [(&'a str, &'a [f64])], bool);

fn request(sequence: Sequence, count: u64, dimensions: u64, map: Option<Mapped>) -> Request {
    let mut options = Options::new(sequence, count);
    options.first = 1001;
    options.dimensions = Some(dimensions);
    options.fractions = map.is_none();
    if sequence == Sequence::Sobol {
        options.scramble = Some(Scramble::OwenHash);
    }
    if let Some((name, parameters, with_pdf)) = map {
        options.map = Some(Mapping::new(Map::from_name(name).unwrap(), parameters).unwrap());
        options.with_pdf = with_pdf;
    }
    Request::new(&options).unwrap()
}

/// One of each way in which points become words: four words an invocation, tiles of several
/// lengths and widths, tiles of parts of a row, a map within, a map of its own, and tiles of parts
/// that share columns.
fn requests() -> Vec<Request> {
    let cone: Mapped = ("cone", &[("theta_max", &[0.5])], true);
    vec![
        request(Sequence::Halton, 5000, 5, None),
        request(Sequence::Halton, 70_001, 1, None),
        request(Sequence::Halton, 70_001, 3, None),
        request(Sequence::Sobol, 70_001, 2, None),
        request(Sequence::Halton, 700_001, 8, None),
        request(
            Sequence::Halton,
            5003,
            2,
            Some(("cosine-hemisphere", &[], true)),
        ),
        request(Sequence::Sobol, 5003, 2, Some(cone)),
        request(
            Sequence::Halton,
            5003,
            1,
            Some(("exponential", &[("sigma", &[2.0])], false)),
        ),
        request(Sequence::Halton, 700_001, 7, None),
    ]
}

/// The words of some points, by the CPU.
fn reference(request: &Request, start: u64, count: u64) -> Vec<u32> {
    let mut words = vec![0; (count * u64::from(request.words_per_point())) as usize];
    Reference::new(request).fill(start, &mut words).unwrap();
    words
}

#[test]
fn the_requests_take_every_kind_of_kernel() {
    on_each_device(|device| {
        let names: Vec<_> = requests()
            .iter()
            .map(|request| Generator::new(device, request).unwrap().kernel_name())
            .collect();
        for (name, part) in names.iter().zip([
            "generate",
            "generate_tile_1",
            "generate_tile_3",
            "generate_tile_2",
            "generate_tile_4",
            "fused",
            "generate",
            "generate",
            "generate_tile_4",
        ]) {
            assert!(name.starts_with(part), "{names:?}");
        }
    });
}

#[test]
fn chunks_of_a_device_are_those_of_the_cpu() {
    on_each_device(|device| {
        for request in requests() {
            let mut generator = Generator::new(device, &request).unwrap();
            let count = request.count;
            for (range, rows) in [
                (0..count.min(600), 241),
                (3..count, count / 3 + 1),
                (count - 5..count, 2),
                (0..count, u64::MAX),
            ] {
                let wanted = reference(&request, range.start, range.end - range.start);
                let mut made = Vec::new();
                let mut chunks = Chunks::new(&mut generator, range.clone(), rows).unwrap();
                while let Some(words) = chunks.next_words() {
                    made.extend_from_slice(words.unwrap());
                }
                assert!(made == wanted, "{:?} {range:?} by {rows}", request.sequence);
                let owned = Chunks::new(&mut generator, range, rows).unwrap();
                let owned: Vec<u32> = owned.flat_map(|words| words.unwrap()).collect();
                assert!(owned == wanted, "{:?}", request.sequence);
            }
        }
    });
}

#[test]
fn a_device_fills_slices() {
    on_each_device(|device| {
        for request in requests() {
            let width = request.words_per_point() as usize;
            let mut generator = Generator::new(device, &request).unwrap();
            assert_eq!(generator.count(), request.count);
            // The words beside the slice stay as they are.
            let mut words = vec![9; 777 * width + 2];
            generator.fill(11, &mut words[1..=777 * width]).unwrap();
            assert_eq!((words[0], words.last()), (9, Some(&9)));
            assert!(words[1..=777 * width] == reference(&request, 11, 777));
            generator.fill(request.count, &mut []).unwrap();
            let many = (request.count as usize + 1) * width;
            for (start, length) in [(0, many), (request.count, width), (u64::MAX, width)] {
                let error = generator.fill(start, &mut vec![0; length]).unwrap_err();
                assert!(matches!(error, Error::Arguments { .. }), "{error}");
            }
            if width > 1 {
                let error = generator.fill(0, &mut vec![0; width + 1]).unwrap_err();
                assert!(error.to_string().contains("points are whole"), "{error}");
            }
        }
    });
}
