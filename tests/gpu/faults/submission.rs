//! Submissions that fail, that end late, or that are dropped before.

use std::sync::Arc;
use std::time::Duration;

use corput::catalog::Request;
use corput::kernels::Generator;
use corput::vulkan::ash::vk;
use corput::vulkan::{Access, Buffer, Device, Submission};
use corput::{Error, Result};

use super::plan::{Fault, Lie, Way};
use super::support::words;
use super::work::{assert_failed, on_each, on_each_that_hangs, points, reference, samples};

const HOST: vk::Result = vk::Result::ERROR_OUT_OF_HOST_MEMORY;

/// All points of a request in flight.
fn fly(device: &Arc<Device>, request: &Request) -> Result<(Submission, Buffer)> {
    let mut generator = Generator::new(device, request)?;
    let bytes = 4 * u64::from(request.words_per_point()) * request.count;
    let buffer = Buffer::new(device, bytes, Access::Readback)?;
    let flying = generator.submit(0, request.count, &buffer.slice(0, bytes)?)?;
    Ok((flying, buffer))
}

fn lands(flown: Result<(Submission, Buffer)>, request: &Request) -> Result<()> {
    let (mut flying, mut buffer) = flown?;
    flying.wait()?;
    let bytes = buffer.bytes();
    assert!(buffer.read(0, bytes, words)? == reference(request));
    Ok(())
}

/// Nothing is waited for before somebody waits.
#[test]
fn two_are_submitted_before_either_is_waited_for() {
    on_each(|session, instance, info| {
        let device = Device::open(instance, info).expect("a device");
        for request in [points(), samples()] {
            let mut generator = Generator::new(&device, &request).expect("a generator");
            let buffers = [0, 1].map(|_| Buffer::new(&device, 1 << 20, Access::Readback));
            let buffers = buffers.map(|buffer| buffer.expect("a buffer"));
            session.heal();
            let mut flying: Vec<Submission> = buffers
                .iter()
                .map(|buffer| generator.submit(0, 1001, &buffer.slice(0, 1 << 20)?))
                .collect::<Result<_>>()
                .expect("submissions");
            assert_eq!(session.seen("vkQueueSubmit"), 2);
            assert_eq!(session.seen("vkWaitForFences"), 0);
            for one in &mut flying {
                one.wait().expect("an end");
            }
            assert_eq!(session.seen("vkWaitForFences"), 2);
        }
    });
}

/// A driver that checks the bounds of bindings would hide what goes past them.
#[test]
fn nothing_is_written_past_the_points() {
    const AFTER: u64 = 16384;
    on_each(|session, instance, info| {
        let device = Device::open(instance, info).expect("a device");
        for request in [points(), samples()] {
            let mut generator = Generator::new(&device, &request).expect("a generator");
            let width = u64::from(request.words_per_point());
            for count in [1, 2, 3, 5, 239, 241, 1003, request.count - 1] {
                let bytes = 4 * width * count;
                let access = Access::Readback;
                let mut buffer = Buffer::new(&device, bytes + AFTER, access).expect("a buffer");
                buffer.fill_zero().expect("zeros");
                session.lie(&[Lie::Unbounded]);
                let slice = buffer.slice(0, bytes).expect("a slice");
                let flying = generator.submit(1, count, &slice);
                drop(slice);
                flying.and_then(|mut one| one.wait()).expect("points");
                assert!(session.fired() > 0);
                let mut wanted = reference(&request)[width as usize..].to_vec();
                wanted.truncate((width * count) as usize);
                wanted.resize(wanted.len() + AFTER as usize / 4, 0);
                let made = buffer.read(0, bytes + AFTER, words).expect("words");
                assert!(made == wanted, "{count} points of {width} words");
            }
        }
    });
}

#[test]
fn every_call_of_a_submission_may_fail() {
    on_each(|session, instance, info| {
        let device = Device::open(instance, info).expect("a device");
        device.keep_pipelines();
        for request in [points(), samples()] {
            session.heal();
            lands(fly(&device, &request), &request).expect("points");
            for call in [
                "vkCreateBuffer",
                "vkAllocateMemory",
                "vkBindBufferMemory",
                "vkCreateDescriptorPool",
                "vkAllocateDescriptorSets",
                "vkCreateCommandPool",
                "vkAllocateCommandBuffers",
                "vkBeginCommandBuffer",
                "vkEndCommandBuffer",
                "vkCreateFence",
                "vkQueueSubmit",
                "vkWaitForFences",
            ] {
                session.heal();
                lands(fly(&device, &request), &request).expect("points");
                let all = session.seen(call);
                assert!(all > 0, "{call} is not seen");
                let before = session.live();
                for nth in 1..=all {
                    session.fail(Fault {
                        nth,
                        ..Fault::next(call, HOST)
                    });
                    let error = lands(fly(&device, &request), &request).expect_err(call);
                    assert_failed(&error, call, "ERROR_OUT_OF_HOST_MEMORY", "memory ran out");
                    assert_eq!((session.fired(), session.live()), (1, before), "{call}");
                }
            }
            session.heal();
            lands(fly(&device, &request), &request).expect("points");
        }
    });
}

#[test]
fn a_lost_device_ends_what_is_in_flight() {
    on_each(|session, instance, info| {
        for call in ["vkWaitForFences", "vkGetFenceStatus", "vkQueueSubmit"] {
            session.heal();
            let device = Device::open(instance, info).expect("a device");
            let request = points();
            let (mut flying, mut buffer) = fly(&device, &request).expect("a submission");
            if call == "vkGetFenceStatus" {
                // The driver has not lost it, and may still be writing.
                // SAFETY: the fence lives as long as the submission.
                let waited = unsafe {
                    let fences = [flying.fence()];
                    device.raw().wait_for_fences(&fences, true, u64::MAX)
                };
                waited.expect("an end");
            }
            session.fail(Fault {
                way: match call {
                    "vkQueueSubmit" => Way::Instead,
                    _ => Way::After,
                },
                ..Fault::next(call, vk::Result::ERROR_DEVICE_LOST)
            });
            let error = match call {
                "vkWaitForFences" => flying.wait().expect_err("lost"),
                "vkGetFenceStatus" => flying.is_done().expect_err("lost"),
                _ => fly(&device, &request).expect_err("lost"),
            };
            let lost = |error: Error| {
                assert_failed(&error, call, "ERROR_DEVICE_LOST", "the device was lost");
            };
            lost(error);
            session.heal();
            lost(flying.wait().expect_err("lost"));
            lost(flying.is_done().expect_err("lost"));
            lost(buffer.read(0, 4, <[u8]>::to_vec).expect_err("lost"));
            lost(fly(&device, &request).expect_err("lost"));
        }
    });
}

/// Nothing that work uses is freed before it has ended, whoever drops it; all of it is then.
#[test]
fn what_is_dropped_too_early_is_freed_at_the_end() {
    on_each(|session, instance, info| {
        let device = Device::open(instance, info).expect("a device");
        device.keep_pipelines();
        for request in [points(), samples()] {
            session.heal();
            lands(fly(&device, &request), &request).expect("points");
            let before = session.live();
            let (mut flying, buffer) = fly(&device, &request).expect("a submission");
            drop(buffer);
            let used = session.live();
            device.set_wait_limit(Duration::from_millis(20));
            let never = Fault::always("vkWaitForFences", vk::Result::TIMEOUT);
            session.fail(never);
            let error = flying.wait().expect_err("late");
            assert!(matches!(error, Error::Timeout { .. }), "{error}");
            drop(flying);
            assert_eq!(session.live(), used);
            // A device that is used meanwhile looks, and frees nothing that still runs.
            session.fail(Fault::always("vkGetFenceStatus", vk::Result::NOT_READY));
            let mut other = Buffer::new(&device, 64, Access::Readback).expect("a buffer");
            other.read(0, 64, |_| ()).expect("bytes");
            assert!(session.fired() > 0);
            drop(other);
            assert_eq!(session.live(), used);
            session.heal();
            device.set_wait_limit(Duration::from_secs(30));
            // Work of one queue ends in order.
            lands(fly(&device, &request), &request).expect("points");
            assert_eq!(session.live(), before);
        }
    });
}

#[test]
fn a_device_may_go_while_something_is_in_flight() {
    on_each_that_hangs(|session, instance, info| {
        let before = session.live();
        let device = Device::open(instance, info).expect("a device");
        let (flying, buffer) = fly(&device, &points()).expect("a submission");
        drop((device, buffer));
        drop(flying);
        assert_eq!(session.live(), before);
        let device = Device::open(instance, info).expect("a device");
        device.set_wait_limit(Duration::from_millis(20));
        let (flying, buffer) = fly(&device, &points()).expect("a submission");
        let used = session.live();
        session.fail(Fault::always("vkWaitForFences", vk::Result::TIMEOUT));
        drop((device, buffer));
        drop(flying);
        assert_eq!(session.live(), used, "something was freed");
    });
}
