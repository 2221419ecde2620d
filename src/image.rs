//! Reading environment maps: an OpenEXR file or a Radiance picture to rows of linear RGB.
//!
//! The header is judged before a texel is decoded, so no file makes the
//! reader allocate more than [`MAX_WIDTH`] x [`MAX_HEIGHT`] allows. Everything that is
//! wrong with a file is an [`Error::Image`].

mod header;
mod radiance;

use std::collections::HashSet;
use std::fs::File;
use std::io::BufReader;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;

use exr::block::UncompressedBlock;
use exr::block::lines::LineRef;
use exr::block::reader::{ChunksReader, Reader};
use exr::meta::attribute::SampleType;
use exr::prelude::f16;

use crate::error::{Error, Result};
use header::{Colour, check_counters, check_layout, check_size, find_colour};
use radiance::Texels;

/// The widest image that is read.
pub const MAX_WIDTH: usize = crate::environment::MAX_WIDTH as usize;
/// The highest image that is read.
pub const MAX_HEIGHT: usize = crate::environment::MAX_HEIGHT as usize;
/// The most negative light, as a share of all light, that is set to 0 and not refused.
/// Lossy compression rings around bright spots: the maps that Blender ships have up to
/// 6e-7, in up to one texel of a hundred.
pub const NEGATIVE_SHARE: f64 = 1e-5;

const NOT_SOUND: &str = "fetch it again, or save it anew";
const SAVE_RGB: &str = "save it as one part with the channels R, G and B, or Y";

/// An image of linear RGB radiances, each finite and at least 0 but for those of [`load_raw`].
#[derive(Clone, Debug, PartialEq)]
pub struct Image {
    /// Texels in a row.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// `width * height` texels, row 0 (the top) first.
    pub texels: Vec<[f32; 3]>,
    /// Texels that had a negative channel, which is now 0: see [`NEGATIVE_SHARE`].
    pub clamped: usize,
}

/// Reads an OpenEXR image: scan lines or tiles of f16, f32 or u32 samples in any
/// compression that the crate `exr` decodes, DWAB included.
///
/// Of several parts and layers the first with R, G and B is taken, else the first
/// with Y, which then fills all three; alpha and the rest are ignored, and so are smaller
/// resolution levels.
///
/// # Errors
///
/// [`Error::Image`] if the file is missing, no regular file, corrupt, truncated, larger
/// than [`MAX_WIDTH`] x [`MAX_HEIGHT`], cropped, without colour, subsampled, or
/// has texels that are not finite, or negative beyond [`NEGATIVE_SHARE`].
pub fn load_exr(path: &Path) -> Result<Image> {
    image(path, open_exr, check_texels)
}

/// Reads an image: a Radiance picture where the name ends in `.hdr` or `.pic`, else
/// OpenEXR.
///
/// # Errors
///
/// Those of [`load_exr`]; of a Radiance picture also if it is not RGBE, or its rows do not
/// run from the top and from the left.
pub fn load(path: &Path) -> Result<Image> {
    image(path, opener(path), check_texels)
}

/// Reads an image as [`load`] does, texels that are no light included:
/// [`Environment::new`](crate::environment::Environment::new) takes and counts them.
///
/// # Errors
///
/// Those of [`load`] but for what concerns texels.
pub fn load_raw(path: &Path) -> Result<Image> {
    image(path, opener(path), |_, _| Ok(0))
}

/// What reads a file.
type Opener = fn(&Path) -> Result<Texels, Fault>;

fn opener(path: &Path) -> Opener {
    let ending = path.extension().map(|e| e.to_string_lossy().to_lowercase());
    match ending.as_deref() {
        Some("hdr" | "pic") => radiance::open,
        _ => open_exr,
    }
}

fn open_exr(path: &Path) -> Result<Texels, Fault> {
    // exr 1.74 computes with what a file says. With overflow checks on (the dev profile) its
    // B44 decoder panics on some damaged files; without them 20,000 found no panic. It runs on
    // this thread and owns all that it touches, so unwinding past it is safe. The panic
    // hook is left alone: it is global, and replacing it would race with other threads.
    catch_unwind(AssertUnwindSafe(|| read(path)))
        .unwrap_or_else(|_| Err("its data made the decoder fail: it is corrupt".into()))
}

fn image(
    path: &Path,
    open: Opener,
    judge: fn(usize, &mut [[f32; 3]]) -> Result<usize, Fault>,
) -> Result<Image> {
    let made = open(path).and_then(|(width, height, mut texels)| {
        let clamped = judge(width, &mut texels)?;
        Ok(Image {
            width: width as u32,
            height: height as u32,
            texels,
            clamped,
        })
    });
    made.map_err(|fault: Fault| Error::Image {
        path: path.to_owned(),
        problem: fault.problem,
        remedy: fault.remedy.to_owned(),
    })
}

/// What is wrong with a file, before its path is added.
struct Fault {
    problem: String,
    remedy: &'static str,
}

impl From<&str> for Fault {
    fn from(problem: &str) -> Self {
        fault(problem, NOT_SOUND)
    }
}

impl From<exr::error::Error> for Fault {
    fn from(error: exr::error::Error) -> Self {
        use exr::error::Error::{Aborted, Invalid, Io, NotSupported};
        match error {
            Io(error) if error.kind() == std::io::ErrorKind::UnexpectedEof => {
                "it ends too early: it is truncated".into()
            }
            Io(error) => fault(
                format!("it cannot be read ({error})"),
                "check the disk and the file",
            ),
            NotSupported(what) => {
                fault(format!("it uses what is not supported ({what})"), SAVE_RGB)
            }
            Invalid(what) => format!("it is no sound OpenEXR file (invalid {what})")
                .as_str()
                .into(),
            Aborted => "its decoding was aborted".into(),
        }
    }
}

fn fault(problem: impl Into<String>, remedy: &'static str) -> Fault {
    Fault {
        problem: problem.into(),
        remedy,
    }
}

fn unopened(error: std::io::Error) -> Fault {
    fault(
        format!("it cannot be opened ({error})"),
        "check the path and its permissions",
    )
}

/// The path, if a file with anything in it lies there.
fn regular(path: &Path) -> Result<&Path, Fault> {
    // Asked before opening, since opening a pipe would wait for its writer.
    let kind = std::fs::metadata(path).map_err(unopened)?;
    if !kind.is_file() {
        return Err(fault(
            "it is no regular file",
            "give the path of an OpenEXR file or a Radiance picture",
        ));
    }
    if kind.len() == 0 {
        return Err("it is empty".into());
    }
    Ok(path)
}

fn read(path: &Path) -> Result<Texels, Fault> {
    let length = std::fs::metadata(regular(path)?).map_err(unopened)?.len();
    let file = BufReader::new(File::open(path).map_err(unopened)?);
    let reader = exr::block::read(file, true)?;
    let parts = reader.headers();
    // The decoder reads the chunk tables of all parts, eight bytes a chunk.
    let chunks = parts
        .iter()
        .try_fold(0_u64, |sum, part| sum.checked_add(part.chunk_count as u64));
    if chunks
        .and_then(|n| n.checked_mul(8))
        .is_none_or(|bytes| bytes > length)
    {
        parts.iter().try_for_each(check_size)?;
        return Err("it is shorter than its table of chunks: it is truncated".into());
    }
    let (part, colour) = find_colour(parts)?;
    check_layout(&parts[part], colour)?;
    decode(reader, part, colour)
}
fn decode(reader: Reader<BufReader<File>>, part: usize, colour: Colour) -> Result<Texels, Fault> {
    let chunks = reader.filter_chunks(true, |_, _, block| {
        block.layer == part && block.level.x() == 0 && block.level.y() == 0
    })?;
    let meta = chunks.meta_data().clone();
    let header = &meta.headers[part];
    let (width, height) = (header.layer_size.width(), header.layer_size.height());
    let mut texels = vec![[0.0; 3]; width * height];
    let mut places = HashSet::new();
    for chunk in chunks {
        let chunk = chunk?;
        check_counters(header, &chunk.compressed_block)?;
        let block = UncompressedBlock::decompress_chunk(chunk, &meta, true)?;
        let index = block.index;
        // With as many blocks as the image has and none twice, none is missing.
        if index.layer != part || index.level.x() + index.level.y() != 0 || !places.insert(index) {
            return Err("one of its blocks is stored twice or in a wrong place".into());
        }
        for line in block.lines(&header.channels) {
            let channel = line.location.channel;
            let first = line.location.position.y() * width + line.location.position.x();
            for (into, _) in colour.iter().enumerate().filter(|&(_, &c)| c == channel) {
                let row = texels[first..].iter_mut().map(|texel| &mut texel[into]);
                fill(row, &line, header.channels.list[channel].sample_type);
            }
        }
    }
    Ok((width, height, texels))
}
/// Converts a line's bytes, which the decoder gives in the machine's order.
fn fill<'t>(row: impl Iterator<Item = &'t mut f32>, line: &LineRef<'_>, kind: SampleType) {
    match kind {
        SampleType::F16 => {
            for (to, from) in row.zip(line.value.as_chunks().0) {
                *to = f16::from_ne_bytes(*from).to_f32();
            }
        }
        SampleType::F32 => {
            for (to, from) in row.zip(line.value.as_chunks().0) {
                *to = f32::from_ne_bytes(*from);
            }
        }
        SampleType::U32 => {
            for (to, from) in row.zip(line.value.as_chunks().0) {
                *to = u32::from_ne_bytes(*from) as f32;
            }
        }
    }
}

/// Refuses texels that are no light, and clamps what lossy compression left below 0.
fn check_texels(width: usize, texels: &mut [[f32; 3]]) -> Result<usize, Fault> {
    const REPLACE: &str = "replace infinities and NaNs, then save it again";
    if let Some((_, places)) = find_texels(width, texels, |l| !l.is_finite()) {
        return Err(fault(format!("{places} not finite"), REPLACE));
    }
    let Some((count, places)) = find_texels(width, texels, |l| l < 0.0) else {
        return Ok(0);
    };
    let (mut below, mut all) = (0.0, 0.0);
    for light in texels.iter().flatten().map(|&l| f64::from(l)) {
        below += (-light).max(0.0);
        all += light.abs();
    }
    if below > NEGATIVE_SHARE * all {
        let share = format!(
            "{:.1e} of all light; the limit is {NEGATIVE_SHARE:e}",
            below / all
        );
        return Err(fault(
            format!("{places} negative, {share}"),
            "clamp it to 0 and above, then save it again",
        ));
    }
    for light in texels.iter_mut().flatten().filter(|light| **light < 0.0) {
        *light = 0.0;
    }
    Ok(count)
}

/// How many texels have such a channel, and the words for it: "2 texels (the first ...) are".
fn find_texels(
    width: usize,
    texels: &[[f32; 3]],
    wrong: fn(f32) -> bool,
) -> Option<(usize, String)> {
    let mut places = (0..texels.len()).filter(|&i| texels[i].iter().any(|&l| wrong(l)));
    let first = places.next()?;
    let count = 1 + places.count();
    let [r, g, b] = texels[first];
    let (column, row) = (first % width, first / width);
    let place = format!("column {column}, row {row}, R {r}, G {g}, B {b}");
    Some((
        count,
        match count {
            1 => format!("1 texel ({place}) is"),
            _ => format!("{count} texels (the first at {place}) are"),
        },
    ))
}
