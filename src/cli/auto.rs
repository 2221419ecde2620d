//! `--device auto`: the CPU or a device, whichever makes the points of a request faster.

use super::host;
use corput::bulk::Reference;
use corput::catalog::{Engine, Profile, Request};
use corput::kernels::Generator;
use corput::vulkan::Device;
use corput::{Error, Result};
use std::hint::black_box;
use std::sync::Arc;
use std::time::{Duration, Instant};

/// Points of the last step of a trial at most; the first makes [`FIRST`], each other twice as many
/// as the one before.
const POINTS: u64 = 1 << 18;
const FIRST: u64 = 1 << 12;

/// No step is begun after this time, so that a trial takes a tenth of a second.
const LONGEST: Duration = Duration::from_millis(40);

/// Tries both, says on standard error what it found, and gives the faster one. Where no device
/// can be had it is the CPU.
///
/// # Errors
/// [`Error::Arguments`] for the native profile; those of the validation layer.
pub fn choose(request: &Request) -> Result<host::Chosen> {
    if request.profile == Profile::Native {
        return Err(Error::Arguments {
            asked: "--device auto with --profile native".into(),
            limit: "native results have other bytes on each device, and auto gives the same ones"
                .into(),
            remedy: "use --profile exact, or name the device".into(),
        });
    }
    let mut reference = Reference::new(request);
    let (mut generator, device) = match on_device(request) {
        Ok(both) => both,
        Err(error) => {
            eprintln!("corput: --device auto takes cpu: {error}");
            return Ok((host::Source::Host(Box::new(reference)), None));
        }
    };
    let name = &device.info().name;
    let cpu = rate(&mut reference, request)?;
    let there = match rate(&mut generator, request) {
        Ok(rate) => rate,
        Err(error) => {
            eprintln!("corput: --device auto takes cpu: {name}: {error}");
            return Ok((host::Source::Host(Box::new(reference)), None));
        }
    };
    let on_cpu = cpu >= there;
    let taken = if on_cpu { "cpu" } else { name };
    let (cpu, there) = (millions(cpu), millions(there));
    eprintln!("corput: --device auto takes {taken}: cpu {cpu}, {name} {there}");
    if on_cpu {
        host::validated(device.instance())?;
        return Ok((host::Source::Host(Box::new(reference)), None));
    }
    Ok((host::Source::Device(Box::new(generator)), Some(device)))
}

fn on_device(request: &Request) -> Result<(Generator, Arc<Device>)> {
    let device = host::open_default()?;
    Ok((Generator::new(&device, request)?, device))
}

/// Points per second in the last step of a trial; each word is read, as writing it to a file would.
fn rate(engine: &mut dyn Engine, request: &Request) -> Result<f64> {
    let begun = Instant::now();
    let mut points = FIRST.min(request.count);
    loop {
        let step = Instant::now();
        let mut fold = 0;
        engine.make(0, points, &mut |words| {
            fold = words.iter().fold(fold, |fold, word| fold ^ word);
            Ok(())
        })?;
        black_box(fold);
        let seconds = step.elapsed().as_secs_f64();
        let next = (2 * points).min(POINTS).min(request.count);
        if next == points || begun.elapsed() > LONGEST {
            return Ok(points as f64 / seconds.max(1e-9));
        }
        points = next;
    }
}

fn millions(rate: f64) -> String {
    format!("{:.1} M points/s", rate * 1e-6)
}
