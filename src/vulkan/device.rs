//! An open device with one compute queue.

use ash::vk;
use std::ffi::CStr;
use std::fmt;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::{Arc, Mutex, OnceLock, PoisonError};
use std::time::Duration;

use super::baseline::{check_baseline, inadequate};
use super::import::Import;
use super::info::DeviceInfo;
use super::instance::Instance;
use super::kept::Kept;
use super::orphan::Orphan;
use super::submission::Stranded;
use super::submit::Lane;
use super::{WAIT_SECONDS, failed, query, refused};
use crate::error::{Error, Result};

/// An open device with one compute queue. Buffers and pipelines hold an `Arc`
/// of it, so they may be dropped in any order.
///
/// Any thread may use it; submissions take turns.
pub struct Device {
    raw: ash::Device,
    info: DeviceInfo,
    physical: vk::PhysicalDevice,
    queue: vk::Queue,
    family: u32,
    pub(super) memory: vk::PhysicalDeviceMemoryProperties,
    pub(super) non_coherent_atom: u64,
    /// How memory of the host becomes that of a buffer, where it can.
    pub(super) import: Option<Import>,
    pub(super) lane: Mutex<Lane>,
    /// Held while something is handed to the queue, and no longer.
    pub(super) handing_over: Mutex<()>,
    /// Compiled pipelines, if they are kept.
    pub(super) kept: Mutex<Option<Kept>>,
    /// A wait has ended before its work, which may still be running.
    pub(super) hung: AtomicBool,
    /// Objects that were dropped meanwhile.
    pub(super) orphans: Mutex<Vec<Orphan>>,
    /// Submissions that were dropped although their work had not ended.
    pub(super) stranded: Mutex<Vec<Stranded>>,
    /// The call that said that the device was lost.
    lost: OnceLock<&'static str>,
    /// Nanoseconds.
    wait_limit: AtomicU64,
    /// Nanoseconds that the driver took to make pipelines.
    pub(super) pipelines: AtomicU64,
    owned: bool,
    instance: Arc<Instance>,
}

impl Device {
    /// Opens a device that [`Instance::devices`] listed, of the optional features with 64-bit
    /// integers alone, and with `VK_EXT_external_memory_host`, for [`FileWindow`], where it has them.
    ///
    /// [`FileWindow`]: super::FileWindow
    ///
    /// # Errors
    /// [`Error::InadequateDevice`] when it lacks a compute queue or the baseline,
    /// all of which Vulkan 1.1 guarantees: 4 storage buffers of 2^27 bytes, 128
    /// invocations in a group, 65535 groups on an axis, 128 bytes of push
    /// constants. [`Error::UnknownDevice`] when it has gone, [`Error::Vulkan`] when
    /// the driver fails.
    pub fn open(instance: &Arc<Instance>, info: &DeviceInfo) -> Result<Arc<Self>> {
        let (physical, info) = find(instance, info)?;
        check_baseline(&info)?;
        let (family, _) = query::compute_family(instance.raw(), physical)
            .ok_or_else(|| inadequate(&info, "it has no compute queue"))?;

        let mut extensions = Vec::new();
        // Must be enabled where it is offered (drivers such as MoltenVK).
        let subset: &CStr = ash::khr::portability_subset::NAME;
        let offered = query::extensions(instance.raw(), physical)?;
        if offered
            .iter()
            .any(|e| e.extension_name_as_c_str() == Ok(subset))
        {
            extensions.push(subset.as_ptr());
        }
        if info.features.external_memory_host {
            extensions.push(ash::ext::external_memory_host::NAME.as_ptr());
        }
        let queues = [vk::DeviceQueueCreateInfo::default()
            .queue_family_index(family)
            .queue_priorities(&[1.0])];
        let features = vk::PhysicalDeviceFeatures::default().shader_int64(true);
        let mut create = vk::DeviceCreateInfo::default()
            .queue_create_infos(&queues)
            .enabled_extension_names(&extensions);
        if info.features.int64 {
            create = create.enabled_features(&features);
        }
        // SAFETY: `physical` belongs to the instance, and `create` and what it
        // points to live until the call returns.
        let raw = unsafe { instance.raw().create_device(physical, &create, None) }
            .map_err(failed("vkCreateDevice"))?;
        // SAFETY: the device was made with one queue of this family.
        let queue = unsafe { raw.get_device_queue(family, 0) };
        Self::assemble(
            Arc::clone(instance),
            raw,
            info,
            physical,
            queue,
            family,
            true,
        )
    }

    /// Wraps a device that the caller owns. Dropping the wrapper destroys what
    /// the wrapper made, and neither the device nor the instance. Whichever extensions it has,
    /// none is used.
    ///
    /// # Errors
    /// As for [`Device::open`], and [`Error::Arguments`] for a family that the device
    /// lacks or that cannot compute.
    ///
    /// # Safety
    /// - The handles belong together, `queue` is of family `family` of `device`,
    ///   and all are alive until the wrapper and all that was made from it have
    ///   been dropped.
    /// - Instance and device are of Vulkan 1.1 at least.
    /// - While a method of the wrapper runs, no other thread uses `queue`.
    pub unsafe fn from_existing(
        entry: &ash::Entry,
        instance: &ash::Instance,
        physical: vk::PhysicalDevice,
        device: ash::Device,
        queue: vk::Queue,
        family: u32,
    ) -> Result<Arc<Self>> {
        let instance = Instance::borrowed(entry, instance);
        let listed = instance.physical_devices()?;
        let index = listed.iter().position(|one| *one == physical).unwrap_or(0);
        let mut info = query::device_info(instance.raw(), physical, index)?;
        check_baseline(&info)?;
        // SAFETY: the caller vouches for the handles.
        let families = unsafe {
            instance
                .raw()
                .get_physical_device_queue_family_properties(physical)
        };
        let computing: Vec<_> = (0u32..)
            .zip(&families)
            .filter(|(_, family)| family.queue_flags.contains(vk::QueueFlags::COMPUTE))
            .collect();
        let Some((_, family_properties)) = computing.iter().find(|(index, _)| *index == family)
        else {
            let computing: Vec<u32> = computing.iter().map(|(index, _)| *index).collect();
            return Err(refused(
                format!("queue family {family} of device {}", info.name),
                format!(
                    "of its {} families {computing:?} can compute",
                    families.len()
                ),
                "give a queue of one that computes, and its family",
            ));
        };
        info.limits.timestamp_valid_bits = family_properties.timestamp_valid_bits;
        Self::assemble(instance, device, info, physical, queue, family, false)
    }

    fn assemble(
        instance: Arc<Instance>,
        raw: ash::Device,
        info: DeviceInfo,
        physical: vk::PhysicalDevice,
        queue: vk::Queue,
        family: u32,
        owned: bool,
    ) -> Result<Arc<Self>> {
        // SAFETY: `physical` belongs to the instance, which is alive.
        let (memory, properties) = unsafe {
            (
                instance
                    .raw()
                    .get_physical_device_memory_properties(physical),
                instance.raw().get_physical_device_properties(physical),
            )
        };
        // Only here is it known to be enabled.
        let import = (owned && info.features.external_memory_host)
            .then(|| Import::of(instance.raw(), &raw, physical));
        let device = Self {
            raw,
            import,
            physical,
            queue,
            family,
            memory,
            non_coherent_atom: properties.limits.non_coherent_atom_size.max(1),
            lane: Mutex::default(),
            handing_over: Mutex::default(),
            kept: Mutex::default(),
            hung: AtomicBool::new(false),
            orphans: Mutex::default(),
            stranded: Mutex::default(),
            lost: OnceLock::new(),
            wait_limit: AtomicU64::new(nanoseconds(Duration::from_secs(WAIT_SECONDS))),
            pipelines: AtomicU64::new(0),
            owned,
            instance,
            info,
        };
        // From here on, dropping `device` destroys it.
        let lane = Lane::new(&device)?;
        *device.lane.lock().unwrap_or_else(PoisonError::into_inner) = lane;
        Ok(Arc::new(device))
    }

    /// What the device said about itself.
    #[must_use]
    pub fn info(&self) -> &DeviceInfo {
        &self.info
    }

    /// The device's handle and functions.
    #[must_use]
    pub fn raw(&self) -> &ash::Device {
        &self.raw
    }

    /// The instance that the device came from.
    #[must_use]
    pub fn instance(&self) -> &Arc<Instance> {
        &self.instance
    }

    /// How long the driver took to make all pipelines so far, of modules and layouts. Drivers may
    /// put compiling off until a pipeline is first dispatched, which is not part of it.
    #[must_use]
    pub fn pipeline_time(&self) -> Duration {
        Duration::from_nanos(self.pipelines.load(Ordering::Relaxed))
    }

    /// The physical device.
    #[must_use]
    pub fn physical(&self) -> vk::PhysicalDevice {
        self.physical
    }

    /// The compute queue. Submitting to it needs the same care as any
    /// `VkQueue`: no two threads at a time, the methods here included.
    #[must_use]
    pub fn queue(&self) -> vk::Queue {
        self.queue
    }

    /// Whether shaders may use integers of 64 bits: where [`Device::open`] found them. Of a
    /// device of the caller's nobody knows what was enabled.
    #[must_use]
    pub fn has_int64(&self) -> bool {
        self.owned && self.info.features.int64
    }

    /// The family of the compute queue.
    #[must_use]
    pub fn queue_family(&self) -> u32 {
        self.family
    }

    /// Changes how long one submission may take before the wait for it ends in
    /// [`Error::Timeout`]; at first [`WAIT_SECONDS`]. After a timeout the next
    /// use of the device waits again for the same submission, and what is dropped
    /// meanwhile is destroyed once that has ended.
    pub fn set_wait_limit(&self, limit: Duration) {
        self.wait_limit.store(nanoseconds(limit), Ordering::Relaxed);
    }

    /// The wait limit.
    #[must_use]
    pub fn wait_limit(&self) -> Duration {
        Duration::from_nanos(self.wait_limit.load(Ordering::Relaxed))
    }

    /// The error of a call, which may be that the device was lost.
    pub(super) fn heard(&self, call: &'static str, code: vk::Result) -> Error {
        if code == vk::Result::ERROR_DEVICE_LOST {
            self.lost.get_or_init(|| call);
        }
        failed(call)(code)
    }

    /// An error once the device was lost: it does not come back.
    pub(super) fn check_alive(&self) -> Result<()> {
        match self.lost.get() {
            Some(call) => Err(failed(call)(vk::Result::ERROR_DEVICE_LOST)),
            None => Ok(()),
        }
    }

    /// Whether a wait has ended before its work, so that nothing may be destroyed.
    pub(super) fn is_hung(&self) -> bool {
        self.hung.load(Ordering::Acquire)
    }
}

impl Drop for Device {
    fn drop(&mut self) {
        // One look: what has ended meanwhile can be destroyed.
        self.set_wait_limit(Duration::ZERO);
        let _ = self.settle();
        if self.is_hung() {
            // Work may still be running; destroying what it uses would be
            // undefined behaviour, so it is left to the end of the process. So are mappings.
            std::mem::forget(Arc::clone(&self.instance));
            std::mem::forget(std::mem::take(&mut self.orphans));
            return;
        }
        self.destroy_orphans();
        let lane = std::mem::take(self.lane.get_mut().unwrap_or_else(PoisonError::into_inner));
        lane.destroy(&self.raw);
        let kept = self.kept.get_mut().unwrap_or_else(PoisonError::into_inner);
        for compiled in kept.take().into_iter().flat_map(|kept| kept.into_values()) {
            compiled.destroy(&self.raw);
        }
        if self.owned {
            // SAFETY: every submission was waited for, and all that was made from
            // the device held an `Arc` of it, so nothing of it is left.
            unsafe { self.raw.destroy_device(None) };
        }
    }
}

impl fmt::Debug for Device {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Device")
            .field("name", &self.info.name)
            .finish_non_exhaustive()
    }
}

/// The physical device that `wanted` describes; the loader's order may have
/// changed since it was listed.
fn find(instance: &Instance, wanted: &DeviceInfo) -> Result<(vk::PhysicalDevice, DeviceInfo)> {
    let same =
        |info: &DeviceInfo| info.device_uuid == wanted.device_uuid && info.name == wanted.name;
    let mut found = instance.listed()?;
    found.retain(|(_, info)| same(info));
    let at = found
        .iter()
        .position(|(_, info)| info.index == wanted.index)
        .unwrap_or(0);
    if found.is_empty() {
        return Err(Error::UnknownDevice {
            asked: wanted.name.clone(),
            present: "it has gone since it was listed".to_owned(),
        });
    }
    Ok(found.swap_remove(at))
}

pub(super) fn nanoseconds(limit: Duration) -> u64 {
    u64::try_from(limit.as_nanos()).unwrap_or(u64::MAX)
}
