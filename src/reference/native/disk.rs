//! The unit disk in the native profile: concentric and polar maps, with inverse.
//!
//! Source: Shirley and Chiu 1997, JGT 2(3). Domain: two fractions of 2^32.
//! Pdf: with respect to area, 1/pi.
//! Mirror: `shaders/corput/native/disk.glsl`.

use glam::{UVec2, Vec2, uvec2, vec2};

/// u as a fraction of 2^32; rounds to 1 for the highest u, unlike `unit_floor`.
#[must_use]
pub fn native_unit(u: u32) -> f32 {
    u as f32 * 2.328_306_4e-10
}

/// 2u - 1 in [-1, 1].
#[must_use]
pub fn native_signed_unit(u: u32) -> f32 {
    (u ^ 0x8000_0000) as i32 as f32 * 4.656_613e-10
}

/// The fraction of 2^32 nearest below x, for x clamped to [0, 1); 0 for NaN.
#[must_use]
pub fn native_fraction(x: f32) -> u32 {
    if x > 0.0 {
        (x.min(0.999_999_94) * 4_294_967_296.0) as u32
    } else {
        0
    }
}

/// x as a density: the largest float for what is larger, 0 for what is negative or NaN.
#[must_use]
pub fn native_density(x: f32) -> f32 {
    if x > 0.0 { x.min(f32::MAX) } else { 0.0 }
}

/// Angle of p in turns, in [0, 1].
#[must_use]
pub fn native_turns(p: Vec2) -> f32 {
    if p.x == 0.0 && p.y == 0.0 {
        return 0.0;
    }
    let turns = p.y.atan2(p.x) * std::f32::consts::FRAC_1_PI * 0.5;
    if turns < 0.0 { turns + 1.0 } else { turns }
}

/// Point of the disk, concentric map.
#[must_use]
pub fn native_concentric_disk(u: UVec2) -> Vec2 {
    let x = native_signed_unit(u.x);
    let y = native_signed_unit(u.y);
    if x == 0.0 && y == 0.0 {
        return Vec2::ZERO;
    }
    if x.abs() >= y.abs() {
        let phi = std::f32::consts::FRAC_PI_4 * (y / x);
        return vec2(x * phi.cos(), x * phi.sin());
    }
    let phi = std::f32::consts::FRAC_PI_4 * (x / y);
    vec2(y * phi.sin(), y * phi.cos())
}

/// The fractions that the concentric map takes to p.
#[must_use]
pub fn native_concentric_disk_invert(p: Vec2) -> UVec2 {
    let radius = (p.x * p.x + p.y * p.y).sqrt();
    let large = p.x.abs().max(p.y.abs());
    let small = p.x.abs().min(p.y.abs());
    let rest = if large == 0.0 {
        0.0
    } else {
        radius * (4.0 * std::f32::consts::FRAC_1_PI * (small / large).atan())
    };
    let x_large = p.x.abs() >= p.y.abs();
    let x = if x_large { radius } else { rest };
    let y = if x_large { rest } else { radius };
    uvec2(
        native_fraction(0.5 + 0.5 * if p.x < 0.0 { -x } else { x }),
        native_fraction(0.5 + 0.5 * if p.y < 0.0 { -y } else { y }),
    )
}

/// Point of the disk, polar map.
#[must_use]
pub fn native_polar_disk(u: UVec2) -> Vec2 {
    let radius = native_unit(u.x).sqrt();
    let phi = std::f32::consts::TAU * native_unit(u.y);
    vec2(radius * phi.cos(), radius * phi.sin())
}

/// The fractions that the polar map takes to p.
#[must_use]
pub fn native_polar_disk_invert(p: Vec2) -> UVec2 {
    uvec2(
        native_fraction(p.x * p.x + p.y * p.y),
        native_fraction(native_turns(p)),
    )
}
