//! What a file's headers say, judged before its texels are decoded.

use exr::block::chunk::{CompressedBlock, CompressedScanLineBlock, CompressedTileBlock};
use exr::compression::Compression;
use exr::meta::attribute::ChannelDescription;
use exr::meta::header::Header;

use super::{Fault, MAX_HEIGHT, MAX_WIDTH, SAVE_RGB, fault};

/// The most bytes that one block of a file may decode to: the largest image in
/// one tile of four f32 channels.
const MAX_BLOCK_BYTES: usize = MAX_WIDTH * MAX_HEIGHT * 16;

/// Indices of the channels that become R, G and B.
pub type Colour = [usize; 3];

/// The first part and layer with R, G and B, else the first with Y.
pub fn find_colour(parts: &[Header]) -> Result<(usize, Colour), Fault> {
    for wanted in [["R", "G", "B"], ["Y"; 3]] {
        for (index, part) in parts.iter().enumerate() {
            let names: Vec<String> = part
                .channels
                .list
                .iter()
                .map(|channel| channel.name.to_string())
                .collect();
            // A layer's channels share the prefix before the last dot: `diffuse.R`.
            for prefix in names.iter().filter_map(|name| name.strip_suffix(wanted[0])) {
                if !(prefix.is_empty() || prefix.ends_with('.')) {
                    continue;
                }
                let find = |suffix: &str| {
                    names
                        .iter()
                        .position(|name| name.strip_prefix(prefix) == Some(suffix))
                };
                if let [Some(r), Some(g), Some(b)] = wanted.map(find) {
                    return Ok((index, [r, g, b]));
                }
            }
        }
    }
    let names: Vec<String> = parts
        .iter()
        .flat_map(|part| &part.channels.list)
        .map(|c| c.name.to_string())
        .take(8)
        .collect();
    Err(fault(
        format!("it has no colour channels (it has {})", names.join(", ")),
        SAVE_RGB,
    ))
}

pub fn check_size(part: &Header) -> Result<(), Fault> {
    let size = part.layer_size;
    if size.width() > MAX_WIDTH || size.height() > MAX_HEIGHT {
        return Err(fault(
            format!(
                "its size is {} x {}; the limit is {MAX_WIDTH} x {MAX_HEIGHT}",
                size.width(),
                size.height()
            ),
            "scale it down",
        ));
    }
    if size.width() == 0 || size.height() == 0 {
        return Err("it has no texels".into());
    }
    Ok(())
}

/// Refuses what would decode to too much, or to texels in the wrong place.
pub fn check_layout(part: &Header, colour: Colour) -> Result<(), Fault> {
    check_size(part)?;
    if part.max_block_byte_size() > MAX_BLOCK_BYTES {
        return Err(fault(
            format!(
                "one block of it decodes to {} bytes; the limit is {MAX_BLOCK_BYTES}",
                part.max_block_byte_size()
            ),
            SAVE_RGB,
        ));
    }
    let display = part.shared_attributes.display_window;
    if display.size != part.layer_size || display.position != part.own_attributes.layer_position {
        return Err(fault(
            format!(
                "its data window is {} x {} in a display window of {} x {}",
                part.layer_size.width(),
                part.layer_size.height(),
                display.size.width(),
                display.size.height()
            ),
            "save it uncropped",
        ));
    }
    // The decoder does not place the lines of a block rightly if any channel is subsampled.
    let subsampled = |c: &&ChannelDescription| c.sampling.x() != 1 || c.sampling.y() != 1;
    if let Some(channel) = part.channels.list.iter().find(subsampled) {
        return Err(fault(
            format!("its channel {} is subsampled", channel.name),
            SAVE_RGB,
        ));
    }
    // Luminance and chroma (Y, RY, BY) at full resolution are colour, too.
    let has = |name: &str| {
        part.channels
            .list
            .iter()
            .any(|channel| channel.name.eq(name))
    };
    if colour[0] == colour[1] && has("RY") && has("BY") {
        return Err(fault(
            "its colour is stored as luminance and chroma",
            SAVE_RGB,
        ));
    }
    Ok(())
}

/// Refuses a DWA block whose counters ask for more than any block can hold: exr 1.74
/// allocates what they say (found by damaging files).
pub fn check_counters(header: &Header, block: &CompressedBlock) -> Result<(), Fault> {
    if !matches!(
        header.compression,
        Compression::DWAA(_) | Compression::DWAB(_)
    ) {
        return Ok(());
    }
    let (CompressedBlock::ScanLine(CompressedScanLineBlock {
        compressed_pixels_le: bytes,
        ..
    })
    | CompressedBlock::Tile(CompressedTileBlock {
        compressed_pixels_le: bytes,
        ..
    })) = block
    else {
        return Err("it has deep data".into());
    };
    // A block that would grow is stored as it is, without counters.
    let place =
        header.get_absolute_block_pixel_coordinates(header.get_block_data_indices(block)?)?;
    if bytes.len() == place.size.area() * header.channels.bytes_per_pixel {
        return Ok(());
    }
    // Eleven u64 lead: 1, 6 and 7 count bytes, 8 and 9 coefficients of blocks of 8 x 8.
    // Blocks are padded to 8 x 8; the constant covers those that are narrower.
    let limit = 4 * header.max_block_byte_size() as u64 + (1 << 24);
    let counters = bytes
        .as_chunks()
        .0
        .iter()
        .take(10)
        .map(|word| u64::from_le_bytes(*word));
    if counters
        .enumerate()
        .any(|(i, counter)| matches!(i, 1 | 6..=9) && counter > limit)
    {
        return Err("a block of it claims more data than it can hold".into());
    }
    Ok(())
}
