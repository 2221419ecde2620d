//! The environment that a map of `generate` draws from.

use super::args::GenerateArgs;
use corput::catalog::{Group, Mapping};
use corput::environment::{Counts, Environment, Options, Weight};
use corput::image::load_raw;
use corput::interface::map;
use corput::{Error, Result};

/// Refuses what only environment maps take.
pub fn refuse(args: &GenerateArgs) -> Result<()> {
    if args.env.is_none() && args.env_weight.is_none() && !args.compensated {
        return Ok(());
    }
    Err(Error::Arguments {
        asked: "--env, --env-weight or --compensated".into(),
        limit: "only the maps environment and environment-alias draw from a picture".into(),
        remedy: "add --map environment, or drop them".into(),
    })
}

/// The map with the tables of --env, and on standard error what was odd about the picture.
pub fn light(mapping: Mapping, args: &GenerateArgs) -> Result<Mapping> {
    if mapping.map().group != Group::Environment {
        refuse(args)?;
        return Ok(mapping);
    }
    let Some(path) = &args.env else {
        return Err(Error::Parameter {
            map: mapping.map().name,
            name: "env".into(),
            problem: "was not given".into(),
            domain: "add --env FILE, an .exr or .hdr".into(),
        });
    };
    let image = load_raw(path)?;
    let options = Options {
        kind: match mapping.map().id {
            map::ENVIRONMENT => corput::environment::Kind::Hierarchical,
            _ => corput::environment::Kind::Alias,
        },
        weight: weight(args.env_weight.as_deref())?,
        compensated: args.compensated,
    };
    let environment = Environment::new(image.width, image.height, &image.texels, options)?;
    for warning in warnings(environment.counts(), args.compensated) {
        eprintln!("corput: warning: {}: {warning}", path.display());
    }
    mapping.with_environment(environment)
}

fn weight(name: Option<&str>) -> Result<Weight> {
    match name {
        None | Some("luminance") => Ok(Weight::Luminance),
        Some("max") => Ok(Weight::Max),
        Some(other) => Err(Error::unknown_name("weight", other, &["luminance", "max"])),
    }
}

/// What may disappoint although it is defined, a sentence each. That compensation leaves rows
/// without light is what it is for.
fn warnings(counts: &Counts, compensated: bool) -> Vec<String> {
    let repairs = counts.repairs;
    let kinds = [
        (repairs.nan, "NaN"),
        (repairs.infinite, "infinite"),
        (repairs.negative, "negative"),
        (repairs.denormal, "below 2^-126"),
    ];
    let mut list: Vec<String> = kinds
        .into_iter()
        .filter(|(count, _)| *count > 0)
        .map(|(count, kind)| match count {
            1 => format!("1 texel has a channel that is {kind}, taken as 0"),
            _ => format!("{count} texels have a channel that is {kind}, taken as 0"),
        })
        .collect();
    if counts.dark_rows > 0 && !counts.black && !compensated {
        list.push(match counts.dark_rows {
            1 => "1 row of it is without light, and never drawn".into(),
            rows => format!("{rows} rows of it are without light, and never drawn"),
        });
    }
    match counts.raised {
        0 => {}
        1 => list.push("1 texel has less than 2^-62 of the light, and is drawn as if that".into()),
        texels => list.push(format!(
            "{texels} texels have less than 2^-62 of the light each, and are drawn as if that"
        )),
    }
    if counts.black {
        list.push("it is black: directions are uniform over the sphere".into());
    }
    if counts.uncompensated {
        list.push(
            "all its texels are alike, so that --compensated would leave nothing: ignored".into(),
        );
    }
    list
}
