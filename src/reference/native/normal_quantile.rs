//! The normal distribution in the native profile: quantile, masses, density and the
//! fraction that a value stands for, by the device's own log, sqrt and exp.
//!
//! Source: as the exact profile's normal_quantile, with shorter polynomials
//! (`scripts/elementary_polynomials.py`). Domain: all fractions u of 2^32, which stand
//! for the midpoints (2 u + 1) / 2^33. Errors: quantile 2e-6 of itself, masses 3e-6 of
//! themselves, within what Vulkan allows log, sqrt and exp.
//! Mirror: `shaders/corput/native/normal_quantile.glsl`.

use crate::reference::native::disk::{native_density, native_fraction, native_unit};
use glam::{Vec2, vec2};

/// z >= 0 with this mass from 0 to z, and this tail beyond, which is 1/2 - mass.
#[inline]
#[must_use]
pub fn native_quantile(mass: f32, tail: f32) -> f32 {
    let w = 8.0 * mass * mass;
    if w < 1.0 {
        let mut p = -0.006_195_989_3 + w * 0.003_548_454_7;
        p = 0.002_079_616_2 + w * (0.009_394_516_5 + w * p);
        p = 0.044_969_951 + w * (0.016_288_6 + w * p);
        return 2.0 * mass * (1.253_314_1 + w * (0.164_064_64 + w * p));
    }
    let t = (-2.0 * tail.ln()).sqrt();
    if t < 3.75 {
        let s = t - 2.8;
        let mut p = -0.000_280_425_17 + s * 0.000_077_392_70;
        p = -0.002_825_531_9 + s * (0.000_820_377_3 + s * p);
        p = -0.038_455_928 + s * (0.010_232_437 + s * p);
        return 2.057_042 + s * (1.155_194_8 + s * p);
    }
    let r = t - 5.25;
    let mut q = 0.000_038_475_87 + r * -0.000_006_049_418_4;
    q = 0.001_357_414_2 + r * (-0.000_214_035_64 + r * q);
    4.746_496 + r * (1.062_399_4 + r * (-0.008_953_585_8 + r * q))
}

/// z such that the normal distribution has mass (2 u + 1) / 2^33 below it.
#[inline]
#[must_use]
pub fn native_normal_quantile(u: u32) -> f32 {
    let upper = if u < 0x8000_0000 { !u } else { u };
    let share = (upper << 1) | 1;
    let z = native_quantile(
        0.5 * native_unit(share),
        0.5 * native_unit(0u32.wrapping_sub(share)),
    );
    if u < 0x8000_0000 { -z } else { z }
}

/// The density at z; 0 for NaN.
#[inline]
#[must_use]
pub fn native_normal_density(z: f32) -> f32 {
    native_density(0.398_942_28 * (-0.5 * z * z).exp())
}

/// The mass of the normal distribution from 0 to |z|, and above |z|.
#[inline]
#[must_use]
pub fn native_normal_masses(z: f32) -> Vec2 {
    let x = z.abs();
    let w = 0.5 * x * x;
    if w < 1.0 {
        let mut p = 0.001_740_105_7 - w * 0.000_199_689_07;
        p = 0.039_881_942 - w * (0.009_445_198 - w * p);
        let near = x * (0.398_942_27 - w * (0.132_979_72 - w * p));
        return vec2(near, 0.5 - near);
    }
    let s = 4.0 / (4.0 + x);
    let mut q = 0.279_956_43 - s * 0.002_756_363_1;
    q = 0.269_938_55 + s * (-0.194_657_06 + s * q);
    q = 0.111_476_11 + s * (0.037_224_575 + s * q);
    let far = (-w).exp() * (s * q - 0.000_915_366_94);
    vec2(0.5 - far, far)
}

/// The fraction whose midpoint's quantile is z.
#[inline]
#[must_use]
pub fn native_normal_fraction(z: f32) -> u32 {
    let tail = native_normal_masses(z).y;
    let mass = if z < 0.0 { tail } else { 1.0 - tail };
    native_fraction(mass)
}
