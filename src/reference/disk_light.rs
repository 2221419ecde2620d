//! Directions from the origin towards a disk, uniformly over its area, with the pdf of the
//! direction, and inverse.
//!
//! Source: PBRT 4th ed., 6.3 and 12.2.3. Domain: a centre, a normal of any length, a radius;
//! two fractions of 2^32; seen from either side; the origin in the plane of the disk, r <= 0
//! or a normal of 0: pdf 0. Range: unit vectors to 2^-23; +z for a point at the origin. Pdf:
//! with respect to solid angle, |p|^3 / (pi r^2 |n . p|); that of a sample is of its point,
//! before the direction is rounded. Errors: 1 + 2 r/|p| ULP a coordinate, those below 1/4 in
//! ULP of it, and pdf of a sample as much; the inverse agrees with the sample to 2^-20, more
//! where the rounding of a direction is more of the disk's angle. Tier I.
//! Mirror: `shaders/corput/disk_light.glsl`.

use crate::reference::disk::{concentric_disk, concentric_disk_invert};
use crate::reference::real::{
    Real, real, real_add, real_divide, real_float, real_less, real_max, real_multiply, real_shift,
    real_square, real_uint, real_zero,
};
use crate::reference::real_frame::{RealFrame, real_frame, real_frame_to_local};
use crate::reference::real_vector::{
    Real3, real3, real3_add, real3_dot, real3_floats, real3_length, real3_normalize, real3_scale,
    real3_subtract,
};
use crate::reference::wide::{wide_add, wide_product, wide_real};
use glam::{UVec2, Vec3, vec2, vec3};

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DiskLight {
    /// The centre.
    pub center: Real3,
    /// Its normal is that of the disk.
    pub frame: RealFrame,
    /// The radius.
    pub radius: Real,
    /// The distance of the plane from the origin.
    pub height: Real,
}

/// A direction and its pdf.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LightSample {
    /// A unit vector.
    pub direction: Vec3,
    /// With respect to solid angle.
    pub pdf: f32,
}

/// The disk with this centre, normal and radius.
#[inline]
#[must_use]
pub fn disk_light_prepare(center: Vec3, normal: Vec3, radius: f32) -> DiskLight {
    let c = real3(center);
    let n = real3(normal);
    let product = wide_add(
        wide_add(wide_product(c.x, n.x), wide_product(c.y, n.y)),
        wide_product(c.z, n.z),
    );
    let height = real_divide(wide_real(product), real3_length(n));
    DiskLight {
        center: c,
        frame: real_frame(real3_normalize(n)),
        radius: real_max(real(radius), real_zero()),
        height: Real {
            m: height.m,
            e: height.e,
            negative: false,
        },
    }
}

/// The pdf of the direction to a point at this distance.
#[inline]
#[must_use]
pub fn disk_light_density(light: DiskLight, distance: Real) -> f32 {
    if light.height.m == 0 || light.radius.m == 0 {
        return 0.0;
    }
    let cube = real_multiply(real_square(distance), distance);
    // 1/pi to 32 bits.
    let part = real_multiply(cube, real_uint(2_734_261_102, -33));
    real_float(real_divide(
        part,
        real_multiply(real_square(light.radius), light.height),
    ))
}

/// A point of the disk, as a direction.
#[inline]
#[must_use]
pub fn disk_light(light: DiskLight, u: UVec2) -> LightSample {
    let p = concentric_disk(u);
    let side = real3_add(
        real3_scale(light.frame.tangent, real_multiply(real(p.x), light.radius)),
        real3_scale(
            light.frame.bitangent,
            real_multiply(real(p.y), light.radius),
        ),
    );
    let point = real3_add(light.center, side);
    let distance = real3_length(point);
    if distance.m == 0 {
        return LightSample {
            direction: vec3(0.0, 0.0, 1.0),
            pdf: 0.0,
        };
    }
    LightSample {
        direction: real3_floats(real3_normalize(point)),
        pdf: disk_light_density(light, distance),
    }
}

/// The distance at which a direction meets the plane of the disk; 0 where it does not.
#[inline]
#[must_use]
pub fn disk_light_distance(light: DiskLight, direction: Real3) -> Real {
    let n = light.frame.normal;
    let along = real3_dot(direction, n);
    let center = real3_dot(light.center, n);
    if along.m == 0 || along.negative != center.negative {
        return real_zero();
    }
    real_divide(
        light.height,
        Real {
            m: along.m,
            e: along.e,
            negative: false,
        },
    )
}

/// Where a direction meets the plane of the disk, from its centre, over its radius.
#[inline]
#[must_use]
pub fn disk_light_point(light: DiskLight, direction: Real3, distance: Real) -> Real3 {
    let point = real3_subtract(real3_scale(direction, distance), light.center);
    let local = real_frame_to_local(light.frame, point);
    Real3 {
        x: real_divide(local.x, light.radius),
        y: real_divide(local.y, light.radius),
        z: real_zero(),
    }
}

/// |p|^3 / (pi r^2 |n . p|) for the point p that a direction meets, else 0.
#[inline]
#[must_use]
pub fn disk_light_pdf(light: DiskLight, direction: Vec3) -> f32 {
    let d = real3(direction);
    let distance = disk_light_distance(light, d);
    if distance.m == 0 || light.radius.m == 0 {
        return 0.0;
    }
    let p = disk_light_point(light, d, distance);
    let slope = real_divide(distance, light.height);
    let one = real_uint(1, 0);
    // The rounding of d moves the point by 2^-23 of its distance, over the cosine.
    let slack = real_divide(real_multiply(distance, slope), light.radius);
    let most = real_add(real_add(one, real_uint(1, -20)), real_shift(slack, -22));
    if real_less(most, real3_length(p)) {
        return 0.0;
    }
    disk_light_density(light, distance)
}

/// The fractions that give this direction.
#[inline]
#[must_use]
pub fn disk_light_invert(light: DiskLight, direction: Vec3) -> UVec2 {
    let d = real3(direction);
    let p = disk_light_point(light, d, disk_light_distance(light, d));
    concentric_disk_invert(vec2(real_float(p.x), real_float(p.y)))
}
