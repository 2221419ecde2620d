//! Lights of a scene file.

use super::file::{name, placed};
use super::kinds::Place;
use super::surface::mapped;
use super::table::{Table, Value};
use super::{Emitter, Light, barycentric, mapping};
use crate::environment::{Environment, Kind, Options};
use crate::{Error, Result, image};

/// Lights of one point or direction.
const DELTA: [&str; 3] = ["point", "spot", "directional"];

/// A mesh has at most so many triangles.
const MOST_AREAS: usize = 1 << 16;

/// A light of `[[light]]`.
pub(super) fn light(mut table: Table, index: usize) -> Result<Light> {
    let name = name(&mut table, index)?;
    let power = power(&mut table)?;
    let kind = table.demand("kind")?;
    let word = kind.text()?;
    let kinds = Place::Light.kinds();
    let emitter = if let Some(delta) = DELTA.iter().find(|one| **one == word) {
        Emitter::Delta(delta)
    } else if word == "mesh" {
        Emitter::Mesh(areas(&table.demand("areas")?)?)
    } else if word == "triangle" {
        triangle(&mut table, &kind)?;
        Emitter::Area(placed(&kind, barycentric())?)
    } else if let Some((_, map)) = kinds.iter().find(|(one, _)| *one == word) {
        Emitter::Area(mapped(&mut table, map, kind.at())?)
    } else {
        let mut known: Vec<&str> = DELTA.into();
        known.extend(kinds.iter().map(|(word, _)| *word));
        known.push("mesh");
        let error = Error::unknown_name("kind of light", word, &known);
        return Err(kind.refuse(&error.to_string()));
    };
    table.finish()?;
    Ok(Light {
        name,
        power,
        emitter,
        cause: kind.cause(),
    })
}

/// The light of `[environment]`.
pub(super) fn environment(value: &Value) -> Result<Light> {
    let mut table = value.table()?;
    let power = power(&mut table)?;
    let map = match table.take("kind") {
        None => "environment",
        Some(kind) => {
            let known = Place::Environment.kinds();
            let word = kind.text()?;
            let found = known.iter().find(|(one, _)| *one == word);
            let known: Vec<&str> = known.iter().map(|(word, _)| *word).collect();
            let unknown = || Error::unknown_name("kind of environment", word, &known);
            placed(&kind, found.ok_or_else(unknown))?.1
        }
    };
    let file = table.demand("map")?;
    let path = table.source.path.with_file_name(file.text()?);
    table.finish()?;
    let made = || {
        let image = image::load_raw(&path)?;
        let options = Options {
            kind: match map {
                "environment" => Kind::Hierarchical,
                _ => Kind::Alias,
            },
            ..Options::default()
        };
        let tables = Environment::new(image.width, image.height, &image.texels, options)?;
        mapping(map, &[])?.with_environment(tables)
    };
    Ok(Light {
        name: "environment".into(),
        power,
        emitter: Emitter::Area(placed(&file, made())?),
        cause: file.cause(),
    })
}

/// The weight of a light in the choice among lights.
fn power(table: &mut Table) -> Result<f64> {
    let Some(value) = table.take("power") else {
        return Ok(1.0);
    };
    let power = value.number()?;
    if power < 0.0 {
        return Err(value.refuse(&format!("power {power}: it is at least 0")));
    }
    Ok(power)
}

/// Refuses three points on a line. The points themselves are no parameters: samples are
/// barycentric, and serve every triangle.
fn triangle(table: &mut Table, kind: &Value) -> Result<()> {
    let mut vertex = |key| -> Result<glam::DVec3> {
        let value = table.demand(key)?;
        let numbers = value.numbers()?;
        let three: Result<[f64; 3], _> = numbers.try_into();
        let problem = format!("`{key}` must be 3 numbers: a vertex");
        three.map(Into::into).map_err(|_| value.refuse(&problem))
    };
    let [a, b, c] = [vertex("a")?, vertex("b")?, vertex("c")?];
    let area = 0.5 * (b - a).cross(c - a).length();
    let longest = (b - a).length().max((c - a).length());
    if area.is_finite() && area > 1e-12 * longest * longest {
        return Ok(());
    }
    Err(kind.refuse("a light of area 0: a, b and c lie on a line; move one of them"))
}

fn areas(value: &Value) -> Result<Vec<f64>> {
    let areas = value.numbers()?;
    if areas.len() > MOST_AREAS {
        let problem = format!("{} triangles: a mesh here has at most 2^16", areas.len());
        return Err(value.refuse(&problem));
    }
    if let Some(wrong) = areas.iter().find(|area| **area < 0.0) {
        return Err(value.refuse(&format!("an area of {wrong}: it is at least 0")));
    }
    if areas.iter().any(|area| *area > 0.0) {
        return Ok(areas);
    }
    Err(value.refuse("a light of area 0: no triangle has any; give one an area"))
}
