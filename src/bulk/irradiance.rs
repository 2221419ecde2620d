//! The CPU's twin of the irradiance kernel: the same directions, texels and sums.

use crate::reference::axis::axis_turned;
use crate::reference::envmap::envmap_texel;
use crate::reference::fixed::fixed64;
use crate::reference::hammersley::hammersley;
use crate::reference::hemisphere::cosine_hemisphere;
use crate::reference::radical_inverse::van_der_corput;
use glam::uvec2;
use std::panic::resume_unwind;

/// A map as the estimator reads it.
#[derive(Clone, Copy, Debug)]
pub struct RadianceMap<'a> {
    /// Columns and rows.
    pub size: [u32; 2],
    /// Texels, row 0 first.
    pub texels: &'a [[f32; 3]],
    /// Row edges: entry i is the float cos(pi i / height).
    pub edges: &'a [f32],
}

/// Edges between the rows of a map: entry i is the float nearest to cos(pi i / height).
#[must_use]
pub fn row_edges(height: u32) -> Vec<f32> {
    let edge = |i| (std::f64::consts::PI * f64::from(i) / f64::from(height)).cos() as f32;
    (0..height.max(1)).map(edge).collect()
}

/// The scale at which sums of `count` texels up to `largest` fit in 64 bits: units of
/// 2^-scale.
#[must_use]
pub fn sum_scale(largest: f32, count: u32) -> u32 {
    let bits = (f64::from(largest).max(1.0) * f64::from(count))
        .log2()
        .ceil() as i32
        + 1;
    (63 - bits).clamp(0, 40) as u32
}

/// Sums of the radiance that `count` cosine-weighted Hammersley directions around an
/// axis (0 to 5: +x, -x, +y, -y, +z, -z) meet, in units of 2^-scale.
#[must_use]
pub fn irradiance_sum(map: RadianceMap, axis: u32, count: u32, scale: u32) -> [u128; 3] {
    let threads = std::thread::available_parallelism().map_or(1, usize::from) as u32;
    let mut sums = [0; 3];
    std::thread::scope(|scope| {
        let parts: Vec<_> = (0..threads)
            .map(|part| scope.spawn(move || partial(map, axis, (part, threads, count), scale)))
            .collect();
        for part in parts {
            // A panic of a thread is a bug, and one here too.
            let part = part.join().unwrap_or_else(|panic| resume_unwind(panic));
            for (sum, add) in sums.iter_mut().zip(part) {
                *sum += add;
            }
        }
    });
    sums
}

fn partial(map: RadianceMap, axis: u32, range: (u32, u32, u32), scale: u32) -> [u128; 3] {
    let (first, step, count) = range;
    let mut sums = [0u128; 3];
    for k in (first..count).step_by(step as usize) {
        let u = uvec2(van_der_corput(k), hammersley(k, count));
        let direction = axis_turned(cosine_hemisphere(u), axis);
        let texel = envmap_texel(direction, uvec2(map.size[0], map.size[1]), map.edges);
        let radiance = map.texels[(texel.y * map.size[0] + texel.x) as usize];
        for (sum, value) in sums.iter_mut().zip(radiance) {
            let value = fixed64(value, scale as i32);
            *sum += u128::from(value.x) | (u128::from(value.y) << 32);
        }
    }
    sums
}
