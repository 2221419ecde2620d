//! The device that the user chose.

use super::auto;
use corput::bulk::Reference;
use corput::catalog::{Engine, Profile, Request};
use corput::kernels::Generator;
use corput::vulkan::{Device, DeviceInfo, Instance, InstanceOptions, select};
use corput::{Error, Result};
use std::sync::Arc;

/// The instance, with validation if `CORPUT_VALIDATION=1`.
pub fn instance() -> Result<Arc<Instance>> {
    let validation = std::env::var_os("CORPUT_VALIDATION").is_some_and(|v| v == "1");
    Instance::new(&InstanceOptions { validation })
}

/// What `--device` or `CORPUT_DEVICE` asks for.
pub fn asked(argument: Option<&str>) -> Option<String> {
    let variable = || {
        std::env::var("CORPUT_DEVICE")
            .ok()
            .filter(|v| !v.is_empty())
    };
    argument.map(str::to_owned).or_else(variable)
}

/// Whether that is the reference on the CPU.
pub fn is_cpu(asked: Option<&str>) -> bool {
    asked.is_some_and(|name| name.eq_ignore_ascii_case("cpu"))
}

/// Whether it is whichever is faster.
fn is_auto(asked: Option<&str>) -> bool {
    asked.is_some_and(|name| name.eq_ignore_ascii_case("auto"))
}

/// What makes points.
pub enum Source {
    /// The CPU, or whoever has them already.
    Host(Box<dyn Engine>),
    Device(Box<Generator>),
}

impl Source {
    /// As any other.
    pub fn as_mut(&mut self) -> &mut dyn Engine {
        match self {
            Self::Host(engine) => engine.as_mut(),
            Self::Device(generator) => generator.as_mut(),
        }
    }
}

/// What makes points, and the device that it runs on; none on the CPU.
pub type Chosen = (Source, Option<Arc<Device>>);

/// The engine for a request.
pub fn engine(argument: Option<&str>, request: &Request) -> Result<Chosen> {
    if is_auto(asked(argument).as_deref()) {
        return auto::choose(request);
    }
    let Some(device) = open_or_cpu(argument, request.profile)? else {
        let reference = Box::new(Reference::new(request));
        return Ok((Source::Host(reference), None));
    };
    let generator = Generator::new(&device, request)?;
    Ok((Source::Device(Box::new(generator)), Some(device)))
}

/// The chosen device; none where the CPU is chosen, or where nobody chose and there is no device,
/// which standard error then says: the exact profile has the same bytes there.
pub fn open_or_cpu(argument: Option<&str>, profile: Profile) -> Result<Option<Arc<Device>>> {
    let asked = asked(argument);
    if is_cpu(asked.as_deref()) {
        return Ok(None);
    }
    match open(argument) {
        Err(error @ (Error::NoDevice { .. } | Error::InadequateDevice { .. }))
            if asked.is_none() && profile == Profile::Exact =>
        {
            eprintln!("corput: warning: the CPU does the work: {error}");
            Ok(None)
        }
        opened => opened.map(Some),
    }
}

/// Opens the chosen device.
pub fn open(argument: Option<&str>) -> Result<Arc<Device>> {
    let asked = asked(argument);
    if is_auto(asked.as_deref()) {
        return Err(Error::Arguments {
            asked: "--device auto".into(),
            limit:
                "only `generate` and `verify` measure the CPU and a device and take the faster one"
                    .into(),
            remedy: "name cpu or a device that `corput devices` lists, or drop --device".into(),
        });
    }
    if is_cpu(asked.as_deref()) {
        return Err(Error::Arguments {
            asked: "--device cpu".into(),
            limit: "this command compares a Vulkan device with the CPU, so it needs one".into(),
            remedy: "choose one that `corput devices` lists".into(),
        });
    }
    select_and_open(asked.as_deref())
}

/// Opens the device that is taken where nobody names one.
pub fn open_default() -> Result<Arc<Device>> {
    select_and_open(None)
}

fn select_and_open(asked: Option<&str>) -> Result<Arc<Device>> {
    let instance = instance()?;
    let devices = instance.devices()?;
    Device::open(&instance, select(&devices, asked)?)
}

/// Fails where the validation layer has found something.
pub fn validated(instance: &Instance) -> Result<()> {
    let said = instance.take_validation_messages();
    if said.is_empty() {
        return Ok(());
    }
    for message in &said {
        eprintln!("validation: {message}");
    }
    Err(Error::CheckFailed {
        failures: said.len(),
        total: said.len(),
    })
}

/// One line that names a device.
pub fn line(info: &DeviceInfo) -> String {
    let (major, minor, patch) = info.api_version;
    format!(
        "{} ({}), {} {}, Vulkan {major}.{minor}.{patch}",
        info.name,
        info.kind.name(),
        info.driver_name,
        info.driver_info
    )
}

/// The command as a shell takes it.
pub fn command() -> String {
    let plain = |c: char| c.is_ascii_alphanumeric() || "-_=+.,:/@%".contains(c);
    let quoted = |word: String| match word.chars().all(plain) && !word.is_empty() {
        true => word,
        false => format!("'{}'", word.replace('\'', "'\\''")),
    };
    let words = std::env::args_os()
        .skip(1)
        .map(|word| quoted(word.to_string_lossy().into_owned()));
    std::iter::once("corput".to_owned())
        .chain(words)
        .collect::<Vec<_>>()
        .join(" ")
}
