//! The page of a study.

use super::figures::Pair;
use super::method::method;
use super::section::section;
use super::summary::summary;
use super::words::escape;
use crate::converge::{Results, Series};
use crate::plot::dark_rules;
use crate::report;

/// Colours of the page, light and dark; figures have theirs in `plot::dark_rules`.
const STYLE: &str = include_str!("page.css");

/// The page of a study; `parts` are its integrands with their figures, in order.
pub fn page(results: &Results, parts: &[(&str, Vec<&Series>, Vec<Pair>)]) -> String {
    let setting = &results.setting;
    let sections: String = parts
        .iter()
        .map(|(integrand, group, pairs)| section(integrand, group, pairs, &setting.targets))
        .collect();
    let failed = match results.not_finite() {
        0 => String::new(),
        1 => "<p class=\"failed\">1 mean is not finite: see its integrand.</p>\n".to_owned(),
        many => {
            format!("<p class=\"failed\">{many} means are not finite: see their integrands.</p>\n")
        }
    };
    let names: Vec<&str> = parts.iter().map(|(name, ..)| *name).collect();
    report::page(
        &format!("Error against time: {}", names.join(", ")),
        &format!(
            "{STYLE}@media (prefers-color-scheme: dark) {{\n{}}}\n",
            dark_rules()
        ),
        &format!(
            "<h1>Error against time</h1>\n<p>Measured by corput converge on {}.</p>\n{failed}\
             <section id=\"summary\">\n<h2>What to use</h2>\n{}</section>\n{sections}{}",
            escape(&setting.device),
            summary(results),
            method(results)
        ),
    )
}
