//! Devices of the least that Vulkan guarantees, and of less.

use std::sync::Arc;

use corput::Error;
use corput::spirv::{Module, describe};
use corput::vulkan::ash::vk;
use corput::vulkan::{Device, DeviceInfo, Instance};

use super::plan::{Lie, Session, with};
use super::support::{compile, pipeline};
use super::work::{assert_failed, estimate, everything, generate, generator, on_each};

/// What a driver without any feature and of 128 invocations a group does not take.
fn needs_more(words: &[u32]) -> bool {
    let facts = describe(words).expect("a module");
    let module = Module::parse(words).expect("a module");
    // Execution mode 17 is the size of a group.
    let sizes = module
        .instructions()
        .iter()
        .filter_map(|row| match row.words {
            [head, _, 17, x, y, z] if head & 0xffff == 16 => Some(x * y * z),
            _ => None,
        });
    facts.capabilities != ["Shader"] || sizes.max().is_none_or(|size| size > 128)
}

/// The limits that Vulkan 1.1 guarantees.
const LEAST: [Lie; 6] = [
    Lie::Properties(|said| {
        let limits = &mut said.limits;
        limits.max_storage_buffer_range = 1 << 27;
        limits.max_push_constants_size = 128;
        limits.max_compute_work_group_invocations = 128;
        limits.max_compute_work_group_size = [128, 128, 64];
        limits.max_compute_work_group_count = [65_535; 3];
        limits.max_per_stage_descriptor_storage_buffers = 4;
        limits.min_storage_buffer_offset_alignment = 256;
    }),
    Lie::Features(|said| *said = vk::PhysicalDeviceFeatures::default()),
    Lie::Subgroup(|said| {
        said.subgroup_size = 1;
        said.supported_stages = vk::ShaderStageFlags::empty();
        said.supported_operations = vk::SubgroupFeatureFlags::empty();
    }),
    Lie::Family(|said| said.timestamp_valid_bits = 0),
    Lie::Maintenance3(|said| said.max_memory_allocation_size = 1 << 30),
    Lie::Module(needs_more),
];

#[test]
fn the_least_device_gives_the_same() {
    on_each(|session, instance, info| {
        session.lie(&LEAST);
        let device = Device::open(instance, info).expect("a device");
        let said = device.info();
        assert!(!said.features.float64 && !said.features.int64 && !said.features.int16);
        assert_eq!(said.limits.timestamp_valid_bits, 0);
        assert_eq!(said.limits.subgroup_size, 1);
        everything(&device).expect("all of it");
        let (mut generator, _) = generator(&device).expect("a generator");
        let timing = generator.dispatch(0, 100).expect("points");
        assert!(timing.device_ns.is_none() && timing.host_ns > 0.0);
        assert_eq!(with(|plan| plan.features_asked), 0);
        assert_eq!(session.seen("vkCreateQueryPool"), 0);
    });
}

/// Such a device does refuse what needs more.
#[test]
fn the_least_device_is_no_other_in_disguise() {
    let wide = "#version 450
        layout(local_size_x = 256) in;
        void main() {}";
    let long = "#version 450
        #extension GL_ARB_gpu_shader_int64 : require
        layout(local_size_x = 64) in;
        layout(std430, binding = 0) buffer Out { uint64_t o[]; };
        void main() { o[0] = 1ul << 40; }";
    let plain = "#version 450
        layout(local_size_x = 128) in;
        void main() {}";
    on_each(|session, instance, info| {
        session.lie(&LEAST);
        let device = Device::open(instance, info).expect("a device");
        for glsl in [wide, long] {
            let words = compile(glsl);
            let description = corput::vulkan::PipelineDescription {
                name: "more",
                spirv: &words,
                bindings: &[0],
                push_constant_bytes: 0,
                specialization: &[],
            };
            let error = corput::vulkan::Pipeline::new(&device, &description).expect_err("more");
            assert_failed(
                &error,
                "vkCreateShaderModule",
                "ERROR_INVALID_SHADER_NV",
                "corput devices",
            );
        }
        pipeline(&device, &compile(plain), &[], 0);
    });
}

/// Opening under a lie: refused, and the text names both numbers.
fn refused(
    session: &Session,
    instance: &Arc<Instance>,
    info: &DeviceInfo,
    lie: Lie,
    parts: &[&str],
) {
    session.lie(&[lie]);
    let before = session.live();
    let listed = instance.devices().expect("a list");
    let error = Device::open(instance, &listed[info.index]).expect_err(parts[0]);
    assert!(session.fired() > 0);
    assert!(matches!(error, Error::InadequateDevice { .. }), "{error}");
    assert_eq!((error.exit_code(), session.live()), (3, before));
    let text = error.to_string();
    for part in parts
        .iter()
        .chain(&[info.name.as_str(), "choose another device"])
    {
        assert!(text.contains(part), "no `{part}` in: {text}");
    }
}

#[test]
fn less_than_vulkan_guarantees_is_refused_at_once() {
    on_each(|session, instance, info| {
        let refused = |lie, parts: &[&str]| refused(session, instance, info, lie, parts);
        refused(
            Lie::Properties(|said| said.limits.max_storage_buffer_range = 1 << 16),
            &[
                "bytes of a storage buffer",
                "it has 65536",
                "134217728 are needed",
            ],
        );
        refused(
            Lie::Properties(|said| said.limits.max_storage_buffer_range = (1 << 27) - 1),
            &[
                "bytes of a storage buffer",
                "it has 134217727",
                "134217728 are needed",
            ],
        );
        refused(
            Lie::Properties(|said| said.limits.max_push_constants_size = 124),
            &["bytes of push constants", "it has 124", "128 are needed"],
        );
        refused(
            Lie::Properties(|said| said.limits.max_push_constants_size = 0),
            &["bytes of push constants", "it has 0", "128 are needed"],
        );
        refused(
            Lie::Properties(|said| said.limits.max_compute_work_group_invocations = 127),
            &["invocations in a group", "it has 127", "128 are needed"],
        );
        refused(
            Lie::Properties(|said| said.limits.max_compute_work_group_size[0] = 64),
            &["x axis", "it has 64", "128 are needed"],
        );
        refused(
            Lie::Properties(|said| said.limits.max_compute_work_group_count[0] = 64),
            &["groups on the x axis", "it has 64", "65535 are needed"],
        );
        refused(
            Lie::Properties(|said| said.limits.max_compute_work_group_count[1] = 1),
            &["groups on the y axis", "it has 1", "65535 are needed"],
        );
        refused(
            Lie::Properties(|said| said.limits.max_per_stage_descriptor_storage_buffers = 3),
            &["storage buffers", "it has 3", "4 are needed"],
        );
        refused(
            Lie::Properties(|said| said.api_version = vk::API_VERSION_1_0),
            &["Vulkan 1.0", "1.1 is needed"],
        );
        refused(
            Lie::Family(|said| said.queue_flags &= !vk::QueueFlags::COMPUTE),
            &["it has no compute queue"],
        );
        refused(
            Lie::Family(|said| said.queue_count = 0),
            &["it has no compute queue"],
        );
    });
}

/// Odd clocks change how the work is cut, and nothing else.
#[test]
fn odd_clocks_change_no_answer() {
    let clocks = [
        Lie::Properties(|said| said.limits.timestamp_period = 0.0),
        Lie::Properties(|said| said.limits.timestamp_period = f32::NAN),
        Lie::Properties(|said| said.limits.timestamp_period = 1e-9),
        Lie::Family(|said| said.timestamp_valid_bits = 36),
        Lie::Family(|said| said.timestamp_valid_bits = 1),
        Lie::Family(|said| said.timestamp_valid_bits = 255),
    ];
    on_each(|session, instance, info| {
        for clock in clocks {
            session.lie(&[clock]);
            let device = Device::open(instance, info).expect("a device");
            generate(&device).expect("points");
            estimate(&device).expect("sums");
            assert!(session.fired() > 0);
        }
    });
}
