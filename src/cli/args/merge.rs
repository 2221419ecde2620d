//! The arguments of `corput merge`.

use clap::Args;
use std::path::PathBuf;

#[derive(Debug, Args)]
#[command(
    after_help = "Estimates merge in any order and any grouping to the bits of a single run: the output of \
                  --json can be merged again."
)]
pub struct MergeArgs {
    /// Documents that `corput estimate --json` printed, to add.
    #[arg(required = true)]
    pub paths: Vec<PathBuf>,
    /// Print one JSON document.
    #[arg(long)]
    pub json: bool,
}
