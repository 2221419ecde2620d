//! Free flight, normal distributions and pixel filters: `map_line.comp`, `map_normal.comp`,
//! `map_filter.comp` and `map_filter_gaussian.comp` of `shaders/kernels`, line by line.

use super::prepared;
use crate::catalog::{Mapping, Profile};
use crate::interface::{MAP_PARAMETERS, map};
use crate::reference::native::{
    filter as native_filter, free_flight as native_flight, gaussian as native_gaussian,
};
use crate::reference::{filter, free_flight, gaussian};
use glam::{Vec2, uvec2, vec2};

fn one(x: f32, pdf: f32) -> [u32; 4] {
    [x, pdf, 0.0, 0.0].map(f32::to_bits)
}

fn two(p: Vec2, pdf: f32) -> [u32; 4] {
    [p.x, p.y, pdf, 0.0].map(f32::to_bits)
}

/// Coordinates and pdf.
pub(super) fn sample(mapping: &Mapping, profile: Profile, u: [u32; 3]) -> [u32; 4] {
    let (id, p) = (mapping.map().id, mapping.parameters());
    match (profile, id) {
        (Profile::Exact, map::FILTER_GAUSSIAN) => {
            let s = filter::filter_gaussian(prepared(mapping), uvec2(u[0], u[1]));
            two(s.p, s.pdf)
        }
        (Profile::Native, map::FILTER_GAUSSIAN) => {
            let f = native_filter::native_filter_gaussian_prepare(p[0], p[1]);
            let s = native_filter::native_filter_gaussian(f, uvec2(u[0], u[1]));
            two(s.p, s.pdf)
        }
        (Profile::Exact, _) => exact(id, p, u),
        (Profile::Native, _) => native(id, p, u),
    }
}

macro_rules! samples {
    ($name:ident, $flight:ident :: $exponential:ident, $gaussian:ident :: { $normal:ident, $pair:ident, $polar:ident },
        $filter:ident :: { $box:ident, $tent:ident }) => {
        fn $name(id: u32, p: &[f32; MAP_PARAMETERS], u: [u32; 3]) -> [u32; 4] {
            let v = uvec2(u[0], u[1]);
            let filtered = match id {
                map::EXPONENTIAL => {
                    let s = $flight::$exponential(p[0], u[0]);
                    return one(s.t, s.pdf);
                }
                map::GAUSSIAN => {
                    let s = $gaussian::$normal(p[0], u[0]);
                    return one(s.x, s.pdf);
                }
                map::NORMAL_PAIR => {
                    let s = $gaussian::$pair(p[0], v);
                    return two(s.p, s.pdf);
                }
                map::BOX_MULLER => {
                    let s = $gaussian::$polar(p[0], v);
                    return two(s.p, s.pdf);
                }
                map::FILTER_BOX => $filter::$box(p[0], v),
                map::FILTER_TENT => $filter::$tent(p[0], v),
                _ => return [0; 4],
            };
            two(filtered.p, filtered.pdf)
        }
    };
}

samples!(exact, free_flight::exponential, gaussian::{ gaussian, normal_pair, box_muller },
    filter::{ filter_box, filter_tent });
samples!(native, native_flight::native_exponential,
native_gaussian::{ native_gaussian, native_normal_pair, native_box_muller },
native_filter::{ native_filter_box, native_filter_tent });

/// The pdf.
pub(super) fn pdf(mapping: &Mapping, profile: Profile, [x, y, _]: [f32; 3]) -> f32 {
    let (id, p) = (mapping.map().id, mapping.parameters());
    let at = vec2(x, y);
    match (profile, id) {
        (Profile::Exact, map::EXPONENTIAL) => free_flight::exponential_pdf(p[0], x),
        (Profile::Exact, map::GAUSSIAN) => gaussian::gaussian_pdf(p[0], x),
        (Profile::Exact, map::NORMAL_PAIR | map::BOX_MULLER) => gaussian::normal_pair_pdf(p[0], at),
        (Profile::Exact, map::FILTER_BOX) => filter::filter_box_pdf(p[0], at),
        (Profile::Exact, map::FILTER_TENT) => filter::filter_tent_pdf(p[0], at),
        (Profile::Exact, map::FILTER_GAUSSIAN) => {
            filter::filter_gaussian_pdf(prepared(mapping), at)
        }
        (Profile::Native, map::EXPONENTIAL) => native_flight::native_exponential_pdf(p[0], x),
        (Profile::Native, map::GAUSSIAN) => native_gaussian::native_gaussian_pdf(p[0], x),
        (Profile::Native, map::NORMAL_PAIR | map::BOX_MULLER) => {
            native_gaussian::native_normal_pair_pdf(p[0], at)
        }
        (Profile::Native, map::FILTER_BOX) => native_filter::native_filter_box_pdf(p[0], at),
        (Profile::Native, map::FILTER_TENT) => native_filter::native_filter_tent_pdf(p[0], at),
        (Profile::Native, map::FILTER_GAUSSIAN) => {
            let f = native_filter::native_filter_gaussian_prepare(p[0], p[1]);
            native_filter::native_filter_gaussian_pdf(f, at)
        }
        _ => 0.0,
    }
}

/// The fractions.
pub(super) fn invert(mapping: &Mapping, profile: Profile, [x, y, _]: [f32; 3]) -> [u32; 3] {
    let (id, p) = (mapping.map().id, mapping.parameters());
    let at = vec2(x, y);
    let u = match (profile, id) {
        (Profile::Exact, map::EXPONENTIAL) => uvec2(free_flight::exponential_invert(p[0], x), 0),
        (Profile::Exact, map::GAUSSIAN) => uvec2(gaussian::gaussian_invert(p[0], x), 0),
        (Profile::Exact, map::NORMAL_PAIR) => gaussian::normal_pair_invert(p[0], at),
        (Profile::Exact, map::BOX_MULLER) => gaussian::box_muller_invert(p[0], at),
        (Profile::Exact, map::FILTER_BOX) => filter::filter_box_invert(p[0], at),
        (Profile::Exact, map::FILTER_TENT) => filter::filter_tent_invert(p[0], at),
        (Profile::Exact, map::FILTER_GAUSSIAN) => {
            filter::filter_gaussian_invert(prepared(mapping), at)
        }
        (Profile::Native, map::EXPONENTIAL) => {
            uvec2(native_flight::native_exponential_invert(p[0], x), 0)
        }
        (Profile::Native, map::GAUSSIAN) => {
            uvec2(native_gaussian::native_gaussian_invert(p[0], x), 0)
        }
        (Profile::Native, map::NORMAL_PAIR) => native_gaussian::native_normal_pair_invert(p[0], at),
        (Profile::Native, map::BOX_MULLER) => native_gaussian::native_box_muller_invert(p[0], at),
        (Profile::Native, map::FILTER_BOX) => native_filter::native_filter_box_invert(p[0], at),
        (Profile::Native, map::FILTER_TENT) => native_filter::native_filter_tent_invert(p[0], at),
        (Profile::Native, map::FILTER_GAUSSIAN) => {
            let f = native_filter::native_filter_gaussian_prepare(p[0], p[1]);
            native_filter::native_filter_gaussian_invert(f, at)
        }
        _ => return [0; 3],
    };
    [u.x, u.y, 0]
}
