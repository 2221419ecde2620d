//! corput: the CPU path, and the kernels of the first device.

use crate::job::{Contender, Job, Kind};
use corput::bulk::Reference;
use corput::catalog::{Engine, Order, Sequence};
use corput::kernels::Generator;
use corput::vulkan::{Device, Instance, InstanceOptions, select};
use std::error::Error;
use std::sync::Arc;
use std::time::Instant;

type Named = (String, Box<dyn Contender>);

struct Cpu(Reference);

impl Contender for Cpu {
    fn make(&mut self, memory: &mut [f32]) -> Result<f64, Box<dyn Error>> {
        let begun = Instant::now();
        self.0.fill(0, bytemuck::cast_slice_mut(memory))?;
        Ok(begun.elapsed().as_secs_f64())
    }
}

/// Dispatches into a buffer that is used again; the device's time.
struct Gpu {
    generator: Generator,
    rows: u64,
    verified: bool,
    dimensions: usize,
}

impl Contender for Gpu {
    fn make(&mut self, memory: &mut [f32]) -> Result<f64, Box<dyn Error>> {
        let limit = self.generator.limit().min(self.rows);
        let (mut seconds, mut start) = (0.0, 0);
        while start < self.rows {
            let rows = limit.min(self.rows - start);
            let timing = self.generator.dispatch(start, rows)?;
            seconds += timing.device_ns.unwrap_or(timing.host_ns) * 1e-9;
            if !self.verified {
                let at = start as usize * self.dimensions;
                self.generator.read(rows, |words| {
                    memory[at..at + words.len()].copy_from_slice(bytemuck::cast_slice(words));
                })?;
            }
            start += rows;
        }
        self.verified = true;
        Ok(seconds)
    }
}

/// The first device, if there is one.
pub fn device() -> Option<Arc<Device>> {
    let instance = Instance::new(&InstanceOptions::default()).ok()?;
    let devices = instance.devices().ok()?;
    Device::open(&instance, select(&devices, None).ok()?).ok()
}

/// What the device is.
pub fn line(device: Option<&Arc<Device>>) -> String {
    device.map_or("no Vulkan device".into(), |device| {
        format!("{} ({})", device.info().name, device.info().driver_info)
    })
}

pub fn cpu(job: &Job) -> corput::Result<Option<Named>> {
    let request = job.request(Order::Natural, job.sequence())?;
    let name = match job.kind {
        Kind::Random => "corput, CPU (pcg4d)",
        Kind::SobolScrambled => "corput, CPU (hash)",
        _ => "corput, CPU",
    };
    Ok(Some((name.into(), Box::new(Cpu(Reference::new(&request))))))
}

pub fn on_device(job: &Job, device: Option<&Arc<Device>>) -> corput::Result<Vec<Named>> {
    let Some(device) = device else {
        return Ok(Vec::new());
    };
    let mut sequences = vec![("corput, Vulkan", job.sequence())];
    if job.kind == Kind::Random {
        sequences.push(("corput, Vulkan (Philox)", Sequence::Random));
    }
    let named = |(name, sequence): (&str, Sequence)| {
        let request = job.request(Order::Natural, sequence)?;
        let maker = Gpu {
            generator: Generator::new(device, &request)?,
            rows: request.count,
            verified: false,
            dimensions: job.dimensions,
        };
        Ok((name.to_owned(), Box::new(maker) as Box<dyn Contender>))
    };
    sequences.into_iter().map(named).collect()
}
