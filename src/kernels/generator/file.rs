//! Points that the device writes into a file itself.

use super::Generator;
use crate::report::{Extent, Sink};
use crate::vulkan::{Device, FileWindow};
use crate::{Error, Result};
use std::sync::Arc;

/// A window of the file, and the rows that belong there.
struct Opened {
    extent: Extent,
    window: FileWindow,
}

impl Generator {
    /// Writes the rows that a sink still lacks into its file, without a copy: windows of the file
    /// are the device's buffers. While it fills one the next is opened, so that two are mapped at
    /// most, of 16 MiB each. `meanwhile` is called as by [`Self::place`].
    ///
    /// Returns why a window was refused, or none where the sink has all rows. After a refusal it
    /// is as good as before: what it lacks then can be made by
    /// [`Engine::make_range`](crate::catalog::Engine::make_range) and written.
    ///
    /// # Errors
    /// Those of [`Self::place`], of [`Sink::take`], and [`Error::Io`] for a full disk, after the
    /// rows that have space are complete; [`Error::Arguments`] for a file of another shape.
    pub fn write_windows(
        &mut self,
        sink: &mut Sink,
        meanwhile: &mut dyn FnMut(u64) -> Result<()>,
    ) -> Result<Option<Error>> {
        let layout = sink.layout();
        if (layout.rows, u64::from(layout.columns)) != (self.count, self.width) {
            return Err(Error::Arguments {
                asked: format!("{} points of {} words", self.count, self.width),
                limit: format!("the file is of {} x {}", layout.rows, layout.columns),
                remedy: "give the sink the shape of the request".into(),
            });
        }
        let device = Arc::clone(self.device());
        let mut next = None;
        while sink.rows() < self.count {
            let start = sink.rows();
            let opened = next.take().unwrap_or_else(|| open(&device, sink, start))?;
            let Opened { extent, window } = match opened {
                Ok(opened) => opened,
                Err(refusal) => return Ok(Some(refusal)),
            };
            let rows = extent.rows();
            let (count, end) = (rows.end - rows.start, rows.end);
            let file = &*sink;
            let made = self.place(rows.start, count, &window.slice(), &mut |points| {
                meanwhile(points)?;
                // An error waits until what is at work is complete.
                if next.is_none() && end < layout.rows {
                    next = Some(open(&device, file, end));
                }
                Ok(())
            });
            // What it holds is in the file only when it is let go of.
            made.and_then(|()| window.close())?;
            sink.take(extent)?;
        }
        Ok(None)
    }
}

/// The window that begins with a row, or why there is none.
fn open(device: &Arc<Device>, sink: &Sink, row: u64) -> Result<Result<Opened>> {
    let Some(extent) = sink.extent(row)? else {
        return Ok(Err(Error::Arguments {
            asked: "windows of the output".into(),
            limit:
                "they are had of .npy and raw files of f32 or u32, whose chunks are whole pages \
                    and at least 1 MiB, on file systems that reserve space"
                    .into(),
            remedy: "write what the device makes".into(),
        }));
    };
    let window = FileWindow::new(device, extent.file(), extent.offset(), extent.bytes());
    Ok(window.map(|window| Opened { extent, window }))
}
