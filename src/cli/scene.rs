//! `corput scene`.

use super::args::SceneArgs;
use super::print;
use comfy_table::{ContentArrangement, Table, presets};
use corput::scene::{self, Domain, Draw, Needs, Part, Scene};

/// Columns of text where there is no terminal to ask.
const WIDTH: u16 = 140;

pub fn run(args: &SceneArgs) -> anyhow::Result<()> {
    let scene = scene::read(&args.file)?;
    let needs = Needs::of(&scene)?;
    for warning in &needs.warnings {
        eprintln!("corput: warning: {warning}");
    }
    if args.json {
        let document = scene::document(&scene, &needs);
        print(&serde_json::to_string_pretty(&document)?);
    } else {
        print(&text(&scene, &needs));
    }
    Ok(())
}

fn text(scene: &Scene, needs: &Needs) -> String {
    let samples = scene.samples.value;
    let mut lines = vec![format!(
        "{}: {} of {}, {}, seed {}, profile {}",
        scene.name,
        counted(samples, "sample"),
        scene.sampler.value.name(),
        counted(needs.dimensions().into(), "dimension"),
        scene.seed,
        scene.profile.name()
    )];
    lines.extend(scene.found.iter().map(|line| format!("  {line}")));
    lines.push(format!("\n{}", kept(needs)));
    lines.join("\n")
}

/// What is drawn and what is left out, each with what decided it.
pub fn kept(needs: &Needs) -> String {
    let mut table = plain(["domain", "drawn by", "dimensions", "why"]);
    for domain in &needs.domains {
        table.add_row([
            domain.key.clone(),
            drawn(domain),
            dimensions(domain),
            domain.cause.to_string(),
        ]);
    }
    format!(
        "Drawn, alternatives by the same dimensions:\n{table}\n\nLeft out:\n{}",
        left_out(needs)
    )
}

fn counted(count: u64, what: &str) -> String {
    format!("{count} {what}{}", if count == 1 { "" } else { "s" })
}

fn plain<const N: usize>(head: [&str; N]) -> Table {
    let mut table = Table::new();
    table
        .load_style(presets::NOTHING)
        .set_content_arrangement(ContentArrangement::Dynamic)
        .set_header(head);
    if table.width().is_none() {
        table.set_width(WIDTH);
    }
    table
}

fn dimensions(domain: &Domain) -> String {
    let range = domain.range();
    match domain.draw.dimensions() {
        1 => range.start.to_string(),
        _ => format!("{} to {}", range.start, range.end - 1),
    }
}

/// A map with its parameters, as `generate` takes them.
fn drawn(domain: &Domain) -> String {
    match &domain.draw {
        Draw::Between([low, high]) => format!("a number from {low} to {high}"),
        Draw::Choice(weights) => format!("a choice among {}", weights.len()),
        Draw::Map(mapping) => {
            let mut values = mapping.values().iter();
            let parameters = mapping.map().parameters.iter().map(|parameter| {
                let numbers = values.by_ref().take(parameter.size).map(f64::to_string);
                format!(
                    "{}={}",
                    parameter.name,
                    numbers.collect::<Vec<_>>().join(",")
                )
            });
            let parameters: Vec<String> = parameters.collect();
            [mapping.map().name.to_owned()]
                .into_iter()
                .chain(parameters)
                .collect::<Vec<_>>()
                .join(" ")
        }
    }
}

/// A row for each reason, with all that are left out for it.
fn left_out(needs: &Needs) -> Table {
    let mut rows: Vec<(Part, &str, Vec<&str>)> = Vec::new();
    for one in &needs.left_out {
        let same = rows
            .iter_mut()
            .find(|(part, reason, _)| *part == one.part && *reason == one.reason);
        match same {
            Some((_, _, names)) => names.push(&one.name),
            None => rows.push((one.part, &one.reason, vec![&one.name])),
        }
    }
    let mut table = plain(["what", "why", "names"]);
    for (part, reason, names) in rows {
        table.add_row([part.name(), reason, &names.join(", ")]);
    }
    table
}
