//! Each measure: whether it is worth its time, its figures, and how they read.

use super::Outcome;
use super::device::OnDevice;
use super::names::Measure;
use corput::Result;
use corput::stats::{
    L2, Points, Progress, elementary_intervals, hexagonal_distance, l2_discrepancy, nearest,
    projections, spectrum, spectrum_range, star_1d, star_2d, star_bounds, t_value,
};
use serde_json::{Value, json};

/// Elementary steps that a measure may take without `--all`: some ten seconds.
const LIMIT: u64 = 1 << 34;

/// Looks at a coordinate for the bounds of a star discrepancy, without `--all` and with it.
const STAR_WORK: [u64; 2] = [1 << 28, 1 << 33];

/// Tests of a point against a shape for a t-value, likewise.
const NET_WORK: [u64; 2] = [1 << 31, 1 << 36];

/// Up to so many dimensions the nearest pair takes linear time.
const GRID_DIMENSIONS: usize = 3;

/// What to measure, and how.
pub struct Job<'a> {
    pub points: &'a Points,
    pub bases: Vec<u32>,
    pub pair: Option<[usize; 2]>,
    pub device: Option<&'a OnDevice>,
    pub all: bool,
}

impl Job<'_> {
    /// One measure.
    pub fn measure(&self, measure: Measure, progress: Progress) -> Result<Outcome> {
        let rows = self.points.rows() as u64;
        let columns = self.points.columns() as u64;
        let square = rows.saturating_mul(rows);
        let pairs = columns * (columns - 1) / 2;
        let (steps, what) = match measure {
            // The bounds take what they are given.
            Measure::Star if columns == 2 => (square, "N^2"),
            Measure::L2(_) => (square.saturating_mul(columns) / 2, "N^2 d / 2"),
            Measure::Projections => (square.saturating_mul(pairs), "N^2 d (d - 1) / 2"),
            Measure::Distance if self.points.columns() > GRID_DIMENSIONS => {
                (square.saturating_mul(columns) / 8, "N^2 d / 8")
            }
            Measure::Spectrum => {
                let range = spectrum_range(self.points.rows()) as u64;
                (4 * rows * range * range, "4 N R^2")
            }
            _ => (0, ""),
        };
        let on_device = matches!(measure, Measure::L2(_) | Measure::Distance);
        let limit = match self.device {
            Some(device) if on_device => device.speed() * LIMIT,
            _ => LIMIT,
        };
        if steps > limit && !self.all {
            return Ok(Outcome::skipped(format!(
                "{what} = {:.1e} steps are more than {:.1e}; use --all",
                steps as f64, limit as f64
            )));
        }
        match measure {
            Measure::Star => self.star(progress),
            Measure::L2(kind) => self.l2(kind, progress),
            Measure::TValue => self.t_value(progress),
            Measure::Intervals => self.intervals(progress),
            Measure::Distance => self.distance(progress),
            Measure::Projections => self.projections(progress),
            Measure::Spectrum => self.spectrum(progress),
        }
    }

    fn star(&self, progress: Progress) -> Result<Outcome> {
        let exact = match self.points.columns() {
            1 => Some(star_1d(self.points.values())),
            2 => Some(star_2d(&self.points.pairs(0, 1)?, progress)?),
            _ => None,
        };
        if let Some(value) = exact {
            return Ok(Outcome {
                value: figure(value),
                note: "exact".into(),
                json: json!({"is": "supremum", "value": value, "exact": true}),
            });
        }
        let bounds = star_bounds(self.points, STAR_WORK[usize::from(self.all)], progress)?;
        let (lower, upper) = (bounds.lower, bounds.upper);
        let json = json!({
            "is": "supremum", "lower": lower, "upper": upper, "exact": bounds.is_exact(),
        });
        Ok(if bounds.is_exact() {
            Outcome {
                value: figure(upper),
                note: "exact".into(),
                json,
            }
        } else {
            Outcome {
                value: format!("{} to {}", figure(lower), figure(upper)),
                note: "lower and upper bound".into(),
                json,
            }
        })
    }

    fn l2(&self, kind: L2, progress: Progress) -> Result<Outcome> {
        let found = match self.device {
            Some(device) => device.l2(kind, progress)?,
            None => l2_discrepancy(self.points, kind, progress)?,
        };
        Ok(Outcome {
            value: figure(found.value),
            note: kind.convention().into(),
            json: json!({
                "is": kind.convention(),
                "value": found.value,
                "square": found.square,
                "square_error_at_most": found.square_error,
                "points_are": points_are(self.device),
            }),
        })
    }

    fn t_value(&self, progress: Progress) -> Result<Outcome> {
        if !self.points.rows().is_power_of_two() {
            return Ok(Outcome::skipped(
                "the number of points is no power of 2".into(),
            ));
        }
        let found = t_value(self.points, NET_WORK[usize::from(self.all)], progress)?;
        let d = self.points.columns();
        let json = json!({
            "base": 2, "m": found.m, "t": found.exact(),
            "t_at_least": found.least, "t_at_most": found.most,
        });
        Ok(match found.exact() {
            Some(t) => Outcome {
                value: t.to_string(),
                note: format!("a ({t}, {}, {d})-net in base 2", found.m),
                json,
            },
            None => Outcome {
                value: format!("{} to {}", found.least, found.most),
                note: format!("of 2^{} points in base 2; more shapes with --all", found.m),
                json,
            },
        })
    }

    fn intervals(&self, progress: Progress) -> Result<Outcome> {
        let rows = self.points.rows();
        // A net is judged by the shapes that have a cell for each point.
        let full = rows.is_power_of_two() && self.bases.iter().all(|base| *base == 2);
        let work = if self.all { u64::MAX } else { LIMIT / 4 };
        let shapes = match elementary_intervals(self.points, &self.bases, full, work, progress) {
            Ok(shapes) => shapes,
            // `--all` lifts one of its two limits.
            Err(corput::Error::Arguments { limit, remedy, .. }) => {
                let also = if self.all { "" } else { ", or use --all" };
                return Ok(Outcome::skipped(format!("{limit}; {remedy}{also}")));
            }
            Err(error) => return Err(error),
        };
        let fair = shapes.iter().filter(|shape| shape.is_fair()).count();
        let worst = shapes
            .iter()
            .min_by(|a, b| (a.fair * b.cells).cmp(&(b.fair * a.cells)));
        let bases: Vec<String> = self.bases.iter().map(u32::to_string).collect();
        let mut note = format!("shapes filled fairly, bases {}", bases.join(","));
        if let Some(worst) = worst.filter(|worst| !worst.is_fair()) {
            note += &format!(
                "; in the worst, {:?}, {} of {} cells",
                worst.digits, worst.fair, worst.cells
            );
        }
        let row = |shape: &corput::stats::Shape| {
            json!({
                "digits": shape.digits, "cells": shape.cells, "fair_cells": shape.fair,
                "least": shape.least, "most": shape.most,
            })
        };
        let list: Vec<Value> = shapes.iter().map(row).collect();
        Ok(Outcome {
            value: format!("{fair} of {}", shapes.len()),
            note,
            json: json!({
                "bases": self.bases,
                "fair_is": "points / cells, rounded down or up",
                "fair_shapes": fair,
                "shapes": list,
            }),
        })
    }

    fn distance(&self, progress: Progress) -> Result<Outcome> {
        // In few dimensions a grid on the CPU beats all pairs on a device.
        let device = self
            .device
            .filter(|_| self.points.columns() > GRID_DIMENSIONS);
        let mut search = |toroidal| match device {
            Some(device) => device.nearest(toroidal, progress),
            None => nearest(self.points, toroidal, progress),
        };
        let (torus, cube) = (search(true)?, search(false)?);
        let (Some(torus), Some(cube)) = (torus, cube) else {
            return Ok(Outcome::skipped("one point has no neighbour".into()));
        };
        let flat = self.points.columns() == 2;
        let ratio = flat.then(|| torus.distance / hexagonal_distance(self.points.rows()));
        let bound = ratio.map_or(String::new(), |ratio| {
            format!(", {ratio:.4} of the hexagonal bound")
        });
        let [first, second] = torus.rows;
        Ok(Outcome {
            value: figure(torus.distance),
            note: format!(
                "on the torus, of points {first} and {second}{bound}; {} in the cube",
                figure(cube.distance)
            ),
            json: json!({
                "torus": {
                    "value": torus.distance, "rows": torus.rows, "ratio_to_hexagonal": ratio,
                },
                "cube": {"value": cube.distance, "rows": cube.rows},
                "points_are": points_are(device),
            }),
        })
    }

    fn projections(&self, progress: Progress) -> Result<Outcome> {
        let found = projections(self.points, progress)?;
        let row = |p: &corput::stats::Projection| {
            json!({
                "dimensions": p.dimensions, "centred": p.centred,
                "correlation": p.correlation, "t": p.t,
            })
        };
        let worst = found.iter().max_by(|a, b| a.centred.total_cmp(&b.centred));
        let Some(worst) = worst else {
            return Ok(Outcome::skipped("one dimension has no pairs".into()));
        };
        let [first, second] = worst.dimensions;
        let correlation = worst
            .correlation
            .map_or("-".to_owned(), |r| format!("{r:.4}"));
        let t = worst.t.map_or(String::new(), |t| format!(", t {t}"));
        let list: Vec<Value> = found.iter().map(row).collect();
        Ok(Outcome {
            value: figure(worst.centred),
            note: format!(
                "centred (square) of the worst of {} pairs, {first},{second}: correlation \
                 {correlation}{t}",
                found.len()
            ),
            json: json!({
                "worst_by": "centred", "centred_is": "square",
                "worst": row(worst), "pairs": list,
            }),
        })
    }

    fn spectrum(&self, progress: Progress) -> Result<Outcome> {
        let Some([first, second]) = self.pair else {
            return Ok(Outcome::skipped("one dimension has no pair".into()));
        };
        let pairs = self.points.pairs(first, second)?;
        let found = spectrum(&pairs, spectrum_range(pairs.len()), progress)?;
        let rings = found.rings();
        let half = 0.5 * (pairs.len() as f64).sqrt();
        let low: Vec<_> = rings
            .iter()
            .filter(|r| r.frequency as f64 <= half)
            .collect();
        let weight = low.iter().map(|r| r.count as f64).sum::<f64>().max(1.0);
        let low_power = low.iter().map(|r| r.power * r.count as f64).sum::<f64>() / weight;
        let peak = rings.iter().max_by(|a, b| a.power.total_cmp(&b.power));
        let peak = peak.map(|r| (r.frequency, r.power));
        let decibels: Vec<f64> = rings.iter().map(|r| r.anisotropy_db).collect();
        let finite: Vec<f64> = decibels
            .iter()
            .copied()
            .filter(|db| db.is_finite())
            .collect();
        let mean = finite.iter().sum::<f64>() / finite.len().max(1) as f64;
        let (at, power) = peak.unwrap_or((0, 0.0));
        let list: Vec<Value> = rings
            .iter()
            .map(|r| {
                json!({
                    "frequency": r.frequency, "count": r.count, "power": r.power,
                    "anisotropy_db": r.anisotropy_db.is_finite().then_some(r.anisotropy_db),
                })
            })
            .collect();
        Ok(Outcome {
            value: figure(low_power),
            note: format!(
                "mean power to sqrt(N)/2 of {first},{second}, white noise 1; peak {} at {at}; \
                 anisotropy {mean:.1} dB",
                figure(power)
            ),
            json: json!({
                "dimensions": [first, second],
                "white_noise_has": 1,
                "range": found.range(),
                "low_frequencies_to": half,
                "low_frequency_power": low_power,
                "peak": {"frequency": at, "power": power},
                "mean_anisotropy_db": mean,
                "rings": list,
            }),
        })
    }
}

/// Whether a device, if one was used, has rounded the points.
fn points_are(device: Option<&OnDevice>) -> &'static str {
    match device {
        Some(device) if !device.is_exact() => "rounded down to multiples of 2^-32",
        _ => "as in the file",
    }
}

/// Six significant digits.
fn figure(value: f64) -> String {
    match value.abs() {
        0.0 => "0".to_owned(),
        v if (1e-4..1e6).contains(&v) => {
            let decimals = (5 - v.log10().floor() as i32).max(0) as usize;
            format!("{value:.decimals$}")
        }
        _ => format!("{value:.5e}"),
    }
}
