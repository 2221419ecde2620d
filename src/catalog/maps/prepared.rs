//! What the host prepares of a map's parameters, as words for its kernel:
//! `shaders/kernels/prepared.glsl`. The reference makes the same bits as a device would, and
//! kernels are shorter by what they need not prepare, which is most of some.

use super::Map;
use crate::interface::{MAP_PARAMETERS, map};
use crate::reference::arc::Arc;
use crate::reference::disk_light::{DiskLight, disk_light_prepare};
use crate::reference::filter::{FilterGaussian, filter_gaussian_prepare};
use crate::reference::ggx_lobe::Ggx;
use crate::reference::real::Real;
use crate::reference::real_frame::RealFrame;
use crate::reference::real_vector::Real3;
use crate::reference::sphere_light::{SphereLight, sphere_light_prepare};
use crate::reference::spherical_rectangle::{SphericalRectangle, spherical_rectangle_prepare};
use crate::reference::spherical_triangle::{SphericalTriangle, spherical_triangle_prepare};
use glam::{Vec3, vec3};

/// A prepared struct as words, its reals in their order.
pub trait Words: Sized {
    /// Appends them.
    fn put(&self, words: &mut Vec<u32>);
    /// Takes them off the front; zeros where there are too few.
    fn take(words: &mut &[u32]) -> Self;

    /// The struct of words that begin with it.
    #[must_use]
    fn of(mut words: &[u32]) -> Self {
        Self::take(&mut words)
    }
}

impl Words for Real {
    fn put(&self, words: &mut Vec<u32>) {
        words.extend([self.m, (self.e << 1) as u32 | u32::from(self.negative)]);
    }

    fn take(words: &mut &[u32]) -> Self {
        let Some((&[m, e], rest)) = words.split_first_chunk() else {
            return crate::reference::real::real_zero();
        };
        *words = rest;
        Self {
            m,
            e: e as i32 >> 1,
            negative: e & 1 != 0,
        }
    }
}

macro_rules! words {
    ($name:ident { $($field:ident),+ }) => {
        impl Words for $name {
            fn put(&self, words: &mut Vec<u32>) {
                $(self.$field.put(words);)+
            }

            fn take(words: &mut &[u32]) -> Self {
                Self { $($field: Words::take(words)),+ }
            }
        }
    };
}

words!(Real3 { x, y, z });
words!(Arc { cosine, sine });
words!(RealFrame {
    tangent,
    bitangent,
    normal
});
#[rustfmt::skip]
words!(SphericalTriangle {
    a, b, c, ab, bc, ca, area, rest, ab_normal, bc_normal, ca_normal, tangent, height
});
words!(SphericalRectangle {
    first,
    second,
    area
});
words!(SphereLight { frame, h, sine });
words!(DiskLight {
    center,
    frame,
    radius,
    height
});
words!(Ggx {
    alpha_x,
    alpha_y,
    wo,
    view,
    stretch,
    view_below,
    cap_above,
    cap_below,
    excess
});
words!(FilterGaussian {
    radius,
    sigma,
    mass,
    tail
});

/// The words that a map's kernel takes besides its parameters; none for most maps.
pub(super) fn prepared(map: &Map, p: &[f32; MAP_PARAMETERS]) -> Vec<u32> {
    let v = |i: usize| -> Vec3 { vec3(p[i], p[i + 1], p[i + 2]) };
    let mut words = Vec::new();
    match map.id {
        map::SPHERICAL_TRIANGLE => spherical_triangle_prepare(v(0), v(3), v(6)).put(&mut words),
        map::SPHERICAL_RECTANGLE => spherical_rectangle_prepare(v(0), v(3), v(6)).put(&mut words),
        map::SPHERE_LIGHT => sphere_light_prepare(v(0), p[3]).put(&mut words),
        map::DISK_LIGHT => disk_light_prepare(v(0), v(3), p[6]).put(&mut words),
        map::FILTER_GAUSSIAN => filter_gaussian_prepare(p[0], p[1]).put(&mut words),
        _ => {}
    }
    words
}
