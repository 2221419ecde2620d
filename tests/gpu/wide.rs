//! Kernels that store eight words at a time, which large requests get where the device has integers of 64 bits:
//! the words of the reference, from any point on, and nothing beside them.

mod support;

use corput::bulk::Reference;
use corput::catalog::{Engine, Map, Mapping, Options, Request, Scramble, Sequence};
use corput::kernels::Generator;
use corput::vulkan::{Access, Buffer, Device, DeviceKind};
use std::sync::Arc;

/// Enough words for each of these kernels.
const WORDS: u64 = 1 << 25;

/// Sequences, their scrambles and dimensions.
const CASES: &[(Sequence, Option<Scramble>, &[u64])] = &[
    (Sequence::VanDerCorput, None, &[1]),
    (Sequence::Hammersley, None, &[2]),
    (Sequence::Sobol, None, &[1, 2, 3, 4, 8, 16, 32]),
    (Sequence::Sobol, Some(Scramble::Shift), &[1, 4]),
    (Sequence::Sobol, Some(Scramble::Matrix), &[2, 8]),
    (Sequence::Sobol, Some(Scramble::OwenHash), &[2, 3, 16]),
    (Sequence::Random, None, &[1, 2, 3, 4]),
    (Sequence::RandomFast, None, &[1, 2, 3, 4]),
    (Sequence::R2, None, &[1, 2, 3, 4]),
];

fn options(sequence: Sequence, scramble: Option<Scramble>, dimensions: u64) -> Options {
    let mut options = Options::new(sequence, WORDS / dimensions);
    options.dimensions = (sequence != Sequence::VanDerCorput).then_some(dimensions);
    options.scramble = scramble;
    options
}

fn expected(request: &Request, start: u64, points: u64) -> Vec<u32> {
    let mut words = vec![0; (points * u64::from(request.words_per_point())) as usize];
    let mut reference = Reference::new(request);
    reference.fill(start, &mut words).expect("points");
    words
}

/// Compares pieces from several points on, aligned and not, and the last.
fn compare(device: &Arc<Device>, options: &Options) {
    let request = Request::new(options).unwrap_or_else(|error| panic!("{error}"));
    let mut generator = Generator::new(device, &request).expect("a generator");
    let wide = generator.kernel_name().starts_with("generate_wide");
    let suits = device.info().kind == DeviceKind::Cpu && device.has_int64();
    let steps = !matches!(
        options.sequence,
        Sequence::Random | Sequence::RandomFast | Sequence::R2
    );
    let aligned = !steps || request.first.is_multiple_of(32);
    assert_eq!(
        wide,
        suits && aligned,
        "{options:?}: {}",
        generator.kernel_name()
    );
    let last = request.count - 1000;
    for (start, points) in [(0, 4096), (64, 1), (5, 1001), (1 << 19, 777), (last, 1000)] {
        generator.dispatch(start, points).expect("points");
        let same = generator.read(points, |words| words == expected(&request, start, points));
        assert!(same.expect("words"), "{options:?} from {start} on");
    }
}

#[test]
fn they_make_the_reference_s_words() {
    support::on_each_device(|device| {
        for &(sequence, scramble, widths) in CASES {
            for &dimensions in widths {
                compare(device, &options(sequence, scramble, dimensions));
            }
        }
    });
}

#[test]
fn fractions_gray_order_and_other_ends_of_the_indices_too() {
    support::on_each_device(|device| {
        let sobol = options(Sequence::Sobol, None, 2);
        let mut fractions = sobol.clone();
        fractions.fractions = true;
        compare(device, &fractions);
        let mut gray = sobol.clone();
        gray.order = corput::catalog::Order::Gray;
        compare(device, &gray);
        for first in [32, 1 << 31, (1 << 32) - (WORDS / 2), 7] {
            let mut far = sobol.clone();
            far.first = first;
            if first == 7 {
                far.count -= 7;
            }
            compare(device, &far);
        }
        let mut uneven = options(Sequence::Hammersley, None, 2);
        uneven.count += 12_345;
        compare(device, &uneven);
    });
}

/// Points that take many instructions come in tiles, which store as much at a time.
#[test]
fn tiles_store_eight_words_at_a_time() {
    let halton = Sequence::Halton;
    let cases: [(Sequence, Option<Scramble>, u64, &[u64]); 7] = [
        (halton, None, 0, &[1, 2, 3, 4]),
        (halton, Some(Scramble::Permute), 0, &[1, 2, 3]),
        (halton, Some(Scramble::Owen), 0, &[2]),
        (halton, Some(Scramble::Faure), 0, &[3]),
        (Sequence::Hammersley, None, 0, &[3, 4]),
        // Where kernels without a loop cannot begin.
        (Sequence::Hammersley, None, 7, &[2]),
        (Sequence::VanDerCorput, None, 7, &[1]),
    ];
    support::on_each_device(|device| {
        let suits = device.info().kind == DeviceKind::Cpu && device.has_int64();
        let name = if suits {
            "generate_eight"
        } else {
            "generate_tile"
        };
        for (sequence, scramble, first, widths) in cases {
            for &dimensions in widths {
                let mut options = options(sequence, scramble, dimensions);
                if sequence == halton && dimensions == 1 {
                    // Of base 2 alone there are shorter kernels.
                    options.bases = Some(vec![3]);
                }
                if first > 0 {
                    options.total = (sequence == Sequence::Hammersley).then_some(options.count);
                    options.first = first;
                    options.count -= first;
                }
                let request = Request::new(&options).unwrap_or_else(|error| panic!("{error}"));
                let mut generator = Generator::new(device, &request).expect("a generator");
                let found = generator.kernel_name();
                assert!(found.starts_with(name), "{options:?}: {found}");
                let last = request.count - 1000;
                for (start, points) in [(0, 4096), (5, 1001), (1 << 15, 777), (last, 1000)] {
                    generator.dispatch(start, points).expect("points");
                    let wanted = expected(&request, start, points);
                    let same = generator.read(points, |words| words == wanted);
                    assert!(same.expect("words"), "{options:?} from {start} on");
                }
            }
        }
    });
}

/// Permuted digits come from tables.
#[test]
fn permuted_points_are_the_reference_s() {
    support::on_each_device(|device| {
        for (dimensions, count) in [
            (1, 70_000),
            (2, 70_000),
            (3, 70_000),
            (4, 70_000),
            (32, 1 << 19),
        ] {
            let mut options = Options::new(Sequence::Halton, count);
            options.dimensions = Some(dimensions);
            options.scramble = Some(Scramble::Permute);
            for first in [0, 12_345, (1 << 32) - count] {
                options.first = first;
                let request = Request::new(&options).expect("a request");
                let mut generator = Generator::new(device, &request).expect("a generator");
                assert!(generator.kernel_name().starts_with("generate_tile"));
                // Of 70,000 points what two divisions leave adds up to the power itself for some.
                let most = count.min(70_000);
                for (start, points) in [(0, most), (777, 1), (count - 999, 999)] {
                    generator.dispatch(start, points).expect("points");
                    let wanted = expected(&request, start, points);
                    let same = generator.read(points, |words| words == wanted);
                    assert!(same.expect("words"), "{options:?} from {start} on");
                }
            }
        }
    });
}

/// Random numbers and recurrences begin at any index, and end at the last.
#[test]
fn kernels_without_an_alignment_begin_anywhere() {
    support::on_each_device(|device| {
        for sequence in [Sequence::Random, Sequence::R2] {
            let mut options = options(sequence, None, 3);
            for first in [7, (1 << 32) - options.count] {
                options.first = first;
                compare(device, &options);
            }
        }
    });
}

/// A map that has a kernel of its own takes the points from them.
#[test]
fn maps_take_their_points() {
    support::on_each_device(|device| {
        let mut options = Options::new(Sequence::Sobol, WORDS / 2);
        let sphere = Map::from_name("uniform-sphere").expect("a map");
        options.dimensions = Some(sphere.dimensions.into());
        options.map = Some(Mapping::new(sphere, &[]).expect("its parameters"));
        let request = Request::new(&options).expect("a request");
        let mut generator = Generator::new(device, &request).expect("a generator");
        for (start, points) in [(0, 4096), (64, 1000), (5, 1001)] {
            generator.dispatch(start, points).expect("samples");
            let wanted = expected(&request, start, points);
            let same = generator.read(points, |words| words == wanted);
            assert!(same.expect("words"), "from {start} on");
        }
    });
}

/// A slice of a buffer is filled to its last word and no further, from an aligned point and
/// from one that is not.
#[test]
fn recorded_points_stay_in_their_slice() {
    support::on_each_device(|device| {
        let least = device.info().limits.storage_offset_alignment.max(4);
        let sobol = [2, 3, 16, 32].map(|dimensions| (Sequence::Sobol, dimensions));
        let halton = [2, 3, 6].map(|dimensions| (Sequence::Halton, dimensions));
        for (sequence, dimensions) in sobol.into_iter().chain(halton) {
            let request = Request::new(&options(sequence, None, dimensions));
            let request = request.expect("a request");
            let mut generator = Generator::new(device, &request).expect("a generator");
            for (start, points) in [(0u64, 2000u64), (48, 33), (3, 2000), (16, 15)] {
                let (bytes, offset) = (4 * dimensions * points, 3 * least);
                let all = bytes + 2 * offset;
                let mut buffer = Buffer::new(device, all, Access::Readback).expect("a buffer");
                buffer.write(0, &vec![0xab; all as usize]).expect("marks");
                let slice = buffer.slice(offset, bytes).expect("a slice");
                let mut work = generator
                    .submit(start, points, &slice)
                    .expect("a submission");
                work.wait().expect("its end");
                drop((work, slice));
                let words = expected(&request, start, points);
                let marks = |bytes: &[u8]| bytes.iter().all(|byte| *byte == 0xab);
                buffer
                    .read(0, all, |found| {
                        let (before, rest) = found.split_at(offset as usize);
                        let (made, after) = rest.split_at(bytes as usize);
                        assert!(marks(before) && marks(after), "{points} from {start} on");
                        assert_eq!(
                            made,
                            words
                                .iter()
                                .flat_map(|word| word.to_ne_bytes())
                                .collect::<Vec<u8>>(),
                            "{points} from {start} on"
                        );
                    })
                    .expect("a look");
            }
        }
    });
}
