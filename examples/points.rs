//! The shortest way to a buffer: a million cosine-weighted directions over Halton points.
//!
//! `cargo run --release --example points`

use corput::bulk::Reference;
use corput::catalog::{Engine, Map, Mapping, Options, Request, Sequence};
use corput::kernels::Generator;
use corput::vulkan::{Device, Instance, InstanceOptions, select};

fn main() -> corput::Result<()> {
    let mut options = Options::new(Sequence::Halton, 1_000_000);
    options.map = Some(Mapping::new(Map::from_name("cosine-hemisphere")?, &[])?);
    let request = Request::new(&options)?;

    let instance = Instance::new(&InstanceOptions::default())?;
    let devices = instance.devices()?;
    let device = Device::open(&instance, select(&devices, None)?)?;
    let mut generator = Generator::new(&device, &request)?;

    // Words arrive row after row: x, y, z as the bits of floats.
    let mut words = Vec::new();
    generator.make(0, request.count, &mut |part| {
        words.extend_from_slice(part);
        Ok(())
    })?;

    // The mean of z under the pdf z / pi is 2/3.
    let z = words
        .chunks_exact(3)
        .map(|d| f64::from(f32::from_bits(d[2])));
    println!(
        "{}: mean of z {:.6}",
        device.info().name,
        z.sum::<f64>() / 1e6
    );

    let mut same = vec![0; words.len()];
    Reference::new(&request).fill(0, &mut same)?;
    println!("equal to the CPU bit for bit: {}", same == words);
    Ok(())
}
