//! Shader modules that are none, and that a driver refuses.

use corput::vulkan::Device;
use corput::vulkan::ash::vk;

use super::plan::Fault;
use super::work::{ALL, assert_failed, on_each};

#[test]
fn modules_and_pipelines_that_a_driver_refuses_are_named() {
    let calls = [
        ("vkCreateShaderModule", vk::Result::ERROR_INVALID_SHADER_NV),
        (
            "vkCreateComputePipelines",
            vk::Result::ERROR_INVALID_SHADER_NV,
        ),
        ("vkCreateComputePipelines", vk::Result::ERROR_UNKNOWN),
    ];
    on_each(|session, instance, info| {
        let device = Device::open(instance, info).expect("a device");
        device.keep_pipelines();
        for (name, work) in ALL {
            for (call, code) in calls {
                session.fail(Fault::next(call, code));
                let error = work(&device).expect_err(name);
                assert_failed(&error, call, &format!("{code:?}"), "`--device cpu`");
                assert_eq!(session.fired(), 1);
            }
            // Nothing broken is kept.
            session.heal();
            work(&device).expect(name);
        }
    });
}
