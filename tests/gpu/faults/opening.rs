//! Loaders without devices, lists that change, and queues of the caller's that are none.

use corput::Error;
use corput::vulkan::ash::vk;
use corput::vulkan::{Device, Instance, select};

use super::loader::entry;
use super::plan::{Fault, Lie, Session};
use super::support;
use super::work::{generate, instance, on_each};

fn is_no_device(error: &Error, reason: &str) {
    assert!(matches!(error, Error::NoDevice { .. }), "{error}");
    assert_eq!(error.exit_code(), 3);
    let text = error.to_string();
    for part in [reason, "no Vulkan device was found", "`--device cpu`"] {
        assert!(text.contains(part), "{text}");
    }
}

#[test]
fn no_device_is_said() {
    if support::skips() {
        return;
    }
    let session = Session::begin();
    session.fail(Fault::next(
        "vkCreateInstance",
        vk::Result::ERROR_INCOMPATIBLE_DRIVER,
    ));
    is_no_device(&instance().expect_err("no driver"), "finds no driver");
    session.lie(&[Lie::Version(vk::API_VERSION_1_0)]);
    is_no_device(&instance().expect_err("too old"), "Vulkan 1.0 only");
    session.heal();
    let instance = instance().expect("an instance");
    let none = |instance: &Instance| {
        let listed = instance.devices().expect("a list");
        is_no_device(&select(&listed, None).expect_err("none"), "lists no device");
        is_no_device(
            &select(&listed, Some("0")).expect_err("none"),
            "lists no device",
        );
    };
    session.lie(&[Lie::Devices(|_, all| all.clear())]);
    none(&instance);
    assert!(session.fired() > 0);
    // What some loaders say when every driver declined.
    let declined = vk::Result::ERROR_INITIALIZATION_FAILED;
    session.fail(Fault::always("vkEnumeratePhysicalDevices", declined));
    none(&instance);
}

#[test]
fn a_device_that_has_gone_is_said() {
    on_each(|session, instance, info| {
        session.lie(&[Lie::Devices(|_, all| all.clear())]);
        let error = Device::open(instance, info).expect_err("gone");
        assert!(matches!(error, Error::UnknownDevice { .. }), "{error}");
        let text = error.to_string();
        assert!(
            text.contains(&info.name) && text.contains("has gone"),
            "{text}"
        );
        assert_eq!(error.exit_code(), 2);
    });
}

/// The list may change at any time, between two questions for it too.
#[test]
fn a_list_that_changes_opens_no_other_device() {
    let changes: [fn(u64, &mut Vec<vk::PhysicalDevice>); 3] = [
        |_, all| all.reverse(),
        |time, all| {
            if time % 2 == 1 {
                all.reverse();
            }
        },
        |time, all| {
            if time % 2 == 0 {
                all.reverse();
            }
        },
    ];
    on_each(|session, instance, info| {
        if instance.devices().expect("a list").len() < 2 {
            println!("one device has one order");
            return;
        }
        let mut fired = 0;
        for change in changes {
            session.lie(&[Lie::Devices(change)]);
            let device = Device::open(instance, info).expect("a device");
            fired += session.fired();
            assert_eq!(device.info().name, info.name);
            session.heal();
            // SAFETY: the physical device is the instance's.
            let said = unsafe {
                instance
                    .raw()
                    .get_physical_device_properties(device.physical())
            };
            assert_eq!(
                said.device_name_as_c_str()
                    .map(|name| name.to_string_lossy()),
                Ok(info.name.as_str().into())
            );
        }
        assert!(fired > 0);
    });
}

#[test]
fn a_queue_family_that_is_none_is_refused() {
    on_each(|session, instance, info| {
        let device = Device::open(instance, info).expect("a device");
        let wrap = |family| {
            // SAFETY: the handles belong together and outlive the wrapper; a family that is
            // not the queue's is refused before it is used.
            unsafe {
                Device::from_existing(
                    &entry(),
                    instance.raw(),
                    device.physical(),
                    device.raw().clone(),
                    device.queue(),
                    family,
                )
            }
        };
        let before = session.live();
        for family in [1 << 10, u32::MAX] {
            let error = wrap(family).expect_err("no family");
            assert!(matches!(error, Error::Arguments { .. }), "{error}");
            let text = error.to_string();
            let parts = [&format!("queue family {family}"), "computes", "give"];
            assert!(parts.iter().all(|part| text.contains(*part)), "{text}");
        }
        session.lie(&[Lie::Family(|said| {
            said.queue_flags = vk::QueueFlags::TRANSFER;
        })]);
        let error = wrap(device.queue_family()).expect_err("it cannot compute");
        assert!(matches!(error, Error::Arguments { .. }), "{error}");
        assert_eq!(session.live(), before);
        session.heal();
        let wrapped = wrap(device.queue_family()).expect("the device");
        generate(&wrapped).expect("points");
    });
}
