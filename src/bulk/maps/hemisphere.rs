//! Disk and hemisphere: `shaders/kernels/map_hemisphere.glsl`, line by line.

use crate::catalog::Profile;
use crate::interface::map;
use crate::reference::native::disk as native_disk;
use crate::reference::native::hemisphere as native_hemisphere;
use crate::reference::{disk, hemisphere};
use glam::{UVec2, Vec2, Vec3, uvec2, vec2, vec3};

/// The pdf of both disks in the native profile.
const DISK_PDF: f32 = std::f32::consts::FRAC_1_PI;

fn planar(p: Vec2, pdf: f32) -> [u32; 4] {
    [p.x, p.y, pdf, 0.0].map(f32::to_bits)
}

fn spatial(d: Vec3, pdf: f32) -> [u32; 4] {
    [d.x, d.y, d.z, pdf].map(f32::to_bits)
}

/// Coordinates and pdf.
pub(super) fn sample(profile: Profile, id: u32, u: [u32; 3]) -> [u32; 4] {
    let u = uvec2(u[0], u[1]);
    match profile {
        Profile::Exact => exact(id, u),
        Profile::Native => native(id, u),
    }
}

fn exact(id: u32, u: UVec2) -> [u32; 4] {
    match id {
        map::CONCENTRIC_DISK => planar(disk::concentric_disk(u), disk::concentric_disk_pdf()),
        map::POLAR_DISK => planar(disk::polar_disk(u), disk::polar_disk_pdf()),
        map::UNIFORM_HEMISPHERE => {
            let d = hemisphere::uniform_hemisphere(u);
            spatial(d, hemisphere::uniform_hemisphere_pdf(d))
        }
        map::COSINE_HEMISPHERE => {
            let d = hemisphere::cosine_hemisphere(u);
            spatial(d, hemisphere::cosine_hemisphere_pdf(d))
        }
        _ => {
            let d = hemisphere::cosine_hemisphere_polar(u);
            spatial(d, hemisphere::cosine_hemisphere_polar_pdf(d))
        }
    }
}

fn native(id: u32, u: UVec2) -> [u32; 4] {
    match id {
        map::CONCENTRIC_DISK => planar(native_disk::native_concentric_disk(u), DISK_PDF),
        map::POLAR_DISK => planar(native_disk::native_polar_disk(u), DISK_PDF),
        map::UNIFORM_HEMISPHERE => {
            let d = native_hemisphere::native_uniform_hemisphere(u);
            spatial(d, native_hemisphere::native_uniform_hemisphere_pdf(d))
        }
        map::COSINE_HEMISPHERE => {
            let d = native_hemisphere::native_cosine_hemisphere(u);
            spatial(d, native_hemisphere::native_cosine_hemisphere_pdf(d))
        }
        _ => {
            let d = native_hemisphere::native_cosine_hemisphere_polar(u);
            spatial(d, native_hemisphere::native_cosine_hemisphere_polar_pdf(d))
        }
    }
}

/// The pdf.
pub(super) fn pdf(profile: Profile, id: u32, [x, y, z]: [f32; 3]) -> f32 {
    let d = vec3(x, y, z);
    match (profile, id) {
        (Profile::Exact, map::CONCENTRIC_DISK | map::POLAR_DISK) => disk::concentric_disk_pdf(),
        (Profile::Exact, map::UNIFORM_HEMISPHERE) => hemisphere::uniform_hemisphere_pdf(d),
        (Profile::Exact, _) => hemisphere::cosine_hemisphere_pdf(d),
        (Profile::Native, map::CONCENTRIC_DISK | map::POLAR_DISK) => DISK_PDF,
        (Profile::Native, map::UNIFORM_HEMISPHERE) => {
            native_hemisphere::native_uniform_hemisphere_pdf(d)
        }
        (Profile::Native, _) => native_hemisphere::native_cosine_hemisphere_pdf(d),
    }
}

/// The fractions.
pub(super) fn invert(profile: Profile, id: u32, [x, y, z]: [f32; 3]) -> [u32; 3] {
    let (p, d) = (vec2(x, y), vec3(x, y, z));
    let u = match (profile, id) {
        (Profile::Exact, map::CONCENTRIC_DISK) => disk::concentric_disk_invert(p),
        (Profile::Exact, map::POLAR_DISK) => disk::polar_disk_invert(p),
        (Profile::Exact, map::UNIFORM_HEMISPHERE) => hemisphere::uniform_hemisphere_invert(d),
        (Profile::Exact, map::COSINE_HEMISPHERE) => hemisphere::cosine_hemisphere_invert(d),
        (Profile::Exact, _) => hemisphere::cosine_hemisphere_polar_invert(d),
        (Profile::Native, map::CONCENTRIC_DISK) => native_disk::native_concentric_disk_invert(p),
        (Profile::Native, map::POLAR_DISK) => native_disk::native_polar_disk_invert(p),
        (Profile::Native, map::UNIFORM_HEMISPHERE) => {
            native_hemisphere::native_uniform_hemisphere_invert(d)
        }
        (Profile::Native, map::COSINE_HEMISPHERE) => {
            native_hemisphere::native_cosine_hemisphere_invert(d)
        }
        (Profile::Native, _) => native_hemisphere::native_cosine_hemisphere_polar_invert(d),
    };
    [u.x, u.y, 0]
}
