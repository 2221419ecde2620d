//! What a study found, as JSON and as a table.

use super::analysis::ErrorAt;
use super::hits::Rarity;
use super::item::Measured;
use super::series::Series;
use super::statistics::Interval;
use super::study::Study;
use super::summary::{comparable, standings};
use super::truth::Truth;
use crate::catalog::Sampler;
use serde_json::{Map, Value, json};
use std::fmt::Write;

/// Name and version of the form of [`Results::document`], which `docs/schemas` describes.
pub const SCHEMA: &str = "corput-converge/2";

/// How a study was run, so that it can be run again.
#[derive(Clone, Debug, PartialEq)]
pub struct Setting {
    /// The device with its driver; of shards all of them.
    pub device: String,
    /// The command; of shards those of all whose cells are taken, a line each.
    pub command: String,
    /// Numbers of points.
    pub counts: Vec<u64>,
    /// Independent randomisations.
    pub replicates: u32,
    /// The seed of the first.
    pub seed: u64,
    /// Relative errors of which the time is asked.
    pub targets: Vec<f64>,
    /// Shards whose cells are taken; 1 of a single run.
    pub shards: u64,
}

impl Setting {
    /// Of a study on a device, asked for by a command.
    #[must_use]
    pub fn new(study: &Study, device: String, command: String) -> Self {
        Self {
            device,
            command,
            counts: study.counts().to_vec(),
            replicates: study.replicates(),
            seed: study.seed(),
            targets: study.targets().to_vec(),
            shards: 1,
        }
    }
}

/// All series of a study, integrand after integrand.
#[derive(Clone, Debug, PartialEq)]
pub struct Results {
    /// How it was run.
    pub setting: Setting,
    /// What it found.
    pub series: Vec<Series>,
}

impl Results {
    /// Of what was measured of all items of a study, in their order.
    pub(super) fn of(study: &Study, setting: Setting, measured: Vec<Measured>) -> Self {
        let mut measured = measured.into_iter();
        let mut series = Vec::new();
        for row in study.rows() {
            let unknown = row.problem.known_truth().is_none();
            let reference = unknown.then(|| measured.next()).flatten();
            let truth = Truth::judged(row, reference.as_ref().map(|one| &one.cell));
            let cells = row.samplers.iter().copied().zip(measured.by_ref());
            let cells: Vec<(Sampler, Measured)> = cells.collect();
            let independent = cells.iter().filter(|(sampler, _)| sampler.is_independent());
            let rarity = Rarity::of(independent.map(|(_, one)| &one.cell), &truth);
            let made = cells
                .into_iter()
                .map(|(sampler, one)| Series::new(row, sampler, truth, one, rarity));
            series.extend(made);
        }
        Self { setting, series }
    }

    /// The series by integrand, in the study's order.
    #[must_use]
    pub fn by_integrand(&self) -> Vec<(&str, Vec<&Series>)> {
        let mut groups: Vec<(&str, Vec<&Series>)> = Vec::new();
        for series in &self.series {
            match groups
                .iter_mut()
                .find(|(name, _)| *name == series.integrand)
            {
                Some((_, group)) => group.push(series),
                None => groups.push((&series.integrand, vec![series])),
            }
        }
        groups
    }

    /// Means that are not finite, of all series.
    #[must_use]
    pub fn not_finite(&self) -> u64 {
        self.series.iter().map(|one| one.analysis.not_finite).sum()
    }

    /// Everything, as `docs/schemas/converge-2.json` describes it, of no files: a report names
    /// its own.
    #[must_use]
    pub fn document(&self) -> Value {
        let setting = &self.setting;
        json!({
            "schema": SCHEMA,
            "corput": env!("CARGO_PKG_VERSION"),
            "device": setting.device,
            "shards": setting.shards,
            "command": setting.command,
            "counts": setting.counts,
            "replicates": setting.replicates,
            "seed": setting.seed,
            "targets": setting.targets,
            "not_finite": self.not_finite(),
            "files": [],
            "series": self.series.iter().map(series).collect::<Vec<_>>(),
            "standings": self.standings(),
        })
    }

    fn standings(&self) -> Value {
        let mut list = Vec::new();
        let groups = self.by_integrand().into_iter();
        for (integrand, group) in groups.filter(|(_, group)| comparable(group)) {
            for &target in &self.setting.targets {
                let standing = |one: super::Standing| {
                    json!({
                        "sampler": one.series.sampler,
                        "estimator": one.series.estimator,
                        "seconds": interval(one.reached.seconds),
                        "count": one.reached.count,
                        "slower": one.slower,
                        "tied_with_first": one.tied,
                    })
                };
                let reached = standings(&group, target).into_iter().map(standing);
                list.push(json!({
                    "integrand": integrand,
                    "relative_error": target,
                    "reached_by": reached.collect::<Vec<_>>(),
                }));
            }
        }
        Value::Array(list)
    }

    /// A row for each count of each series, under a head.
    #[must_use]
    pub fn csv(&self) -> String {
        let mut text = String::from(
            "integrand,dimensions,estimator,sampler,random,count,replicates,truth,floor,statistic,\
             error,error_low,error_high,relative_error,bias,bias_standard_error,effective_hits,device,seconds,\
             seconds_low_quartile,seconds_high_quartile,host_seconds\n",
        );
        for one in &self.series {
            for (at, point) in one.analysis.errors.iter().zip(&one.cell.points) {
                // Writing to a String cannot fail.
                let _ = writeln!(
                    text,
                    "\"{}\",{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},\"{}\",{},{},{},{}",
                    one.integrand.replace('"', "\"\""),
                    one.dimensions,
                    one.estimator.unwrap_or(""),
                    one.sampler,
                    one.analysis.random,
                    at.count,
                    point.means.len(),
                    one.truth.value,
                    one.truth.floor(),
                    one.analysis.statistic.name(),
                    at.error.value,
                    at.error.low,
                    at.error.high,
                    at.error.value / one.scale(),
                    at.bias,
                    at.bias_error,
                    at.hits.map_or(String::new(), |hits| hits.to_string()),
                    one.device.replace('"', "\"\""),
                    at.seconds.value,
                    at.seconds.low,
                    at.seconds.high,
                    at.host_seconds,
                );
            }
        }
        text
    }
}

fn series(one: &Series) -> Value {
    let analysis = &one.analysis;
    let points: Vec<Value> = analysis
        .errors
        .iter()
        .zip(&one.cell.points)
        .map(|(at, point)| point_document(at, &point.means))
        .collect();
    let refused: Vec<Value> = one
        .cell
        .refused
        .iter()
        .map(|(count, why)| json!({ "count": count, "why": why }))
        .collect();
    let mut document = Map::new();
    document.extend([
        ("integrand".to_owned(), json!(one.integrand)),
        ("dimensions".to_owned(), json!(one.dimensions)),
        ("estimator".to_owned(), json!(one.estimator)),
        ("sampler".to_owned(), json!(one.sampler)),
        ("device".to_owned(), json!(one.device)),
        ("random".to_owned(), json!(analysis.random)),
        ("truth".to_owned(), json!(one.truth.value)),
        ("truth_uncertainty".to_owned(), json!(one.truth.uncertainty)),
        ("floor".to_owned(), json!(one.truth.floor())),
        ("statistic".to_owned(), json!(analysis.statistic.name())),
        (
            "slope".to_owned(),
            json!(analysis.slope.map(|slope| {
                match analysis.slope_has_interval {
                    true => interval(slope),
                    false => json!({ "value": slope.value }),
                }
            })),
        ),
        (
            "slope_counts".to_owned(),
            json!({
                "fitted": analysis.slope_counts.fitted,
                "left_out": {
                    "below_64_points": analysis.slope_counts.small,
                    "few_hits": analysis.slope_counts.few_hits,
                    "near_floor": analysis.slope_counts.near_floor,
                },
            }),
        ),
        ("setup_ms".to_owned(), json!(one.cell.setup_ms)),
        ("first_dispatch_ms".to_owned(), json!(one.cell.first_ms)),
        ("not_finite".to_owned(), json!(analysis.not_finite)),
        ("warnings".to_owned(), json!(one.cell.warnings)),
        ("refused".to_owned(), json!(refused)),
        ("points".to_owned(), json!(points)),
    ]);
    Value::Object(document)
}

fn point_document(at: &ErrorAt, means: &[f64]) -> Value {
    json!({
        "count": at.count,
        "error": interval(at.error),
        "above_floor": at.above_floor,
        "effective_hits": at.hits,
        "few_hits": at.few_hits(),
        "bias": at.bias,
        "bias_standard_error": at.bias_error,
        "seconds": {
            "median": at.seconds.value,
            "low_quartile": at.seconds.low,
            "high_quartile": at.seconds.high,
        },
        "host_seconds": at.host_seconds,
        "means": means,
    })
}

/// An end that is infinite has no JSON but null.
fn interval(one: Interval) -> Value {
    json!({ "value": one.value, "low": one.low, "high": one.high })
}
