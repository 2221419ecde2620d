//! Rows of the native profile: the device's own functions, judged by what Vulkan's
//! precision tables allow.

use super::inputs::arguments;
use super::rows::Row;
use crate::Result;
use crate::catalog::Kind;
use crate::judge;
use crate::kernels::Evaluator;
use crate::vulkan::Device;
use std::sync::Arc;

/// A native function and its bound.
#[derive(Clone, Copy, Debug)]
pub struct NativeRow {
    /// Its name.
    pub name: &'static str,
    /// Value of the constant `FUNCTION` of `evaluate_native`.
    pub id: u32,
    /// Its arguments.
    pub kind: Kind,
    /// Worst absolute error of a coordinate, or of a fraction modulo one.
    pub bound: f64,
}

/// sin and cos may be off by 2^-11, to which square root and products add less than
/// 2^-19.
pub(super) const SINE: f64 = 1.0 / 2048.0 + 1.0 / 524_288.0;

/// atan may be off by 4096 ULP, 2^-11 of the result, which is at most pi and half a turn.
const ARC: f64 = 1.0 / 2048.0 + 1.0 / 524_288.0;

/// Division 2.5 ULP, a few products and sums.
const ALGEBRA: f64 = 1.0 / 524_288.0;

const fn row(name: &'static str, id: u32, kind: Kind, bound: f64) -> NativeRow {
    NativeRow {
        name,
        id,
        kind,
        bound,
    }
}

/// Every native function.
pub const NATIVE: &[NativeRow] = &[
    row("native_frame_tangent", 0, Kind::Direction, ALGEBRA),
    row("native_frame_bitangent", 1, Kind::Direction, ALGEBRA),
    row("native_concentric_disk", 2, Kind::Words, SINE),
    row("native_polar_disk", 3, Kind::Words, SINE),
    row("native_uniform_hemisphere", 4, Kind::Words, SINE),
    row("native_cosine_hemisphere", 5, Kind::Words, SINE),
    row("native_cosine_hemisphere_polar", 6, Kind::Words, SINE),
    row("native_uniform_hemisphere_invert", 7, Kind::Direction, ARC),
    row("native_cosine_hemisphere_invert", 8, Kind::Direction, ARC),
    row(
        "native_cosine_hemisphere_polar_invert",
        9,
        Kind::Direction,
        ARC,
    ),
    row("native_frame_to_world", 10, Kind::Direction, ALGEBRA),
    row("native_frame_to_local", 11, Kind::Direction, ALGEBRA),
];

/// Checks a native function.
pub fn check(device: &Arc<Device>, row: &NativeRow) -> Result<Row> {
    let evaluator = Evaluator::new(device, "evaluate_native", row.id)?;
    compare_native(&evaluator, row, &arguments(row.kind))
}

/// Holds a native function to its bound, on an evaluator and arguments of the caller's.
///
/// # Errors
/// Those of the device.
pub fn compare_native(
    evaluator: &Evaluator,
    row: &NativeRow,
    arguments: &[[u32; 4]],
) -> Result<Row> {
    let results = evaluator.run(arguments)?;
    let mut worst = 0.0;
    let mut witness = String::new();
    for (&a, &got) in arguments.iter().zip(&results) {
        let error = error(row.id, a, got);
        if error > worst || error.is_nan() {
            worst = error;
            witness = format!("{a:08x?}");
        }
    }
    let mut row = Row::native(row.name, "evaluate_native", row.bound, "absolute");
    row.compared = arguments.len() as u64;
    row.worst = Some(worst);
    row.witness = witness;
    row.hash(results.as_flattened());
    Ok(row.judged())
}

fn error(id: u32, a: [u32; 4], got: [u32; 4]) -> f64 {
    let u = [a[0], a[1]];
    let v = [0, 1, 2].map(|i| f64::from(f32::from_bits(a[i])));
    let away = |truth: &[f64]| {
        got.iter()
            .zip(truth)
            .map(|(&word, &t)| (f64::from(f32::from_bits(word)) - t).abs())
            .fold(0.0, |x: f64, y| if x.is_nan() || x > y { x } else { y })
    };
    let with_pdf = |d: [f64; 3], times_pi: f64| {
        away(&[d[0], d[1], d[2], times_pi * std::f64::consts::FRAC_1_PI])
    };
    let lambert = |d: [f64; 3]| with_pdf(d, d[2]);
    // The truth of a fraction wraps, as angles do.
    let wrapped = |got: u32, truth: f64| {
        let difference = (f64::from(got) / 4_294_967_296.0 - truth).abs();
        difference.min(1.0 - difference)
    };
    let angle = if v[0] == 0.0 && v[1] == 0.0 {
        0.0
    } else {
        (v[1].atan2(v[0]) / std::f64::consts::TAU).rem_euclid(1.0)
    };
    let square = (v[0] * v[0] + v[1] * v[1]).min(1.0);
    match id {
        0 => away(&judge::frame(v)[0]),
        1 => away(&judge::frame(v)[1]),
        2 => away(&judge::concentric_disk(u)),
        3 => away(&judge::polar_disk(u)),
        4 => with_pdf(judge::uniform_hemisphere(u), 0.5),
        5 => lambert(judge::cosine_hemisphere(u)),
        6 => lambert(judge::cosine_hemisphere_polar(u)),
        7 => wrapped(got[0], v[2].clamp(0.0, 1.0)).max(wrapped(got[1], angle)),
        8 => {
            let radius = square.sqrt();
            let (large, small) = (v[0].abs().max(v[1].abs()), v[0].abs().min(v[1].abs()));
            let rest = match large {
                0.0 => 0.0,
                _ => radius * (small / large).atan() / std::f64::consts::FRAC_PI_4,
            };
            let x_large = v[0].abs() >= v[1].abs();
            let (x, y) = if x_large {
                (radius, rest)
            } else {
                (rest, radius)
            };
            wrapped(got[0], 0.5 + 0.5 * x.copysign(v[0]))
                .max(wrapped(got[1], 0.5 + 0.5 * y.copysign(v[1])))
        }
        10 | 11 => {
            // The vector (0.6, 0, 0.8) of `evaluate.comp`.
            let [t, b] = judge::frame(v);
            let d = [0.6, 0.0, 0.8];
            let dot = |p: [f64; 3]| d[0] * p[0] + d[1] * p[1] + d[2] * p[2];
            if id == 10 {
                away(&[0, 1, 2].map(|i| d[0] * t[i] + d[1] * b[i] + d[2] * v[i]))
            } else {
                away(&[dot(t), dot(b), dot(v)])
            }
        }
        _ => wrapped(got[0], square).max(wrapped(got[1], angle)),
    }
}
