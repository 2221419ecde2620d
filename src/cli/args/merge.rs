//! The arguments of `corput merge`.

use super::values::whole;
use clap::Args;
use std::path::PathBuf;

#[derive(Debug, Args)]
#[command(
    after_help = "Exit code 1: chunks of the store are missing or damaged, or cells of the study are missing; the \
                  output names them, and the shards that make them.\n\
                  Estimates merge in any order and any grouping to the bits of a single run: the output of \
                  --json can be merged again."
)]
pub struct MergeArgs {
    /// A Zarr store, to check that it is complete; the folder of `corput converge --shard`, to write
    /// the report of its study; or documents that `corput estimate --json` printed, to add.
    #[arg(required = true)]
    pub paths: Vec<PathBuf>,
    /// Name the shards of so many [default: of a store as many as it was begun with, or else as many as
    /// chunks, so that each makes one; of a study as many as there were].
    #[arg(long, value_name = "N", value_parser = whole, allow_hyphen_values = true)]
    pub shards: Option<u64>,
    /// Print one JSON document.
    #[arg(long)]
    pub json: bool,
}
