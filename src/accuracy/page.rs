//! The figures as one HTML file: no script, no request, light or dark as the reader's system is.

use super::document::{About, figure, floor, millions};
use super::{Accuracy, Comparison};
use crate::report::escape;
use std::fmt::Write;

const HEAD: &str = r##"<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<title>corput accuracy</title>
<style>
:root { --page: #ffffff; --ink: #222222; --quiet: #5c5c5c; --line: #d4d4d4; --bar: #f4f4f4; --join: #b8b8b8;
  --blue: #0072b2; --red: #d55e00; }
@media (prefers-color-scheme: dark) {
  :root { --page: #16181c; --ink: #e8e8e8; --quiet: #a8a8a8; --line: #3b3f46; --bar: #20242a; --join: #5a616b;
    --blue: #5cb8f0; --red: #ff9146; }
}
body { margin: 0 auto; max-width: 76rem; padding: 1rem; background: var(--page); color: var(--ink);
  font: 16px/1.5 system-ui, sans-serif; }
h1 { font-size: 1.5rem; margin: .5rem 0; }
p, dl { max-width: 46rem; }
dl { display: grid; grid-template-columns: max-content 1fr; gap: .2rem 1rem; color: var(--quiet); }
dt { font-weight: 600; } dd { margin: 0; overflow-wrap: anywhere; }
.box { overflow-x: auto; margin: 1rem 0; border: 1px solid var(--line); }
table { border-collapse: collapse; font-size: .875rem; font-variant-numeric: tabular-nums; width: 100%; }
caption { text-align: left; padding: .5rem .6rem; color: var(--quiet); }
th, td { padding: .25rem .6rem; text-align: right; white-space: nowrap; border-top: 1px solid var(--line); }
thead th { background: var(--bar); vertical-align: bottom; }
th[scope=colgroup] { text-align: center; border-left: 1px solid var(--line); }
th[scope=row], thead th:first-child { text-align: left; position: sticky; left: 0; background: var(--page); }
thead th:first-child { background: var(--bar); }
.wrong { color: var(--red); font-weight: 700; }
svg { display: block; min-width: 48rem; width: 100%; height: auto; }
svg [fill="#ffffff"] { fill: var(--page); } svg [fill="#222222"] { fill: var(--ink); }
svg [fill="#666666"] { fill: var(--quiet); } svg [stroke="#222222"] { stroke: var(--ink); }
svg [stroke="#666666"] { stroke: var(--quiet); } svg [stroke="#d4d4d4"] { stroke: var(--line); }
svg [stroke="#b8b8b8"] { stroke: var(--join); }
svg [fill="#0072b2"] { fill: var(--blue); } svg [fill="#d55e00"] { fill: var(--red); }
</style>
</head>
<body>
<h1>What exactness costs</h1>
"##;

const TEXT: &str = "<p>Errors are in units of the last place (ULP) of the correctly rounded float, against \
results in double precision; where a true result is smaller than the floor, in ULP of the floor. Those of a \
vector are its worst coordinate's; relative is the worst in ULP of the result itself, wherever a function \
passes through zero. The exact profile gives the same bits on every device, and they were compared \
with the CPU's before anything was timed; the native profile has the device's own functions. Speeds are millions \
of results a second of a loop that stores 16 bytes for 64 results; ± is the median absolute deviation. The bare \
loop takes the share of the native time in the last column.</p>\n";

/// The page, with the plot as SVG text.
#[must_use]
pub fn page(about: &About, comparisons: &[Comparison], svg: &str) -> String {
    let mut text = HEAD.to_owned();
    text.push_str(TEXT);
    let facts = [
        ("device", about.device.as_str()),
        ("driver", &about.driver),
        ("command", &about.command),
        ("corput", env!("CARGO_PKG_VERSION")),
    ];
    text.push_str("<dl>\n");
    for (name, value) in facts {
        // Writing to a String cannot fail, here and below.
        let _ = writeln!(text, "<dt>{name}</dt><dd>{}</dd>", escape(value));
    }
    text.push_str("</dl>\n");
    let _ = writeln!(
        text,
        "<div class=\"box\" role=\"region\" aria-label=\"Plot\" tabindex=\"0\">\n{svg}</div>"
    );
    text.push_str(
        "<div class=\"box\" role=\"region\" aria-label=\"Table\" tabindex=\"0\">\n<table>\n\
         <caption>Both profiles of each function. Speeds in millions of results a second.</caption>\n\
         <thead><tr><th rowspan=\"2\" scope=\"col\">function</th>\
         <th rowspan=\"2\" scope=\"col\">floor</th>\
         <th colspan=\"6\" scope=\"colgroup\">exact</th><th colspan=\"6\" scope=\"colgroup\">native</th>\
         <th rowspan=\"2\" scope=\"col\">exact takes</th><th rowspan=\"2\" scope=\"col\">loop</th></tr>\n<tr>",
    );
    for _ in 0..2 {
        for name in ["worst", "mean", "relative", "pdf", "speed", "±"] {
            let _ = write!(text, "<th scope=\"col\">{name}</th>");
        }
    }
    text.push_str("</tr></thead>\n<tbody>\n");
    for one in comparisons {
        let differ = match one.mismatches {
            0 => String::new(),
            count => format!(
                " <span class=\"wrong\">{count} of {} differ from the CPU's</span>",
                one.compared
            ),
        };
        let _ = writeln!(
            text,
            "<tr><th scope=\"row\">{}{differ}</th><td>{}</td>{}{}<td>{}</td><td>{}</td></tr>",
            one.name,
            floor(one.exact.judged.floor),
            cells(&one.exact),
            cells(&one.native),
            one.price()
                .map_or("-".to_owned(), |price| format!("{price:.1} ×")),
            one.loop_share().map_or("-".to_owned(), percent),
        );
    }
    text.push_str("</tbody>\n</table>\n</div>\n</body>\n</html>\n");
    text
}

fn cells(one: &Accuracy) -> String {
    let pdf = one.judged.pdf.map(|pdf| figure(pdf.worst_ulp));
    let speed = one.speed.map(|speed| millions(speed.results_per_s()));
    let spread = one.speed.map(|speed| percent(speed.spread()));
    let dash = |cell: Option<String>| cell.unwrap_or_else(|| "-".to_owned());
    [
        figure(one.judged.errors.worst_ulp),
        figure(one.judged.errors.mean_ulp),
        figure(one.judged.worst_relative_ulp),
        dash(pdf),
        dash(speed),
        dash(spread),
    ]
    .map(|cell| format!("<td>{cell}</td>"))
    .concat()
}

fn percent(share: f64) -> String {
    format!("{:.0} %", 100.0 * share)
}
