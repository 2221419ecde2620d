//! Fences that never signal.

use std::time::{Duration, Instant};

use corput::Error;
use corput::vulkan::ash::vk;
use corput::vulkan::{Device, WAIT_SECONDS};

use super::plan::{Fault, Session, with};
use super::work::{ALL, Work, everything, on_each, on_each_that_hangs};

const LIMIT: Duration = Duration::from_millis(50);

/// Waits that end one after the other before a check gives up: each of its four threads
/// has a first one, and may have begun another row.
const WAITS: u32 = 8;

fn hangs(session: &Session, device: &std::sync::Arc<Device>, (name, work): (&str, Work)) {
    session.fail(Fault::always("vkWaitForFences", vk::Result::TIMEOUT));
    let start = Instant::now();
    let error = work(device).expect_err(name);
    let spent = start.elapsed();
    assert!(
        matches!(
            error,
            Error::Timeout {
                call: "vkWaitForFences",
                ..
            }
        ),
        "{error}"
    );
    let text = error.to_string();
    let said =
        "vkWaitForFences did not end within 0.05 s; the device hangs or is shared: try again";
    assert!(text.starts_with(said), "{text}");
    assert_eq!(error.exit_code(), 4);
    // What it waits is what it was told, and some seconds are for compilers.
    assert_eq!(with(|plan| plan.longest_wait), LIMIT.as_nanos() as u64);
    let waited = session.seen("vkWaitForFences") as u32;
    println!("{name}: {waited} waits, {spent:?}");
    assert!((1..=WAITS).contains(&waited), "{name}: {waited} waits");
    assert!(spent >= LIMIT && spent < WAITS * LIMIT + Duration::from_secs(10));
}

#[test]
fn waits_are_bounded_and_can_go_on() {
    on_each(|session, instance, info| {
        let device = Device::open(instance, info).expect("a device");
        device.keep_pipelines();
        assert_eq!(device.wait_limit(), Duration::from_secs(WAIT_SECONDS));
        device.set_wait_limit(LIMIT);
        for (name, work) in ALL {
            hangs(session, &device, (name, work));
            session.heal();
            device.set_wait_limit(Duration::from_secs(WAIT_SECONDS));
            work(&device).expect(name);
            device.set_wait_limit(LIMIT);
        }
    });
}

#[test]
fn a_device_that_hangs_can_be_dropped() {
    on_each_that_hangs(|session, instance, info| {
        for (name, work) in ALL {
            session.heal();
            let device = Device::open(instance, info).expect("a device");
            device.set_wait_limit(LIMIT);
            hangs(session, &device, (name, work));
        }
    });
}

/// What fits into the bound on the first wait of all is no hang.
#[test]
fn the_usual_limit_is_passed_on() {
    on_each(|_, instance, info| {
        let device = Device::open(instance, info).expect("a device");
        everything(&device).expect("all of it");
        assert_eq!(with(|plan| plan.longest_wait), WAIT_SECONDS * 1_000_000_000);
    });
}
