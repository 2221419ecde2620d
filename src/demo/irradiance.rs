//! Irradiance of a map for the six axis directions as normals, by growing point sets.

use super::Watch;
use crate::Result;
use crate::bulk::{RadianceMap, irradiance_sum, row_edges, sum_scale};
use crate::image::Image;
use crate::irradiance::irradiance;
use crate::kernels::Irradiator;
use crate::vulkan::Device;
use std::sync::Arc;

/// Point sets: 2^10 to 2^20.
const LOG_COUNTS: std::ops::RangeInclusive<u32> = 10..=20;

/// An estimate, and what it should have been.
#[derive(Clone, Debug)]
pub struct Estimate {
    /// Axis of the normal, 0 to 5: +x, -x, +y, -y, +z, -z.
    pub axis: u32,
    /// Points.
    pub count: u32,
    /// Irradiance of red, green and blue, in the map's radiance unit times steradian.
    pub estimate: [f64; 3],
    /// The sum over texels of radiance times projected solid angle.
    pub truth: [f64; 3],
    /// Time on the device.
    pub device_ms: f64,
    /// Whether the device's integer sums equal the CPU's.
    pub equal: bool,
}

impl Estimate {
    /// `+x` and so on.
    #[must_use]
    pub fn axis_name(&self) -> &'static str {
        ["+x", "-x", "+y", "-y", "+z", "-z"]
            .get(self.axis as usize)
            .copied()
            .unwrap_or("?")
    }

    /// Luminance (Rec. 709) of the estimate and of the truth.
    #[must_use]
    pub fn luminances(&self) -> (f64, f64) {
        (luminance(self.estimate), luminance(self.truth))
    }

    /// |estimate - truth| / truth of the luminance.
    #[must_use]
    pub fn relative_error(&self) -> f64 {
        let (estimate, truth) = self.luminances();
        if truth == 0.0 {
            return estimate;
        }
        (estimate - truth).abs() / truth
    }
}

fn luminance([r, g, b]: [f64; 3]) -> f64 {
    0.2126 * r + 0.7152 * g + 0.0722 * b
}

/// Estimates for all axes and counts.
///
/// # Errors
/// Those of the device, and those of `watch`.
pub fn estimates(
    device: &Arc<Device>,
    image: &Image,
    watch: &mut Watch<'_>,
) -> Result<Vec<Estimate>> {
    let size = [image.width, image.height];
    let edges = row_edges(image.height);
    let map = RadianceMap {
        size,
        texels: &image.texels,
        edges: &edges,
    };
    let irradiator = Irradiator::new(device, size, &image.texels, &edges)?;
    let largest = image.texels.iter().flatten().fold(0f32, |a, &b| a.max(b));
    let scale = sum_scale(largest, 1 << LOG_COUNTS.end());
    let total = 6 * LOG_COUNTS.count() as u64;
    let mut list = Vec::new();
    for axis in 0..6u32 {
        let mut normal = [0.0; 3];
        normal[(axis / 2) as usize] = if axis % 2 == 0 { 1.0 } else { -1.0 };
        let truth = irradiance(image.width, image.height, &image.texels, normal);
        for count in LOG_COUNTS.map(|log| 1u32 << log) {
            let (sum, timing) = irradiator.run(axis, count, scale)?;
            let unit = std::f64::consts::PI / f64::from(count) * f64::powi(2.0, -(scale as i32));
            list.push(Estimate {
                axis,
                count,
                estimate: sum.channels.map(|channel| channel as f64 * unit),
                truth,
                device_ms: timing.device_ns.unwrap_or(timing.host_ns) * 1e-6,
                equal: sum.channels == irradiance_sum(map, axis, count, scale),
            });
            watch("irradiance sums", list.len() as u64, total)?;
        }
    }
    Ok(list)
}
