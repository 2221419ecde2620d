//! Loaders without devices, lists that change, and queues of the caller's that are none.

use corput::Error;
use corput::vulkan::ash::vk;
use corput::vulkan::{Device, Instance, select};

use super::plan::{Fault, Lie, Session};
use super::support;
use super::work::{instance, on_each};

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
