//! Devices that fail or lie: each fault ends in the error or the fallback that
//! `corput::vulkan` promises, never in a wrong answer, a panic or an endless wait.
//!
//! The host runs by a loader that wraps the system's ([`loader`]): calls fail as planned, and
//! what drivers say about themselves is changed. Nothing in the crate knows of it.

mod support;

#[path = "faults/answers.rs"]
mod answers;
#[path = "faults/calls.rs"]
mod calls;
#[path = "faults/every_call.rs"]
mod every_call;
#[path = "faults/limits.rs"]
mod limits;
#[path = "faults/loader.rs"]
mod loader;
#[path = "faults/lost.rs"]
mod lost;
#[path = "faults/memory.rs"]
mod memory;
#[path = "faults/modules.rs"]
mod modules;
#[path = "faults/opening.rs"]
mod opening;
#[path = "faults/plan.rs"]
mod plan;
#[path = "faults/submission.rs"]
mod submission;
#[path = "faults/timeout.rs"]
mod timeout;
#[cfg(target_os = "linux")]
#[path = "faults/windows.rs"]
mod windows;
#[path = "faults/work.rs"]
mod work;

use corput::vulkan::Device;
use corput::vulkan::ash::vk;
use plan::{Fault, Lie};

/// The wrapped loader alone changes nothing, and sees the calls.
#[test]
fn a_loader_that_does_nothing_is_not_noticed() {
    work::on_each(|session, instance, info| {
        let device = Device::open(instance, info).expect("a device");
        assert_eq!(device.info(), info);
        work::everything(&device).expect("all of it");
        let calls = [
            "vkCreateDevice",
            "vkCreateBuffer",
            "vkAllocateMemory",
            "vkMapMemory",
            "vkCreateShaderModule",
            "vkCreateComputePipelines",
            "vkQueueSubmit",
            "vkWaitForFences",
        ];
        for call in calls {
            assert!(session.seen(call) > 0, "{call} is not seen");
        }
        assert!(session.live() > 1, "objects are not counted");
        assert_eq!(session.fired(), 0);
    });
}

/// The same driver by the system's loader and by the wrapped one says the same.
#[test]
fn the_wrapped_loader_lists_the_same_devices() {
    use corput::vulkan::{Instance, InstanceOptions};
    if support::skips() {
        return;
    }
    let session = plan::Session::begin();
    let wrapped = work::instance().expect("an instance");
    let plain = Instance::new(&InstanceOptions::default()).expect("an instance");
    let plain = plain.devices().expect("a list");
    assert_eq!(wrapped.devices().expect("a list"), plain);
    session.lie(&[Lie::Properties(|said| said.vendor_id ^= 1)]);
    assert_ne!(wrapped.devices().expect("a list"), plain);
    assert!(session.fired() > 0);
    // A fault of a function that is not called does not fire.
    session.fail(Fault::next("vkQueueSubmit", vk::Result::ERROR_DEVICE_LOST));
    assert_eq!(wrapped.devices().expect("a list"), plain);
    assert_eq!(session.fired(), 0);
}
