//! Names, numbers and markup of the page.

use crate::converge::{Interval, Series};
use crate::plot::{Measured, duration};
pub use crate::report::escape;

/// A number of three digits, as commands take it.
pub fn number(value: f64) -> String {
    match value {
        0.0 => "0".to_owned(),
        value => format!("{value:.2e}"),
    }
}

/// An error with its interval, or with the word that it has none; and that few hits speak for it.
pub fn error(one: &Measured, random: bool) -> String {
    let value = number(one.error);
    let few = if one.faint { "; few hits" } else { "" };
    match random {
        true => {
            let (low, high) = (number(one.low), number(one.high));
            format!("{value} ({low} to {high}{few})")
        }
        false => format!("{value} (one run{few})"),
    }
}

/// A target as it is asked for: 1e-3.
pub fn target(value: f64) -> String {
    format!("{value:e}")
}

/// A time with its interval; an upper end that was not reached is said.
pub fn time(seconds: Interval) -> String {
    let value = duration(seconds.value);
    if seconds.low == seconds.high {
        return value;
    }
    match seconds.high.is_finite() {
        true => format!(
            "{value} ({} to {})",
            duration(seconds.low),
            duration(seconds.high)
        ),
        false => format!("{value} ({} to beyond the study)", duration(seconds.low)),
    }
}

/// A row of cells; the first is the row's head.
pub fn row(cells: &[String]) -> String {
    let mut text = String::from("<tr>");
    for (column, cell) in cells.iter().enumerate() {
        let cell = escape(cell);
        text += &match column {
            0 => format!("<th scope=\"row\">{cell}</th>"),
            _ => format!("<td>{cell}</td>"),
        };
    }
    text + "</tr>\n"
}

/// A table in a box of its own, which scrolls where the page is narrow.
pub fn table(caption: &str, head: &[String], rows: &[Vec<String>]) -> String {
    let caption = escape(caption);
    let head: String = head
        .iter()
        .map(|cell| format!("<th scope=\"col\">{}</th>", escape(cell)))
        .collect();
    let rows: String = rows.iter().map(|cells| row(cells)).collect();
    format!(
        "<p class=\"caption\">{caption}</p>\n<div class=\"scroll\" role=\"region\" \
         aria-label=\"{caption}\" tabindex=\"0\">\n<table aria-label=\"{caption}\">\n\
         <thead><tr>{head}</tr></thead>\n<tbody>\n{rows}</tbody>\n</table>\n</div>\n"
    )
}

/// Series by estimator, in their order.
pub fn group_by_estimator<'a>(
    group: &[&'a Series],
) -> Vec<(Option<&'static str>, Vec<&'a Series>)> {
    let mut found: Vec<(Option<&'static str>, Vec<&Series>)> = Vec::new();
    for &series in group {
        match found.iter_mut().find(|(name, _)| *name == series.estimator) {
            Some((_, list)) => list.push(series),
            None => found.push((series.estimator, vec![series])),
        }
    }
    found
}

/// The relative floor of a series.
pub fn floor(series: &Series) -> f64 {
    series.truth.floor() / series.scale()
}
