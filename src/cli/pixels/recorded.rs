//! The arguments of a picture in its FILE.json, and back.

use crate::cli::args::EstimateArgs;
use corput::catalog::{Problem, Request, Sampler};
use corput::report::Origin;
use corput::{Error, Result};
use serde_json::Value;

/// Whether recorded arguments are those of a picture: points have no integrand.
pub fn is_picture(arguments: &Value) -> bool {
    arguments.get("integrand").is_some()
}

/// What FILE.json records: all that decides the bytes, and who made them.
pub fn origin(
    args: &EstimateArgs,
    problem: &Problem,
    request: &Request,
    device: &str,
) -> Result<Origin> {
    let mut args = args.clone();
    // That which was chosen by default is told.
    args.estimator = problem.estimator().map(str::to_owned);
    let scrambles = !request.sequence.scrambles().is_empty();
    let scramble = scrambles.then_some(request.scramble);
    args.sampler = Sampler::new(request.sequence, scramble)?.name();
    let arguments = serde_json::to_value(&args).map_err(|fault| Error::Arguments {
        asked: "arguments that FILE.json is to record".into(),
        limit: format!("they are no JSON ({fault})"),
        remedy: "leave out --out, and take --json".into(),
    })?;
    Ok(Origin {
        arguments,
        device: device.to_owned(),
    })
}

/// The arguments that a FILE.json records, and the size of the picture; those of this run, as the
/// device, are left open.
///
/// # Errors
/// [`Error::Arguments`] where they are not all known.
pub fn parse(recorded: &Value) -> Result<(EstimateArgs, [u32; 2])> {
    let refused = |why: String| Error::Arguments {
        asked: "the recorded arguments".into(),
        limit: format!("they are not those of `corput estimate --pixels` ({why})"),
        remedy: "use the version of corput that wrote the file".into(),
    };
    let args: EstimateArgs =
        serde_json::from_value(recorded.clone()).map_err(|fault| refused(fault.to_string()))?;
    let size = args.pixels.ok_or_else(|| refused("no pixels".into()))?;
    Ok((args, size))
}
