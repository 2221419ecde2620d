//! The part of the page on one integrand.

use super::figures::{Figure, Pair, relative};
use super::words::{error, escape, group_by_estimator, table, target, time};
use crate::converge::hits::ENOUGH;
use crate::converge::{Series, Statistic, comparable};
use crate::plot::{duration, grouped, scientific};

/// Facts, figures, tables and notes.
pub fn section(integrand: &str, group: &[&Series], pairs: &[Pair], targets: &[f64]) -> String {
    let mut text = format!("<section>\n<h2>{}</h2>\n", escape(integrand));
    text += &facts(group);
    let notes: String = notes(group)
        .iter()
        .map(|note| format!("<li>{}</li>\n", escape(note)))
        .collect();
    if !notes.is_empty() {
        text += &format!("<ul class=\"notes\">\n{notes}</ul>\n");
    }
    for pair in pairs {
        text += "<figure>\n<div class=\"pair\">\n";
        text.extend(pair.figures.iter().map(view));
        text += &format!(
            "</div>\n{}<figcaption>{}</figcaption>\n</figure>\n",
            pair.figures.first().map_or(String::new(), names),
            escape(&pair.caption)
        );
    }
    text += &errors(integrand, group);
    text += &times(integrand, group, targets);
    text + "</section>\n"
}

/// A figure in a box, which cuts the names off where the page is narrow.
fn view(figure: &Figure) -> String {
    format!(
        "<div class=\"view\" style=\"--across:{:.3}\">\n{}</div>\n",
        figure.key.across, figure.svg
    )
}

/// The names of a pair's curves, for narrow pages.
fn names(figure: &Figure) -> String {
    let entry = |(mark, name): &(String, String)| format!("<li>{mark} {}</li>\n", escape(name));
    let entries: String = figure.key.entries.iter().map(entry).collect();
    format!("<ul class=\"key\">\n{entries}</ul>\n")
}

/// What it is, its integral, and its floor.
fn facts(group: &[&Series]) -> String {
    let Some(first) = group.first() else {
        return String::new();
    };
    // Estimators may differ, as one that also chooses a technique.
    let alike = group.iter().all(|one| one.dimensions == first.dimensions);
    let within = match alike {
        true => format!(", in {}", dimensions(first)),
        false => String::new(),
    };
    let mut text = format!("<p>{}{within}.", escape(first.summary));
    for (estimator, series) in group_by_estimator(group) {
        let Some(one) = series.first() else { continue };
        let truth = &one.truth;
        let integral = match truth.uncertainty {
            None => format!("The integral is {}", truth.value),
            Some(half) => format!("The reference is {} ± {}", truth.value, scientific(half)),
        };
        let of = estimator.map_or(String::new(), |name| match alike {
            true => format!(" of estimator {name}"),
            false => format!(" of estimator {name}, in {},", dimensions(one)),
        });
        let unit = match one.truth.value {
            0.0 => "; errors are absolute, since the integral is 0",
            _ => "",
        };
        let floor = match truth.floor() {
            0.0 => "0: arithmetic is exact".to_owned(),
            floor => format!(
                "{}, {} relative",
                scientific(floor),
                scientific(floor / one.scale())
            ),
        };
        text += &escape(&format!(" {integral}; the floor{of} is {floor}{unit}."));
    }
    text + "</p>\n"
}

fn dimensions(series: &Series) -> String {
    match series.dimensions {
        1 => "1 dimension".to_owned(),
        many => format!("{many} dimensions"),
    }
}

/// What a reader must know before believing a number.
fn notes(group: &[&Series]) -> Vec<String> {
    let mut notes = Vec::new();
    let Some(first) = group.first() else {
        return notes;
    };
    if first.analysis.statistic == Statistic::MedianAbsolute {
        notes.push(
            "The variance is infinite, so mean squares of errors say nothing: errors here are \
             medians of |error| over the replicates."
                .to_owned(),
        );
    }
    if let Some(half) = first.truth.uncertainty {
        notes.push(format!(
            "No integral is known: errors are against a reference that was measured with more \
             points, whose 95 % interval is ± {}. It is a part of the floor.",
            scientific(half)
        ));
    }
    if !comparable(group) {
        notes.push(
            "Several devices measured it: run times are each device's own, and not comparable."
                .to_owned(),
        );
    }
    notes.extend(few_hits(group));
    for series in group {
        let name = series.label();
        let missing = series.analysis.not_finite;
        if missing > 0 {
            notes.push(format!(
                "{name}: {missing} {} not finite, and in none of the numbers.",
                if missing == 1 { "mean is" } else { "means are" }
            ));
        }
        for warning in series.cell.notices() {
            notes.push(format!("{name}: {warning}"));
        }
        if let Some((count, why)) = series.cell.refused.first() {
            let more = match series.cell.refused.len() {
                1 => String::new(),
                many => format!(", nor {} other counts", many - 1),
            };
            notes.push(format!("{name} has no {count} points{more}: {why}"));
        }
    }
    notes
}

/// Which errors too few points speak for: a sentence for each estimator.
fn few_hits(group: &[&Series]) -> Vec<String> {
    let sentence = |(estimator, series): (Option<&str>, Vec<&Series>)| {
        let most = |random: bool| {
            let series = series.iter().filter(|one| one.analysis.random == random);
            let errors = series.flat_map(|one| &one.analysis.errors);
            let few = errors.filter(|at| at.few_hits()).map(|at| at.count).max();
            few.map(|count| grouped(count as i64))
        };
        let reach = match (most(true), most(false)) {
            (None, None) => return None,
            (Some(all), None) => format!("fewer than {ENOUGH} effective hits to {all} points"),
            (None, Some(one)) => {
                format!("fewer than 3 effective hits in single runs to {one} points")
            }
            (Some(all), Some(one)) => format!(
                "fewer than {ENOUGH} effective hits to {all} points, or 3 in single runs to {one}"
            ),
        };
        let name = estimator.map_or(String::new(), |name| format!("{name}: "));
        Some(format!(
            "{name}{reach}, or all replicates missed the same: intervals are too narrow there, \
             and no slope is fitted."
        ))
    };
    let estimators = group_by_estimator(group).into_iter();
    estimators.filter_map(sentence).collect()
}

fn errors(integrand: &str, group: &[&Series]) -> String {
    let head = [
        "sampler",
        "points N",
        "relative error (95 %)",
        "slope (95 %)",
    ];
    let head = head.map(str::to_owned);
    let rows: Vec<Vec<String>> = group.iter().map(|one| error_row(one)).collect();
    let statistic = group
        .first()
        .map_or("", |one| one.analysis.statistic.label());
    let caption = format!("{integrand}: {statistic} at the largest N, and slope over N");
    table(&caption, &head, &rows)
}

fn error_row(one: &Series) -> Vec<String> {
    let analysis = &one.analysis;
    let mut row = vec![one.label()];
    match relative(one).last() {
        None => row.extend(["-".to_owned(), "-".to_owned()]),
        Some(last) => {
            row.push(grouped(last.work as i64));
            row.push(error(&last, analysis.random));
        }
    }
    row.push(match (analysis.slope, analysis.slope_has_interval) {
        (Some(s), true) => format!("{:.2} ({:.2} to {:.2})", s.value, s.low, s.high),
        (Some(s), false) => format!("{:.2}", s.value),
        (None, _) => "-".to_owned(),
    });
    row
}

fn times(integrand: &str, group: &[&Series], targets: &[f64]) -> String {
    let mut head: Vec<String> = ["sampler", "set-up", "first dispatch", "at largest N"]
        .map(str::to_owned)
        .to_vec();
    head.extend(targets.iter().map(|one| format!("to {}", target(*one))));
    let several = !comparable(group);
    if several {
        head.push("device".to_owned());
    }
    let row = |one: &&Series| {
        let last = one.analysis.errors.last();
        let mut row = vec![
            one.label(),
            duration(one.cell.setup_ms * 1e-3),
            duration(one.cell.first_ms * 1e-3),
            last.map_or("-".to_owned(), |last| time(last.seconds)),
        ];
        row.extend(targets.iter().map(|target| {
            let reached = one.analysis.reached(target * one.scale());
            reached.map_or("-".to_owned(), |reached| time(reached.seconds))
        }));
        if several {
            row.push(one.device.clone());
        }
        row
    };
    let rows: Vec<Vec<String>> = group.iter().map(row).collect();
    let caption = format!(
        "{integrand}: time once for set-up and the first dispatch, then of one replicate (median \
         and quartiles), and to each relative error (95 %)"
    );
    table(&caption, &head, &rows)
}
