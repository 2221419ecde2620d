//! `corput generate blue-noise-mask`.
//!
//! A pixel's value is the fraction (rank + 1/2) / pixels: rounded down to 2^-32 as `u32`
//! in an .npy with --fractions, else to 2^-24 as `f32` in an .npy or .exr, or to 2^-16 in a
//! PNG of 16 bits. With at most 65,536 pixels no two ranks share a value in any of them.

use super::args::GenerateArgs;
use super::arguments::origin;
use super::format::Format;
use super::generate::element;
use super::{host, interrupt, progress};
use corput::blue_noise::{MaskShape, void_and_cluster};
use corput::catalog::{Guide, Profile};
use corput::kernels::VoidAndCluster;
use corput::picture::{self, Size};
use corput::reference::blue_noise::blue_noise_fraction;
use corput::reference::unit::unit_floor;
use corput::report::{Document, Element, Form, NPY_DATA_OFFSET, Target, npy_array};
use corput::vulkan::Device;
use corput::{Error, Result};
use std::sync::Arc;

/// The name on the command line.
pub const NAME: &str = "blue-noise-mask";

/// What it is, as `generate --help` says it.
pub const GUIDE: Guide = Guide {
    what: "ranks of pixels by void-and-cluster, to 256 x 256 or 64 x 64 x 16",
    purpose: "dithering, and one offset per pixel",
    points: "any size; all ranks once",
    source: "Ulichney 1993, Wolfe et al. 2022",
};

pub fn run(args: &GenerateArgs) -> anyhow::Result<()> {
    let (shape, channels) = shape(args)?;
    refuse_points(args)?;
    let target = Target::from(args.out.as_path());
    let format = Format::of(&target, args.format.as_deref())?;
    if args.fractions && format != Format::Npy {
        let limit = "a PNG holds 16 bits of the fractions, and an .exr floats";
        return Err(refusal("--fractions".into(), limit, "write an .npy, or drop it").into());
    }
    let document = Document::open_described(&target)?;
    interrupt::clean_up();
    let device = open(args)?;
    let origin = origin(args, None, device.as_ref())?;
    let fractions = fractions(args, shape, channels, device.as_ref())?;
    let (bytes, form) = encode(format, shape, channels, args.fractions, &fractions)?;
    document.finish_described(&bytes, &form, &origin)?;
    Ok(())
}

/// A mask of recorded arguments made again: the bytes of its file.
pub fn again(made: &GenerateArgs, format: &str) -> Result<(Vec<u8>, Form)> {
    let (shape, channels) = shape(made)?;
    let format = Format::of(&Target::Stdout, Some(format))?;
    let whole = element(made)? == Element::U32;
    let device = open(made)?;
    let fractions = fractions(made, shape, channels, device.as_ref())?;
    encode(format, shape, channels, whole, &fractions)
}

/// Pixels and channels.
fn shape(args: &GenerateArgs) -> Result<(MaskShape, u32)> {
    let size = args.size.ok_or_else(|| {
        refusal(
            format!("{NAME} without --size"),
            "a mask has pixels, not a count of points",
            "add --size 128",
        )
    })?;
    let shape = MaskShape::new(size, size, args.frames.unwrap_or(1))?;
    match args.channels.unwrap_or(1) {
        channels @ 1..=2 => Ok((shape, channels as u32)),
        channels => {
            let asked = format!("--channels {channels}");
            let remedy = "make several masks with different seeds for more";
            Err(refusal(asked, "a mask has 1 or 2", remedy))
        }
    }
}

/// The device that ranks the pixels; none for the CPU.
fn open(args: &GenerateArgs) -> Result<Option<Arc<Device>>> {
    host::open_or_cpu(args.device.as_deref(), Profile::Exact)
}

/// Refuses what only masks have, for points.
pub fn refuse(args: &GenerateArgs) -> Result<()> {
    if args.size.is_some() || args.channels.is_some() || args.frames.is_some() {
        return Err(refusal(
            format!("--size, --channels or --frames with {}", args.sequence),
            "only masks have pixels; points have a --count",
            "drop them, or use blue-noise-mask",
        ));
    }
    Ok(())
}

/// Refuses what only points have.
fn refuse_points(args: &GenerateArgs) -> Result<()> {
    let columns = args.dims.is_some()
        || args.bases.is_some()
        || args.total.is_some()
        || args.scramble.is_some()
        || args.grid.is_some()
        || args.generator.is_some()
        || args.element.is_some()
        || args.resume
        || args.chunk_rows.is_some()
        || args.order != "natural";
    let mapped =
        args.map.is_some() || args.with_pdf || !args.param.is_empty() || args.env.is_some();
    if columns || mapped || args.count.is_some() || args.first != 0 || args.index_first {
        return Err(refusal(
            format!(
                "--count, --first, --dims, --bases, --total, --index-first, --scramble, --order, --grid, \
                 --generator, --type, --resume, --chunk-rows, --map, --param, --env or --with-pdf with {NAME}"
            ),
            "only points have them; a mask has --size, --channels and --frames",
            "drop them",
        ));
    }
    Ok(())
}

fn refusal(asked: String, limit: &str, remedy: &str) -> Error {
    Error::Arguments {
        asked,
        limit: limit.to_owned(),
        remedy: remedy.to_owned(),
    }
}

/// The fractions of every pixel, channels innermost.
fn fractions(
    args: &GenerateArgs,
    shape: MaskShape,
    channels: u32,
    device: Option<&Arc<Device>>,
) -> Result<Vec<u32>> {
    let pixels = shape.pixels();
    let mut fractions = vec![0; (pixels * channels) as usize];
    let kernel = device.map(VoidAndCluster::new).transpose()?;
    let total = u64::from(pixels * channels);
    let bar = progress::points(total);
    for channel in 0..channels {
        let seed = MaskShape::channel_seed(args.seed.unwrap_or(0), channel);
        let ranks = match &kernel {
            None => void_and_cluster(shape, seed),
            Some(kernel) => kernel.ranks(shape, seed, &mut |ranked| {
                bar.inc(u64::from(ranked));
                interrupt::stop(bar.position(), total)
            })?,
        };
        for (pixel, rank) in ranks.iter().enumerate() {
            let at = pixel * channels as usize + channel as usize;
            fractions[at] = blue_noise_fraction(*rank, pixels);
        }
    }
    bar.finish_and_clear();
    if let Some(device) = device {
        host::validated(device.instance())?;
    }
    Ok(fractions)
}

/// Of an array `f32` fractions, or `u32` ones where they are asked for whole; of a PNG their
/// leading 16 bits. Frames lie one below the other in pictures, and along the first axis of an
/// array; channels along the last.
fn encode(
    format: Format,
    shape: MaskShape,
    channels: u32,
    whole: bool,
    fractions: &[u32],
) -> Result<(Vec<u8>, Form)> {
    let size = Size {
        width: shape.width,
        height: shape.height * shape.frames,
        channels,
    };
    let floats = || fractions.iter().map(|fraction| unit_floor(*fraction));
    let mut axes = vec![size.height, size.width];
    if format == Format::Npy && shape.frames > 1 {
        axes = vec![shape.frames, shape.height, shape.width];
    }
    if channels > 1 {
        axes.push(channels);
    }
    let (bytes, format, descr, header) = match format {
        Format::Png => {
            let samples: Vec<u16> = fractions.iter().map(|f| (f >> 16) as u16).collect();
            (picture::png(size, &samples)?, "png", ">u2", 0)
        }
        Format::Exr => {
            let samples: Vec<f32> = floats().collect();
            (picture::exr(size, &samples)?, "exr", "<f4", 0)
        }
        Format::Npy => {
            let (element, words) = match whole {
                true => (Element::U32, fractions.to_vec()),
                false => (Element::F32, floats().map(f32::to_bits).collect()),
            };
            let bytes = npy_array(element, &axes, &words);
            (bytes, "npy", element.descr(), NPY_DATA_OFFSET)
        }
    };
    let form = Form {
        format,
        shape: axes,
        descr,
        header,
    };
    Ok((bytes, form))
}
