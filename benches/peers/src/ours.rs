//! corput: the CPU path, and the kernels of the first device.

use crate::job::{Contender, Job, Kind, Maker};
use crate::versions;
use corput::bulk::Reference;
use corput::catalog::{Engine, Order, Sequence};
use corput::kernels::Generator;
use corput::vulkan::{Device, Instance, InstanceOptions, select};
use std::error::Error;
use std::sync::Arc;
use std::time::Instant;

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
        format!("{}, {}", device.info().name, device.info().driver_info)
    })
}

pub fn cpu(job: &Job) -> corput::Result<Maker> {
    let request = job.request(Order::Natural, job.sequence())?;
    let note = match job.kind {
        Kind::Random => "(CPU, pcg4d)",
        Kind::SobolScrambled => "(CPU, hash)",
        _ => "(CPU)",
    };
    let cpu = Cpu(Reference::new(&request));
    Ok(maker("CPU", note.to_owned(), "", Box::new(cpu)))
}

pub fn on_device(job: &Job, device: Option<&Arc<Device>>) -> corput::Result<Vec<Maker>> {
    let Some(device) = device else {
        return Ok(Vec::new());
    };
    // Of llvmpipe (LLVM 15.0.6, 256 bits) the first word.
    let name = device.info().name.split(" (").next().unwrap_or_default();
    let mut sequences = vec![(job.sequence(), format!("({name})"), "")];
    if job.kind == Kind::Random {
        sequences.push((Sequence::Random, format!("({name}, Philox)"), "`random`"));
    }
    let on_it = |(sequence, note, label): (Sequence, String, &str)| {
        let request = job.request(Order::Natural, sequence)?;
        let gpu = Gpu {
            generator: Generator::new(device, &request)?,
            rows: request.count,
            verified: false,
            dimensions: job.dimensions,
        };
        Ok(maker(name, note, label, Box::new(gpu)))
    };
    sequences.into_iter().map(on_it).collect()
}

fn maker(place: &str, note: String, label: &str, contender: Box<dyn Contender>) -> Maker {
    Maker {
        library: format!("corput {}", versions::of("corput")),
        note,
        column: format!("corput, {place}"),
        label: label.to_owned(),
        contender,
    }
}
