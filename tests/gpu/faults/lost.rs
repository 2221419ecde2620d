//! Devices that are lost, or that cannot say what became of the work.

use corput::vulkan::ash::vk;
use corput::vulkan::{Access, Buffer, Device};

use super::plan::{Fault, Way};
use super::work::{
    ALL, assert_failed, everything, generate, generator, is_the_sum, on_each, summed,
};

const LOST: vk::Result = vk::Result::ERROR_DEVICE_LOST;

/// Where a loss is heard of. Waits and queries have done their work by then.
const HEARD: [(&str, Way); 3] = [
    ("vkQueueSubmit", Way::Instead),
    ("vkWaitForFences", Way::After),
    ("vkGetQueryPoolResults", Way::After),
];

#[test]
fn a_lost_device_says_so_and_stays_lost() {
    on_each(|session, instance, info| {
        for (call, way) in HEARD {
            // All of it where a wait says so; where others do, the one that is the quickest.
            let count = if call == "vkWaitForFences" {
                ALL.len()
            } else {
                1
            };
            for (name, work) in ALL.into_iter().take(count) {
                // At once in all of them, and in the middle of one.
                let times: &[u64] = if name == "generate" { &[1, 2] } else { &[1] };
                for &nth in times {
                    session.heal();
                    let device = Device::open(instance, info).expect("a device");
                    let mut buffer = Buffer::new(&device, 64, Access::Readback).expect("a buffer");
                    session.fail(Fault {
                        way,
                        nth,
                        ..Fault::next(call, LOST)
                    });
                    let error = work(&device).expect_err(name);
                    assert_failed(&error, call, "ERROR_DEVICE_LOST", "the device was lost");
                    assert_eq!(session.fired(), 1);
                    // Whatever the driver says now, what its memory holds is anyone's guess.
                    session.heal();
                    let error = buffer.read(0, 64, <[u8]>::to_vec).expect_err("lost");
                    assert_failed(&error, call, "ERROR_DEVICE_LOST", "the device was lost");
                    let error = work(&device).expect_err(name);
                    assert_failed(&error, call, "ERROR_DEVICE_LOST", "the device was lost");
                }
            }
        }
    });
}

#[test]
fn one_of_two_devices_may_be_lost() {
    use vk::Handle;
    on_each(|session, instance, info| {
        // The same driver twice, or two where there are two.
        let all = instance.devices().expect("a list");
        let other = all.iter().find(|one| one.index != info.index);
        let one = Device::open(instance, info).expect("a device");
        let two = Device::open(instance, other.unwrap_or(info)).expect("a device");
        one.keep_pipelines();
        two.keep_pipelines();
        session.fail(Fault {
            way: Way::After,
            of: one.raw().handle().as_raw(),
            ..Fault::always("vkWaitForFences", LOST)
        });
        generate(&one).expect_err("lost");
        everything(&two).expect("the other");
        generate(&one).expect_err("lost");
        assert!(session.fired() > 0);
        drop(one);
        everything(&two).expect("the other");
    });
}

/// A clock that cannot be read costs the time on the device, and nothing else.
#[test]
fn a_clock_that_fails_is_done_without() {
    on_each(|session, instance, info| {
        let device = Device::open(instance, info).expect("a device");
        device.keep_pipelines();
        for code in [vk::Result::NOT_READY, vk::Result::ERROR_OUT_OF_HOST_MEMORY] {
            session.fail(Fault::always("vkGetQueryPoolResults", code));
            everything(&device).expect("all of it");
            let (mut generator, _) = generator(&device).expect("a generator");
            let timing = generator.dispatch(0, 100).expect("points");
            assert!(timing.device_ns.is_none() && timing.host_ns > 0.0);
            assert!(session.fired() > 1);
        }
    });
}

/// One that fails under way leaves every sum right, and no time of the host below the device's.
#[test]
fn a_clock_that_fails_in_a_batch_is_not_asked_again() {
    on_each(|session, instance, info| {
        let device = Device::open(instance, info).expect("a device");
        session.heal();
        summed(&device, 40).expect("sums");
        let all = session.seen("vkGetQueryPoolResults");
        for nth in [1, all.div_ceil(2), all] {
            session.fail(Fault {
                nth,
                ..Fault::always("vkGetQueryPoolResults", vk::Result::NOT_READY)
            });
            let mut clocks = 0;
            for (sum, timing) in summed(&device, 40).expect("sums") {
                assert!(is_the_sum(&sum), "wrong sums");
                clocks += u32::from(timing.device_ns.is_some());
                assert!(timing.host_ns > 0.0 && timing.host_ns >= timing.device_ns.unwrap_or(0.0));
            }
            // How many share a submission hangs on the clock.
            assert!(session.fired() == 0 || clocks < 40);
        }
    });
}

/// A wait that fails has not ended: what it waited for must not be destroyed, nor read.
#[test]
fn a_wait_without_memory_is_waited_again() {
    on_each(|session, instance, info| {
        let device = Device::open(instance, info).expect("a device");
        device.keep_pipelines();
        for (name, work) in ALL {
            for nth in [1, 2] {
                let code = vk::Result::ERROR_OUT_OF_HOST_MEMORY;
                session.fail(Fault {
                    nth,
                    ..Fault::next("vkWaitForFences", code)
                });
                let error = work(&device).expect_err(name);
                assert_failed(
                    &error,
                    "vkWaitForFences",
                    "ERROR_OUT_OF_HOST_MEMORY",
                    "memory",
                );
                session.heal();
                work(&device).expect(name);
            }
        }
    });
}
