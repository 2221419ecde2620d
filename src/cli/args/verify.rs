//! The arguments of `corput verify`.

use super::values::range;
use clap::Args;
use std::ops::Range;
use std::path::PathBuf;

#[derive(Debug, Args)]
pub struct VerifyArgs {
    /// A file that `corput generate` or `corput estimate --pixels` wrote, with its FILE.json beside
    /// it; or the folder of a Zarr store.
    pub file: PathBuf,
    /// Only these rows, counted from 0, the last not among them; hashes are left out
    /// [default: all, and the hashes].
    #[arg(long, value_name = "A..B", value_parser = range, allow_hyphen_values = true)]
    pub range: Option<Range<u64>>,
    /// Where the picture of --env lies now [default: where it was, seen from here or from the folder
    /// of the file; a store names no folder].
    #[arg(long, value_name = "FILE")]
    pub env: Option<PathBuf>,
    /// Device by index or part of its name, or cpu for the reference: any makes the same bytes.
    #[arg(long)]
    pub device: Option<String>,
}
