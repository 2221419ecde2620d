//! The irradiance kernel and its lookup of texels, on a map of noise.

use super::inputs::mix;
use super::rows::{Row, words128};
use crate::Result;
use crate::bulk::{RadianceMap, irradiance_sum, row_edges, sum_scale};
use crate::kernels::Irradiator;
use crate::vulkan::Device;
use std::sync::Arc;

/// An odd size, so that no row edge is 0 and columns meet no power of two.
const SIZE: [u32; 2] = [61, 33];

/// Directions of a sum: more than one an invocation.
const COUNT: u32 = 10_007;

/// Compares the sums of all six axes with the CPU's.
pub fn check(device: &Arc<Device>) -> Result<Row> {
    let texel = |i: u32| [3 * i, 3 * i + 1, 3 * i + 2].map(|word| mix(word) as f32 * 1e-6);
    let texels: Vec<[f32; 3]> = (0..SIZE[0] * SIZE[1]).map(texel).collect();
    let edges = row_edges(SIZE[1]);
    let map = RadianceMap {
        size: SIZE,
        texels: &texels,
        edges: &edges,
    };
    let scale = sum_scale(u32::MAX as f32 * 1e-6, COUNT);
    let irradiator = Irradiator::new(device, SIZE, &texels, &edges)?;
    let mut row = Row::exact("irradiance, envmap_texel", "irradiance");
    for axis in 0..6 {
        let got = irradiator.run(axis, COUNT, scale)?.0.channels;
        got.iter().for_each(|sum| row.hash(&words128(*sum)));
        let expected = irradiance_sum(map, axis, COUNT, scale);
        row.count(got == expected, || {
            format!("axis {axis}: {got:x?}, not {expected:x?}")
        });
    }
    Ok(row.judged())
}
