//! `corput estimate --pixels`: a picture, an exact estimate for each pixel.
//!
//! An .npy holds mean, variance and number of terms of each pixel as `f32`, an .exr the means,
//! a PNG of 16 bits the means as shares of the largest; FILE.json beside it has what makes it
//! again. What `--json` prints has the sums, so that pictures of other points of a pixel merge.

mod recorded;

pub use recorded::is_picture;

use super::args::EstimateArgs;
use super::estimate::{self, about, heading};
use super::format::Format;
use super::{host, interrupt, print, progress};
use corput::bulk::estimate_pixels;
use corput::catalog::{Profile, Raster, Request, Sampler};
use corput::estimate::{Estimate, Pixels};
use corput::kernels::PixelEstimator;
use corput::picture::{self, Size};
use corput::report::{Document, Element, Form, NPY_DATA_OFFSET, Target, npy_array};
use corput::{Error, Result};
use serde_json::{Value, json};
use std::time::Instant;

pub fn run(args: &EstimateArgs, raster: &Raster, request: &Request) -> anyhow::Result<()> {
    // Before there is a file that could be left.
    interrupt::clean_up();
    let target = args.out.as_deref().map(Target::from);
    let piped = target == Some(Target::Stdout);
    let target = target.map(|target| {
        let format = Format::of(&target, None)?;
        Ok::<_, Error>((format, Document::open_described(&target)?))
    });
    let target = target.transpose()?;
    let made = made(args, raster)?;
    if let Some((format, document)) = target {
        let (bytes, form) = encode(format, &made.pixels)?;
        let origin = recorded::origin(args, raster.problem(), request, &made.device)?;
        document.finish_described(&bytes, &form, &origin)?;
    }
    let truths = truths(raster)?;
    let told = match args.json {
        true => serde_json::to_string_pretty(&document(raster, request, &made, &truths))?,
        false => text(raster, request, &made, &truths)?,
    };
    // A picture on standard output has that for itself.
    match piped {
        true => eprintln!("{told}"),
        false => print(&told),
    }
    Ok(())
}

/// A picture of recorded arguments made again: the bytes of its file.
pub fn again(
    arguments: &Value,
    device: Option<&str>,
    format: &str,
) -> anyhow::Result<(Vec<u8>, Form)> {
    let (mut args, size) = recorded::parse(arguments)?;
    args.device = device.map(str::to_owned);
    let problem = estimate::problem(&args)?;
    let options = estimate::options(&args, Sampler::parse(&args.sampler)?, &problem);
    let raster = Raster::new(&problem, &options, size)?;
    let format = Format::of(&Target::Stdout, Some(format))?;
    Ok(encode(format, &made(&args, &raster)?.pixels)?)
}

/// Refuses what only pictures have.
pub fn refuse(args: &EstimateArgs) -> Result<()> {
    match args.out {
        None => Ok(()),
        Some(_) => Err(Error::Arguments {
            asked: "--out without --pixels".into(),
            limit: "only pictures are written to a file".into(),
            remedy: "add --pixels 64x48, or take --json for the sums".into(),
        }),
    }
}

/// A picture, and what made it.
struct Made {
    pixels: Pixels,
    device: String,
    device_ms: Option<f64>,
    total_ms: f64,
}

fn made(args: &EstimateArgs, raster: &Raster) -> anyhow::Result<Made> {
    let total = raster.count() * u64::from(raster.pixels());
    let Some(device) = host::open_or_cpu(args.device.as_deref(), Profile::Exact)? else {
        let bar = progress::points(total);
        let begun = Instant::now();
        let [width, _] = raster.size();
        let mut all: Vec<Estimate> = Vec::new();
        while (all.len() as u32) < raster.pixels() {
            let from = all.len() as u32;
            all.extend(estimate_pixels(raster, from..from + width)?);
            let done = all.len() as u64 * raster.count();
            bar.set_position(done);
            interrupt::stop(done, total)?;
        }
        bar.finish_and_clear();
        return Ok(Made {
            pixels: Pixels::new(width, all)?,
            device: "cpu".to_owned(),
            device_ms: None,
            total_ms: begun.elapsed().as_secs_f64() * 1e3,
        });
    };
    let mut estimator = PixelEstimator::new(&device, raster)?;
    let bar = progress::points(total);
    let begun = Instant::now();
    let (pixels, timing) = estimator.run(&mut |done| {
        bar.set_position(done);
        interrupt::stop(done, total)
    })?;
    let total_ms = begun.elapsed().as_secs_f64() * 1e3;
    bar.finish_and_clear();
    host::validated(device.instance())?;
    Ok(Made {
        pixels,
        device: host::line(device.info()),
        device_ms: timing.device_ns.map(|ns| ns * 1e-6),
        total_ms,
    })
}

fn truths(raster: &Raster) -> Result<Vec<f64>> {
    let truth = |index| Ok(raster.pixel(index)?.0.truth());
    (0..raster.pixels()).map(truth).collect()
}

fn encode(format: Format, pixels: &Pixels) -> Result<(Vec<u8>, Form)> {
    let [width, height] = pixels.size();
    let size = Size {
        width,
        height,
        channels: 1,
    };
    let means = || pixels.moments().map(|[mean, ..]| mean);
    let mut shape = vec![height, width];
    let (bytes, format, descr, header) = match format {
        Format::Npy => {
            let words: Vec<u32> = pixels
                .moments()
                .flatten()
                .map(|x| (x as f32).to_bits())
                .collect();
            shape.push(3);
            let bytes = npy_array(Element::F32, &shape, &words);
            (bytes, "npy", Element::F32.descr(), NPY_DATA_OFFSET)
        }
        Format::Exr => {
            let samples: Vec<f32> = means().map(|x| x as f32).collect();
            (picture::exr(size, &samples)?, "exr", "<f4", 0)
        }
        Format::Png => {
            let white = means().fold(0.0, f64::max).max(f64::MIN_POSITIVE);
            let sample = |mean: f64| (65535.0 * (mean / white).clamp(0.0, 1.0)).round() as u16;
            let samples: Vec<u16> = means().map(sample).collect();
            (picture::png(size, &samples)?, "png", ">u2", 0)
        }
    };
    let form = Form {
        format,
        shape,
        descr,
        header,
    };
    Ok((bytes, form))
}

/// Whose points pixels have.
fn points(raster: &Raster) -> Result<&'static str> {
    let columns = |index| Ok::<_, Error>(raster.pixel(index)?.1.columns);
    let shared = columns(0)? == columns(raster.pixels() - 1)?;
    Ok(match shared && raster.pixels() > 1 {
        true => "which share their points",
        false => "each with a seed of its own",
    })
}

/// The root of the mean square of the pixels' errors.
fn rms(pixels: &Pixels, truths: &[f64]) -> f64 {
    let squares = pixels
        .moments()
        .zip(truths)
        .map(|([mean, ..], truth)| (mean - truth).powi(2));
    (squares.sum::<f64>() / truths.len() as f64).sqrt()
}

fn text(raster: &Raster, request: &Request, made: &Made, truths: &[f64]) -> Result<String> {
    let [width, height] = raster.size();
    let largest = truths.iter().copied().fold(0.0, f64::max);
    let pixel_us = 1e3 * made.total_ms / f64::from(raster.pixels());
    let mut lines = vec![
        heading(raster.problem(), request, 0..raster.count()),
        format!("pixels          {width} x {height}, {}", points(raster)?),
        format!("largest truth   {largest}"),
        format!("RMS error       {:.3e}", rms(&made.pixels, truths)),
        format!(
            "time            {:.3} ms, {pixel_us:.2} us a pixel, on {}",
            made.total_ms, made.device
        ),
    ];
    if let Some(device_ms) = made.device_ms {
        lines.push(format!("device time     {device_ms:.3} ms"));
    }
    Ok(lines.join("\n"))
}

fn document(raster: &Raster, request: &Request, made: &Made, truths: &[f64]) -> Value {
    let [width, height] = raster.size();
    let pixels: Vec<Value> = made
        .pixels
        .estimates()
        .iter()
        .zip(truths)
        .map(|(estimate, truth)| {
            json!({
                "mean": estimate.mean(),
                "variance": estimate.variance(),
                "count": estimate.count(),
                "truth": truth,
                "sum": estimate.sum().to_string(),
                "sum_of_squares": estimate.squares().to_string(),
                "scale": estimate.scale(),
            })
        })
        .collect();
    let mut document = about(raster.problem(), request);
    let result = json!({
        "count": raster.count(),
        "width": width,
        "height": height,
        "rms_error": rms(&made.pixels, truths),
        "device": made.device,
        "device_ms": made.device_ms,
        "total_ms": made.total_ms,
        "pixels": pixels,
    });
    document.extend(result.as_object().cloned().unwrap_or_default());
    Value::Object(document)
}
