//! Cameras, materials and media of a scene file.

use super::file::name;
use super::kinds::Place;
use super::table::{Table, Value};
use super::{Camera, Lobe, Material, Medium, Stated};
use crate::catalog::{Map, Mapping};
use crate::{Error, Result};
use std::collections::BTreeSet;

/// Lobes of one direction, besides those with `alpha = 0`.
const SMOOTH: [&str; 2] = ["mirror", "glass"];

/// The camera of `[camera]`.
pub(super) fn camera(mut table: Table) -> Result<Camera> {
    let filter = table.take("filter");
    let lens = table.take("lens");
    let shutter = table.take("shutter");
    table.finish()?;
    let shutter = shutter.map(|value| {
        let times: Result<[f64; 2], _> = value.numbers()?.try_into();
        match times {
            Ok([opens, closes]) if opens <= closes => Ok(Stated {
                value: [opens, closes],
                cause: value.cause(),
            }),
            _ => Err(value.refuse("`shutter` must be two times, as [0.0, 0.02]: opens, closes")),
        }
    });
    Ok(Camera {
        filter: filter.map(|v| of(&v, Place::Filter, "kind")).transpose()?,
        lens: lens.map(|v| of(&v, Place::Lens, "shape")).transpose()?,
        shutter: shutter.transpose()?,
    })
}

/// The material of `[[material]]`.
pub(super) fn material(mut table: Table, index: usize) -> Result<Material> {
    let name = name(&mut table, index)?;
    let list = table.demand("lobes")?;
    table.finish()?;
    let lobes: Vec<Lobe> = list
        .tables()?
        .into_iter()
        .map(lobe)
        .collect::<Result<_>>()?;
    let mut names = BTreeSet::new();
    if let Some(twice) = lobes.iter().find(|lobe| !names.insert(&lobe.name)) {
        let problem = format!("lobe {} twice: give one a `name` of its own", twice.name);
        return Err(list.refuse(&problem));
    }
    Ok(Material {
        name,
        lobes,
        cause: list.cause(),
    })
}

/// The medium of `[[medium]]`.
pub(super) fn medium(mut table: Table, index: usize) -> Result<Medium> {
    let name = name(&mut table, index)?;
    let distance = table.take("distance");
    let phase = table.take("phase");
    let cause = table.source.cause(table.at);
    table.finish()?;
    let distance = distance.map(|value| {
        let mut table = value.table()?;
        let made = mapped(&mut table, "exponential", value.at())?;
        Ok(Stated {
            value: made,
            cause: value.cause(),
        })
    });
    Ok(Medium {
        name,
        distance: distance.transpose()?,
        phase: phase.map(|v| of(&v, Place::Phase, "kind")).transpose()?,
        cause,
    })
}

fn lobe(mut table: Table) -> Result<Lobe> {
    let kind = table.demand("kind")?;
    let word = kind.text()?;
    let cause = table.source.cause(table.at);
    let name = match table.take("name") {
        None => word.to_owned(),
        Some(_) => name(&mut table, 0)?,
    };
    let weight = table.take("weight").map(|value| match value.number()? {
        weight if weight >= 0.0 => Ok(weight),
        weight => Err(value.refuse(&format!("weight {weight}: it is at least 0"))),
    });
    let weight = weight.transpose()?.unwrap_or(1.0);
    let map = if SMOOTH.contains(&word) {
        None
    } else {
        let map = find(&kind, Place::Lobe, &SMOOTH)?;
        let rough = map.parameters.iter().any(|one| one.name == "alpha");
        let alpha = if rough { table.take("alpha") } else { None };
        match alpha.map(|value| value.number()).transpose()? {
            Some(0.0) => {
                smooth(&mut table, map)?;
                None
            }
            _ => Some(mapped(&mut table, map.name, kind.at())?),
        }
    };
    table.finish()?;
    Ok(Lobe {
        name,
        weight,
        map,
        cause,
    })
}

/// Reads what a mirror ignores, and refuses roughness along y alone.
fn smooth(table: &mut Table, map: &'static Map) -> Result<()> {
    for parameter in map.parameters {
        let Some(value) = table.take(parameter.name) else {
            continue;
        };
        if parameter.name == "alpha_y" && value.number()? != 0.0 {
            let problem = "alpha is 0 and alpha_y is not; a mirror has neither, others have both";
            return Err(value.refuse(problem));
        }
    }
    Ok(())
}

/// The map of a table with a word for it.
fn of(value: &Value, place: Place, key: &'static str) -> Result<Stated<Mapping>> {
    let mut table = value.table()?;
    let kind = table.demand(key)?;
    let map = find(&kind, place, &[])?;
    let made = mapped(&mut table, map.name, kind.at())?;
    Ok(Stated {
        value: made,
        cause: value.cause(),
    })
}

/// The map that a word stands for; `more` are words besides.
fn find(kind: &Value, place: Place, more: &[&str]) -> Result<&'static Map> {
    let word = kind.text()?;
    let found = place.kinds().iter().find(|(one, _)| *one == word);
    let Some((_, map)) = found else {
        let known = place.kinds().iter().map(|(word, _)| *word);
        let known: Vec<&str> = known.chain(more.iter().copied()).collect();
        let error = Error::unknown_name(place.word(), word, &known);
        return Err(kind.refuse(&error.to_string()));
    };
    Map::from_name(map)
}

/// A map with the parameters of a table, of whose keys the others were asked for before. What
/// the map refuses is told where the parameter is, or else where the map is named.
pub(super) fn mapped(table: &mut Table, map: &str, at: usize) -> Result<Mapping> {
    let map = Map::from_name(map)?;
    let mut given: Vec<(&str, Vec<f64>, usize)> = Vec::new();
    for parameter in map.parameters {
        if let Some(value) = table.take(parameter.name) {
            given.push((parameter.name, value.numbers()?, value.at()));
        }
    }
    // A misspelt parameter is not a missing one.
    table.finish()?;
    let numbers: Vec<(&str, &[f64])> = given
        .iter()
        .map(|(name, numbers, _)| (*name, numbers.as_slice()))
        .collect();
    Mapping::new(map, &numbers).map_err(|error| {
        let at = match &error {
            Error::Parameter { name, .. } => given.iter().find(|(one, ..)| one == name),
            _ => None,
        }
        .map_or(at, |(_, _, at)| *at);
        table.source.refuse(at, &error.to_string())
    })
}
