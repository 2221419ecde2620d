//! A map over what lies in memory: fractions to samples, samples to their pdf or back to
//! fractions.

use super::points::table;
use super::{constant, groups, kernel, pipeline, spirv};
use crate::Result;
use crate::catalog::{Mapping, Profile};
use crate::interface::{Kernel, MapPush, TABLE_WORDS, task};
use crate::vulkan::{Access, Buffer, BufferSlice, Device, Pipeline, Recording, Timing};
use std::sync::Arc;

/// Does one task of a map.
pub struct Mapper {
    pipeline: Arc<Pipeline>,
    kernel: &'static Kernel,
    parameters: [u32; 16],
    tables: Vec<Buffer>,
    /// Words of an input and of a result.
    widths: [u64; 2],
    device: Arc<Device>,
}

impl Mapper {
    /// Compiles the pipeline; `task` is of [`task`].
    ///
    /// # Errors
    /// Those of the device.
    pub fn new(
        device: &Arc<Device>,
        mapping: &Mapping,
        with_pdf: bool,
        profile: Profile,
        task: u32,
    ) -> Result<Self> {
        let words = spirv(mapping.map().group.kernel(profile))?;
        Self::with_module(device, mapping, with_pdf, profile, task, &words)
    }

    /// The same with other SPIR-V of the same interface: how tests run broken kernels.
    ///
    /// # Errors
    /// Those of the device.
    pub fn with_module(
        device: &Arc<Device>,
        mapping: &Mapping,
        with_pdf: bool,
        profile: Profile,
        task: u32,
        words: &[u32],
    ) -> Result<Self> {
        let map = mapping.map();
        let kernel = kernel(map.group.kernel(profile))?;
        let constants: Vec<(u32, u32)> = [
            constant(kernel, "MAP", map.id),
            constant(kernel, "WITH_PDF", u32::from(with_pdf)),
            constant(kernel, "DIMENSIONS", map.dimensions),
            constant(kernel, "COORDINATES", map.coordinates),
            constant(kernel, "TASK", task),
        ]
        .into_iter()
        .flatten()
        .collect();
        Ok(Self {
            pipeline: Arc::new(pipeline(device, kernel, words, &constants)?),
            kernel,
            parameters: mapping.words(),
            tables: tables(device, kernel, mapping)?,
            widths: match task {
                task::SAMPLE => [map.dimensions, map.coordinates + u32::from(with_pdf)],
                task::PDF => [4, 1],
                _ => [4, 4],
            }
            .map(u64::from),
            device: Arc::clone(device),
        })
    }

    /// Gives the same kernel the parameters and tables of another mapping of its map, which
    /// costs no compilation.
    ///
    /// # Errors
    /// Those of the device.
    pub fn set(&mut self, mapping: &Mapping) -> Result<()> {
        self.parameters = mapping.words();
        self.tables = tables(&self.device, self.kernel, mapping)?;
        Ok(())
    }

    /// Words of a result.
    #[must_use]
    pub fn words(&self) -> u32 {
        self.widths[1] as u32
    }

    /// Maps the first `count` inputs of a buffer, which must hold four times as many as
    /// there are invocations, rounded up, into another.
    ///
    /// # Errors
    /// Those of the device.
    pub fn dispatch(&self, input: &Buffer, results: &Buffer, count: u64) -> Result<Timing> {
        let invocations = count.div_ceil(4) as u32;
        let mut buffers = vec![(0, results), (1, input)];
        buffers.extend((2..).zip(&self.tables));
        let push = MapPush::new(invocations, &self.parameters);
        self.device.run(
            &self.pipeline,
            &buffers,
            &push.bytes(),
            groups(self.kernel, invocations),
        )
    }

    /// Records the same for the inputs of so many invocations, four each, of a slice into
    /// another, which holds the results of as many.
    pub(super) fn record(
        &self,
        recording: &mut Recording,
        input: &BufferSlice,
        results: &BufferSlice,
        invocations: u32,
    ) -> Result<()> {
        if invocations == 0 {
            return Ok(());
        }
        let mut slices = vec![(0, results.clone()), (1, input.clone())];
        slices.extend((2..).zip(self.tables.iter().map(Buffer::whole)));
        let push = MapPush::new(invocations, &self.parameters);
        let groups = groups(self.kernel, invocations);
        recording.dispatch(&self.pipeline, &slices, &push.bytes(), groups)
    }

    /// The loops of so many invocations by the tasks `REPEAT` and `BARE`, each with 16 bytes
    /// of the results.
    ///
    /// # Errors
    /// Those of the device.
    pub fn repeat(&self, results: &Buffer, invocations: u32) -> Result<Timing> {
        let unused = Buffer::new(&self.device, 16, Access::Upload)?;
        self.dispatch(&unused, results, 4 * u64::from(invocations))
    }

    /// So many words of what the device prepares of the parameters, by the task of that
    /// name: the first table of a mapping, which the host prepares.
    ///
    /// # Errors
    /// Those of the device.
    pub fn prepare(&self, words: usize) -> Result<Vec<u32>> {
        let bytes = 4 * words as u64;
        let input = Buffer::new(&self.device, 16, Access::Upload)?;
        let mut results = Buffer::new(&self.device, bytes.next_multiple_of(16), Access::Readback)?;
        self.dispatch(&input, &results, 1)?;
        results.read(0, bytes, bytemuck::pod_collect_to_vec)
    }

    /// Rows of results for rows of input words: of the map's dimensions for samples, and
    /// four words, of which the first are coordinates, otherwise. At most 2^22 at a time.
    ///
    /// # Errors
    /// Those of the device.
    pub fn run(&self, rows: &[u32]) -> Result<(Vec<u32>, Timing)> {
        let count = rows.len() as u64 / self.widths[0];
        let whole = count.next_multiple_of(4);
        let mut input = Buffer::new(&self.device, 4 * whole * self.widths[0], Access::Upload)?;
        input.write(0, bytemuck::cast_slice(rows))?;
        let bytes = 4 * whole * self.widths[1];
        let mut results = Buffer::new(&self.device, bytes, Access::Readback)?;
        let timing = self.dispatch(&input, &results, count)?;
        let made = 4 * count * self.widths[1];
        let words = results.read(0, made, bytemuck::pod_collect_to_vec)?;
        Ok((words, timing))
    }
}

/// The tables of a mapping, cut to what a buffer holds; a buffer of one word for each
/// binding that then has none.
fn tables(device: &Arc<Device>, kernel: &Kernel, mapping: &Mapping) -> Result<Vec<Buffer>> {
    let bindings = kernel.bindings.len().saturating_sub(2);
    let parts = mapping
        .tables()
        .iter()
        .flat_map(|words| words.chunks(TABLE_WORDS));
    let parts = parts.chain(std::iter::repeat(&[0][..]));
    parts
        .take(bindings)
        .map(|part| table(device, part))
        .collect()
}
