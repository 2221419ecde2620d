//! The arguments of what integrates.

use super::values::{size, whole};
use clap::Args;
use corput::catalog::Shard;
use serde::{Deserialize, Serialize};
use std::path::PathBuf;

#[derive(Debug, Args)]
pub struct IntegrandsArgs {
    /// Only this one.
    pub name: Option<String>,
    /// Print one JSON document.
    #[arg(long)]
    pub json: bool,
}

#[derive(Debug, Args)]
#[command(
    after_help = "Without --study and --integrand the default study runs: 6 integrands, 6 samplers."
)]
pub struct ConvergeArgs {
    /// A study file (TOML): integrands, samplers and settings, which options below override.
    #[arg(long, value_name = "FILE", conflicts_with_all = ["integrand", "sampler", "estimator"])]
    pub study: Option<PathBuf>,
    /// What to integrate, as genz-gaussian:d=8; may be repeated. `corput integrands` lists them.
    #[arg(long)]
    pub integrand: Vec<String>,
    /// Samplers, as random,halton:permute,sobol:owen [default: those of the default study].
    #[arg(long, value_delimiter = ',')]
    pub sampler: Option<Vec<String>>,
    /// Estimators of the integrand, where it has a choice [default: all].
    #[arg(long, value_delimiter = ',', requires = "integrand")]
    pub estimator: Option<Vec<String>>,
    /// The fewest points [default: 16].
    #[arg(long, value_parser = whole, allow_hyphen_values = true)]
    pub min_count: Option<u64>,
    /// The most points, to 2^32; the counts are the powers of two up to it, and it
    /// [default: 262144].
    #[arg(long, value_parser = whole, allow_hyphen_values = true)]
    pub max_count: Option<u64>,
    /// Independent randomisations of each sampler that is random [default: 32].
    #[arg(long, value_parser = whole, allow_hyphen_values = true)]
    pub replicates: Option<u64>,
    /// Seed of the first; the others follow it [default: 1].
    #[arg(long, value_parser = whole, allow_hyphen_values = true)]
    pub seed: Option<u64>,
    /// Relative errors of which the time is asked [default: 1e-2,1e-3,1e-4].
    #[arg(long, value_delimiter = ',', allow_hyphen_values = true)]
    pub target: Option<Vec<f64>>,
    /// Folder for report.html, figures, results.json and results.csv. A study that was cut off
    /// goes on from the cells that it keeps there.
    #[arg(long, value_name = "DIR")]
    pub report: Option<PathBuf>,
    /// Measure share I of N of the cells, from 0, and keep them in the folder: other machines, or
    /// processes, measure the others into the same. `corput merge DIR` then writes the report.
    #[arg(
        long,
        value_name = "I/N",
        requires = "report",
        allow_hyphen_values = true
    )]
    pub shard: Option<Shard>,
    /// Begin anew in place of going on.
    #[arg(long, requires = "report")]
    pub fresh: bool,
    /// Device by index or part of its name; `cpu` for the reference.
    #[arg(long)]
    pub device: Option<String>,
    /// Print the results as one JSON document.
    #[arg(long)]
    pub json: bool,
}

#[derive(Clone, Debug, Args, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[command(
    after_help = "Sums are exact: the same bits on every device, by any number of dispatches."
)]
pub struct EstimateArgs {
    /// What to integrate, as x-squared, genz-gaussian:d=8,difficulty=5 or
    /// irradiance:map=FILE,axis=+z; `corput integrands` lists them.
    #[arg(long)]
    pub integrand: String,
    /// How to estimate it, where there is a choice; `corput integrands` lists them, the
    /// default first.
    #[arg(long)]
    pub estimator: Option<String>,
    /// The points: a sequence of `corput generate`, and its scramble, as sobol:owen.
    #[arg(long)]
    pub sampler: String,
    /// Points: 1 to 2^32.
    #[arg(long, value_parser = whole, allow_hyphen_values = true)]
    pub count: u64,
    /// Seed of the randomisation.
    #[arg(long, value_parser = whole, allow_hyphen_values = true)]
    pub seed: Option<u64>,
    /// Index of the first point.
    #[arg(long, visible_alias = "first", value_parser = whole, allow_hyphen_values = true, default_value = "0")]
    pub start: u64,
    /// Only share I of N of the points, from 0: `corput merge` adds what --json prints of all.
    #[serde(skip)]
    #[arg(
        long,
        value_name = "I/N",
        allow_hyphen_values = true,
        conflicts_with = "pixels"
    )]
    pub shard: Option<Shard>,
    /// A picture of so many pixels, as 64x48, with --count points for each: of pixel-edge and
    /// soft-shadow.
    #[arg(long, value_parser = size)]
    pub pixels: Option<[u32; 2]>,
    /// Write the picture: .npy has mean, variance and count, .exr the means, .png the means as
    /// shares of the largest; - is an .npy on standard output, and what else is said goes to
    /// standard error. FILE.json beside a file records arguments and hashes, for `corput verify`.
    #[serde(skip)]
    #[arg(long)]
    pub out: Option<PathBuf>,
    /// Device by index or part of its name; `cpu` for the reference.
    #[serde(skip)]
    #[arg(long)]
    pub device: Option<String>,
    /// Print one JSON document, with the sums as decimal strings.
    #[serde(skip)]
    #[arg(long)]
    pub json: bool,
}
