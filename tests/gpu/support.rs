//! What the tests on devices share.

#![allow(dead_code, reason = "each test uses a part of it")]

use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, OnceLock, PoisonError};

use corput::interface::Kernel;
use corput::vulkan::{
    Device, DeviceInfo, Instance, InstanceOptions, Pipeline, PipelineDescription,
};
use corput::{Error, headers};

/// Compiles GLSL for a stock kernel's target.
pub fn compile(glsl: &str) -> Vec<u32> {
    use glslang::{CompilerOptions, ShaderInput, ShaderSource, ShaderStage, SpirvVersion, Target};
    let options = CompilerOptions {
        target: Target::Vulkan {
            version: glslang::VulkanVersion::Vulkan1_1,
            spirv_version: SpirvVersion::SPIRV1_3,
        },
        ..CompilerOptions::default()
    };
    let compiler = glslang::Compiler::acquire().expect("glslang starts");
    let source = ShaderSource::from(glsl.to_owned());
    let none: Option<&[(&str, Option<&str>)]> = None;
    let input = ShaderInput::new(&source, ShaderStage::Compute, &options, none, None);
    let shader = compiler.create_shader(input.expect("a shader input"));
    shader
        .and_then(|shader| shader.compile())
        .unwrap_or_else(|error| panic!("{error}\n{glsl}"))
}

/// A stock kernel's SPIR-V, checked, with an edit of its source.
pub fn edited(kernel: &Kernel, edit: impl Fn(String) -> String) -> Vec<u32> {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("shaders/kernels");
    let mut read = |name: &str| {
        let header = headers().iter().find(|(header, _)| *header == name);
        match header {
            Some((_, text)) => Some((*text).to_owned()),
            None if name == "interface.glsl" => Some(kernel.glsl()),
            None => std::fs::read_to_string(folder.join(name)).ok(),
        }
    };
    let source = edit(read(kernel.source).expect("the kernel's source"));
    let words = corput::compile::to_spirv(&source, kernel.defines, &mut read).expect("SPIR-V");
    corput::compile::check(&words, kernel.profile).expect("a clean module")
}

/// A shader of 64 invocations a group, with `i` the invocation's number.
pub fn shader(declarations: &str, body: &str) -> Vec<u32> {
    compile(&format!(
        "#version 450
        layout(local_size_x = 64) in;
        {declarations}
        void main() {{
            uint i = (gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * 64u
                + gl_LocalInvocationID.x;
            {body}
        }}"
    ))
}

/// A test's turn at the validation layer, until it is dropped.
pub struct Turn(#[allow(dead_code, reason = "held")] MutexGuard<'static, ()>);

/// Waits until no other test of this process has a device. The layer (1.3.239) finds its data
/// of an instance or a device in one map without a lock, in every call: where one test made or
/// destroyed a device while another was calling, one process in hundreds crashed. Threads of
/// one test may share its devices.
pub fn turn() -> Turn {
    static ONE: Mutex<()> = Mutex::new(());
    Turn(ONE.lock().unwrap_or_else(PoisonError::into_inner))
}

/// An instance with validation; without only if `CORPUT_SKIP_VALIDATION=1`.
pub fn instance(_: &Turn) -> Arc<Instance> {
    // The loader unloads drivers with its last instance, while threads of theirs may still be
    // ending: one run in hundreds crashed. One instance is therefore never closed.
    static OPEN: OnceLock<Option<Arc<Instance>>> = OnceLock::new();
    OPEN.get_or_init(|| Instance::new(&InstanceOptions::default()).ok());
    let validation = validates();
    Instance::new(&InstanceOptions { validation }).unwrap_or_else(|error| panic!("{error}"))
}

/// Whether tests run under the validation layer.
pub fn validates() -> bool {
    !is_set("CORPUT_SKIP_VALIDATION")
}

/// Calls `test` with every device present, and fails on validation messages.
/// No device is a failure, unless `CORPUT_SKIP_GPU=1`.
pub fn on_each_device(test: impl Fn(&Arc<Device>)) {
    if skips() {
        return;
    }
    let turn = turn();
    let instance = instance(&turn);
    let devices = instance.devices().expect("a list of devices");
    assert!(
        !devices.is_empty(),
        "{}",
        Error::NoDevice {
            reason: "none listed".to_owned()
        }
    );
    if let Some(least) = std::env::var_os("CORPUT_DRIVERS") {
        let least: Option<usize> = least.to_str().and_then(|least| least.parse().ok());
        let least = least.expect("CORPUT_DRIVERS is a number of devices");
        let found = devices.len();
        assert!(found >= least, "{found} devices, CORPUT_DRIVERS={least}");
    }
    for info in &devices {
        on_device(&instance, info, &test);
    }
}

/// Calls `test` with lavapipe, or with the first device where there is none.
pub fn on_one_device(test: impl Fn(&Arc<Device>)) {
    if skips() {
        return;
    }
    let turn = turn();
    let instance = instance(&turn);
    let devices = instance.devices().expect("a list of devices");
    let lavapipe = devices.iter().find(|info| info.name.contains("llvmpipe"));
    let info = lavapipe.or(devices.first()).unwrap_or_else(|| {
        let reason = "none listed".to_owned();
        panic!("{}", Error::NoDevice { reason })
    });
    on_device(&instance, info, test);
}

fn on_device(instance: &Arc<Instance>, info: &DeviceInfo, test: impl Fn(&Arc<Device>)) {
    println!("on {}: {} ({})", info.index, info.name, info.driver_info);
    let device = Device::open(instance, info).unwrap_or_else(|error| panic!("{error}"));
    test(&device);
    drop(device);
    let said = instance.take_validation_messages();
    assert!(said.is_empty(), "validation on {}: {said:#?}", info.name);
}

/// Calls `test` with every item, on as many threads as there are cores: what drivers and
/// references compute on one.
pub fn at_once<T: Sync>(items: &[T], test: impl Fn(&T) + Sync) {
    let next = AtomicUsize::new(0);
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    std::thread::scope(|scope| {
        for _ in 0..threads {
            scope.spawn(|| {
                while let Some(item) = items.get(next.fetch_add(1, Ordering::Relaxed)) {
                    test(item);
                }
            });
        }
    });
}

/// Whether tests on devices are to be skipped, which is said aloud.
pub fn skips() -> bool {
    let skip = is_set("CORPUT_SKIP_GPU");
    if skip {
        eprintln!("SKIPPED: CORPUT_SKIP_GPU=1");
    }
    skip
}

/// A pipeline without specialization constants.
pub fn pipeline(device: &Arc<Device>, spirv: &[u32], bindings: &[u32], push: u32) -> Pipeline {
    let description = PipelineDescription {
        name: "test",
        spirv,
        bindings,
        push_constant_bytes: push,
        specialization: &[],
    };
    Pipeline::new(device, &description).unwrap_or_else(|error| panic!("{error}"))
}

/// The bytes as words.
pub fn words(bytes: &[u8]) -> Vec<u32> {
    bytes
        .as_chunks::<4>()
        .0
        .iter()
        .map(|word| u32::from_ne_bytes(*word))
        .collect()
}

fn is_set(variable: &str) -> bool {
    std::env::var_os(variable).is_some_and(|value| value == "1")
}
