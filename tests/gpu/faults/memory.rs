//! Memory that runs out in the middle of work, is not mapped, or is not coherent.

use corput::Error;
use corput::vulkan::ash::vk;
use corput::vulkan::{Access, Buffer, Device};

use super::plan::{Fault, Lie};
use super::work::{
    ALL, STILL, assert_failed, check, estimator, everything, generator, is_the_sum, made, on_each,
};

/// A driver on the CPU that says that it is a card: buffers are not mapped but copied.
const CARD: Lie = Lie::Properties(|said| said.device_type = vk::PhysicalDeviceType::DISCRETE_GPU);

#[test]
fn every_allocation_of_a_run_may_fail() {
    let codes = [
        (
            vk::Result::ERROR_OUT_OF_DEVICE_MEMORY,
            "ERROR_OUT_OF_DEVICE_MEMORY",
        ),
        (
            vk::Result::ERROR_OUT_OF_HOST_MEMORY,
            "ERROR_OUT_OF_HOST_MEMORY",
        ),
        (vk::Result::ERROR_TOO_MANY_OBJECTS, "ERROR_TOO_MANY_OBJECTS"),
    ];
    on_each(|session, instance, info| {
        for lies in [&[STILL][..], &[STILL, CARD]] {
            session.lie(lies);
            let device = Device::open(instance, info).expect("a device");
            device.keep_pipelines();
            for (name, work) in ALL.into_iter().filter(|(name, _)| *name != "check") {
                session.lie(lies);
                work(&device).expect(name);
                let all = session.seen("vkAllocateMemory");
                assert!(all >= 1, "{name} allocates nothing");
                for nth in 1..=all {
                    let (code, text) = codes[nth as usize % codes.len()];
                    let fault = Fault {
                        nth,
                        ..Fault::next("vkAllocateMemory", code)
                    };
                    session.set(&[fault], lies);
                    let error = work(&device).expect_err(name);
                    assert_failed(&error, "vkAllocateMemory", text, "memory ran out");
                }
                session.lie(lies);
                work(&device).expect(name);
            }
        }
    });
}

#[test]
fn a_check_that_runs_out_of_memory_says_so() {
    on_each(|session, instance, info| {
        let device = Device::open(instance, info).expect("a device");
        device.keep_pipelines();
        for nth in [1, 2, 3] {
            let code = vk::Result::ERROR_OUT_OF_DEVICE_MEMORY;
            let fault = Fault {
                nth,
                ..Fault::next("vkAllocateMemory", code)
            };
            session.fail(fault);
            let error = check(&device).expect_err("no memory");
            assert_failed(
                &error,
                "vkAllocateMemory",
                "ERROR_OUT_OF_DEVICE_MEMORY",
                "memory ran out",
            );
        }
        session.heal();
        check(&device).expect("rows");
    });
}

/// The objects themselves go on after a failure, and count nothing twice.
#[test]
fn generators_and_estimators_outlive_a_failed_allocation() {
    on_each(|session, instance, info| {
        session.lie(&[STILL, CARD]);
        let device = Device::open(instance, info).expect("a device");
        let (mut generator, points) = generator(&device).expect("a generator");
        let (mut estimator, count) = estimator(&device).expect("an estimator");
        let lack = Fault::next("vkAllocateMemory", vk::Result::ERROR_OUT_OF_DEVICE_MEMORY);
        session.set(&[lack], &[CARD]);
        made(&mut generator, points).expect_err("no staging buffer");
        assert_eq!(session.fired(), 1);
        // The second: the estimator's records, grown for its second dispatch.
        for nth in [1, 2, 3] {
            session.set(&[Fault { nth, ..lack }], &[CARD]);
            estimator
                .run(0, count, &mut |_| Ok(()))
                .expect_err("no room");
            assert_eq!(session.fired(), 1);
        }
        session.lie(&[CARD]);
        let again = made(&mut generator, points).expect("points");
        assert_eq!(again, made(&mut generator, points).expect("points"));
        let (sum, _) = estimator.run(0, count, &mut |_| Ok(())).expect("sums");
        assert!(is_the_sum(&sum));
    });
}

#[test]
fn a_card_gives_the_same() {
    on_each(|session, instance, info| {
        session.lie(&[CARD]);
        let device = Device::open(instance, info).expect("a device");
        let buffer = Buffer::new(&device, 64, Access::Readback).expect("a buffer");
        assert!(!buffer.is_mapped());
        drop(buffer);
        everything(&device).expect("all of it");
    });
}

#[test]
fn a_mapping_that_fails_is_an_error() {
    on_each(|session, instance, info| {
        let device = Device::open(instance, info).expect("a device");
        device.keep_pipelines();
        for (name, work) in ALL {
            let code = vk::Result::ERROR_MEMORY_MAP_FAILED;
            session.fail(Fault::always("vkMapMemory", code));
            let error = work(&device).expect_err(name);
            assert_failed(
                &error,
                "vkMapMemory",
                "ERROR_MEMORY_MAP_FAILED",
                "memory ran out",
            );
            // And one that succeeds with no address.
            session.lie(&[Lie::NullMap]);
            let error = work(&device).expect_err(name);
            assert_failed(
                &error,
                "vkMapMemory",
                "ERROR_MEMORY_MAP_FAILED",
                "memory ran out",
            );
            assert!(session.fired() > 0);
        }
        session.heal();
        everything(&device).expect("all of it");
    });
}

#[test]
fn memory_that_is_not_coherent_is_flushed() {
    let incoherent = Lie::Memory(|said| {
        for one in &mut said.memory_types {
            one.property_flags &= !vk::MemoryPropertyFlags::HOST_COHERENT;
        }
    });
    on_each(|session, instance, info| {
        session.lie(&[incoherent]);
        let device = Device::open(instance, info).expect("a device");
        device.keep_pipelines();
        everything(&device).expect("all of it");
        for call in [
            "vkFlushMappedMemoryRanges",
            "vkInvalidateMappedMemoryRanges",
        ] {
            session.lie(&[incoherent]);
            everything(&device).expect("all of it");
            assert!(session.seen(call) > 0, "{call} is not seen");
            let fault = Fault::next(call, vk::Result::ERROR_OUT_OF_HOST_MEMORY);
            session.set(&[fault], &[incoherent]);
            let error = everything(&device).expect_err(call);
            assert_failed(&error, call, "ERROR_OUT_OF_HOST_MEMORY", "memory ran out");
        }
    });
}

#[test]
fn a_buffer_past_the_largest_allocation_is_refused() {
    let small = Lie::Maintenance3(|said| said.max_memory_allocation_size = 1 << 16);
    on_each(|session, instance, info| {
        session.lie(&[small]);
        let listed = instance.devices().expect("a list");
        assert_eq!(listed[info.index].limits.max_allocation, 1 << 16);
        let device = Device::open(instance, info).expect("a device");
        Buffer::new(&device, 1 << 16, Access::Upload).expect("what it takes");
        let error = Buffer::new(&device, (1 << 16) + 4, Access::Upload).expect_err("more");
        assert!(matches!(error, Error::Arguments { .. }), "{error}");
        let text = error.to_string();
        for part in [
            "65540 bytes",
            "allocates at most 65536 bytes",
            "a smaller one",
        ] {
            assert!(text.contains(part), "{text}");
        }
        assert!(session.fired() > 0);
    });
}
