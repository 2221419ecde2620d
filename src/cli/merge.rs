//! `corput merge`: estimates of several ranges.

mod estimates;

use super::args::MergeArgs;

pub fn run(args: &MergeArgs) -> anyhow::Result<()> {
    estimates::run(&args.paths, args.json)
}
