//! What to use, in sentences.

use super::words::{escape, floor, number, target as written, time};
use crate::converge::{Results, Series, Standing, comparable, standings};
use crate::plot::grouped;
use std::fmt::Write;

/// A list for each integrand, an item for each target.
pub fn summary(results: &Results) -> String {
    let mut text = String::new();
    for (integrand, group) in results.by_integrand() {
        // Writing to a String cannot fail.
        let _ = writeln!(text, "<h3>{}</h3>", escape(integrand));
        if !comparable(&group) {
            text += "<p>Several devices measured it, whose run times are not comparable: the tables below \
                     name them.</p>\n";
            continue;
        }
        text += "<ul>\n";
        for &target in &results.setting.targets {
            let _ = writeln!(text, "<li>{}</li>", sentence(&group, target));
        }
        text += "</ul>\n";
    }
    if results.setting.targets.is_empty() {
        text += "<p>The study asked for no target.</p>\n";
    }
    text
}

/// Who reaches a relative error first, and how all others do.
fn sentence(group: &[&Series], target: f64) -> String {
    let list = standings(group, target);
    let missing: Vec<String> = group
        .iter()
        .filter(|one| !list.iter().any(|standing| same(standing.series, one)))
        .map(|one| name(one))
        .collect();
    let mut text = match list.first() {
        None => format!(
            "To {}: {} within the study.",
            written(target),
            match missing.as_slice() {
                [one] => format!("{one} does not reach it"),
                many => format!("none of {} reaches it", many.join(", ")),
            }
        ),
        Some(best) => {
            let mut clauses = vec![format!(
                "To {} use <strong>{}</strong>: {} with {}",
                written(target),
                standing(best),
                time(best.reached.seconds),
                points(best.series, best.reached.count),
            )];
            let others = list.iter().skip(1);
            let (ties, others): (Vec<&Standing<'_>>, Vec<_>) = others.partition(|one| one.tied);
            clauses.extend(ties.iter().map(|one| {
                let name = standing(one);
                format!("{name} ties")
            }));
            let (slower, faster): (Vec<&Standing<'_>>, Vec<_>) =
                others.into_iter().partition(|one| one.slower > 1.0);
            if !slower.is_empty() {
                clauses.push(slowness(&slower));
            }
            clauses.extend(faster.iter().map(|one| {
                let (name, faster) = (standing(one), one.slower.recip());
                format!("{name} was {faster:.1} times faster, perhaps by luck")
            }));
            if !missing.is_empty() {
                let verb = if missing.len() == 1 { "does" } else { "do" };
                clauses.push(format!("{} {verb} not reach it", missing.join(", ")));
            }
            clauses.join("; ") + "."
        }
    };
    let floors = group.iter().map(|one| floor(one));
    let least = floors.fold(f64::INFINITY, f64::min);
    let lucky: Vec<String> = list
        .iter()
        .filter(|one| target < floor(one.series))
        .map(|one| format!("{} ({})", standing(one), number(floor(one.series))))
        .collect();
    if target < least {
        let _ = write!(
            text,
            " It is below the floor {}: what reaches it does so by chance.",
            number(least)
        );
    } else if !lucky.is_empty() {
        let _ = write!(
            text,
            " It is below the floor of {}: reaching it there is chance.",
            lucky.join(", ")
        );
    }
    text
}

/// How many times slower each is: said in full of the first.
fn slowness(list: &[&Standing<'_>]) -> String {
    let each = list.iter().enumerate().map(|(place, one)| {
        let name = standing(one);
        let times = match one.slower < 9.95 {
            true => format!("{:.1} times", one.slower),
            false => format!("{:.0} times", one.slower),
        };
        match place {
            0 => format!("{name} is {times} slower"),
            _ => format!("{name} {times}"),
        }
    });
    each.collect::<Vec<_>>().join(", ")
}

/// The sampler with its estimator, and whether a single run speaks for it: without a comma,
/// since names stand in lists.
fn name(series: &Series) -> String {
    let mut text = series.sampler.clone();
    if let Some(estimator) = series.estimator {
        text += &format!(" with {estimator}");
    }
    if !series.analysis.random {
        text += " (one run)";
    }
    escape(&text)
}

/// The same, and whether it has few hits where it reaches the target.
fn standing(one: &Standing<'_>) -> String {
    let few = one.series.analysis.few_hits_at(one.reached.count);
    let name = name(one.series);
    match few {
        true => format!("{name} (few hits)"),
        false => name,
    }
}

fn same(one: &Series, other: &Series) -> bool {
    one.sampler == other.sampler && one.estimator == other.estimator
}

/// A target that the fewest points reach may need fewer.
fn points(series: &Series, count: f64) -> String {
    let fewest = series.analysis.errors.first().map(|one| one.count as f64);
    let text = grouped(count.round() as i64);
    match fewest == Some(count) {
        true => format!("{text} points or fewer"),
        false => format!("about {text} points"),
    }
}
