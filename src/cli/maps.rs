//! `corput maps`, and the map that `generate` is asked for.

use super::args::{GenerateArgs, MapsArgs, Param};
use super::{environment, print};
use corput::catalog::{Map, Mapping, Parameter, maps};
use corput::{Error, Result};
use serde_json::{Value, json};

pub fn run(args: &MapsArgs) -> anyhow::Result<()> {
    let chosen = match &args.name {
        Some(name) => vec![Map::from_name(name)?],
        None => maps().collect(),
    };
    if args.json {
        let list: Vec<Value> = chosen.into_iter().map(document).collect();
        print(&serde_json::to_string_pretty(&json!({ "maps": list }))?);
    } else {
        let texts: Vec<String> = chosen.into_iter().map(text).collect();
        print(&texts.join("\n\n"));
    }
    Ok(())
}

fn text(map: &'static Map) -> String {
    let mut lines = vec![
        format!("{:<24} {}", map.name, map.summary),
        format!(
            "    {}; makes {}",
            dimensions(map.dimensions),
            coordinates(map.coordinates)
        ),
        format!("    pdf {}, with respect to {}", map.pdf, map.measure),
    ];
    lines.extend(map.parameters.iter().map(parameter));
    lines.push(format!(
        "    exact (tier {}): {} ULP{}, pdf {} ULP; native: {}, pdf {} of itself",
        map.tier.letter(),
        map.ulp,
        map.counted(),
        map.pdf_ulp,
        short(map.native),
        short(map.native_pdf),
    ));
    lines.push(format!("    {}", map.source));
    lines.join("\n")
}

fn short(x: f64) -> String {
    format!("{x:.1e}")
}

fn dimensions(count: u32) -> String {
    match count {
        1 => "takes 1 dimension".to_owned(),
        _ => format!("takes {count} dimensions"),
    }
}

fn coordinates(count: u32) -> &'static str {
    match count {
        1 => "x",
        2 => "x, y",
        _ => "x, y, z",
    }
}

fn parameter(one: &Parameter) -> String {
    let places = vec!["X"; one.size].join(",");
    let default = one.default.map_or(String::new(), |numbers| {
        let numbers: Vec<String> = numbers.iter().map(f64::to_string).collect();
        format!(" [default: {}]", numbers.join(","))
    });
    format!(
        "    --param {}={places}    {}: {}{default}",
        one.name, one.summary, one.domain
    )
}

fn document(map: &'static Map) -> Value {
    let parameters: Vec<Value> = map
        .parameters
        .iter()
        .map(|one| {
            json!({
                "name": one.name,
                "size": one.size,
                "default": one.default,
                "domain": one.domain,
                "summary": one.summary,
            })
        })
        .collect();
    json!({
        "name": map.name,
        "summary": map.summary,
        "dimensions": map.dimensions,
        "coordinates": map.coordinates,
        "parameters": parameters,
        "pdf": map.pdf,
        "measure": map.measure,
        "tier": map.tier.letter(),
        "profiles": ["exact", "native"],
        "worst_ulp": map.ulp,
        "worst_ulp_floor": map.floor,
        "worst_ulp_pdf": map.pdf_ulp,
        "native_absolute": map.native,
        "native_pdf_relative": map.native_pdf,
        "source": map.source,
    })
}

/// The map of `--map` with the parameters of `--param`, and the light of `--env`.
pub fn mapping(args: &GenerateArgs) -> Result<Option<Mapping>> {
    let Some(mapping) = named(args.map.as_deref(), &args.param)? else {
        environment::refuse(args)?;
        return Ok(None);
    };
    environment::light(mapping, args).map(Some)
}

/// The map of a name with parameters.
pub fn named(name: Option<&str>, params: &[Param]) -> Result<Option<Mapping>> {
    let Some(name) = name else {
        return match params.first() {
            None => Ok(None),
            Some(param) => Err(Error::Arguments {
                asked: format!("--param {}", param.name),
                limit: "only maps have parameters".into(),
                remedy: "add --map NAME; `corput maps` lists them".into(),
            }),
        };
    };
    let given: Vec<(&str, &[f64])> = params
        .iter()
        .map(|param| (param.name.as_str(), param.numbers.as_slice()))
        .collect();
    Mapping::new(Map::from_name(name)?, &given).map(Some)
}
