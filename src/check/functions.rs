//! Rows of the exact profile: device, reference and judge on the same arguments.

use super::blue_noise;
use super::inputs::arguments;
use super::rows::Row;
use super::{discrete, domain, net, random, real, strata, transcendental};
use crate::Result;
use crate::catalog::Function;
use crate::judge::{self, ulp_error};
use crate::kernels::Evaluator;
use crate::reference::{
    bits, disk, elementary, fixed, frame, hammersley, hemisphere, radical_inverse, unit,
};
use crate::vulkan::Device;
use glam::{UVec2, Vec2, Vec3, uvec2, vec3};
use std::sync::Arc;

/// Checks a function as a kernel evaluates it.
pub fn check(device: &Arc<Device>, function: &Function, kernel: &str) -> Result<Row> {
    let evaluator = Evaluator::new(device, kernel, function.id)?;
    compare_function(&evaluator, function, kernel, &arguments(function.kind))
}

/// Compares a function with the reference and the judge, on an evaluator and arguments
/// of the caller's; `kernel` names the row.
///
/// # Errors
/// Those of the device.
pub fn compare_function(
    evaluator: &Evaluator,
    function: &Function,
    kernel: &str,
    arguments: &[[u32; 4]],
) -> Result<Row> {
    let results = evaluator.run(arguments)?;
    let mut mismatches = 0;
    let mut worst = 0.0;
    let mut mismatch = None;
    let mut witness = String::new();
    for (&a, &got) in arguments.iter().zip(&results) {
        let expected = function_words(function.name, a);
        if got != expected {
            mismatches += 1;
            mismatch.get_or_insert_with(|| format!("{a:08x?}: {got:08x?}, not {expected:08x?}"));
        }
        if function.bound.is_some() {
            let error = function_error(function.name, a, got);
            // A NaN must not pass unseen.
            if error > worst || error.is_nan() {
                worst = error;
                witness = format!("{a:08x?}");
            }
        }
    }
    let mut row = Row::exact(function.name, kernel);
    row.tier = function.tier.letter();
    row.compared = arguments.len() as u64;
    row.mismatches = Some(mismatches);
    row.worst = function.bound.map(|_| worst);
    row.bound = function.bound;
    row.unit = function.unit;
    row.witness = mismatch.unwrap_or(witness);
    row.hash(results.as_flattened());
    Ok(row.judged())
}

fn f(word: u32) -> f32 {
    f32::from_bits(word)
}

/// The float of these bits, denormals as zeros: so the functions take them.
fn flushed(word: u32) -> f32 {
    let x = f(word);
    if x.is_subnormal() {
        0f32.copysign(x)
    } else {
        x
    }
}

fn v3(a: [u32; 4]) -> Vec3 {
    vec3(f(a[0]), f(a[1]), f(a[2]))
}

fn local(word: u32) -> Vec3 {
    hemisphere::cosine_hemisphere(uvec2(word, word.wrapping_mul(0x9e37_79b9)))
}

/// What a device must give of a function of the catalogue, by its name: the `evaluate` kernels,
/// line by line.
#[must_use]
pub fn function_words(name: &str, a: [u32; 4]) -> [u32; 4] {
    let u = uvec2(a[0], a[1]);
    let v = v3(a);
    let two = |x: UVec2, y: UVec2| [x.x, x.y, y.x, y.y];
    let planar = |p: Vec2| [p.x.to_bits(), p.y.to_bits(), 0, 0];
    let spatial = |d: Vec3, w: u32| [d.x.to_bits(), d.y.to_bits(), d.z.to_bits(), w];
    let one = |x: u32| [x, 0, 0, 0];
    match name {
        "mul64" => two(fixed::mul64(a[0], a[1]), fixed::addc(a[0], a[1])),
        "add64" => {
            let w = uvec2(a[2], a[3]);
            two(fixed::add64(u, w), fixed::sub64(u, w))
        }
        "shl64" => two(fixed::shl64(u, a[2] & 63), fixed::shr64(u, a[2] & 63)),
        "fixed64" => {
            let wide = fixed::fixed64(f(a[0] & 0x7fff_ffff), (a[1] % 129) as i32 - 64);
            [
                fixed::fixed31(f(a[0])),
                wide.x,
                wide.y,
                bits::find_msb(a[0]),
            ]
        }
        "unit" => [
            unit::unit_floor(a[0]).to_bits(),
            unit::unit_ceil(a[0]).to_bits(),
            radical_inverse::van_der_corput(a[0]),
            0,
        ],
        "cos_sin" => planar(elementary::cos_sin(a[0])),
        "sqrt" => one(elementary::sqrt(f(a[0])).to_bits()),
        "divide" => one(elementary::divide(f(a[0]), f(a[1])).to_bits()),
        "multiply" => one(elementary::multiply(f(a[0]), f(a[1])).to_bits()),
        "atan2" => one(elementary::atan2(f(a[1]), f(a[0]))),
        "ratio" => one(elementary::ratio(
            a[0].min(a[1]) >> 1,
            (a[0].max(a[1]) >> 1).max(1),
        )),
        "radical_inverse" => one(radical_inverse::radical_inverse(a[0], a[1])),
        "hammersley" => {
            let point = hammersley::hammersley_start(a[0], a[1]);
            let step = hammersley::hammersley_start(1, a[1]);
            let next = hammersley::hammersley_next(point, step, a[1]);
            let value = hammersley::hammersley(a[0], a[1]);
            [value, point.fraction, point.remainder, next.remainder]
        }
        "concentric_disk" => planar(disk::concentric_disk(u)),
        "polar_disk" => planar(disk::polar_disk(u)),
        "uniform_hemisphere" => {
            let d = hemisphere::uniform_hemisphere(u);
            spatial(d, hemisphere::uniform_hemisphere_pdf(d).to_bits())
        }
        "cosine_hemisphere" => {
            let d = hemisphere::cosine_hemisphere(u);
            spatial(d, hemisphere::cosine_hemisphere_pdf(d).to_bits())
        }
        "cosine_hemisphere_polar" => {
            let d = hemisphere::cosine_hemisphere_polar(u);
            spatial(d, hemisphere::cosine_hemisphere_polar_pdf(d).to_bits())
        }
        "hemisphere_pdf" => {
            let d = vec3(0.0, 0.0, f(a[0]));
            [
                hemisphere::cosine_hemisphere_pdf(d).to_bits(),
                hemisphere::uniform_hemisphere_pdf(d).to_bits(),
                0,
                0,
            ]
        }
        "disk_invert" => two(
            disk::concentric_disk_invert(v.truncate()),
            disk::polar_disk_invert(v.truncate()),
        ),
        "hemisphere_invert" => two(
            hemisphere::uniform_hemisphere_invert(v),
            hemisphere::cosine_hemisphere_invert(v),
        ),
        "hemisphere_polar_invert" => {
            two(hemisphere::cosine_hemisphere_polar_invert(v), UVec2::ZERO)
        }
        "frame_tangent" => spatial(frame::frame(v).tangent, 0),
        "frame_bitangent" => spatial(frame::frame(v).bitangent, 0),
        "frame_to_world" => spatial(frame::frame_to_world(frame::frame(v), local(a[3])), 0),
        "frame_to_local" => spatial(frame::frame_to_local(frame::frame(v), local(a[3])), 0),
        "blue_noise" | "blue_noise_shift" | "screen_space" => blue_noise::reference(name, a),
        // A name that is not of the catalogue is a mismatch everywhere.
        // Those that are checked over all words come first.
        _ => transcendental::reference(name, a)
            .or_else(|| random::reference(name, a))
            .or_else(|| net::reference(name, a))
            .or_else(|| strata::reference(name, a))
            .or_else(|| domain::reference(name, a))
            .or_else(|| real::reference(name, a))
            .or_else(|| discrete::reference(name, a))
            .unwrap_or([u32::MAX; 4]),
    }
}

/// The judge's error of a function's result, in the unit of its row of the catalogue; 0 of
/// integers, which it does not judge.
#[must_use]
pub fn function_error(name: &str, a: [u32; 4], got: [u32; 4]) -> f64 {
    let u = [a[0], a[1]];
    let ulps = |truth: &[f64]| {
        got.iter()
            .zip(truth)
            .map(|(&word, &t)| ulp_error(f(word), t))
            .fold(0.0, worse)
    };
    let with_pdf = |d: [f64; 3], pdf: f64| ulps(&[d[0], d[1], d[2], pdf]);
    let lambert = |d: [f64; 3]| with_pdf(d, f64::from(f(got[2])) * std::f64::consts::FRAC_1_PI);
    match name {
        "unit" => {
            let up = (f64::from(a[0]) / 256.0).ceil().min(16_777_215.0);
            ulps(&[f64::from(a[0] >> 8) / 16_777_216.0, up / 16_777_216.0])
        }
        "cos_sin" => {
            let (s, c) = judge::sin_cos(a[0]);
            ulps(&[c, s])
        }
        // The judge rounds correctly too: any difference is a failure.
        "sqrt" => rounded(f(got[0]), judge::sqrt(flushed(a[0]))),
        "divide" => rounded(f(got[0]), judge::divide(flushed(a[0]), flushed(a[1]))),
        "multiply" => rounded(f(got[0]), judge::multiply(flushed(a[0]), flushed(a[1]))),
        "atan2" => {
            let (x, y) = (flushed(a[0]), flushed(a[1]));
            if !x.is_finite() || !y.is_finite() || (x == 0.0 && y == 0.0) {
                return 0.0;
            }
            turns(got[0], judge::atan2_turns(y, x))
        }
        "concentric_disk" => ulps(&judge::concentric_disk(u)),
        "polar_disk" => ulps(&judge::polar_disk(u)),
        "uniform_hemisphere" => with_pdf(
            judge::uniform_hemisphere(u),
            0.5 * std::f64::consts::FRAC_1_PI,
        ),
        "cosine_hemisphere" => lambert(judge::cosine_hemisphere(u)),
        "cosine_hemisphere_polar" => lambert(judge::cosine_hemisphere_polar(u)),
        "hemisphere_pdf" => {
            let z = f64::from(f(a[0]));
            let over_pi = std::f64::consts::FRAC_1_PI;
            let direction = z.is_finite() && z >= f64::powi(2.0, -124);
            let half = if f(a[0]) >= 0.0 { 0.5 * over_pi } else { 0.0 };
            ulps(&[if direction { z * over_pi } else { 0.0 }, half])
        }
        "disk_invert" => concentric(got[0], got[1], a).max(polar(got[2], got[3], a)),
        "hemisphere_invert" => {
            let z = f64::from(f(a[2])).abs().min(1.0 - f64::powi(2.0, -32));
            (f64::from(got[0]) - z * 4_294_967_296.0)
                .abs()
                .max(angle(got[1], a))
                .max(concentric(got[2], got[3], a))
        }
        "hemisphere_polar_invert" => polar(got[0], got[1], a),
        "frame_tangent" => absolute(got, judge::frame(normal(a))[0]),
        "frame_bitangent" => absolute(got, judge::frame(normal(a))[1]),
        "frame_to_world" | "frame_to_local" => {
            let n = normal(a);
            let [t, b] = judge::frame(n);
            let d = local(a[3]);
            let d = [f64::from(d.x), f64::from(d.y), f64::from(d.z)];
            let dot = |p: [f64; 3], q: [f64; 3]| p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
            let truth = if name == "frame_to_local" {
                [dot(d, t), dot(d, b), dot(d, n)]
            } else {
                std::array::from_fn(|i| d[0] * t[i] + d[1] * b[i] + d[2] * n[i])
            };
            absolute(got, truth)
        }
        _ => discrete::error(name, a, got)
            .or_else(|| real::error(name, a, got))
            .or_else(|| transcendental::error(name, a, got))
            .unwrap_or(0.0),
    }
}

/// The larger, or the NaN.
fn worse(a: f64, b: f64) -> f64 {
    if a.is_nan() || a > b { a } else { b }
}

/// A normal as `corput_frame` takes it: components below 2^-40 are +0.
fn normal(a: [u32; 4]) -> [f64; 3] {
    wide(a).map(|x| {
        if x.abs() < f64::powi(2.0, -40) {
            0.0
        } else {
            x
        }
    })
}

fn wide(a: [u32; 4]) -> [f64; 3] {
    [f64::from(f(a[0])), f64::from(f(a[1])), f64::from(f(a[2]))]
}

/// Whether two floats that are to be the same are: half a ULP, or a failure.
fn rounded(got: f32, truth: f32) -> f64 {
    if got.to_bits() == truth.to_bits() || (got.is_nan() && truth.is_nan()) {
        0.5
    } else if got == 0.0 && truth == 0.0 {
        // sqrt(-0) is +0 here.
        0.5
    } else {
        f64::INFINITY
    }
}

/// The largest difference of three coordinates, in units of 2^-24.
fn absolute(got: [u32; 4], truth: [f64; 3]) -> f64 {
    got.iter()
        .zip(truth)
        .map(|(&word, t)| (f64::from(f(word)) - t).abs() * 16_777_216.0)
        .fold(0.0, worse)
}

/// The distance of two angles, in units of 2^-32 of a turn.
fn turns(got: u32, truth: f64) -> f64 {
    let difference = (f64::from(got) - truth * 4_294_967_296.0).abs();
    difference.min(4_294_967_296.0 - difference)
}

fn angle(got: u32, a: [u32; 4]) -> f64 {
    if f(a[0]) == 0.0 && f(a[1]) == 0.0 {
        return 0.0;
    }
    turns(got, judge::atan2_turns(f(a[1]), f(a[0])))
}

/// Error of the polar inverse: u.x = x^2 + y^2, u.y the angle.
fn polar(x: u32, y: u32, a: [u32; 4]) -> f64 {
    let [px, py, _] = wide(a);
    let truth = (px * px + py * py).min(1.0 - f64::powi(2.0, -32));
    (f64::from(x) - truth * 4_294_967_296.0)
        .abs()
        .max(angle(y, a))
}

/// Error of the concentric inverse, by its definition in `f64`.
fn concentric(x: u32, y: u32, a: [u32; 4]) -> f64 {
    let [px, py, _] = wide(a);
    let radius = px.hypot(py).min(1.0);
    let (large, small) = (px.abs().max(py.abs()), px.abs().min(py.abs()));
    let rest = if large == 0.0 {
        0.0
    } else {
        radius * (small / large).atan() / std::f64::consts::FRAC_PI_4
    };
    let (tx, ty) = if px.abs() >= py.abs() {
        (radius, rest)
    } else {
        (rest, radius)
    };
    let fraction = |t: f64, p: f64| {
        let u = 0.5 + 0.5 * if p < 0.0 { -t } else { t };
        u.min(1.0 - f64::powi(2.0, -32)) * 4_294_967_296.0
    };
    let dx = (f64::from(x) - fraction(tx, px)).abs();
    let dy = (f64::from(y) - fraction(ty, py)).abs();
    dx.max(dy)
}
