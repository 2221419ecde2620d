//! An orthonormal frame around a unit normal in the native profile.
//!
//! Source: Duff et al. 2017, JCGT 6(1).
//! Mirror: `shaders/corput/native/frame.glsl`.

use glam::{Vec3, vec3};

/// Tangent, bitangent, normal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NativeFrame {
    /// First axis.
    pub tangent: Vec3,
    /// Second axis.
    pub bitangent: Vec3,
    /// Third axis.
    pub normal: Vec3,
}

/// The frame around a unit normal.
#[must_use]
pub fn native_frame(normal: Vec3) -> NativeFrame {
    // By the sign bit, so that -0 agrees with the denominator.
    let one = f32::from_bits(0x3f80_0000 | (normal.z.to_bits() & 0x8000_0000));
    let a = -1.0 / (one + normal.z);
    let b = normal.x * normal.y * a;
    NativeFrame {
        tangent: vec3(
            1.0 + one * normal.x * normal.x * a,
            one * b,
            -one * normal.x,
        ),
        bitangent: vec3(b, one + normal.y * normal.y * a, -normal.y),
        normal,
    }
}

/// The vector with these coordinates in the frame.
#[must_use]
pub fn native_frame_to_world(f: NativeFrame, local: Vec3) -> Vec3 {
    local.x * f.tangent + local.y * f.bitangent + local.z * f.normal
}

/// Coordinates in the frame of this vector.
#[must_use]
pub fn native_frame_to_local(f: NativeFrame, world: Vec3) -> Vec3 {
    vec3(
        world.dot(f.tangent),
        world.dot(f.bitangent),
        world.dot(f.normal),
    )
}
