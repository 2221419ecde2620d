//! Look-ups of dither masks, and the kernel that makes the masks.

use super::rows::Row;
use crate::blue_noise::{MaskShape, void_and_cluster};
use crate::kernels::VoidAndCluster;
use crate::reference::{blue_noise, screen_space};
use crate::vulkan::Device;
use crate::{Error, Result};
use glam::{uvec2, uvec3};
use std::sync::Arc;

/// The ranks of `evaluate_blue_noise.comp`.
const RANKS: [u32; 240] = {
    let mut ranks = [0; 240];
    let mut at = 0;
    while at < ranks.len() {
        ranks[at] = at as u32 * 77 % 240;
        at += 1;
    }
    ranks
};

/// Masks to compare: smaller and larger than the energy reaches, sides that are no powers
/// of two, wider than a group, over time.
const SHAPES: [[u64; 3]; 5] = [[4, 4, 1], [23, 17, 1], [130, 5, 1], [6, 5, 4], [20, 9, 2]];

const SEED: u64 = 0x1234_5678_9abc_def0;

/// What the device must give: `evaluate_blue_noise.comp`, line by line.
pub fn reference(name: &str, a: [u32; 4]) -> [u32; 4] {
    let pixel = uvec2(a[0], a[1]);
    let size = uvec2(24, 10);
    match name {
        "blue_noise" => {
            let count = (a[3] & 0xffff) + 1;
            let fraction = blue_noise::blue_noise_fraction(a[2] % count, count);
            [
                blue_noise::blue_noise(pixel, size, &RANKS),
                blue_noise::blue_noise_frame(pixel, a[2], uvec3(24, 2, 5), &RANKS),
                fraction,
                blue_noise::blue_noise_animate(fraction, a[0]),
            ]
        }
        "blue_noise_shift" => {
            let sides = uvec2(a[3], a[3] >> 16) & 0xffff;
            let shifted = blue_noise::blue_noise_shift(pixel, a[2], sides + 1);
            [
                shifted.x,
                shifted.y,
                blue_noise::blue_noise_rank(shifted, size, &RANKS),
                screen_space::screen_space_hash(a[0], a[1], a[2]),
            ]
        }
        _ => {
            let bits = a[3] & 31;
            let sample = a[2] & ((1 << bits) - 1);
            [
                screen_space::screen_space_index(pixel, sample, bits, a[2]),
                screen_space::screen_space_index(pixel, a[2], 32, a[3]),
                screen_space::screen_space_morton(pixel),
                screen_space::screen_space_shuffle(a[0], a[3] % 17, a[1]),
            ]
        }
    }
}

/// Compares small masks with the CPU's.
pub fn check(device: &Arc<Device>) -> Result<Row> {
    compare_mask(&VoidAndCluster::new(device)?)
}

/// The same on a kernel of the caller's.
///
/// # Errors
/// Those of the device.
pub fn compare_mask(kernel: &VoidAndCluster) -> Result<Row> {
    let mut row = Row::exact("blue_noise_mask", "void_and_cluster");
    for [width, height, frames] in SHAPES {
        let shape = MaskShape::new(width, height, frames)?;
        let got = match kernel.ranks(shape, SEED, &mut |_| Ok(())) {
            // Its initial pattern never comes to rest.
            Err(Error::CheckFailed { .. }) => vec![u32::MAX; shape.pixels() as usize],
            got => got?,
        };
        row.hash(&got);
        let expected = void_and_cluster(shape, SEED);
        for (i, (got, expected)) in got.iter().zip(&expected).enumerate() {
            row.count(got == expected, || {
                format!("pixel {i} of {width} x {height} x {frames}: rank {got}, not {expected}")
            });
        }
    }
    Ok(row.judged())
}
