//! Every call that may run out of memory does, at its first, a middle and its last time.

use corput::vulkan::Device;
use corput::vulkan::ash::vk;

use super::plan::{Fault, Session};
use super::support;
use super::work::{STILL, assert_failed, generate, instance, on_each};

const HOST: vk::Result = vk::Result::ERROR_OUT_OF_HOST_MEMORY;
const DEVICE: vk::Result = vk::Result::ERROR_OUT_OF_DEVICE_MEMORY;

/// Those of a device that is open, and once its pipelines are kept.
const RUNNING: [&str; 11] = [
    "vkCreateBuffer",
    "vkAllocateMemory",
    "vkBindBufferMemory",
    "vkMapMemory",
    "vkResetDescriptorPool",
    "vkAllocateDescriptorSets",
    "vkResetCommandPool",
    "vkBeginCommandBuffer",
    "vkEndCommandBuffer",
    "vkQueueSubmit",
    "vkResetFences",
];

const COMPILING: [&str; 4] = [
    "vkCreateShaderModule",
    "vkCreateDescriptorSetLayout",
    "vkCreatePipelineLayout",
    "vkCreateComputePipelines",
];

const OPENING: [&str; 7] = [
    "vkEnumeratePhysicalDevices",
    "vkEnumerateDeviceExtensionProperties",
    "vkCreateDevice",
    "vkCreateCommandPool",
    "vkAllocateCommandBuffers",
    "vkCreateFence",
    "vkCreateDescriptorPool",
];

/// The first, a middle one and the last.
fn times(all: u64) -> Vec<u64> {
    let mut times = vec![1, all.div_ceil(2), all];
    times.dedup();
    times
}

fn fails(session: &Session, nth: u64, call: &'static str, code: vk::Result) {
    session.fail(Fault {
        nth,
        ..Fault::next(call, code)
    });
}

#[test]
fn calls_that_run_out_of_memory_say_so_and_the_device_goes_on() {
    on_each(|session, instance, info| {
        session.lie(&[STILL]);
        let device = Device::open(instance, info).expect("a device");
        for call in COMPILING {
            fails(session, 1, call, DEVICE);
            let error = generate(&device).expect_err(call);
            assert_failed(&error, call, "ERROR_OUT_OF_DEVICE_MEMORY", "memory ran out");
            assert_eq!(session.fired(), 1);
        }
        session.heal();
        device.keep_pipelines();
        generate(&device).expect("points");
        for call in RUNNING {
            session.heal();
            generate(&device).expect("points");
            let all = session.seen(call);
            assert!(all > 0, "{call} is not seen");
            for nth in times(all) {
                fails(session, nth, call, HOST);
                let error = generate(&device).expect_err(call);
                assert_failed(&error, call, "ERROR_OUT_OF_HOST_MEMORY", "memory ran out");
                assert_eq!(session.fired(), 1, "{call}");
                // The very next work on the same device is right.
                session.heal();
                generate(&device).unwrap_or_else(|error| panic!("after {call}: {error}"));
            }
        }
    });
}

#[test]
fn opening_fails_cleanly_at_every_call() {
    on_each(|session, instance, info| {
        let mut calls = OPENING.to_vec();
        if info.limits.timestamp_valid_bits > 0 {
            calls.push("vkCreateQueryPool");
        }
        for call in calls {
            session.heal();
            let before = session.live();
            drop(Device::open(instance, info).expect("a device"));
            let all = session.seen(call);
            assert!(all > 0, "{call} is not seen");
            for nth in 1..=all {
                fails(session, nth, call, HOST);
                let error = Device::open(instance, info).expect_err(call);
                assert_failed(&error, call, "ERROR_OUT_OF_HOST_MEMORY", "memory ran out");
                assert_eq!((session.fired(), session.live()), (1, before), "{call}");
            }
        }
        let lost = vk::Result::ERROR_INITIALIZATION_FAILED;
        session.fail(Fault::next("vkCreateDevice", lost));
        let error = Device::open(instance, info).expect_err("no device");
        assert_failed(
            &error,
            "vkCreateDevice",
            "ERROR_INITIALIZATION_FAILED",
            "corput devices",
        );
    });
}

#[test]
fn connecting_fails_cleanly() {
    if support::skips() {
        return;
    }
    let session = Session::begin();
    for call in ["vkEnumerateInstanceVersion", "vkCreateInstance"] {
        session.fail(Fault::next(call, HOST));
        let error = instance().expect_err(call);
        assert_failed(&error, call, "ERROR_OUT_OF_HOST_MEMORY", "memory ran out");
        assert_eq!((session.fired(), session.live()), (1, 0));
    }
}
