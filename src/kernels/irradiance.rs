//! Irradiance of an environment map, by cosine-weighted Hammersley directions.

use super::{groups, kernel, pipeline, spirv};
use crate::interface::IrradiancePush;
use crate::vulkan::{Access, Buffer, Device, Pipeline, Timing};
use crate::{Error, Result};
use std::sync::Arc;

/// Sums of the three channels, in units of 2^-scale.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct IrradianceSum {
    /// Red, green and blue.
    pub channels: [u128; 3],
}

/// A map on the device.
pub struct Irradiator {
    pipeline: Pipeline,
    texels: Buffer,
    edges: Buffer,
    size: [u32; 2],
    device: Arc<Device>,
}

/// Invocations, unless there are more points than these can take; each sums every so
/// manieth point.
const INVOCATIONS: u32 = 4096;

/// Points of an invocation at most: llvmpipe ends an invocation's loops after 65,535
/// iterations in all, of which a point takes about 50.
const POINTS: u32 = 512;

impl Irradiator {
    /// Uploads a map of width times height texels; edge i of `edges` is the float
    /// cos(pi i / height).
    ///
    /// # Errors
    /// Those of the device.
    pub fn new(
        device: &Arc<Device>,
        size: [u32; 2],
        texels: &[[f32; 3]],
        edges: &[f32],
    ) -> Result<Self> {
        let row = kernel("irradiance")?;
        let upload = |bytes: &[u8]| -> Result<Buffer> {
            let mut buffer = Buffer::new(device, bytes.len() as u64, Access::Upload)?;
            buffer.write(0, bytes)?;
            Ok(buffer)
        };
        Ok(Self {
            pipeline: pipeline(device, row, &spirv("irradiance")?, &[])?,
            texels: upload(bytemuck::cast_slice(texels))?,
            edges: upload(bytemuck::cast_slice(edges))?,
            size,
            device: Arc::clone(device),
        })
    }

    /// Directions that one sum may take: its dispatch stays short.
    pub const MAX_COUNT: u32 = 1 << 24;

    /// Sums the radiance that `count` directions around an axis (0 to 5: +x, -x, +y, -y,
    /// +z, -z) meet. The sum has the same bits for every grouping, as integers have.
    ///
    /// # Errors
    /// Those of the device.
    pub fn run(&self, axis: u32, count: u32, scale: u32) -> Result<(IrradianceSum, Timing)> {
        if count == 0 || count > Self::MAX_COUNT {
            return Err(Error::Arguments {
                asked: format!("a sum of {count} directions"),
                limit: format!("one sum takes 1 to {} of them", Self::MAX_COUNT),
                remedy: "ask for fewer".into(),
            });
        }
        let row = kernel("irradiance")?;
        let invocations = count.min(INVOCATIONS).max(count.div_ceil(POINTS));
        let bytes = 32 * u64::from(invocations);
        let mut results = Buffer::new(&self.device, bytes, Access::Readback)?;
        let push = IrradiancePush {
            first: 0,
            count,
            invocations,
            axis,
            width: self.size[0],
            height: self.size[1],
            scale,
        };
        let timing = self.device.run(
            &self.pipeline,
            &[(0, &results), (1, &self.texels), (2, &self.edges)],
            &push.bytes(),
            groups(row, invocations),
        )?;
        let sums = results.read(0, bytes, |bytes| {
            let mut channels = [0u128; 3];
            for part in bytemuck::pod_collect_to_vec::<u8, [u32; 8]>(bytes) {
                for (channel, sum) in channels.iter_mut().enumerate() {
                    *sum += u128::from(part[2 * channel]) | u128::from(part[2 * channel + 1]) << 32;
                }
            }
            channels
        })?;
        Ok((IrradianceSum { channels: sums }, timing))
    }
}
