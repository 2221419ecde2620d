//! `corput integrands`.

use super::args::IntegrandsArgs;
use super::print;
use corput::catalog::{Integrand, Parameter, Problem, integrands};
use serde_json::{Value, json};

pub fn run(args: &IntegrandsArgs) -> anyhow::Result<()> {
    let chosen = match &args.name {
        Some(name) => vec![Integrand::from_name(name)?],
        None => integrands().collect(),
    };
    if args.json {
        let list: Vec<Value> = chosen.into_iter().map(document).collect();
        print(&serde_json::to_string_pretty(
            &json!({ "integrands": list }),
        )?);
    } else {
        let texts: Vec<String> = chosen.into_iter().map(text).collect();
        print(&texts.join("\n\n"));
    }
    Ok(())
}

fn text(integrand: &'static Integrand) -> String {
    let mut lines = vec![
        format!("{:<20} {}", integrand.name, integrand.summary),
        format!("    {}", integrand.formula),
    ];
    let (least, most) = integrand.dimensions;
    lines.push(match least == most {
        true => format!("    d={least}"),
        false => format!(
            "    d=X    dimensions: {least} to {most} [default: {}]",
            integrand.default_dimensions
        ),
    });
    if integrand.needs_map {
        lines.push("    map=FILE    an environment map, .exr or .hdr".to_owned());
    }
    lines.extend(integrand.parameters.iter().map(parameter));
    if !integrand.estimators.is_empty() {
        lines.push(format!(
            "    estimators: {}",
            integrand.estimators.join(", ")
        ));
    }
    if integrand.picture.is_some() {
        lines.push("    a picture by estimate --pixels 64x48".to_owned());
    }
    if let Ok(problem) = Problem::new(integrand, &[]) {
        lines.push(format!("    integral by default: {}", problem.truth()));
    }
    lines.push(match integrand.error == 0.0 {
        true => "    terms are exact".to_owned(),
        false => format!("    terms within {:.1e} of the peak", integrand.error),
    });
    lines.push(format!("    {}", integrand.source));
    lines.join("\n")
}

fn parameter(one: &Parameter) -> String {
    let default = one.default.and_then(|numbers| numbers.first());
    let default = default.map_or(String::new(), |number| {
        let word = one.words().get(*number as usize);
        let text = word.map_or(number.to_string(), |word| (*word).to_owned());
        format!(" [default: {text}]")
    });
    format!(
        "    {}=X    {}: {}{default}",
        one.name, one.summary, one.domain
    )
}

fn document(integrand: &'static Integrand) -> Value {
    let parameters: Vec<Value> = integrand
        .parameters
        .iter()
        .map(|one| {
            json!({
                "name": one.name,
                "default": one.default.and_then(|numbers| numbers.first()),
                "domain": one.domain,
                "summary": one.summary,
            })
        })
        .collect();
    let problem = Problem::new(integrand, &[]).ok();
    json!({
        "name": integrand.name,
        "summary": integrand.summary,
        "formula": integrand.formula,
        "estimators": integrand.estimators,
        "needs_map": integrand.needs_map,
        "least_dimensions": integrand.dimensions.0,
        "most_dimensions": integrand.dimensions.1,
        "default_dimensions": integrand.default_dimensions,
        "parameters": parameters,
        "default_truth": problem.map(|problem| problem.truth()),
        "error_of_peak": integrand.error,
        "source": integrand.source,
    })
}
