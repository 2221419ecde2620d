//! Which study is asked for.

use crate::cli::args::ConvergeArgs;
use corput::Result;
use corput::catalog::Sampler;
use corput::converge::{self, DEFAULT, Row, Settings, Study};
use std::path::Path;

/// The study of the arguments: a file, names, or the default.
pub fn study(args: &ConvergeArgs) -> Result<Study> {
    let (rows, settings) = match &args.study {
        Some(path) => converge::read(path)?,
        None if args.integrand.is_empty() => {
            let (rows, settings) = converge::parse(DEFAULT, Path::new("(the default study)"))?;
            (named_samplers(args, rows)?, settings)
        }
        None => (named(args)?, Settings::default()),
    };
    let given = |value: Option<u64>, otherwise| value.unwrap_or(otherwise);
    Study::new(
        rows,
        Settings {
            min_count: given(args.min_count, settings.min_count),
            max_count: given(args.max_count, settings.max_count),
            replicates: match args.replicates {
                // A number past the limit is refused as such.
                Some(many) => u32::try_from(many).unwrap_or(u32::MAX),
                None => settings.replicates,
            },
            seed: given(args.seed, settings.seed),
            targets: args.target.clone().unwrap_or(settings.targets),
        },
    )
}

/// The default samplers are those of the default study.
fn named(args: &ConvergeArgs) -> Result<Vec<Row>> {
    // A name that is none is told before a sampler that does not fit it.
    for integrand in &args.integrand {
        converge::rows(
            integrand,
            args.estimator.as_deref().unwrap_or_default(),
            &[],
        )?;
    }
    let samplers = match samplers(args)? {
        Some(samplers) => samplers,
        None => {
            let (rows, _) = converge::parse(DEFAULT, Path::new("(the default study)"))?;
            rows.into_iter()
                .next()
                .map_or(Vec::new(), |row| row.samplers)
        }
    };
    let mut all = Vec::new();
    for integrand in &args.integrand {
        let estimators = args.estimator.as_deref().unwrap_or_default();
        all.extend(converge::rows(integrand, estimators, &samplers)?);
    }
    Ok(all)
}

fn named_samplers(args: &ConvergeArgs, mut rows: Vec<Row>) -> Result<Vec<Row>> {
    if let Some(samplers) = samplers(args)? {
        for row in &mut rows {
            row.samplers.clone_from(&samplers);
        }
    }
    Ok(rows)
}

fn samplers(args: &ConvergeArgs) -> Result<Option<Vec<Sampler>>> {
    let parsed = |names: &Vec<String>| names.iter().map(|name| Sampler::parse(name)).collect();
    args.sampler.as_ref().map(parsed).transpose()
}
