//! Dither masks by void-and-cluster.

use super::{kernel, pipeline, spirv};
use crate::blue_noise::{MaskShape, energies, scattered_words};
use crate::interface::{Kernel, MaskPush};
use crate::vulkan::{Access, Buffer, Device, Pipeline};
use crate::{Error, Result};
use std::sync::Arc;

/// Iterations of loops that an invocation may run: llvmpipe ends it after 65,535.
const ITERATIONS: u32 = 60_000;

/// Passes of the first dispatch: short on the slowest device.
const FIRST_PASSES: u32 = 16;

/// A dispatch should take about this long, as a generator's.
const TARGET_NS: f64 = 1e8;

/// No pixel was toggled yet.
const NONE: u32 = u32::MAX;

/// Makes dither masks on a device: the ranks of
/// [`void_and_cluster`](crate::blue_noise::void_and_cluster), bit for bit.
pub struct VoidAndCluster {
    pipeline: Pipeline,
    row: &'static Kernel,
    device: Arc<Device>,
}

/// The buffers of one mask, and how fast the device is at it.
struct Run<'a> {
    kernel: &'a VoidAndCluster,
    shape: MaskShape,
    words: Buffer,
    ranks: Buffer,
    state: Buffer,
    energies: Buffer,
    terms: u32,
    passes: u32,
}

impl VoidAndCluster {
    /// Prepares the kernel.
    ///
    /// # Errors
    /// Those of the device.
    pub fn new(device: &Arc<Device>) -> Result<Self> {
        Self::with_module(device, &spirv("void_and_cluster")?)
    }

    /// The same with other SPIR-V of the same interface: how tests run broken kernels.
    ///
    /// # Errors
    /// Those of the device.
    pub fn with_module(device: &Arc<Device>, words: &[u32]) -> Result<Self> {
        let row = kernel("void_and_cluster")?;
        Ok(Self {
            pipeline: pipeline(device, row, words, &[])?,
            row,
            device: Arc::clone(device),
        })
    }

    /// The rank of each pixel. `progress` is told how many are ranked, of how many, and
    /// may stop the work by an error.
    ///
    /// # Errors
    /// Those of the device and of `progress`; [`Error::CheckFailed`] where the device
    /// does not relax the initial pattern as integers must.
    pub fn ranks(
        &self,
        shape: MaskShape,
        seed: u64,
        progress: &mut dyn FnMut(u32) -> Result<()>,
    ) -> Result<Vec<u32>> {
        let (minority, pixels) = (shape.minority(), shape.pixels());
        let mut run = Run::new(self, shape, seed)?;
        run.relax(progress)?;
        let saved = (read(&mut run.words)?, read(&mut run.state)?);
        let mut push = run.push();
        push.removes = 3;
        push.rank = minority - 1;
        push.rank_step = u32::MAX;
        run.rank(push, minority, progress)?;
        write(&mut run.words, &saved.0)?;
        write(&mut run.state, &saved.1)?;
        push.removes = 0;
        push.rank = minority;
        push.rank_step = 1;
        run.rank(push, pixels - minority, progress)?;
        read(&mut run.ranks)
    }
}

impl<'a> Run<'a> {
    fn new(kernel: &'a VoidAndCluster, shape: MaskShape, seed: u64) -> Result<Self> {
        let buffer = |words: &[u32]| {
            let mut buffer = Buffer::new(&kernel.device, 4 * words.len() as u64, Access::Readback)?;
            write(&mut buffer, words)?;
            Ok::<_, Error>(buffer)
        };
        let energies = energies();
        Ok(Self {
            words: buffer(&scattered_words(shape, seed))?,
            ranks: buffer(&vec![0; shape.pixels() as usize])?,
            state: buffer(&[NONE, 0, 0])?,
            terms: energies.len() as u32,
            energies: buffer(&energies)?,
            passes: FIRST_PASSES,
            kernel,
            shape,
        })
    }

    fn push(&self) -> MaskPush {
        MaskPush {
            width: self.shape.width,
            height: self.shape.height,
            frames: self.shape.frames,
            span: (2 * (self.terms - 1).isqrt() + 1).min(self.shape.height),
            terms: self.terms,
            ..MaskPush::default()
        }
    }

    /// The most passes of a dispatch, an even number. Each loop's last test counts too.
    fn limit(&self) -> u32 {
        let MaskShape {
            width,
            height,
            frames,
            ..
        } = self.shape;
        let (lanes, rows) = (self.kernel.row.local_size, height * frames);
        let columns = width.div_ceil(lanes) + 1;
        let start = 2 * rows / lanes + rows * (columns + 1) + 4;
        let reached = self.push().span + frames;
        let pass = 2 + reached * (2 * columns + 1) + rows / lanes + 2 + columns;
        ((ITERATIONS - start) / pass).max(2) & !1
    }

    /// Moves the tightest cluster to the largest void until it returns.
    fn relax(&mut self, progress: &mut dyn FnMut(u32) -> Result<()>) -> Result<()> {
        // A pattern takes a few moves a pixel; this many are a device that errs.
        let most = u64::from(self.shape.pixels()) * 64 + 4096;
        let mut moves = 0;
        let mut push = self.push();
        push.removes = 1;
        while read(&mut self.state)?[2] == 0 {
            progress(0)?;
            push.passes = self.passes;
            self.dispatch(&push)?;
            moves += u64::from(push.passes);
            if moves > most {
                return Err(Error::CheckFailed {
                    failures: 1,
                    total: 1,
                });
            }
        }
        Ok(())
    }

    /// Toggles and ranks so many pixels.
    fn rank(
        &mut self,
        mut push: MaskPush,
        count: u32,
        progress: &mut dyn FnMut(u32) -> Result<()>,
    ) -> Result<()> {
        let mut left = count;
        while left > 0 {
            push.passes = self.passes.min(left);
            self.dispatch(&push)?;
            push.rank = push
                .rank
                .wrapping_add(push.passes.wrapping_mul(push.rank_step));
            left -= push.passes;
            progress(push.passes)?;
        }
        Ok(())
    }

    /// Runs some passes, and fits the next number to what they took.
    fn dispatch(&mut self, push: &MaskPush) -> Result<()> {
        let buffers = [
            (0, &self.words),
            (1, &self.ranks),
            (2, &self.state),
            (3, &self.energies),
        ];
        let timing = self
            .kernel
            .device
            .run(&self.kernel.pipeline, &buffers, &push.bytes(), 1)?;
        let spent = timing.device_ns.unwrap_or(timing.host_ns).max(1.0);
        let ideal = f64::from(push.passes) * (TARGET_NS / spent).min(4.0);
        self.passes = (ideal as u32 & !1).clamp(2, self.limit());
        Ok(())
    }
}

fn read(buffer: &mut Buffer) -> Result<Vec<u32>> {
    buffer.read(0, buffer.bytes(), bytemuck::pod_collect_to_vec)
}

fn write(buffer: &mut Buffer, words: &[u32]) -> Result<()> {
    buffer.write(0, bytemuck::cast_slice(words))
}
