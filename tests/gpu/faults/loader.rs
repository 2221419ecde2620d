//! A loader that wraps the system's: the functions that others stand in for, and the rest
//! as they are.

use std::ffi::{CStr, CString, c_char};
use std::sync::{Mutex, OnceLock, PoisonError};

use corput::vulkan::ash::{Entry, StaticFn, vk};

use super::{answers, calls};

/// Any function, as loaders give it.
pub type Function = unsafe extern "system" fn();

/// Instances that are alive, the newest last.
static INSTANCES: Mutex<Vec<vk::Instance>> = Mutex::new(Vec::new());

fn system() -> &'static Entry {
    static SYSTEM: OnceLock<Entry> = OnceLock::new();
    // SAFETY: loads the system's loader.
    SYSTEM.get_or_init(|| unsafe { Entry::load() }.unwrap_or_else(|error| panic!("{error}")))
}

/// The wrapped loader.
pub fn entry() -> Entry {
    let get_instance_proc_addr = instance_function;
    let functions = StaticFn {
        get_instance_proc_addr,
    };
    // SAFETY: the function answers as the loader does, which is never unloaded.
    unsafe { Entry::from_static_fn(functions) }
}

pub fn remember(instance: vk::Instance) {
    let mut all = INSTANCES.lock().unwrap_or_else(PoisonError::into_inner);
    all.push(instance);
}

pub fn forget(instance: vk::Instance) {
    let mut all = INSTANCES.lock().unwrap_or_else(PoisonError::into_inner);
    all.retain(|one| *one != instance);
}

/// The loader's function of this name. What it gives for an instance goes by the handles in
/// the call, so that any instance alive serves.
///
/// # Safety
/// `F` is the type of the function.
pub unsafe fn real<F: Copy>(name: &str) -> F {
    assert_eq!(size_of::<F>(), size_of::<Function>());
    let text = CString::new(name).expect("a name");
    let all = INSTANCES.lock().unwrap_or_else(PoisonError::into_inner);
    let newest = all.last().copied().unwrap_or_default();
    let of = |instance| ask(instance, text.as_ptr());
    let found = of(newest).or_else(|| of(vk::Instance::null()));
    let found = found.unwrap_or_else(|| panic!("the loader has no {name}"));
    // SAFETY: both are pointers to functions, and the caller vouches for the type.
    unsafe { std::mem::transmute_copy(&found) }
}

fn ask(instance: vk::Instance, name: *const c_char) -> vk::PFN_vkVoidFunction {
    // SAFETY: the instance is null or alive, the name ends in NUL.
    unsafe { (system().static_fn().get_instance_proc_addr)(instance, name) }
}

unsafe extern "system" fn instance_function(
    instance: vk::Instance,
    name: *const c_char,
) -> vk::PFN_vkVoidFunction {
    // SAFETY: the caller's, and it ends in NUL.
    let text = unsafe { CStr::from_ptr(name) };
    if text == c"vkGetDeviceProcAddr" {
        let function: vk::PFN_vkGetDeviceProcAddr = device_function;
        // SAFETY: who asks by this name calls it by this type.
        return Some(unsafe {
            std::mem::transmute::<vk::PFN_vkGetDeviceProcAddr, Function>(function)
        });
    }
    stand_in(text).or_else(|| ask(instance, name))
}

unsafe extern "system" fn device_function(
    device: vk::Device,
    name: *const c_char,
) -> vk::PFN_vkVoidFunction {
    // SAFETY: the caller's, and it ends in NUL.
    let text = unsafe { CStr::from_ptr(name) };
    stand_in(text).or_else(|| {
        // SAFETY: the caller vouches for the arguments.
        unsafe { real::<vk::PFN_vkGetDeviceProcAddr>("vkGetDeviceProcAddr")(device, name) }
    })
}

fn stand_in(name: &CStr) -> vk::PFN_vkVoidFunction {
    calls::find(name).or_else(|| answers::find(name))
}
