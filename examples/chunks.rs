//! More points than one buffer holds, chunk by chunk: from the CPU and from every device, and
//! the same bits from all.
//!
//! `cargo run --release --example chunks` ends with 1 where they differ.

use corput::bulk::Reference;
use corput::catalog::{Chunks, Engine, Options, Request, Scramble, Sequence};
use corput::kernels::Generator;
use corput::vulkan::{Access, Buffer, Device, Instance, InstanceOptions};
use std::error::Error;
use std::process::ExitCode;

/// Points of a chunk.
const ROWS: u64 = 100_000;

/// Folds every word of every point, from memory of one chunk.
fn fold<E: Engine + ?Sized>(engine: &mut E) -> corput::Result<u64> {
    let all = 0..engine.count();
    let mut chunks = Chunks::new(engine, all, ROWS)?;
    let mut hash = 0u64;
    while let Some(words) = chunks.next_words() {
        for word in words? {
            hash = (hash ^ u64::from(*word)).wrapping_mul(0x0100_0000_01b3);
        }
    }
    Ok(hash)
}

/// The last points of a request by two submissions, both in flight.
fn last(device: &std::sync::Arc<Device>, request: &Request) -> corput::Result<Vec<u32>> {
    let mut generator = Generator::new(device, request)?;
    let bytes = 4 * u64::from(request.words_per_point()) * 1000;
    let mut buffers = [
        Buffer::new(device, bytes, Access::Readback)?,
        Buffer::new(device, bytes, Access::Readback)?,
    ];
    let from = request.count - 2000;
    let first = generator.submit(from, 1000, &buffers[0].slice(0, bytes)?)?;
    let second = generator.submit(from + 1000, 1000, &buffers[1].slice(0, bytes)?)?;
    // The CPU is free meanwhile.
    let mut words = Vec::new();
    for (mut submission, buffer) in [first, second].into_iter().zip(&mut buffers) {
        submission.wait()?;
        buffer.read(0, bytes, |bytes| {
            words.extend(bytemuck::pod_collect_to_vec::<u8, u32>(bytes));
        })?;
    }
    Ok(words)
}

/// Whether every device gives the words of the CPU.
pub fn run(_arguments: &[String]) -> Result<bool, Box<dyn Error>> {
    let mut options = Options::new(Sequence::Sobol, 1_000_003);
    options.dimensions = Some(4);
    options.scramble = Some(Scramble::OwenHash);
    let request = Request::new(&options)?;

    let mut reference = Reference::new(&request);
    let hash = fold(&mut reference)?;
    let mut end = vec![0; 2000 * request.words_per_point() as usize];
    reference.fill(request.count - 2000, &mut end)?;
    println!("CPU: {hash:016x}");

    let instance = Instance::new(&InstanceOptions::default())?;
    let mut equal = true;
    for info in instance.devices()? {
        let device = Device::open(&instance, &info)?;
        let made = fold(&mut Generator::new(&device, &request)?)?;
        let same = made == hash && last(&device, &request)? == end;
        println!("{}: {made:016x}, equal: {same}", info.name);
        equal &= same;
    }
    Ok(equal)
}

fn main() -> ExitCode {
    match run(&[]) {
        Ok(equal) => ExitCode::from(u8::from(!equal)),
        Err(error) => {
            eprintln!("chunks: {error}");
            ExitCode::from(2)
        }
    }
}
