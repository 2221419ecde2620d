//! Samples of a map over points that lie in memory.

use super::{constant, groups, kernel, pipeline, spirv};
use crate::Result;
use crate::catalog::{Map, Profile};
use crate::interface::WorkPush;
use crate::vulkan::{Access, Buffer, Device, Timing};
use std::sync::Arc;

/// Applies a map to points of two fractions each.
pub struct Mapper {
    pipeline: crate::vulkan::Pipeline,
    name: &'static str,
    width: u32,
    device: Arc<Device>,
}

impl Mapper {
    /// Compiles the pipeline.
    ///
    /// # Errors
    /// Those of the device.
    pub fn new(device: &Arc<Device>, map: &Map, with_pdf: bool, profile: Profile) -> Result<Self> {
        let name = match profile {
            Profile::Exact => "map",
            Profile::Native => "map_native",
        };
        let row = kernel(name)?;
        let constants: Vec<(u32, u32)> = [
            constant(row, "MAP", map.id),
            constant(row, "WITH_PDF", u32::from(with_pdf)),
        ]
        .into_iter()
        .flatten()
        .collect();
        Ok(Self {
            pipeline: pipeline(device, row, &spirv(name)?, &constants)?,
            name,
            width: map.coordinates + u32::from(with_pdf),
            device: Arc::clone(device),
        })
    }

    /// Maps points, given as pairs of fractions, to rows of coordinates and pdf, as
    /// float bits; at most 2^22 points at a time.
    ///
    /// # Errors
    /// Those of the device.
    pub fn run(&self, points: &[[u32; 2]]) -> Result<(Vec<u32>, Timing)> {
        let row = kernel(self.name)?;
        let invocations = points.len().div_ceil(4) as u32;
        let mut input = Buffer::new(&self.device, u64::from(invocations) * 32, Access::Upload)?;
        input.write(0, bytemuck::cast_slice(points))?;
        let mut results = Buffer::new(
            &self.device,
            u64::from(invocations) * 16 * u64::from(self.width),
            Access::Readback,
        )?;
        let push = WorkPush {
            first: 0,
            invocations,
            stride: 1,
        };
        let timing = self.device.run(
            &self.pipeline,
            &[(0, &results), (1, &input)],
            &push.bytes(),
            groups(row, invocations),
        )?;
        let bytes = points.len() as u64 * 4 * u64::from(self.width);
        let words = results.read(0, bytes, bytemuck::pod_collect_to_vec)?;
        Ok((words, timing))
    }
}
