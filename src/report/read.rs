//! `.npy` files of points.
//!
//! Format: NumPy enhancement proposal 1 and `numpy/lib/format.py`, versions 1 to 3.

mod header;

use crate::error::{Error, Result};
use crate::stats::{Points, Source};
use header::Header;
use std::fs::File;
use std::io::{self, BufReader, Read};
use std::path::Path;

/// The most values that a file of points may hold: 2 GiB of them as `f64`.
pub const MAX_VALUES: u64 = 1 << 28;

/// Bytes of a header at most; NumPy's have a few hundred.
const MAX_HEADER: usize = 1 << 16;

/// Bytes that are read at a time.
const CHUNK: usize = 1 << 16;

/// Reads points from an `.npy` file: a two-dimensional array, one point a row, of `u4`,
/// `f4` or `f8` of either byte order, in C or Fortran order. A `u4` is a fraction of 2^32.
///
/// Memory grows with what the file holds, not with what its header says.
///
/// # Errors
/// [`Error::Points`] for a file that cannot be read, is no `.npy` file, is shorter or longer
/// than its shape, has another type or number of dimensions, is empty, holds more than
/// [`MAX_VALUES`] values, or one that is not in [0, 1): the first is named.
pub fn read_points(path: &Path) -> Result<Points> {
    let refuse = |(problem, remedy): Refusal| Error::Points {
        path: path.to_owned(),
        problem,
        remedy,
    };
    let unreadable = |source: io::Error| {
        refuse((
            source.to_string(),
            "name a file that can be read".to_owned(),
        ))
    };
    let file = File::open(path).map_err(unreadable)?;
    let known = file.metadata().map_err(unreadable)?;
    // A pipe has no length, and what it holds is only known at its end.
    let length = known.is_file().then_some(known.len());
    points(BufReader::with_capacity(CHUNK, file), length).map_err(|fault| match fault {
        Fault::Refused(refusal) => refuse(refusal),
        Fault::Io(source) => unreadable(source),
    })
}

/// What is wrong, and what to do.
type Refusal = (String, String);

/// Why reading ended.
enum Fault {
    Refused(Refusal),
    Io(io::Error),
}

fn fault(problem: impl Into<String>, remedy: impl Into<String>) -> Fault {
    Fault::Refused((problem.into(), remedy.into()))
}

fn points(mut file: impl Read, length: Option<u64>) -> Result<Points, Fault> {
    let (header, start) = prefix(&mut file)?;
    let Header {
        element,
        fortran,
        shape,
    } = header;
    let &[rows, columns] = shape.as_slice() else {
        return Err(fault(
            format!(
                "its array has {} dimension{} and must be 2-D, one point a row",
                shape.len(),
                if shape.len() == 1 { "" } else { "s" }
            ),
            "save it with a shape (points, coordinates): x.reshape(-1, 1) for one coordinate",
        ));
    };
    if rows == 0 || columns == 0 {
        return Err(fault(
            format!("its array is empty: shape ({rows}, {columns})"),
            "save at least one point of one coordinate",
        ));
    }
    let count = rows.checked_mul(columns).filter(|n| *n <= MAX_VALUES);
    let count = count.ok_or_else(|| {
        fault(
            format!("its shape ({rows}, {columns}) has more than {MAX_VALUES} values, the limit"),
            "save a part of it",
        )
    })?;
    let bytes = count * element.size as u64;
    if let Some(held) = length {
        complete(held.saturating_sub(start), bytes)?;
    }
    let mut values = Vec::new();
    if length.is_some() {
        values.reserve_exact(count as usize);
    }
    let mut chunk = vec![0; CHUNK];
    let mut done = 0;
    while done < bytes {
        let part = &mut chunk[..(bytes - done).min(CHUNK as u64) as usize];
        let got = fill(&mut file, part)?;
        done += got as u64;
        if got < part.len() {
            complete(done, bytes)?;
        }
        values.extend(
            part.chunks_exact(element.size)
                .map(|word| element.value(word)),
        );
    }
    let more = fill(&mut file, &mut chunk[..1])? as u64;
    complete(bytes + more, bytes)?;
    let columns = columns as usize;
    if fortran {
        values = transposed(&values, columns);
    }
    Points::new(columns, values, element.source).map_err(|error| match error {
        Error::Arguments {
            asked,
            limit,
            remedy,
        } => fault(format!("{asked}; {limit}"), remedy),
        other => fault(other.to_string(), ""),
    })
}

/// The header, and where the data start.
fn prefix(file: &mut impl Read) -> Result<(Header, u64), Fault> {
    let foreign = || {
        fault(
            "it is no .npy file: it does not begin with \\x93NUMPY",
            "write it with `corput generate --out FILE.npy` or numpy.save",
        )
    };
    let truncated = || fault("it ends within its header", "write it again");
    let mut begin = [0; 8];
    if fill(file, &mut begin)? < 8 || !begin.starts_with(b"\x93NUMPY") {
        return Err(foreign());
    }
    let width = match begin[6] {
        1 => 2,
        2 | 3 => 4,
        version => {
            return Err(fault(
                format!("it has version {version} of the format; known are 1 to 3"),
                "save it with a release of NumPy that writes one of those",
            ));
        }
    };
    let mut size = [0; 4];
    if fill(file, &mut size[..width])? < width {
        return Err(truncated());
    }
    let size = u32::from_le_bytes(size) as usize;
    if size > MAX_HEADER {
        return Err(fault(
            format!("its header has {size} bytes, and at most {MAX_HEADER} are read"),
            "save a plain array of f4, f8 or u4",
        ));
    }
    let mut text = vec![0; size];
    if fill(file, &mut text)? < size {
        return Err(truncated());
    }
    let header = header::parse(&text).map_err(Fault::Refused)?;
    Ok((header, (8 + width + size) as u64))
}

/// Whether the file holds as many bytes of data as its shape says.
fn complete(held: u64, bytes: u64) -> Result<(), Fault> {
    match held {
        held if held < bytes => Err(fault(
            format!("it is truncated: its shape needs {bytes} bytes of data, and it holds {held}"),
            "write it again",
        )),
        held if held > bytes => Err(fault(
            format!("its shape needs {bytes} bytes of data, and it holds more"),
            "save one array a file",
        )),
        _ => Ok(()),
    }
}

/// Reads until the buffer is full or the file ends.
fn fill(file: &mut impl Read, buffer: &mut [u8]) -> Result<usize, Fault> {
    let mut got = 0;
    while got < buffer.len() {
        match file.read(&mut buffer[got..]) {
            Ok(0) => break,
            Ok(n) => got += n,
            Err(error) if error.kind() == io::ErrorKind::Interrupted => {}
            Err(error) => return Err(Fault::Io(error)),
        }
    }
    Ok(got)
}

/// Rows from columns that lie one after the other.
fn transposed(values: &[f64], columns: usize) -> Vec<f64> {
    let rows = values.len() / columns;
    let at = |i: usize| values[i % columns * rows + i / columns];
    (0..values.len()).map(at).collect()
}

/// How a value lies in the file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Element {
    source: Source,
    size: usize,
    big_endian: bool,
}

impl Element {
    /// The value of a word of `size` bytes.
    fn value(self, word: &[u8]) -> f64 {
        let mut bytes = [0; 8];
        bytes[..word.len()].copy_from_slice(word);
        if self.big_endian {
            bytes[..word.len()].reverse();
        }
        let wide = u64::from_le_bytes(bytes);
        let value = match self.source {
            Source::U32 => wide as f64 / 4_294_967_296.0,
            Source::F32 => f64::from(f32::from_bits(wide as u32)),
            Source::F64 => f64::from_bits(wide),
        };
        // -0 is 0.
        value + 0.0
    }
}
