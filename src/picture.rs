//! Small pictures to bytes: PNG of 16 bits and OpenEXR, of one channel or two.
//!
//! The bytes depend on nothing but the arguments: no dates, one thread.

use crate::{Error, Result};
use exr::prelude::{AnyChannel, AnyChannels, Encoding, FlatSamples, Image, Layer, WritableImage};
use exr::prelude::{LayerAttributes, SmallVec};
use std::io::Cursor;

/// A picture of so many columns, rows and channels, row-major, channels innermost.
#[derive(Clone, Copy, Debug)]
pub struct Size {
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// 1: grey; 2: red and green.
    pub channels: u32,
}

/// A PNG of 16 bits: grey, or red and green with a blue of 0.
///
/// # Errors
/// [`Error::Arguments`] where the number of samples is not that of the size.
pub fn png(size: Size, samples: &[u16]) -> Result<Vec<u8>> {
    let pixels = pixels(size, samples)?;
    let colour = match size.channels {
        1 => png::ColorType::Grayscale,
        _ => png::ColorType::Rgb,
    };
    let mut data = Vec::with_capacity(6 * samples.len());
    for pixel in pixels {
        data.extend(pixel.iter().flat_map(|sample| sample.to_be_bytes()));
        if size.channels == 2 {
            data.extend([0, 0]);
        }
    }
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, size.width, size.height);
    encoder.set_color(colour);
    encoder.set_depth(png::BitDepth::Sixteen);
    let written = encoder.write_header().and_then(|mut writer| {
        writer.write_image_data(&data)?;
        writer.finish()
    });
    written.map_err(|error| failed("a PNG", &error.to_string()))?;
    Ok(bytes)
}

/// An OpenEXR picture of `f32`, not compressed: the channel Y, or R and G.
///
/// # Errors
/// [`Error::Arguments`] where the number of samples is not that of the size.
pub fn exr(size: Size, samples: &[f32]) -> Result<Vec<u8>> {
    let pixels: Vec<&[f32]> = pixels(size, samples)?.collect();
    let names: &[&str] = match size.channels {
        1 => &["Y"],
        _ => &["R", "G"],
    };
    let channels: SmallVec<[AnyChannel<FlatSamples>; 4]> = names
        .iter()
        .enumerate()
        .map(|(at, name)| {
            let values = pixels.iter().map(|pixel| pixel[at]).collect();
            AnyChannel::new(*name, FlatSamples::F32(values))
        })
        .collect();
    let layer = Layer::new(
        (size.width as usize, size.height as usize),
        LayerAttributes::default(),
        Encoding::UNCOMPRESSED,
        AnyChannels::sort(channels),
    );
    let mut bytes = Cursor::new(Vec::new());
    Image::from_layer(layer)
        .write()
        .non_parallel()
        .to_buffered(&mut bytes)
        .map_err(|error| failed("an OpenEXR picture", &error.to_string()))?;
    Ok(bytes.into_inner())
}

/// The samples by pixel, if they are as many as the size says.
fn pixels<T>(size: Size, samples: &[T]) -> Result<std::slice::ChunksExact<'_, T>> {
    let Size {
        width,
        height,
        channels,
    } = size;
    let wanted = u64::from(width) * u64::from(height) * u64::from(channels);
    if !(1..=2).contains(&channels) || wanted == 0 || samples.len() as u64 != wanted {
        return Err(Error::Arguments {
            asked: format!(
                "a picture of {width} x {height} pixels, {channels} channels and {} samples",
                samples.len()
            ),
            limit: "it has 1 or 2 channels, and as many samples as channels of pixels".into(),
            remedy: "give the size of the samples".into(),
        });
    }
    Ok(samples.chunks_exact(channels as usize))
}

fn failed(what: &str, problem: &str) -> Error {
    Error::Arguments {
        asked: what.to_owned(),
        limit: problem.to_owned(),
        remedy: "write an .npy instead, and report this".to_owned(),
    }
}
