//! What a study found, in text: a table and verdicts for each integrand.

use comfy_table::{CellAlignment, Table, presets};
use corput::converge::{self, Results, Series, comparable, standings};

/// All integrands, one after another.
pub fn text(results: &Results) -> String {
    let setting = &results.setting;
    let mut lines = vec![
        setting.device.clone(),
        format!(
            "{} replicates, seeds from {}; times are medians of one replicate on the device",
            setting.replicates, setting.seed
        ),
    ];
    for (integrand, group) in results.by_integrand() {
        let Some(first) = group.first() else { continue };
        let truth = &first.truth;
        lines.push(format!(
            "\n{integrand}, {}: {} {}; {}",
            dimensions(&group),
            match truth.uncertainty {
                None => format!("integral {}", truth.value),
                Some(half) => format!("no known integral, reference {} +- {half:.1e}", truth.value),
            },
            match first.analysis.statistic {
                converge::Statistic::Rmse => "",
                converge::Statistic::MedianAbsolute => "(infinite variance: median |error|)",
            },
            floors(&group),
        ));
        lines.push(table(&group, &setting.targets).to_string());
        if comparable(&group) {
            let verdict = |&target| verdict(&group, target);
            lines.extend(setting.targets.iter().map(verdict));
        } else {
            lines.push("  of several devices, whose times are not comparable:".to_owned());
            let device = |one: &&Series| format!("  {}: {}", name(one), one.device);
            lines.extend(group.iter().map(device));
        }
    }
    lines.join("\n")
}

/// The relative floor, of each estimator where there are several.
fn floors(group: &[&Series]) -> String {
    let mut all: Vec<(Option<&str>, f64)> = Vec::new();
    for one in group {
        if !all.iter().any(|(estimator, _)| *estimator == one.estimator) {
            all.push((one.estimator, one.truth.floor() / one.scale()));
        }
    }
    let each = all.iter().map(|(estimator, floor)| match estimator {
        Some(name) => format!("{floor:.1e} of {name}"),
        None => format!("{floor:.1e}"),
    });
    format!("relative floor {}", each.collect::<Vec<_>>().join(", "))
}

/// "2 dimensions", or "2 to 3 dimensions" where estimators differ.
fn dimensions(group: &[&Series]) -> String {
    let all = || group.iter().map(|one| one.dimensions);
    let (least, most) = (all().min().unwrap_or(0), all().max().unwrap_or(0));
    match (least, most) {
        (1, 1) => "1 dimension".to_owned(),
        _ if least == most => format!("{least} dimensions"),
        _ => format!("{least} to {most} dimensions"),
    }
}

fn table(group: &[&Series], targets: &[f64]) -> Table {
    let mut table = Table::new();
    let mut head = vec![
        "sampler".to_owned(),
        "N".into(),
        "relative error".into(),
        "slope".into(),
    ];
    head.extend(targets.iter().map(|target| format!("ms to {target:.0e}")));
    table.load_style(presets::NOTHING).set_header(head);
    for one in group {
        let analysis = &one.analysis;
        let Some(last) = analysis.errors.last() else {
            continue;
        };
        let relative = |value: f64| value / one.scale();
        let few = if last.few_hits() { ", few hits" } else { "" };
        let broken = match analysis.not_finite {
            0 => String::new(),
            many => format!("; {many} not finite"),
        };
        let error = match analysis.random {
            true => format!(
                "{:.2e} ({:.1e} to {:.1e}{few})",
                relative(last.error.value),
                relative(last.error.low),
                relative(last.error.high)
            ),
            false => format!("{:.2e} (one run{few})", relative(last.error.value)),
        };
        let error = error + &broken;
        let slope = match (analysis.slope, analysis.slope_has_interval) {
            (Some(s), true) => format!("{:.2} ({:.2} to {:.2})", s.value, s.low, s.high),
            (Some(s), false) => format!("{:.2}", s.value),
            (None, _) => "-".into(),
        };
        let mut row = vec![one.label(), last.count.to_string(), error, slope];
        row.extend(targets.iter().map(|target| {
            let reached = analysis.reached(target * one.scale());
            reached.map_or("-".into(), |r| format!("{:.3}", r.seconds.value * 1e3))
        }));
        table.add_row(row);
    }
    for column in 1..4 + targets.len() {
        if let Some(column) = table.column_mut(column) {
            column.set_cell_alignment(CellAlignment::Right);
        }
    }
    table
}

/// Who reaches an error first, in a line.
fn verdict(group: &[&Series], target: f64) -> String {
    let list = standings(group, target);
    let Some(best) = list.first() else {
        return format!("  to {target:.0e}: none reaches it within the study");
    };
    let others = list.iter().skip(1).map(|one| match one.tied {
        true => format!("{} ties", name(one.series)),
        false if one.slower < 1.0 => {
            let faster = one.slower.recip();
            format!("{} {faster:.1} x faster, perhaps by luck", name(one.series))
        }
        false => format!("{} {:.1} x slower", name(one.series), one.slower),
    });
    let others: Vec<String> = others.collect();
    format!(
        "  to {target:.0e}: use {}; {}",
        name(best.series),
        match others.is_empty() {
            true => "no other reaches it".to_owned(),
            false => others.join(", "),
        }
    )
}

/// A series without a comma, since names stand in lists, and whether a single run speaks
/// for it.
fn name(series: &Series) -> String {
    let run = if series.analysis.random {
        ""
    } else {
        " (one run)"
    };
    format!("{}{run}", series.label().replace(", ", " with "))
}
