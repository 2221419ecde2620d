//! Shader modules that are none, and that a driver refuses.

use corput::Error;
use corput::kernels::{kernel, pipeline, spirv};
use corput::vulkan::Device;
use corput::vulkan::ash::vk;

use super::plan::{Fault, Lie};
use super::work::{ALL, assert_failed, everything, on_each};

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
        for (name, work) in ALL {
            let device = Device::open(instance, info).expect("a device");
            device.keep_pipelines();
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

/// Words that are cut off, or lie about their lengths, never reach a driver.
#[test]
fn words_that_are_no_module_never_reach_the_driver() {
    let row = kernel("generate_tile_2").expect("a kernel");
    let whole = spirv("generate_tile_2").expect("a module");
    let mut zero = whole.clone();
    zero[5] = 0;
    let mut long = whole.clone();
    let last = long.len() - 1;
    long[last] = 0xffff_0000 | long[last] & 0xffff;
    let broken: [&[u32]; 6] = [
        &[],
        &whole[..4],
        &whole[..whole.len() - 1],
        &whole[1..],
        &zero,
        &long,
    ];
    on_each(|session, instance, info| {
        let device = Device::open(instance, info).expect("a device");
        for words in broken {
            // A driver that takes nothing: what comes this far is not for one.
            session.lie(&[Lie::Module(|_| true)]);
            let error = pipeline(&device, row, words, &[]).expect_err("no module");
            assert!(
                matches!(&error, Error::Shader { shader, .. } if shader == "generate_tile_2"),
                "{error}"
            );
            assert_eq!(session.seen("vkCreateShaderModule"), 0);
        }
        session.heal();
        everything(&device).expect("all of it");
    });
}
