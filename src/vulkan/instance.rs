//! The connection to the Vulkan loader, with the validation layer on request.

use ash::vk;
use std::ffi::{CStr, c_char, c_void};
use std::fmt;
use std::sync::{Arc, Mutex, PoisonError};

use super::info::DeviceInfo;
use super::{failed, query, refused};
use crate::error::{Error, Result};

const VALIDATION: &CStr = c"VK_LAYER_KHRONOS_validation";

/// Validation messages kept until they are taken; later ones are dropped.
const MESSAGES: usize = 1000;

/// How to connect to the loader.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct InstanceOptions {
    /// Load the Khronos validation layer, synchronisation validation included. The layer
    /// (1.3.239 at least) crashes where one thread makes or destroys an instance or a device
    /// while another calls any: a program that validates keeps the two apart.
    pub validation: bool,
}

/// A connection to the Vulkan loader.
pub struct Instance {
    // Fields drop in this order, after `drop`: the messages outlive the
    // messenger, and the loader's library outlives the instance.
    messenger: Option<Messenger>,
    raw: ash::Instance,
    messages: Box<Mutex<Vec<String>>>,
    owned: bool,
    _entry: ash::Entry,
}

struct Messenger {
    functions: ash::ext::debug_utils::Instance,
    raw: vk::DebugUtilsMessengerEXT,
}

impl Instance {
    /// Connects to the loader.
    ///
    /// # Errors
    /// [`Error::NoDevice`] without a loader, without a driver, or with a loader
    /// of Vulkan 1.0; [`Error::Arguments`] when validation is asked for and its
    /// layer is not installed.
    pub fn new(options: &InstanceOptions) -> Result<Arc<Self>> {
        // SAFETY: loading the Vulkan loader runs its initialisers, which are
        // trusted like any system library's.
        let entry = unsafe { ash::Entry::load() }.map_err(|e| Error::NoDevice {
            reason: format!("no Vulkan loader: {e}"),
        })?;
        // SAFETY: the functions are the loader's, and the entry keeps its library.
        unsafe { Self::with_entry(entry, options) }
    }

    /// The same by a loader of the caller's: one that is linked in, lies at a path
    /// of its own, or has been wrapped.
    ///
    /// # Errors
    /// As for [`Instance::new`].
    ///
    /// # Safety
    /// The entry's functions, and those that they lead to, do what Vulkan says, and
    /// stay valid until the instance and all that was made from it have been
    /// dropped. (An entry by `load`, `load_from` or `linked` sees to that.)
    pub unsafe fn with_entry(entry: ash::Entry, options: &InstanceOptions) -> Result<Arc<Self>> {
        // SAFETY: the caller vouches for the entry.
        let version = unsafe { entry.try_enumerate_instance_version() }
            .map_err(failed("vkEnumerateInstanceVersion"))?
            .unwrap_or(vk::API_VERSION_1_0);
        if version < vk::API_VERSION_1_1 {
            return Err(Error::NoDevice {
                reason: "the loader knows Vulkan 1.0 only".to_owned(),
            });
        }

        let (mut layers, mut extensions): (Vec<*const c_char>, Vec<*const c_char>) =
            Default::default();
        let mut flags = vk::InstanceCreateFlags::empty();
        if offers(&entry, None, ash::khr::portability_enumeration::NAME)? {
            extensions.push(ash::khr::portability_enumeration::NAME.as_ptr());
            flags |= vk::InstanceCreateFlags::ENUMERATE_PORTABILITY_KHR;
        }
        let checks = [vk::ValidationFeatureEnableEXT::SYNCHRONIZATION_VALIDATION];
        let mut features =
            vk::ValidationFeaturesEXT::default().enabled_validation_features(&checks);
        let application = vk::ApplicationInfo::default()
            .application_name(c"corput")
            .api_version(version.min(vk::API_VERSION_1_2));
        let mut create = vk::InstanceCreateInfo::default()
            .flags(flags)
            .application_info(&application);
        if options.validation {
            require_validation(&entry)?;
            layers.push(VALIDATION.as_ptr());
            extensions.push(ash::ext::debug_utils::NAME.as_ptr());
            if offers(
                &entry,
                Some(VALIDATION),
                ash::ext::validation_features::NAME,
            )? {
                extensions.push(ash::ext::validation_features::NAME.as_ptr());
                create = create.push_next(&mut features);
            }
        }
        let create = create
            .enabled_layer_names(&layers)
            .enabled_extension_names(&extensions);
        // SAFETY: `create` and what it points to live until the call returns.
        let raw = match unsafe { entry.create_instance(&create, None) } {
            Ok(raw) => raw,
            Err(vk::Result::ERROR_INCOMPATIBLE_DRIVER) => {
                return Err(Error::NoDevice {
                    reason: "the loader finds no driver".to_owned(),
                });
            }
            Err(code) => return Err(failed("vkCreateInstance")(code)),
        };
        let mut instance = Self {
            messenger: None,
            raw,
            messages: Box::default(),
            owned: true,
            _entry: entry,
        };
        if options.validation {
            instance.messenger = Some(instance.listen()?);
        }
        Ok(Arc::new(instance))
    }

    /// Wraps an instance that someone else owns and destroys.
    pub(super) fn borrowed(entry: &ash::Entry, raw: &ash::Instance) -> Arc<Self> {
        Arc::new(Self {
            messenger: None,
            raw: raw.clone(),
            messages: Box::default(),
            owned: false,
            _entry: entry.clone(),
        })
    }

    /// The devices present, in the loader's order; may be empty.
    ///
    /// # Errors
    /// [`Error::Vulkan`] when the driver fails to answer.
    pub fn devices(&self) -> Result<Vec<DeviceInfo>> {
        Ok(self.listed()?.into_iter().map(|(_, info)| info).collect())
    }

    /// The same with their handles, of one answer of the loader: another may be in
    /// another order.
    pub(super) fn listed(&self) -> Result<Vec<(vk::PhysicalDevice, DeviceInfo)>> {
        let physical = self.physical_devices()?;
        let info = |(index, physical)| {
            query::device_info(&self.raw, physical, index).map(|info| (physical, info))
        };
        physical.into_iter().enumerate().map(info).collect()
    }

    /// Takes what the validation layer has said since the last call: warnings
    /// and errors of type validation. The loader's own words are left out.
    #[must_use]
    pub fn take_validation_messages(&self) -> Vec<String> {
        std::mem::take(&mut *self.messages.lock().unwrap_or_else(PoisonError::into_inner))
    }

    /// The instance's handle and functions.
    #[must_use]
    pub fn raw(&self) -> &ash::Instance {
        &self.raw
    }

    /// Whether the validation layer watches this instance.
    #[must_use]
    pub fn is_validating(&self) -> bool {
        self.messenger.is_some()
    }

    pub(super) fn physical_devices(&self) -> Result<Vec<vk::PhysicalDevice>> {
        // SAFETY: the instance is alive.
        match unsafe { self.raw.enumerate_physical_devices() } {
            Ok(devices) => Ok(devices),
            // What some loaders say when every driver declined.
            Err(vk::Result::ERROR_INITIALIZATION_FAILED) => Ok(Vec::new()),
            Err(code) => Err(failed("vkEnumeratePhysicalDevices")(code)),
        }
    }

    fn listen(&self) -> Result<Messenger> {
        let functions = ash::ext::debug_utils::Instance::new(&self._entry, &self.raw);
        let create = vk::DebugUtilsMessengerCreateInfoEXT::default()
            .message_severity(
                vk::DebugUtilsMessageSeverityFlagsEXT::WARNING
                    | vk::DebugUtilsMessageSeverityFlagsEXT::ERROR,
            )
            .message_type(vk::DebugUtilsMessageTypeFlagsEXT::VALIDATION)
            .pfn_user_callback(Some(on_message))
            .user_data(
                std::ptr::from_ref::<Mutex<Vec<String>>>(&self.messages)
                    .cast_mut()
                    .cast(),
            );
        // SAFETY: the extension is enabled; the boxed messages do not move and
        // outlive the messenger, which `drop` destroys first.
        let raw = unsafe { functions.create_debug_utils_messenger(&create, None) }
            .map_err(failed("vkCreateDebugUtilsMessengerEXT"))?;
        Ok(Messenger { functions, raw })
    }
}

impl Drop for Instance {
    fn drop(&mut self) {
        if let Some(messenger) = self.messenger.take() {
            // SAFETY: the messenger was made from this instance and is used no more.
            unsafe {
                messenger
                    .functions
                    .destroy_debug_utils_messenger(messenger.raw, None)
            };
        }
        if self.owned {
            // SAFETY: every device holds an `Arc` of its instance, so none is left.
            unsafe { self.raw.destroy_instance(None) };
        }
    }
}

impl fmt::Debug for Instance {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Instance")
            .field("validating", &self.is_validating())
            .finish_non_exhaustive()
    }
}

fn require_validation(entry: &ash::Entry) -> Result<()> {
    // SAFETY: the loader is loaded.
    let layers = unsafe { entry.enumerate_instance_layer_properties() }
        .map_err(failed("vkEnumerateInstanceLayerProperties"))?;
    if layers
        .iter()
        .any(|layer| layer.layer_name_as_c_str() == Ok(VALIDATION))
    {
        return Ok(());
    }
    Err(refused(
        "validation",
        "the layer VK_LAYER_KHRONOS_validation is not installed",
        "install it (Debian, Ubuntu: `apt-get install vulkan-validationlayers`), or go without",
    ))
}

/// Whether the loader, or one of its layers, offers an instance extension.
fn offers(entry: &ash::Entry, layer: Option<&CStr>, extension: &CStr) -> Result<bool> {
    // SAFETY: the loader is loaded.
    let extensions = unsafe { entry.enumerate_instance_extension_properties(layer) }
        .map_err(failed("vkEnumerateInstanceExtensionProperties"))?;
    Ok(extensions
        .iter()
        .any(|e| e.extension_name_as_c_str() == Ok(extension)))
}

/// Keeps one message. Must not unwind into the layer.
unsafe extern "system" fn on_message(
    _severity: vk::DebugUtilsMessageSeverityFlagsEXT,
    _kind: vk::DebugUtilsMessageTypeFlagsEXT,
    data: *const vk::DebugUtilsMessengerCallbackDataEXT<'_>,
    messages: *mut c_void,
) -> vk::Bool32 {
    // SAFETY: `listen` gave this pointer, to a mutex that outlives the messenger;
    // the layer passes valid data with NUL-terminated text.
    let (messages, text) = unsafe {
        (
            messages.cast::<Mutex<Vec<String>>>().as_ref(),
            data.as_ref().and_then(|data| data.message_as_c_str()),
        )
    };
    if let (Some(messages), Some(text)) = (messages, text) {
        let mut messages = messages.lock().unwrap_or_else(PoisonError::into_inner);
        if messages.len() < MESSAGES {
            messages.push(text.to_string_lossy().into_owned());
        }
    }
    vk::FALSE
}
