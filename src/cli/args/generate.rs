//! The arguments of `corput generate`.

use super::values::{Grid, Param, grid, param, whole};
use crate::cli::guide;
use clap::Args;
use corput::catalog::Shard;
use serde::{Deserialize, Serialize};
use std::path::PathBuf;

#[derive(Clone, Debug, Args, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[command(after_help = "`corput generate --help` says what each sequence is, and what it takes.")]
#[command(after_long_help = guide::generate())]
pub struct GenerateArgs {
    #[arg(help = guide::sequences())]
    pub sequence: String,
    /// Points to make: 1 to 2^32; of blue-noise to 65536.
    #[arg(long, value_parser = whole, allow_hyphen_values = true)]
    pub count: Option<u64>,
    /// blue-noise-mask: pixels along a side, 4 to 256.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[arg(long, value_parser = whole, allow_hyphen_values = true)]
    pub size: Option<u64>,
    /// blue-noise-mask: values of a pixel, 1 or 2 [default: 1].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[arg(long, value_parser = whole, allow_hyphen_values = true)]
    pub channels: Option<u64>,
    /// blue-noise-mask: frames of a mask over time, 1 to 16; size x size x frames is at
    /// most 65536 [default: 1].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[arg(long, value_parser = whole, allow_hyphen_values = true)]
    pub frames: Option<u64>,
    /// Index of the first point.
    #[arg(long, default_value = "0", value_parser = whole, allow_hyphen_values = true)]
    pub first: u64,
    /// Dimensions [default: 2, for vdc 1].
    #[arg(long, value_parser = whole, allow_hyphen_values = true)]
    pub dims: Option<u64>,
    /// Prime bases in place of the first primes, as 2,3,8161.
    #[arg(long, value_delimiter = ',', value_parser = whole, allow_hyphen_values = true)]
    pub bases: Option<Vec<u64>>,
    #[arg(help = guide::total())]
    #[arg(long, value_parser = whole, allow_hyphen_values = true)]
    pub total: Option<u64>,
    /// hammersley: k/N as the first column instead of the last.
    #[arg(long)]
    pub index_first: bool,
    /// Seed of what is random, 0 to 2^64 - 1 [default: 0]; given to lattice, korobov or r2 it
    /// also rotates them.
    #[arg(long, value_parser = whole, allow_hyphen_values = true)]
    pub seed: Option<u64>,
    #[arg(help = guide::scrambles())]
    #[arg(long)]
    pub scramble: Option<String>,
    /// sobol: natural or gray.
    #[arg(long, default_value = "natural")]
    pub order: String,
    /// stratified, cmj: cells along each axis, as 32x16 [default: nearly equal divisors].
    #[arg(long, value_parser = grid, allow_hyphen_values = true)]
    pub grid: Option<Grid>,
    /// korobov: the generator [default: that published for the number of points].
    #[arg(long, value_parser = whole, allow_hyphen_values = true)]
    pub generator: Option<u64>,
    /// f32; or fractions of 2^32 as u32, as u16 (their leading bits) or as f64 (all of them)
    /// [default: f32].
    #[serde(rename = "type")]
    #[arg(long = "type", value_name = "TYPE")]
    pub element: Option<String>,
    /// As --type u32.
    #[serde(skip)]
    #[arg(long)]
    pub fractions: bool,
    #[arg(help = guide::maps())]
    #[arg(long)]
    pub map: Option<String>,
    /// A parameter of the map, as alpha=0.1 or wo=0.8,0,0.6; `corput maps` lists them.
    #[arg(long, value_name = "NAME=X[,X...]", value_parser = param, allow_hyphen_values = true)]
    pub param: Vec<Param>,
    /// environment maps: the picture whose light is sampled, .exr or .hdr.
    #[arg(long, value_name = "FILE")]
    pub env: Option<PathBuf>,
    /// environment maps: what a texel weighs, luminance or max, the largest channel
    /// [default: luminance].
    #[arg(long, value_name = "NAME")]
    pub env_weight: Option<String>,
    /// environment maps: subtract the mean, for use beside another technique of multiple
    /// importance sampling.
    #[arg(long)]
    pub compensated: bool,
    /// Append the map's pdf as the last column.
    #[arg(long)]
    pub with_pdf: bool,
    /// exact: the same bytes everywhere; native: the device's own functions.
    #[arg(long, default_value = "exact")]
    pub profile: String,
    /// Device by index or part of its name; cpu for none; auto for whichever of the default device
    /// and the CPU is faster in a trial of a tenth of a second each, which standard error reports.
    #[serde(skip)]
    #[arg(long)]
    pub device: Option<String>,
    /// npy, raw, csv, c-header or glsl, an array, or zarr; of blue-noise-mask npy, png or exr
    /// [default: from the file's ending; npy on standard output].
    #[serde(skip)]
    #[arg(long)]
    pub format: Option<String>,
    /// Make share I of N, from 0, of a Zarr store's chunks: other machines make the others in
    /// the same folder. Chunks that are there and whole are kept.
    #[serde(skip)]
    #[arg(long, value_name = "I/N", allow_hyphen_values = true)]
    pub shard: Option<Shard>,
    /// The file, or the folder of a Zarr store; - is standard output. FILE.json beside a file
    /// records arguments and hashes.
    #[serde(skip)]
    #[arg(long)]
    pub out: PathBuf,
    /// Go on from the complete chunks that a run with these arguments left when it was cut off;
    /// without this they are discarded.
    #[serde(skip)]
    #[arg(long)]
    pub resume: bool,
    /// Rows of a chunk, the unit of what is kept and hashed [default: those of about 64 MiB].
    #[serde(skip)]
    #[arg(long, value_parser = whole, allow_hyphen_values = true)]
    pub chunk_rows: Option<u64>,
}
