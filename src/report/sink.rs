//! The writer: rows in, a finished file out.

use std::io;
use std::path::PathBuf;

use super::chunked::{self, Chunked, Extent, Keeping, Origin};
use super::encode::Encoder;
use super::place::{Existing, Place, Target, existing, failed};
use super::stream::Stream;
use super::{Format, Layout};
use crate::error::{Error, Result};

/// What was written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Summary {
    /// Bytes of the file, header included, sidecar not.
    pub bytes: u64,
    /// SHA-256 of a regular file in lower-case hexadecimal, which its sidecar holds too.
    /// Streams are not hashed.
    pub sha256: Option<String>,
}

/// Takes the data of one array, chunk by chunk, and makes the file of it.
///
/// A regular file gets a [`Sidecar`](super::Sidecar) beside it. It is written, synced and
/// hashed by two threads of its own, over four buffers of 16 MiB; or written by a device, in
/// place ([`Sink::extent`]), and hashed by them. Dropped without
/// [`Sink::finish`], it removes what it wrote, or keeps it as [`Sink::keeping`] says.
pub struct Sink {
    out: Out,
    encoder: Encoder,
    /// The target as messages name it.
    path: PathBuf,
    /// Words in the whole array, and those taken so far.
    total: u64,
    taken: u64,
    broken: bool,
}

enum Out {
    File(Box<Chunked>),
    Stream(Stream),
}

impl Sink {
    /// Opens the target for an array of this layout. `origin` goes into the sidecar.
    ///
    /// # Errors
    ///
    /// [`Error::Output`] if the folder does not exist or is not writable, if another run is
    /// writing the file, or if the target is a folder or, for binary data, a terminal;
    /// [`Error::Arguments`] if the layout is impossible; [`Error::Io`] if the
    /// header cannot be written.
    pub fn open(
        target: &Target,
        format: Format,
        layout: Layout,
        origin: impl Into<Origin>,
    ) -> Result<Self> {
        Self::make(target, format, layout, origin.into(), None, &mut |_, _| {
            Ok(())
        })
    }

    /// The same for a file that outlives a run which fails: complete chunks stay under a
    /// partial name, from which a run with [`Keeping::resume`] goes on. It reads them again
    /// before; `watch` hears how many of how many bytes it has read, and may stop it.
    ///
    /// # Errors
    ///
    /// As [`Sink::open`]; also [`Error::Output`] if what is to be gone on from is of another
    /// origin, version or layout, [`Error::Arguments`] for too many chunks, or if a stream is
    /// to go on, and those of `watch`.
    pub fn keeping(
        target: &Target,
        format: Format,
        layout: Layout,
        origin: Origin,
        keeping: Keeping,
        watch: &mut dyn FnMut(u64, u64) -> Result<()>,
    ) -> Result<Self> {
        Self::make(target, format, layout, origin, Some(keeping), watch)
    }

    fn make(
        target: &Target,
        format: Format,
        layout: Layout,
        origin: Origin,
        keeping: Option<Keeping>,
        watch: &mut dyn FnMut(u64, u64) -> Result<()>,
    ) -> Result<Self> {
        let total = layout.words()?;
        let encoder = Encoder::new(format, layout, &target.name())?;
        let file = match target {
            Target::File(path) => Some((path, existing(path)?)),
            Target::Stdout => None,
        };
        let (out, path) = match file {
            Some((path, Existing::File(real))) => {
                let file = Chunked::open(path, real, encoder.clone(), origin, keeping, watch)?;
                (Out::File(Box::new(file)), path.clone())
            }
            _ => {
                let (place, path) = Place::open(target, format)?;
                if keeping.is_some_and(|keeping| keeping.resume || keeping.chunk_rows.is_some()) {
                    return Err(Error::Arguments {
                        asked: format!("--resume or --chunk-rows with {}", path.display()),
                        limit: "only a regular file has chunks, and can be taken up again".into(),
                        remedy: "drop them, or give the name of a file".into(),
                    });
                }
                (Out::Stream(Stream::new(place, &encoder)), path)
            }
        };
        let start = match &out {
            Out::File(file) => file.start(),
            Out::Stream(_) => 0,
        };
        Ok(Self {
            out,
            path,
            total,
            taken: start * u64::from(layout.columns),
            broken: false,
            encoder,
        })
    }

    /// Whether a file of this layout and origin is finished under this name, so that there is
    /// nothing to go on with. Its bytes are not read.
    ///
    /// # Errors
    ///
    /// [`Error::Output`] if the target is a folder, or finished by another version of corput;
    /// [`Error::Arguments`] as [`Sink::open`].
    pub fn is_finished(
        target: &Target,
        format: Format,
        layout: Layout,
        origin: &Origin,
    ) -> Result<bool> {
        match target {
            Target::File(path) => {
                chunked::is_finished(path, &Encoder::new(format, layout, &target.name())?, origin)
            }
            Target::Stdout => Ok(false),
        }
    }

    /// Shape and type of the array.
    #[must_use]
    pub fn layout(&self) -> Layout {
        self.encoder.layout
    }

    /// Rows taken so far, those of an earlier run among them.
    #[must_use]
    pub fn rows(&self) -> u64 {
        self.taken / u64::from(self.encoder.layout.columns)
    }

    /// Words that complete the chunk at work. Whoever writes no more at once may stop between
    /// chunks, each of which waits for the disk. A stream has no chunks, and no such limit.
    #[must_use]
    pub fn chunk_left(&self) -> u64 {
        match &self.out {
            Out::File(file) => file.chunk_left(self.taken),
            Out::Stream(_) => u64::MAX,
        }
    }

    /// Appends words, row-major; floats as their bits. A piece may begin and
    /// end anywhere, also within a row.
    ///
    /// # Errors
    ///
    /// [`Error::Io`] if they cannot be written: the disk is full, the pipe is
    /// closed; [`Error::Arguments`] if they are more than the layout has. The
    /// sink is of no more use then. What a file says may be of earlier words.
    pub fn write(&mut self, words: &[u32]) -> Result<()> {
        self.still_whole()?;
        // Until the words are written, so that an error cannot be passed over.
        self.broken = true;
        let taken = self.taken.saturating_add(words.len() as u64);
        if taken > self.total {
            return Err(self.miscounted(taken));
        }
        match &mut self.out {
            Out::File(file) => file.write(self.taken, words)?,
            Out::Stream(stream) => stream.write(&self.encoder, self.taken, words, &self.path)?,
        }
        self.taken = taken;
        self.broken = false;
        Ok(())
    }

    /// Space on the disk for the rows from `row` on, up to the end of their chunk or 16 MiB, for
    /// somebody who writes the words there: as 4 bytes each, little-endian. None where the file's
    /// bytes are others, where chunks are short or no whole pages, of a stream, and where
    /// system or file system cannot reserve space. [`Self::take`] takes the words then. An extent
    /// may be had before those before it are taken.
    ///
    /// # Errors
    ///
    /// [`Error::Io`] if the disk is full. The sink can still be written to, as far as there is space.
    pub fn extent(&self, row: u64) -> Result<Option<Extent>> {
        match &self.out {
            Out::File(file) if row >= self.rows() => file.extent(row),
            _ => Ok(None),
        }
    }

    /// Takes the words of the next rows, which stand in an [extent](Self::extent) now and whose
    /// writer has let go of it.
    ///
    /// # Errors
    ///
    /// As [`Sink::write`]; [`Error::Arguments`] also if the extent is of another file, or of rows
    /// that are not the next.
    pub fn take(&mut self, extent: Extent) -> Result<()> {
        self.still_whole()?;
        self.broken = true;
        let columns = u64::from(self.encoder.layout.columns);
        let rows = extent.rows();
        match &mut self.out {
            Out::File(file) if file.is_own(&extent) && rows.start * columns == self.taken => {
                file.take(&extent)?;
            }
            _ => {
                return Err(Error::Arguments {
                    asked: format!("rows {rows:?} of {}", self.path.display()),
                    limit: format!("row {} of that file is the next", self.rows()),
                    remedy: "take extents of one sink in the order of their rows".into(),
                });
            }
        }
        self.taken = rows.end * columns;
        self.broken = false;
        Ok(())
    }

    /// Completes the file: all bytes to the disk, then the sidecar, then the final name.
    ///
    /// # Errors
    ///
    /// [`Error::Arguments`] if fewer words came than the layout has;
    /// [`Error::Io`] if the file cannot be completed. The data that stood
    /// under the final name is then as it was. [`Error::Kept`] as [`Sink::abandon`] says.
    pub fn finish(self) -> Result<Summary> {
        let whole = self.still_whole().and_then(|()| match self.taken {
            taken if taken == self.total => Ok(()),
            taken => Err(self.miscounted(taken)),
        });
        if let Err(cause) = whole {
            return Err(self.abandon(cause));
        }
        match self.out {
            Out::Stream(stream) => Ok(Summary {
                bytes: stream.finish(&self.encoder, &self.path)?,
                sha256: None,
            }),
            Out::File(mut file) => match file.finish() {
                Ok((bytes, sha256)) => Ok(Summary {
                    bytes,
                    sha256: Some(sha256),
                }),
                Err(cause) => Err(file.abandon(cause)),
            },
        }
    }

    /// Ends without a file. Returns the error that was the cause, as [`Error::Kept`] where
    /// complete chunks stay for a later run.
    #[must_use]
    pub fn abandon(self, cause: Error) -> Error {
        match self.out {
            Out::File(mut file) => file.abandon(cause),
            Out::Stream(_) => cause,
        }
    }

    fn still_whole(&self) -> Result<()> {
        if self.broken {
            return Err(failed(
                "complete",
                &self.path,
                io::Error::other("an earlier write to it failed"),
            ));
        }
        Ok(())
    }

    fn miscounted(&self, taken: u64) -> Error {
        let Layout { rows, columns, .. } = self.encoder.layout;
        Error::Arguments {
            asked: format!("{taken} words for {}", self.path.display()),
            limit: format!("{rows} rows of {columns} are {}", self.total),
            remedy: "write exactly as many as the layout has".to_owned(),
        }
    }
}

/// Bytes as lower-case digits, as `sha256sum` prints a hash.
#[must_use]
pub fn hexadecimal(bytes: &[u8]) -> String {
    bytes.iter().map(|byte| format!("{byte:02x}")).collect()
}
