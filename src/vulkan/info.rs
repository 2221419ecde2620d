//! What a device says about itself, as plain data.

/// The kind of hardware behind a device.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum DeviceKind {
    /// A card with its own memory.
    Discrete,
    /// A graphics unit that shares the host's memory.
    Integrated,
    /// A device passed into a virtual machine.
    Virtual,
    /// A driver that runs on the CPU, such as lavapipe.
    Cpu,
    /// Anything else.
    #[default]
    Other,
}

impl DeviceKind {
    /// The kind as one lower-case word.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Discrete => "discrete",
            Self::Integrated => "integrated",
            Self::Virtual => "virtual",
            Self::Cpu => "cpu",
            Self::Other => "other",
        }
    }
}

/// Everything worth knowing about a device before it is opened.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct DeviceInfo {
    /// Position in the loader's list.
    pub index: usize,
    /// The device's name.
    pub name: String,
    /// The kind of hardware.
    pub kind: DeviceKind,
    /// PCI vendor, or a Khronos vendor id.
    pub vendor_id: u32,
    /// The vendor's number of this device.
    pub device_id: u32,
    /// The Vulkan version it offers: major, minor, patch.
    pub api_version: (u32, u32, u32),
    /// The driver's name; empty where the driver does not tell.
    pub driver_name: String,
    /// The driver's own version text; empty where the driver does not tell.
    pub driver_info: String,
    /// The driver's version in the vendor's encoding.
    pub driver_version: u32,
    /// Identifies the device, in 32 hexadecimal digits.
    pub device_uuid: String,
    /// Identifies the driver's build, in 32 hexadecimal digits.
    pub driver_uuid: String,
    /// What it can take.
    pub limits: Limits,
    /// Optional features that are present, none of which is needed.
    pub features: Features,
    /// What it promises about 32-bit float arithmetic.
    pub float_controls: FloatControls,
}

/// The limits that matter to compute.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Limits {
    /// Most bytes of one storage buffer that a shader can see.
    pub max_storage_buffer_range: u64,
    /// Most bytes of push constants.
    pub max_push_constants: u32,
    /// Most invocations in one workgroup.
    pub max_group_invocations: u32,
    /// Most invocations in one workgroup, per axis.
    pub max_group_size: [u32; 3],
    /// Most workgroups in one dispatch, per axis.
    pub max_group_count: [u32; 3],
    /// Most storage buffers that one compute shader can see.
    pub max_storage_buffers: u32,
    /// Alignment of an offset at which a storage buffer may be bound.
    pub storage_offset_alignment: u64,
    /// Nanoseconds of one timestamp tick.
    pub timestamp_period_ns: f32,
    /// Meaningful bits of a timestamp on the compute queue; 0: no timestamps.
    pub timestamp_valid_bits: u32,
    /// Invocations in one subgroup.
    pub subgroup_size: u32,
    /// Most bytes of one memory allocation.
    pub max_allocation: u64,
    /// Bytes of the largest device-local heap.
    pub memory_bytes: u64,
}

/// Optional features: nothing here is ever required. 64-bit integers and the last are used where
/// they are.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Features {
    /// `double` in shaders.
    pub float64: bool,
    /// 64-bit integers in shaders.
    pub int64: bool,
    /// 16-bit integers in shaders.
    pub int16: bool,
    /// Half floats in shaders.
    pub float16: bool,
    /// `VK_EXT_external_memory_host`: host memory can be a storage buffer, as a
    /// [`FileWindow`](super::FileWindow) is.
    pub external_memory_host: bool,
}

/// Execution modes of 32-bit floats that a shader may request. A device can
/// behave so without saying so; the probe finds out what it does.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct FloatControls {
    /// Rounding to nearest even can be requested.
    pub rte: bool,
    /// Rounding toward zero can be requested.
    pub rtz: bool,
    /// Preserving denormals can be requested.
    pub denorm_preserve: bool,
    /// Flushing denormals to zero can be requested.
    pub denorm_flush: bool,
    /// Preserving signed zeros, infinities and NaNs can be requested.
    pub signed_zero_inf_nan_preserve: bool,
}
