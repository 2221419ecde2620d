//! Dispatches: run and wait, or record into the caller's command buffer.

use ash::vk;
use std::time::Instant;

use super::buffer::Buffer;
use super::descriptor::{self, DescriptorSet};
use super::device::Device;
use super::pipeline::Pipeline;
use super::submit::Edge;
use super::{MAX_BATCH, failed, refused};
use crate::error::{Error, Result};

/// How long one dispatch took.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Timing {
    /// Nanoseconds on the device, from its own clock; `None` without timestamps,
    /// or where they cannot be read.
    pub device_ns: Option<f64>,
    /// Nanoseconds of the whole call on the host: record, submit, wait.
    pub host_ns: f64,
}

/// What a dispatch of a pipeline takes, for [`Device::run_batch`].
#[derive(Clone, Copy, Debug)]
pub struct Dispatch<'a> {
    /// A buffer for each binding.
    pub buffers: &'a [(u32, &'a Buffer)],
    /// Push constants.
    pub push: &'a [u8],
    /// Workgroups; none does nothing.
    pub groups: u64,
}

impl Device {
    /// Runs `groups` workgroups of a pipeline and waits for them. The host's
    /// earlier writes are visible to the shader, and the shader's to whatever
    /// comes next. No groups: nothing happens.
    ///
    /// More groups than the x axis holds are spread over x and y, with up to
    /// `y - 1` groups too many. So shaders compute the group's number as
    /// `gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x`, and check it
    /// against their bounds.
    ///
    /// # Errors
    /// [`Error::Shader`] when bindings or push constants are not those of the
    /// pipeline; [`Error::Arguments`] for too many groups, or for objects of
    /// another device; [`Error::Timeout`] past [`Device::wait_limit`];
    /// [`Error::Vulkan`] when the driver fails.
    pub fn run(
        &self,
        pipeline: &Pipeline,
        buffers: &[(u32, &Buffer)],
        push: &[u8],
        groups: u64,
    ) -> Result<Timing> {
        let start = Instant::now();
        let one = Dispatch {
            buffers,
            push,
            groups,
        };
        if groups == 0 {
            self.check(pipeline, &one)?;
            return Ok(Timing::default());
        }
        let device_ns = self.run_batch(pipeline, &[one])?.first().copied().flatten();
        Ok(Timing {
            device_ns,
            host_ns: start.elapsed().as_nanos() as f64,
        })
    }

    /// Runs several dispatches of a pipeline, one after the other as by [`Device::run`], in one
    /// submission, which the host pays once. Returns what the device's clock says of each: its
    /// nanoseconds, from when the one before has ended; `None` as in [`Timing::device_ns`].
    ///
    /// The [wait limit](Device::wait_limit) is that of all together.
    ///
    /// # Errors
    /// Those of [`Device::run`], before anything is run; [`Error::Arguments`] for more than
    /// [`MAX_BATCH`] dispatches.
    pub fn run_batch(
        &self,
        pipeline: &Pipeline,
        dispatches: &[Dispatch],
    ) -> Result<Vec<Option<f64>>> {
        if dispatches.len() > MAX_BATCH {
            return Err(refused(
                format!("a batch of {} dispatches", dispatches.len()),
                format!("the most is {MAX_BATCH}"),
                "use several batches",
            ));
        }
        let counts = dispatches
            .iter()
            .map(|one| self.check(pipeline, one))
            .collect::<Result<Vec<_>>>()?;
        if dispatches.is_empty() {
            return Ok(Vec::new());
        }
        self.submit(dispatches.len(), |lane, commands| {
            // SAFETY: the pool is the lane's, whose last submission has ended.
            unsafe {
                self.raw()
                    .reset_descriptor_pool(lane.descriptors, vk::DescriptorPoolResetFlags::empty())
            }
            .map_err(failed("vkResetDescriptorPool"))?;
            for (span, (one, counts)) in dispatches.iter().zip(counts).enumerate() {
                let ranges = descriptor::ranges(one.buffers);
                let set = descriptor::allocate(self, lane.descriptors, pipeline, &ranges)?;
                // SAFETY: the command buffer is recording, the set was made for this
                // pipeline, and all of it lives until the submission has ended.
                unsafe {
                    if span > 0 {
                        // All stages, so that a timestamp too waits for what was before.
                        barrier_before(self, commands, vk::PipelineStageFlags::ALL_COMMANDS);
                    }
                    lane.stamp(self.raw(), commands, span, Edge::Begin);
                    if let Some(counts) = counts {
                        write(self, commands, pipeline, set, one.push, counts);
                    }
                    lane.stamp(self.raw(), commands, span, Edge::End);
                }
            }
            Ok(())
        })
    }

    /// The size of a dispatch that fits its pipeline; `None` of no groups.
    fn check(&self, pipeline: &Pipeline, one: &Dispatch) -> Result<Option<(u32, u32)>> {
        descriptor::check_owner(self, pipeline, one.buffers)?;
        descriptor::check_bindings(pipeline, one.buffers.iter().map(|one| one.0))?;
        check_push(pipeline, one.push)?;
        split(self, one.groups)
    }
}

/// Records `groups` workgroups of a pipeline into the caller's command buffer,
/// without barriers: see [`barrier`]. Groups are spread as by [`Device::run`].
///
/// # Errors
/// [`Error::Shader`] when the push constants are not those of the pipeline;
/// [`Error::Arguments`] for too many groups, or a pipeline of another device.
///
/// # Safety
/// `commands` is a command buffer of this device in the recording state, outside
/// a render pass, of a family that can compute. `set` was made for `pipeline`,
/// and both, with the buffers of the set, outlive the execution.
pub unsafe fn record(
    device: &Device,
    commands: vk::CommandBuffer,
    pipeline: &Pipeline,
    set: &DescriptorSet,
    push: &[u8],
    groups: u64,
) -> Result<()> {
    descriptor::check_owner(device, pipeline, &[])?;
    check_push(pipeline, push)?;
    if let Some(counts) = split(device, groups)? {
        // SAFETY: the caller vouches for `commands`, `set` and lifetimes.
        unsafe { write(device, commands, pipeline, set.raw(), push, counts) };
    }
    Ok(())
}

/// Records a barrier: what earlier dispatches and copies in the queue wrote is
/// visible to later ones and, after a wait, to the host.
///
/// # Safety
/// `commands` is a command buffer of this device in the recording state, outside
/// a render pass, of a family that can compute.
pub unsafe fn barrier(device: &Device, commands: vk::CommandBuffer) {
    // SAFETY: the caller vouches for `commands`.
    unsafe { barrier_before(device, commands, WORK) }
}

/// What compute queues do.
const WORK: vk::PipelineStageFlags = vk::PipelineStageFlags::from_raw(
    vk::PipelineStageFlags::COMPUTE_SHADER.as_raw() | vk::PipelineStageFlags::TRANSFER.as_raw(),
);

/// The same, for which these stages wait, and the host.
///
/// # Safety
/// As for [`barrier`], and the stages are of a queue that can compute.
unsafe fn barrier_before(
    device: &Device,
    commands: vk::CommandBuffer,
    next: vk::PipelineStageFlags,
) {
    let writes = vk::AccessFlags::SHADER_WRITE | vk::AccessFlags::TRANSFER_WRITE;
    let all = writes
        | vk::AccessFlags::SHADER_READ
        | vk::AccessFlags::TRANSFER_READ
        | vk::AccessFlags::HOST_READ
        | vk::AccessFlags::HOST_WRITE;
    let memory = [vk::MemoryBarrier::default()
        .src_access_mask(writes)
        .dst_access_mask(all)];
    // SAFETY: the caller vouches for `commands`; the stages exist on every queue
    // that can compute.
    unsafe {
        device.raw().cmd_pipeline_barrier(
            commands,
            WORK,
            next | vk::PipelineStageFlags::HOST,
            vk::DependencyFlags::empty(),
            &memory,
            &[],
            &[],
        );
    }
}

/// Records the dispatch itself.
///
/// # Safety
/// As for [`record`], and `push` has the pipeline's size.
unsafe fn write(
    device: &Device,
    commands: vk::CommandBuffer,
    pipeline: &Pipeline,
    set: vk::DescriptorSet,
    push: &[u8],
    (x, y): (u32, u32),
) {
    let (raw, point) = (device.raw(), vk::PipelineBindPoint::COMPUTE);
    // SAFETY: the caller vouches for the handles; the counts are within limits.
    unsafe {
        raw.cmd_bind_pipeline(commands, point, pipeline.compiled.raw);
        if !pipeline.bindings.is_empty() {
            raw.cmd_bind_descriptor_sets(commands, point, pipeline.compiled.layout, 0, &[set], &[]);
        }
        if !push.is_empty() {
            let stage = vk::ShaderStageFlags::COMPUTE;
            raw.cmd_push_constants(commands, pipeline.compiled.layout, stage, 0, push);
        }
        raw.cmd_dispatch(commands, x, y, 1);
    }
}

fn check_push(pipeline: &Pipeline, push: &[u8]) -> Result<()> {
    if push.len() == pipeline.push_constant_bytes as usize {
        return Ok(());
    }
    Err(Error::Shader {
        shader: pipeline.name().to_owned(),
        problem: format!(
            "it takes {} bytes of push constants, and {} were given",
            pipeline.push_constant_bytes,
            push.len()
        ),
    })
}

/// The dispatch's size for a number of groups; `None` for no groups.
fn split(device: &Device, groups: u64) -> Result<Option<(u32, u32)>> {
    if groups == 0 {
        return Ok(None);
    }
    let info = device.info();
    let [most_x, most_y, _] = info.limits.max_group_count;
    spread(groups, most_x, most_y).map(Some).ok_or_else(|| {
        refused(
            format!("a dispatch of {groups} groups"),
            format!(
                "device {} takes at most {most_x} x {most_y}, and 2^32 in all",
                info.name
            ),
            "use several dispatches",
        )
    })
}

/// The fewest rows, of equal length, that hold `groups`.
fn spread(groups: u64, most_x: u32, most_y: u32) -> Option<(u32, u32)> {
    let rows = groups.div_ceil(u64::from(most_x.max(1)));
    let columns = groups.div_ceil(rows.max(1));
    // The shader's group number has 32 bits.
    if rows > u64::from(most_y) || columns.checked_mul(rows)? > 1 << 32 {
        return None;
    }
    Some((u32::try_from(columns).ok()?, u32::try_from(rows).ok()?))
}

#[cfg(test)]
mod tests {
    use super::spread;

    #[test]
    fn groups_fit_in_few_equal_rows() {
        let most = 65_535;
        assert_eq!(spread(1, most, most), Some((1, 1)));
        assert_eq!(spread(65_535, most, most), Some((65_535, 1)));
        assert_eq!(spread(65_536, most, most), Some((32_768, 2)));
        assert_eq!(spread(131_071, most, most), Some((43_691, 3)));
        assert_eq!(spread(65_535 * 65_535, most, most), Some((65_535, 65_535)));
        assert_eq!(spread(65_535 * 65_535 + 1, most, most), None);
        assert_eq!(spread(u64::MAX, most, most), None);
        assert_eq!(spread(1 << 32, u32::MAX, most), Some((1 << 31, 2)));
        assert_eq!(spread((1 << 32) + 1, u32::MAX, most), None);
        assert_eq!(spread(1, 0, 0), None);
        for groups in (1..300_000u64).step_by(997) {
            let (x, y) = spread(groups, most, most).unwrap();
            let all = u64::from(x) * u64::from(y);
            assert!(
                all >= groups && all - groups < u64::from(y),
                "{groups}: {x} x {y}"
            );
        }
    }
}
