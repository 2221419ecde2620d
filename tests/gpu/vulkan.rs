//! The Vulkan host on every device present, under validation.

#[path = "vulkan/batch.rs"]
mod batch;
#[path = "support.rs"]
mod support;

use std::sync::Arc;
use std::time::Duration;

use corput::Error;
use corput::vulkan::ash::vk;
use corput::vulkan::{
    Access, Buffer, DescriptorSet, Device, Instance, InstanceOptions, Pipeline,
    PipelineDescription, Probe, ProbeGroup, ProbeSample, UNIFORM_BYTES, barrier, probe, record,
    select,
};
use support::{compile, on_each_device, pipeline, shader, words};

const ACCESSES: [Access; 3] = [Access::Upload, Access::Readback, Access::DeviceOnly];

const OUT: &str = "layout(std430, binding = 0) buffer Out { uint o[]; };";

fn add_one() -> Vec<u32> {
    shader(OUT, "if (i < uint(o.length())) o[i] += 1u;")
}

#[test]
fn device_info_is_plausible() {
    on_each_device(|device| {
        let info = device.info();
        assert!(!info.name.is_empty());
        assert_eq!(info.device_uuid.len(), 32);
        assert!(info.api_version >= (1, 1, 0));
        assert!(info.limits.max_storage_buffer_range >= 1 << 27);
        assert!(
            info.limits
                .max_group_count
                .iter()
                .all(|count| *count >= 65_535)
        );
        assert!(info.limits.memory_bytes > 0 && info.limits.max_allocation > 0);
        assert!(info.limits.subgroup_size >= 1);
        println!("{info:#?}");
    });
}

#[test]
fn bytes_come_back_as_they_went() {
    on_each_device(|device| {
        for access in ACCESSES {
            for length in [1u64, 3, 4, 4097, 1 << 20] {
                let mut buffer = Buffer::new(device, length, access).unwrap();
                assert_eq!(buffer.bytes(), length);
                buffer.fill_zero().unwrap();
                assert!(
                    buffer
                        .read(0, length, |bytes| bytes.iter().all(|b| *b == 0))
                        .unwrap()
                );
                let data: Vec<u8> = (0..length).map(|i| (i * 7 + i / 256) as u8).collect();
                buffer.write(0, &data).unwrap();
                assert!(buffer.read(0, length, |bytes| bytes == data).unwrap());
                let half = length / 2;
                buffer.write(half, &[0xa5]).unwrap();
                let (before, at) = (half.saturating_sub(1), half as usize);
                let read = buffer
                    .read(before, length - before, <[u8]>::to_vec)
                    .unwrap();
                assert_eq!(read[at - before as usize], 0xa5);
                assert_eq!(read[at + 1 - before as usize..], data[at + 1..]);
                buffer.write(length, &[]).unwrap();
                assert!(buffer.read(length, 0, <[u8]>::is_empty).unwrap());
            }
        }
    });
}

#[test]
fn shaders_read_and_write_every_kind_of_buffer() {
    let spirv = shader(
        "layout(std430, binding = 0) readonly buffer In { uint a[]; };
         layout(std430, binding = 3) buffer Out { uint o[]; };
         layout(push_constant) uniform Push { uint factor; uint n; };",
        "if (i < n) o[i] = a[i] * factor + i;",
    );
    on_each_device(|device| {
        let pipeline = pipeline(device, &spirv, &[0, 3], 8);
        for from in ACCESSES {
            for to in ACCESSES {
                let n = 1000u32;
                let mut input = Buffer::new(device, u64::from(n) * 4, from).unwrap();
                let mut output = Buffer::new(device, u64::from(n) * 4 + 4, to).unwrap();
                output.fill_zero().unwrap();
                let data: Vec<u8> = (0..n).flat_map(|i| (i ^ 0x55).to_ne_bytes()).collect();
                for factor in [3u32, 5] {
                    input.write(0, &data).unwrap();
                    let push: Vec<u8> = [factor, n].iter().flat_map(|w| w.to_ne_bytes()).collect();
                    let buffers = [(3, &output), (0, &input)];
                    device
                        .run(&pipeline, &buffers, &push, u64::from(n.div_ceil(64)))
                        .unwrap();
                    let got = output.read(0, output.bytes(), words).unwrap();
                    for i in 0..n {
                        assert_eq!(got[i as usize], (i ^ 0x55) * factor + i);
                    }
                    assert_eq!(got[n as usize], 0, "wrote past its bound");
                }
            }
        }
    });
}

#[test]
fn more_groups_than_an_axis_holds() {
    let spirv = add_one();
    on_each_device(|device| {
        let pipeline = pipeline(device, &spirv, &[0], 0);
        for groups in [65_535u64, 65_536, 70_001, 131_071] {
            let n = groups * 64 - 5;
            let mut out = Buffer::new(device, n * 4, Access::Readback).unwrap();
            out.fill_zero().unwrap();
            device.run(&pipeline, &[(0, &out)], &[], groups).unwrap();
            device.run(&pipeline, &[(0, &out)], &[], groups).unwrap();
            assert!(
                out.read(0, n * 4, |b| words(b).iter().all(|w| *w == 2))
                    .unwrap(),
                "{groups}"
            );
        }
        let out = Buffer::new(device, 4, Access::Readback).unwrap();
        let error = device
            .run(&pipeline, &[(0, &out)], &[], u64::MAX)
            .unwrap_err();
        assert!(matches!(error, Error::Arguments { .. }), "{error}");
    });
}

#[test]
fn no_groups_do_nothing() {
    let spirv = add_one();
    on_each_device(|device| {
        let pipeline = pipeline(device, &spirv, &[0], 0);
        let mut out = Buffer::new(device, 256, Access::Readback).unwrap();
        out.fill_zero().unwrap();
        device.run(&pipeline, &[(0, &out)], &[], 0).unwrap();
        assert!(
            out.read(0, 256, |bytes| bytes.iter().all(|b| *b == 0))
                .unwrap()
        );
    });
}

#[test]
fn specialization_constants_arrive() {
    let spirv = shader(
        &format!(
            "{OUT} layout(constant_id = 0) const uint A = 1u;
             layout(constant_id = 7) const bool B = false;
             layout(constant_id = 3) const float C = 0.5;"
        ),
        "if (i == 0u) { o[0] = A; o[1] = B ? 1u : 0u; o[2] = floatBitsToUint(C); }",
    );
    on_each_device(|device| {
        let mut out = Buffer::new(device, 12, Access::Readback).unwrap();
        let mut with = |specialization: &[(u32, u32)]| {
            let description = PipelineDescription {
                name: "constants",
                spirv: &spirv,
                bindings: &[0],
                push_constant_bytes: 0,
                specialization,
            };
            let pipeline = Pipeline::new(device, &description).unwrap();
            device.run(&pipeline, &[(0, &out)], &[], 1).unwrap();
            out.read(0, 12, words).unwrap()
        };
        assert_eq!(with(&[]), [1, 0, 0x3f00_0000]);
        assert_eq!(
            with(&[(7, 1), (3, 0x4049_0fdb), (0, u32::MAX)]),
            [u32::MAX, 1, 0x4049_0fdb]
        );
        assert_eq!(with(&[(0, 9), (99, 4)]), [9, 0, 0x3f00_0000]);
    });
}

/// Once a device keeps its pipelines, others of the same words and constants are the same, even
/// after they were dropped, and from several threads; others are not.
#[test]
fn kept_pipelines_serve_again() {
    let spirv = shader(
        &format!("layout(constant_id = 0) const uint A = 0u; {OUT}"),
        "if (i < uint(o.length())) o[i] += A;",
    );
    on_each_device(|device| {
        let make = |value: u32, bindings: &[u32]| {
            let description = PipelineDescription {
                name: "kept",
                spirv: &spirv,
                bindings,
                push_constant_bytes: 0,
                specialization: &[(0, value)],
            };
            Pipeline::new(device, &description).unwrap()
        };
        let (one, other) = (make(1, &[0]), make(1, &[0]));
        assert_ne!(one.raw(), other.raw());
        device.keep_pipelines();
        let kept = make(1, &[0]).raw();
        assert_ne!(kept, one.raw());
        drop((one, other));
        // Keeping again forgets nothing.
        device.keep_pipelines();
        assert_eq!(make(1, &[0]).raw(), kept);
        assert_ne!(make(2, &[0]).raw(), kept);
        assert_ne!(make(1, &[0, 1]).raw(), kept);
        let mut buffer = Buffer::new(device, 4 * 64, Access::Readback).unwrap();
        buffer.fill_zero().unwrap();
        std::thread::scope(|scope| {
            for value in [1, 2, 3, 1, 2, 3] {
                let (make, buffer) = (&make, &buffer);
                scope.spawn(move || {
                    let pipeline = make(value, &[0]);
                    device.run(&pipeline, &[(0, buffer)], &[], 1).unwrap();
                });
            }
        });
        let sums = buffer.read(0, 4 * 64, words).unwrap();
        assert_eq!(sums, [12; 64]);
    });
}

#[test]
fn uniform_blocks_are_read_and_may_not_be_long() {
    let spirv = shader(
        &format!(
            "{OUT} layout(std140, set = 0, binding = 1) uniform Block {{ uvec4 rows[1024]; }};"
        ),
        "o[i] = rows[1023u - i][i & 3u];",
    );
    on_each_device(|device| {
        let description = PipelineDescription {
            name: "uniform",
            spirv: &spirv,
            bindings: &[0, 1],
            push_constant_bytes: 0,
            specialization: &[],
        };
        let pipeline = Pipeline::with_uniforms(device, &description, &[1]).unwrap();
        let mut out = Buffer::new(device, 256, Access::Readback).unwrap();
        let mut block = Buffer::new(device, UNIFORM_BYTES, Access::Upload).unwrap();
        let bytes: Vec<u8> = (0..UNIFORM_BYTES as u32 / 4)
            .flat_map(u32::to_ne_bytes)
            .collect();
        block.write(0, &bytes).unwrap();
        let buffers = [(0, &out), (1, &block)];
        device.run(&pipeline, &buffers, &[], 1).unwrap();
        // The same by a set of its own.
        DescriptorSet::of(device, &pipeline, &buffers).unwrap();
        let expected: Vec<u32> = (0..64).map(|i| 4 * (1023 - i) + (i & 3)).collect();
        assert_eq!(out.read(0, 256, words).unwrap(), expected);

        let long = Buffer::new(device, UNIFORM_BYTES + 16, Access::Upload).unwrap();
        let buffers = [(0, &out), (1, &long)];
        let error = device.run(&pipeline, &buffers, &[], 1).unwrap_err();
        assert!(matches!(error, Error::Shader { .. }), "{error}");
        assert!(DescriptorSet::of(device, &pipeline, &buffers).is_err());
    });
}

#[test]
fn dispatches_are_timed() {
    let spirv = shader(
        OUT,
        "uint x = i; for (uint k = 0u; k < 2000u; k++) x = x * 1664525u + k; o[i] = x;",
    );
    on_each_device(|device| {
        let pipeline = pipeline(device, &spirv, &[0], 0);
        let out = Buffer::new(device, 1 << 18, Access::Readback).unwrap();
        device.run(&pipeline, &[(0, &out)], &[], 1024).unwrap();
        let timing = device.run(&pipeline, &[(0, &out)], &[], 1024).unwrap();
        println!(
            "{timing:?}, valid bits {}",
            device.info().limits.timestamp_valid_bits
        );
        assert!(timing.host_ns > 0.0);
        let has_clock = device.info().limits.timestamp_valid_bits > 0;
        assert_eq!(timing.device_ns.is_some(), has_clock);
        if let Some(ns) = timing.device_ns {
            assert!(ns > 0.0 && ns <= timing.host_ns * 1.5, "{timing:?}");
        }
    });
}

/// Runs `fill` in a command buffer of the test's own, and waits.
fn submit(device: &Device, fill: impl FnOnce(vk::CommandBuffer)) {
    let raw = device.raw();
    // SAFETY: plain use of a device that is alive, on one thread; everything is
    // waited for before it is destroyed.
    unsafe {
        let pool = vk::CommandPoolCreateInfo::default().queue_family_index(device.queue_family());
        let pool = raw.create_command_pool(&pool, None).unwrap();
        let one = vk::CommandBufferAllocateInfo::default()
            .command_pool(pool)
            .command_buffer_count(1);
        let commands = raw.allocate_command_buffers(&one).unwrap()[0];
        raw.begin_command_buffer(commands, &vk::CommandBufferBeginInfo::default())
            .unwrap();
        fill(commands);
        raw.end_command_buffer(commands).unwrap();
        let buffers = [commands];
        let submission = [vk::SubmitInfo::default().command_buffers(&buffers)];
        raw.queue_submit(device.queue(), &submission, vk::Fence::null())
            .unwrap();
        raw.queue_wait_idle(device.queue()).unwrap();
        raw.destroy_command_pool(pool, None);
    }
}

#[test]
fn the_caller_may_record_and_submit() {
    let spirv = add_one();
    on_each_device(|device| {
        let pipeline = pipeline(device, &spirv, &[0], 0);
        let mut out = Buffer::new(device, 4096, Access::Readback).unwrap();
        out.fill_zero().unwrap();
        let whole = DescriptorSet::of(device, &pipeline, &[(0, &out)]).unwrap();
        // SAFETY: a part of a buffer that outlives the set.
        let part = unsafe { DescriptorSet::new(device, &pipeline, &[(0, out.raw(), 1024, 256)]) };
        let part = part.unwrap();
        submit(device, |commands| {
            // SAFETY: recording, and everything outlives the wait in `submit`.
            unsafe {
                record(device, commands, &pipeline, &whole, &[], 16).unwrap();
                barrier(device, commands);
                record(device, commands, &pipeline, &part, &[], 1).unwrap();
                barrier(device, commands);
                record(device, commands, &pipeline, &whole, &[], 0).unwrap();
                let error = record(device, commands, &pipeline, &whole, &[0; 4], 1).unwrap_err();
                assert!(matches!(error, Error::Shader { .. }), "{error}");
            }
        });
        let got = out.read(0, 4096, words).unwrap();
        for (i, word) in got.iter().enumerate() {
            assert_eq!(*word, if (256..320).contains(&i) { 2 } else { 1 }, "{i}");
        }
        // SAFETY: refused before the handle is used.
        let odd = unsafe { DescriptorSet::new(device, &pipeline, &[(0, out.raw(), 1, 256)]) };
        assert!(
            matches!(odd, Err(Error::Arguments { .. }))
                || device.info().limits.storage_offset_alignment == 1
        );
    });
}

#[test]
fn a_device_of_the_caller_is_left_alone() {
    let spirv = add_one();
    on_each_device(|device| {
        // SAFETY: loads the system's loader.
        let entry = unsafe { corput::vulkan::ash::Entry::load() }.unwrap();
        // SAFETY: the handles belong together and outlive the wrapper.
        let wrapped = unsafe {
            Device::from_existing(
                &entry,
                device.instance().raw(),
                device.physical(),
                device.raw().clone(),
                device.queue(),
                device.queue_family(),
            )
        };
        let wrapped = wrapped.unwrap();
        assert_eq!(wrapped.info(), device.info());
        for device in [&wrapped, device] {
            let pipeline = pipeline(device, &spirv, &[0], 0);
            let mut out = Buffer::new(device, 256, Access::Readback).unwrap();
            out.fill_zero().unwrap();
            device.run(&pipeline, &[(0, &out)], &[], 1).unwrap();
            assert!(
                out.read(0, 256, |b| words(b).iter().all(|w| *w == 1))
                    .unwrap()
            );
        }
        let ours = pipeline(device, &spirv, &[0], 0);
        let theirs = Buffer::new(&wrapped, 256, Access::Readback).unwrap();
        let mixed = device.run(&ours, &[(0, &theirs)], &[], 1).unwrap_err();
        assert!(matches!(mixed, Error::Arguments { .. }), "{mixed}");
        drop(theirs);
        drop(wrapped);
        let out = Buffer::new(device, 256, Access::Readback).unwrap();
        device.run(&ours, &[(0, &out)], &[], 1).unwrap();
    });
}

#[test]
fn impossible_requests_are_typed_errors() {
    let spirv = add_one();
    on_each_device(|device| {
        let limits = &device.info().limits;
        for bytes in [0, limits.max_storage_buffer_range + 1, u64::MAX] {
            let error = Buffer::new(device, bytes, Access::Upload).unwrap_err();
            assert!(matches!(error, Error::Arguments { .. }), "{bytes}: {error}");
        }
        let mut buffer = Buffer::new(device, 10, Access::Upload).unwrap();
        for (offset, length) in [(0, 11usize), (10, 1), (11, 0), (u64::MAX, 2)] {
            let error = buffer.write(offset, &vec![0; length]).unwrap_err();
            assert!(matches!(error, Error::Arguments { .. }), "{error}");
            let error = buffer.read(offset, length as u64, |_| ()).unwrap_err();
            assert!(matches!(error, Error::Arguments { .. }), "{error}");
        }

        let good = PipelineDescription {
            name: "odd",
            spirv: &spirv,
            bindings: &[0],
            push_constant_bytes: 0,
            specialization: &[],
        };
        let many: Vec<u32> = (0..limits.max_storage_buffers.min(100) + 1).collect();
        let refused = |description: &PipelineDescription<'_>| {
            Pipeline::new(device, description).unwrap_err().exit_code()
        };
        assert_eq!(refused(&PipelineDescription { spirv: &[], ..good }), 4);
        assert_eq!(
            refused(&PipelineDescription {
                spirv: &[1, 2, 3, 4, 5, 6],
                ..good
            }),
            4
        );
        assert_eq!(
            refused(&PipelineDescription {
                bindings: &[0, 1, 0],
                ..good
            }),
            4
        );
        assert_eq!(
            refused(&PipelineDescription {
                specialization: &[(1, 0), (1, 1)],
                ..good
            }),
            4
        );
        assert_eq!(
            refused(&PipelineDescription {
                push_constant_bytes: 3,
                ..good
            }),
            4
        );
        assert_eq!(
            refused(&PipelineDescription {
                push_constant_bytes: 1 << 20,
                ..good
            }),
            3
        );
        assert_eq!(
            refused(&PipelineDescription {
                bindings: &many,
                ..good
            }),
            3
        );

        let pipeline = Pipeline::new(device, &good).unwrap();
        let wrong = |buffers: &[(u32, &Buffer)], push: &[u8]| {
            let error = device.run(&pipeline, buffers, push, 1).unwrap_err();
            assert!(matches!(error, Error::Shader { .. }), "{error}");
        };
        wrong(&[], &[]);
        wrong(&[(1, &buffer)], &[]);
        wrong(&[(0, &buffer), (0, &buffer)], &[]);
        wrong(&[(0, &buffer)], &[0; 4]);
    });
}

#[test]
fn a_timeout_is_typed_and_can_be_waited_out() {
    let spirv = shader(
        OUT,
        "uint x = i; for (uint k = 0u; k < 200000u; k++) x = x * 1664525u + k; o[i] = x | 1u;",
    );
    on_each_device(|device| {
        let pipeline = pipeline(device, &spirv, &[0], 0);
        let mut out = Buffer::new(device, 1 << 16, Access::Readback).unwrap();
        out.fill_zero().unwrap();
        let patience = device.wait_limit();
        device.set_wait_limit(Duration::ZERO);
        let error = device.run(&pipeline, &[(0, &out)], &[], 256).unwrap_err();
        assert!(matches!(error, Error::Timeout { .. }), "{error}");
        assert_eq!(error.exit_code(), 4);
        device.set_wait_limit(patience);
        assert!(
            out.read(0, 1 << 16, |b| words(b).iter().all(|w| w & 1 == 1))
                .unwrap()
        );
        device.run(&pipeline, &[(0, &out)], &[], 1).unwrap();
    });
}

#[test]
fn threads_take_turns_and_drop_order_is_free() {
    let spirv = add_one();
    on_each_device(|device| {
        std::thread::scope(|scope| {
            for _ in 0..3 {
                scope.spawn(|| {
                    let pipeline = pipeline(device, &spirv, &[0], 0);
                    for access in ACCESSES {
                        let mut out = Buffer::new(device, 4096, access).unwrap();
                        out.fill_zero().unwrap();
                        for _ in 0..20 {
                            device.run(&pipeline, &[(0, &out)], &[], 16).unwrap();
                        }
                        assert!(
                            out.read(0, 4096, |b| words(b).iter().all(|w| *w == 20))
                                .unwrap()
                        );
                    }
                });
            }
        });
        let other = Device::open(device.instance(), device.info()).unwrap();
        let pipeline = pipeline(&other, &spirv, &[0], 0);
        let buffer = Buffer::new(&other, 64, Access::DeviceOnly).unwrap();
        let set = DescriptorSet::of(&other, &pipeline, &[(0, &buffer)]).unwrap();
        drop(other);
        drop(buffer);
        drop(pipeline);
        drop(set);
    });
}

fn run_probe(device: &Arc<Device>) -> Probe {
    probe(
        device,
        &compile(include_str!("../../shaders/kernels/probe.comp")),
    )
    .unwrap()
}

#[test]
fn the_probe_trusts_what_is_conformant() {
    on_each_device(|device| {
        let probe = run_probe(device);
        let odd: Vec<_> = probe
            .samples
            .iter()
            .filter(|sample| !sample.is_expected())
            .collect();
        for ProbeSample {
            group,
            name,
            got,
            expected,
        } in odd.iter().take(40)
        {
            println!("{group:?}: {name} = 0x{got:08x}, not 0x{expected:08x}");
        }
        println!(
            "{:?}",
            Probe {
                samples: Vec::new(),
                ..probe.clone()
            }
        );
        assert!(probe.tier_i(), "shifts or conversions are wrong");
        assert!(probe.operations > 4000);
        assert!(
            probe
                .samples
                .iter()
                .any(|sample| sample.group == ProbeGroup::Reassociation)
        );
        assert_eq!(run_probe(device), probe, "the probe is repeatable");
        if device.info().float_controls.rte || device.info().driver_name.contains("llvmpipe") {
            assert!(probe.tier_f());
        }
    });
}

#[test]
fn the_probe_sees_fusion_on_a_device() {
    // The same shader, told to fuse where the device can.
    let fused = include_str!("../../shaders/kernels/probe.comp").replacen(
        "precise float sum = product + z;",
        "precise float sum = float(fma(double(x), double(y), double(z)));",
        1,
    );
    let spirv = compile(&fused);
    on_each_device(|device| {
        if !device.info().features.float64 {
            println!("{} has no doubles", device.info().name);
            return;
        }
        // Doubles are a feature that this crate never enables, so the module is
        // run on a device of the test's own.
        let instance = device.instance().raw();
        let features = vk::PhysicalDeviceFeatures::default().shader_float64(true);
        let queues = [vk::DeviceQueueCreateInfo::default()
            .queue_family_index(device.queue_family())
            .queue_priorities(&[1.0])];
        let create = vk::DeviceCreateInfo::default()
            .queue_create_infos(&queues)
            .enabled_features(&features);
        // SAFETY: plain use of handles that are alive; the device is destroyed
        // after all that was made from it.
        unsafe {
            let raw = instance
                .create_device(device.physical(), &create, None)
                .unwrap();
            let queue = raw.get_device_queue(device.queue_family(), 0);
            let entry = corput::vulkan::ash::Entry::load().unwrap();
            let (physical, family) = (device.physical(), device.queue_family());
            let own = Device::from_existing(&entry, instance, physical, raw.clone(), queue, family);
            let found = probe(&own.unwrap(), &spirv).unwrap();
            raw.destroy_device(None);
            assert!(found.contracts && !found.tier_f(), "{found:?}");
        }
    });
}

#[test]
fn selection_works_on_the_real_list() {
    if support::skips() {
        return;
    }
    let instance = Instance::new(&InstanceOptions::default()).unwrap();
    let devices = instance.devices().unwrap();
    let chosen = select(&devices, None).unwrap();
    assert_eq!(
        select(&devices, Some(&chosen.index.to_string())).unwrap(),
        chosen
    );
    let error = select(&devices, Some("no such thing")).unwrap_err();
    assert!(
        error
            .to_string()
            .contains(&format!("0: `{}`", devices[0].name)),
        "{error}"
    );
    assert!(instance.take_validation_messages().is_empty());
}

#[test]
fn validation_speaks_up() {
    if support::skips() {
        return;
    }
    let turn = support::turn();
    let instance = support::instance(&turn);
    if !instance.is_validating() {
        eprintln!("SKIPPED: CORPUT_SKIP_VALIDATION=1");
        return;
    }
    let devices = instance.devices().unwrap();
    let device = Device::open(&instance, select(&devices, None).unwrap()).unwrap();
    assert_eq!(instance.take_validation_messages(), [""; 0]);

    let invalid = vk::BufferCreateInfo::default().usage(vk::BufferUsageFlags::STORAGE_BUFFER);
    // SAFETY: a size of 0 is invalid, which drivers here survive; that is the test.
    unsafe {
        let made = device.raw().create_buffer(&invalid, None);
        device.raw().destroy_buffer(made.unwrap_or_default(), None);
    }
    let said = instance.take_validation_messages();
    assert!(
        said.iter()
            .any(|text| text.contains("VUID-VkBufferCreateInfo-size")),
        "{said:#?}"
    );

    // A reader after a writer, without a barrier: only synchronisation validation
    // sees that. (Two writers it lets pass: it cannot know what they write.)
    let writer = pipeline(&device, &add_one(), &[0], 0);
    let copy = "layout(std430, binding = 0) readonly buffer In { uint a[]; };
        layout(std430, binding = 1) buffer Out { uint o[]; };";
    let reader = pipeline(&device, &shader(copy, "o[i] = a[i];"), &[0, 1], 0);
    let first = Buffer::new(&device, 256, Access::DeviceOnly).unwrap();
    let second = Buffer::new(&device, 256, Access::DeviceOnly).unwrap();
    let write = DescriptorSet::of(&device, &writer, &[(0, &first)]).unwrap();
    let read = DescriptorSet::of(&device, &reader, &[(0, &first), (1, &second)]).unwrap();
    let both = |ordered: bool| {
        submit(&device, |commands| {
            // SAFETY: recording, and everything outlives the wait in `submit`. Not
            // ordered it is a race on the device, which drivers here survive.
            unsafe {
                record(&device, commands, &writer, &write, &[], 1).unwrap();
                if ordered {
                    barrier(&device, commands);
                }
                record(&device, commands, &reader, &read, &[], 1).unwrap();
            }
        });
    };
    both(true);
    assert_eq!(instance.take_validation_messages(), [""; 0]);
    both(false);
    let said = instance.take_validation_messages();
    assert!(
        said.iter().any(|text| text.contains("SYNC-HAZARD")),
        "{said:#?}"
    );
    assert!(instance.take_validation_messages().is_empty());
}

#[test]
fn no_driver_is_a_stated_failure() {
    if support::skips() {
        return;
    }
    // The loader reads its environment once, so a process of its own.
    let child = std::process::Command::new(std::env::current_exe().unwrap())
        .args([
            "--exact",
            "child_without_driver",
            "--ignored",
            "--nocapture",
        ])
        .env("VK_DRIVER_FILES", "/nonexistent/icd.json")
        .env("VK_ICD_FILENAMES", "/nonexistent/icd.json")
        .output()
        .unwrap();
    let said = String::from_utf8_lossy(&child.stdout);
    assert!(
        child.status.success() && said.contains("1 passed"),
        "{said}"
    );
}

#[test]
#[ignore = "run by no_driver_is_a_stated_failure, without a driver"]
fn child_without_driver() {
    let chosen = Instance::new(&InstanceOptions::default())
        .and_then(|instance| instance.devices())
        .and_then(|devices| select(&devices, None).cloned());
    let error = chosen.unwrap_err();
    println!("{error}");
    assert!(matches!(error, Error::NoDevice { .. }));
    assert_eq!(error.exit_code(), 3);
}
