//! Radiance pictures (.hdr, .pic): texels of four bytes, a shared exponent last.
//!
//! Source: Ward 1991, Real pixels, Graphics Gems II; the file format of Radiance 6,
//! `ray/doc/filefmts.pdf`. Scan lines are stored flat, or run-length encoded in the old way
//! (a texel 1, 1, 1, n repeats the one before n 256^k times) or in the new one (the four
//! bytes of all texels apart). A byte c with exponent e is (c + 1/2) 2^(e - 136), as Radiance
//! decodes it, 0 for e = 0, and is divided by the product of all EXPOSURE lines.

use super::{Fault, MAX_HEIGHT, MAX_WIDTH, NOT_SOUND, fault, regular, unopened};
use std::fs::File;
use std::io::Read;
use std::path::Path;

/// A size of columns and rows, and texels as the file has them.
pub type Texels = (usize, usize, Vec<[f32; 3]>);

const SAVE_ANEW: &str = "save it anew as Radiance RGBE with rows from the top (-Y, then +X)";
const TRUNCATED: &str = "it ends too early: it is truncated";
/// Longer headers are no headers.
const MAX_HEADER: usize = 1 << 16;

/// Bytes of a picture at most: a header with its last line, and rows of the largest size whose
/// every byte is a run of its own.
const MOST: u64 = (2 * MAX_HEADER + MAX_HEIGHT * (4 + 8 * MAX_WIDTH)) as u64;

/// Bytes that are read one after the other.
struct Bytes<'b> {
    rest: &'b [u8],
}

impl<'b> Bytes<'b> {
    fn take(&mut self, count: usize) -> Result<&'b [u8], Fault> {
        let (taken, rest) = self.rest.split_at_checked(count).ok_or(TRUNCATED)?;
        self.rest = rest;
        Ok(taken)
    }

    fn byte(&mut self) -> Result<u8, Fault> {
        Ok(self.take(1)?[0])
    }

    fn texel(&mut self) -> Result<[u8; 4], Fault> {
        let bytes = self.take(4)?;
        Ok([bytes[0], bytes[1], bytes[2], bytes[3]])
    }

    /// A line of the header, without its end.
    fn line(&mut self) -> Result<&'b str, Fault> {
        let end = self.rest.iter().take(MAX_HEADER).position(|&b| b == b'\n');
        let line = self.take(end.ok_or("its header does not end")?)?;
        self.byte()?;
        let line = std::str::from_utf8(line).map_err(|_| "its header is no text")?;
        Ok(line.trim_end_matches('\r'))
    }
}

/// Reads the picture of a file.
pub fn open(path: &Path) -> Result<Texels, Fault> {
    let file = File::open(regular(path)?).map_err(unopened)?;
    let length = file.metadata().map_err(unopened)?.len();
    if length > MOST {
        let problem = format!("it has {length} bytes; the limit is {MOST}");
        return Err(fault(problem, SAVE_ANEW));
    }
    let mut bytes = Vec::new();
    // It may grow meanwhile.
    let taken = file.take(MOST).read_to_end(&mut bytes);
    taken.map_err(|error| fault(format!("it cannot be read ({error})"), NOT_SOUND))?;
    read(&bytes)
}

/// The same of its bytes.
fn read(bytes: &[u8]) -> Result<Texels, Fault> {
    let mut bytes = Bytes { rest: bytes };
    if !bytes.rest.starts_with(b"#?") {
        return Err(fault(
            "it is no Radiance picture, which begins with #?",
            SAVE_ANEW,
        ));
    }
    let exposure = header(&mut bytes)?;
    let (width, height) = size(bytes.line()?)?;
    // However it is encoded, a row takes a texel's bytes at least.
    if bytes.rest.len() / height < 4 {
        return Err(TRUNCATED.into());
    }
    let mut row = vec![[0u8; 4]; width];
    let mut texels = Vec::with_capacity(width * height);
    for _ in 0..height {
        scan_line(&mut bytes, &mut row)?;
        texels.extend(row.iter().map(|&texel| colour(texel, exposure)));
    }
    Ok((width, height, texels))
}

/// The product of all exposures.
fn header(bytes: &mut Bytes) -> Result<f64, Fault> {
    let start = bytes.rest.len();
    let mut exposure = 1.0;
    loop {
        let line = bytes.line()?;
        if line.is_empty() {
            break;
        }
        if start - bytes.rest.len() > MAX_HEADER {
            return Err("its header does not end".into());
        }
        if let Some(format) = line.strip_prefix("FORMAT=")
            && format.trim() != "32-bit_rle_rgbe"
        {
            return Err(fault(
                format!("its format is {}, not 32-bit_rle_rgbe", format.trim()),
                SAVE_ANEW,
            ));
        }
        if let Some(value) = line.strip_prefix("EXPOSURE=") {
            let value: f64 = value.trim().parse().unwrap_or(f64::NAN);
            exposure *= value;
        }
    }
    if !(exposure.is_finite() && exposure > 0.0) {
        return Err(fault(
            format!("its exposure is {exposure}, which is no positive number"),
            SAVE_ANEW,
        ));
    }
    Ok(exposure)
}

/// Columns and rows of the line `-Y height +X width`.
fn size(line: &str) -> Result<(usize, usize), Fault> {
    let words: Vec<&str> = line.split_whitespace().collect();
    let &[y, height, x, width] = &words[..] else {
        return Err(fault(format!("`{line}` is no size"), SAVE_ANEW));
    };
    if (y, x) != ("-Y", "+X") {
        return Err(fault(
            format!("its rows run {y} and {x}, not -Y and +X"),
            SAVE_ANEW,
        ));
    }
    let number = |word: &str| word.parse::<usize>().ok();
    match (number(width), number(height)) {
        (Some(width), Some(height))
            if (1..=MAX_WIDTH).contains(&width) && (1..=MAX_HEIGHT).contains(&height) =>
        {
            Ok((width, height))
        }
        (Some(0), _) | (_, Some(0)) => Err(fault(
            format!("its size is {width} x {height}: it has no texels"),
            SAVE_ANEW,
        )),
        _ => Err(fault(
            format!("its size is {width} x {height}; the limit is {MAX_WIDTH} x {MAX_HEIGHT}"),
            "scale it down",
        )),
    }
}

fn colour([r, g, b, e]: [u8; 4], exposure: f64) -> [f32; 3] {
    if e == 0 {
        return [0.0; 3];
    }
    let scale = f64::powi(2.0, i32::from(e) - 136) / exposure;
    [r, g, b].map(|c| ((f64::from(c) + 0.5) * scale) as f32)
}

fn scan_line(bytes: &mut Bytes, row: &mut [[u8; 4]]) -> Result<(), Fault> {
    let width = row.len();
    let lead = bytes.rest.get(..4);
    let apart = lead.is_some_and(|b| b[..2] == [2, 2] && b[2] < 128);
    if !apart || !(8..0x8000).contains(&width) {
        return flat(bytes, row);
    }
    let [_, _, high, low] = bytes.texel()?;
    let told = usize::from(high) << 8 | usize::from(low);
    if told != width {
        return Err(format!("a row of it has {told} texels, not {width}")
            .as_str()
            .into());
    }
    for part in 0..4 {
        let mut at = 0;
        while at < width {
            let count = usize::from(bytes.byte()?);
            let (count, run) = match count {
                129.. => (count - 128, true),
                _ => (count, false),
            };
            if count == 0 || at + count > width {
                return Err("a run of it is longer than its row".into());
            }
            let values = bytes.take(if run { 1 } else { count })?;
            for (texel, value) in row[at..at + count].iter_mut().zip(values.iter().cycle()) {
                texel[part] = *value;
            }
            at += count;
        }
    }
    Ok(())
}

/// Texels one by one, with runs in the old way.
fn flat(bytes: &mut Bytes, row: &mut [[u8; 4]]) -> Result<(), Fault> {
    let (mut at, mut shift) = (0, 0);
    while at < row.len() {
        let texel = bytes.texel()?;
        if texel[..3] != [1, 1, 1] {
            row[at] = texel;
            (at, shift) = (at + 1, 0);
            continue;
        }
        // Beyond two bytes a run is longer than any row.
        let count = match shift {
            0 | 8 => usize::from(texel[3]) << shift,
            _ => usize::MAX,
        };
        if at == 0 || count > row.len() - at {
            return Err("a run of it is longer than its row".into());
        }
        let last = row[at - 1];
        row[at..at + count].fill(last);
        (at, shift) = (at + count, shift + 8);
    }
    Ok(())
}
