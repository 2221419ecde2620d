//! The arguments of what looks at points.

use super::values::{cells, whole};
use clap::Args;
use std::path::PathBuf;

#[derive(Debug, Args)]
#[command(after_help = CONVENTIONS)]
pub struct MeasureArgs {
    /// An .npy file, one point a row: f4 or f8 in [0, 1), or u4 as fractions of 2^32.
    pub file: PathBuf,
    /// Only these: star, l2-star, centred, wrap-around, mixture, modified-l2, t-value,
    /// intervals, distance, projections, spectrum.
    #[arg(long, value_delimiter = ',')]
    pub only: Option<Vec<String>>,
    /// Bases of the elementary intervals, one for each dimension, as 2,3 [default: 2 for
    /// all].
    #[arg(long, value_delimiter = ',', value_parser = whole, allow_hyphen_values = true)]
    pub base: Option<Vec<u64>>,
    /// Dimensions of the spectrum.
    #[arg(long, value_delimiter = ',', value_parser = whole, allow_hyphen_values = true, default_value = "0,1")]
    pub pair: Vec<u64>,
    /// Also what takes long.
    #[arg(long)]
    pub all: bool,
    /// Device for sums and searches over pairs of points, by index or part of its name
    /// [default: the CPU].
    #[arg(long)]
    pub device: Option<String>,
    /// Print one JSON document.
    #[arg(long)]
    pub json: bool,
}

const CONVENTIONS: &str = "Conventions: l2-star is a square root; centred, wrap-around, \
mixture and modified-l2 are squares, as SciPy has them (whose MD is mixture, not modified). \
star is a supremum: exact for one and two dimensions, otherwise between two bounds. Of \
projections the worst is that of the largest centred discrepancy. A device sums products in \
fixed point; by how much any square may be off is in the JSON. The spectrum is 1 for white \
noise, its anisotropy 0 dB.";

#[derive(Debug, Args)]
pub struct PlotArgs {
    /// The files, 1 to 8: points of [0, 1) as f4 or f8, or u4 fractions of 2^32. Several
    /// stand side by side.
    #[arg(required = true)]
    pub files: Vec<PathBuf>,
    /// scatter, pairs, spectrum or all [default: all for 1 or 2 dimensions, else pairs].
    #[arg(long)]
    pub kind: Option<String>,
    /// Dimensions, counted from 0, as 0,3,7 [default: the first 8; the first 2 for scatter and
    /// spectrum].
    #[arg(long, value_delimiter = ',', value_parser = whole, allow_hyphen_values = true)]
    pub dims: Option<Vec<u64>>,
    /// Draw and measure the first so many points [default: all, at most 65536, in pairs as
    /// many as can be told apart; the figure says how many].
    #[arg(long, value_parser = whole, allow_hyphen_values = true)]
    pub points: Option<u64>,
    /// A grid over the points, as 16x9, to show elementary cells.
    #[arg(long, value_parser = cells)]
    pub cells: Option<[u32; 2]>,
    /// Above the figure [default: the file's name].
    #[arg(long)]
    pub title: Option<String>,
    /// Side of a square in pixels, 200 to 1000; a PNG has twice as many.
    #[arg(long, default_value = "360", value_parser = whole, allow_hyphen_values = true)]
    pub size: u64,
    /// The picture: .svg or .png.
    #[arg(long)]
    pub out: PathBuf,
}
