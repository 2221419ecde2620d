//! Submissions that are not waited for at once.

use super::support::{on_each_device, words};
use super::{reference, request, requests};
use corput::Error;
use corput::catalog::{Engine, Sequence};
use corput::kernels::Generator;
use corput::vulkan::{Access, Buffer};
use std::time::{Duration, Instant};

/// Points of each.
const POINTS: u64 = 3001;

/// Whole invocations of every kernel, which need no copy.
const WHOLE: u64 = 2880;

#[test]
fn several_are_in_flight_at_once() {
    on_each_device(|device| {
        for (request, points) in requests()
            .into_iter()
            .zip([POINTS, WHOLE].into_iter().cycle())
        {
            let bytes = 4 * u64::from(request.words_per_point()) * points;
            let starts = [0, request.count - points, 1];
            let mut generator = Generator::new(device, &request).unwrap();
            let mut buffers = starts.map(|_| Buffer::new(device, bytes, Access::Readback).unwrap());
            let mut flying = Vec::new();
            for (buffer, start) in buffers.iter().zip(starts) {
                let target = buffer.slice(0, bytes).unwrap();
                flying.push(generator.submit(start, points, &target).unwrap());
            }
            // Each is the host's again once its own has been waited for, in any order.
            for at in [1, 2, 0] {
                let error = buffers[at].read(0, bytes, |_| ()).unwrap_err();
                assert!(
                    error.to_string().contains("wait for the submission"),
                    "{error}"
                );
                assert!(buffers[at].write(0, &[0; 4]).is_err());
                assert!(buffers[at].fill_zero().is_err());
                flying[at].wait().unwrap();
                let made = buffers[at].read(0, bytes, words).unwrap();
                assert!(made == reference(&request, starts[at], points));
                assert!(flying[at].is_done().unwrap());
                flying[at].wait().unwrap();
            }
        }
    });
}

/// The waits of one kind of work do not disturb those of the other.
#[test]
fn points_may_be_made_at_once_while_others_are_in_flight() {
    on_each_device(|device| {
        for request in [&requests()[0], &requests()[6]] {
            let bytes = 4 * u64::from(request.words_per_point()) * POINTS;
            let mut generator = Generator::new(device, request).unwrap();
            let mut buffer = Buffer::new(device, bytes, Access::Readback).unwrap();
            let target = buffer.slice(0, bytes).unwrap();
            let mut flying = generator.submit(5, POINTS, &target).unwrap();
            drop(target);
            let mut filled = vec![0; bytes as usize / 4];
            generator.fill(1000, &mut filled).unwrap();
            assert!(filled == reference(request, 1000, POINTS));
            flying.wait().unwrap();
            let made = buffer.read(0, bytes, words).unwrap();
            assert!(made == reference(request, 5, POINTS));
        }
    });
}

#[test]
fn one_that_is_dropped_has_ended() {
    on_each_device(|device| {
        let request = request(Sequence::Sobol, 1 << 20, 4, None);
        let bytes = 16 << 20;
        let mut generator = Generator::new(device, &request).unwrap();
        let mut buffer = Buffer::new(device, bytes, Access::Readback).unwrap();
        let target = buffer.slice(0, bytes).unwrap();
        drop(generator.submit(0, 1 << 20, &target).unwrap());
        drop(target);
        // What made it may go first, and what it fills.
        let made = buffer.read(0, bytes, words).unwrap();
        assert!(made == reference(&request, 0, 1 << 20));
        let flying = generator.submit(0, 1 << 20, &buffer.slice(0, bytes).unwrap());
        drop(generator);
        drop(buffer);
        drop(flying);
    });
}

#[test]
fn the_end_can_be_seen_without_a_wait() {
    on_each_device(|device| {
        let request = request(Sequence::Halton, 100_000, 3, None);
        let mut generator = Generator::new(device, &request).unwrap();
        let mut buffer = Buffer::new(device, 1_200_000, Access::Readback).unwrap();
        let target = buffer.slice(0, 1_200_000).unwrap();
        let mut flying = generator.submit(0, 100_000, &target).unwrap();
        drop(target);
        let begun = Instant::now();
        while !flying.is_done().unwrap() {
            assert!(begun.elapsed() < Duration::from_secs(60));
            std::thread::yield_now();
        }
        let made = buffer.read(0, 1_200_000, words).unwrap();
        assert!(made == reference(&request, 0, 100_000));
        // A wait of the caller's, by the fence.
        let target = buffer.slice(0, 1_200_000).unwrap();
        let mut flying = generator.submit(0, 1000, &target).unwrap();
        // SAFETY: the fence lives as long as the submission.
        let waited = unsafe {
            let fences = [flying.fence()];
            device.raw().wait_for_fences(&fences, true, u64::MAX)
        };
        waited.unwrap();
        assert!(flying.is_done().unwrap());
    });
}

#[test]
fn a_wait_is_bounded_and_can_go_on() {
    on_each_device(|device| {
        let request = request(Sequence::Sobol, 1 << 21, 4, None);
        let mut generator = Generator::new(device, &request).unwrap();
        let bytes = 32 << 20;
        let mut buffer = Buffer::new(device, bytes, Access::Readback).unwrap();
        let patience = device.wait_limit();
        let target = buffer.slice(0, bytes).unwrap();
        let mut flying = generator.submit(0, 1 << 21, &target).unwrap();
        drop(target);
        device.set_wait_limit(Duration::ZERO);
        match flying.wait() {
            Err(error) => assert!(matches!(error, Error::Timeout { .. }), "{error}"),
            // A device may be so quick.
            Ok(()) => eprintln!("{} had ended", device.info().name),
        }
        device.set_wait_limit(patience);
        flying.wait().unwrap();
        let end = buffer.read(bytes - 16_000, 16_000, words).unwrap();
        assert!(end == reference(&request, (1 << 21) - 1000, 1000));
    });
}
