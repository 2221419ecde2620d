//! The texel of an equirectangular environment map that a direction meets.
//!
//! Source: row 0 lies at +z; column c has its centre at azimuth 2 pi (c + 1/2) / width;
//! nearest texel. Rows by binary search over the row edges, so no arc cosine is needed.
//! Domain: unit directions; widths and heights from 1 to 65536. Tier I.
//! Mirror: `shaders/corput/envmap.glsl`.

use crate::reference::elementary::atan2;
use crate::reference::fixed::mulhi;
use glam::{UVec2, Vec3, uvec2};

/// A word that grows with the float of these bits.
#[inline]
#[must_use]
pub fn envmap_order(bits: u32) -> u32 {
    if bits >> 31 != 0 {
        !bits
    } else {
        bits | 0x8000_0000
    }
}

/// Column and row of the texel in this direction.
///
/// `edges[i]` is the float cos(pi i / height), for 1 <= i < height (entry 0 is not
/// read); the shader reads it by its hook `CORPUT_ENVMAP_EDGE(i)`.
#[inline]
#[must_use]
pub fn envmap_texel(direction: Vec3, size: UVec2, edges: &[f32]) -> UVec2 {
    let z = envmap_order(direction.z.to_bits());
    let mut low = 0;
    let mut high = size.y - 1;
    while low < high {
        let middle = (low + high + 1) >> 1;
        if z <= envmap_order(edges[middle as usize].to_bits()) {
            low = middle;
        } else {
            high = middle - 1;
        }
    }
    uvec2(mulhi(atan2(direction.y, direction.x), size.x), low)
}
