//! The report card as a page.

use super::{Card, Supplement};
use crate::check::{Row, Verdict, figure};
use crate::report::{self, escape};
use serde_json::Value;
use std::fmt::Write;

const STYLE: &str = include_str!("page.css");

/// The page of a card, whose document the caller has made.
#[must_use]
pub fn page(card: &Card, document: &Value) -> String {
    let title = format!("{}: report card", card.info.name);
    let parts = [
        summary(card),
        identity(card, document),
        probe(document),
        both(&card.outcome.rows),
        card.supplement.map_or(String::new(), supplement),
        not_proved(card),
        rows(&card.outcome.rows),
        kernels(document),
    ];
    let main = format!("<h1>{}</h1>\n{}", escape(&title), parts.concat());
    report::page(&title, STYLE, &main)
}

/// What a reader wants first.
fn summary(card: &Card) -> String {
    let rows = &card.outcome.rows;
    let exact = || rows.iter().filter(|row| row.profile == "exact");
    let compared: u64 = exact().map(|row| row.compared).sum();
    let differ: u64 = exact().filter_map(|row| row.mismatches).sum();
    let native = rows.iter().filter(|row| row.profile == "native").count();
    let failures = card.failures();
    let beyond = match card.outcome.defects() {
        0 => "none of the driver's own functions is beyond them".to_owned(),
        1 => "1 of the driver's own functions is beyond them".to_owned(),
        many => format!("{many} of the driver's own functions are beyond them"),
    };
    let class = if failures == 0 { "passed" } else { "failed" };
    let verdict = match failures {
        0 if card.outcome.defects() == 0 => "Every row passed".to_owned(),
        0 => "No row failed".to_owned(),
        1 => "1 row failed".to_owned(),
        many => format!("{many} rows failed"),
    };
    format!(
        "<p class=\"{class}\">{verdict}: {differ} of {compared} results of the exact profile, in {} rows, \
         differ from the CPU's; {native} rows of the native profile were held to Vulkan's precision \
         tables, and {beyond}.</p>\n<dl><dt>fingerprint of the exact rows</dt><dd><code>{}</code></dd></dl>\n\
         <p>Two drivers with the same fingerprint gave the same bits in every row.</p>\n",
        exact().count(),
        card.fingerprint()
    )
}

fn identity(card: &Card, document: &Value) -> String {
    let info = card.info;
    let (major, minor, patch) = info.api_version;
    let driver = format!("{} {}", info.driver_name, info.driver_info);
    let vulkan = format!("{major}.{minor}.{patch}");
    let version = format!("{:#010x}", info.driver_version);
    let ids = format!("{:#06x}, {:#06x}", info.vendor_id, info.device_id);
    let host = text(document, "host");
    facts(
        "Identity",
        &[
            ("device", &info.name),
            ("kind", info.kind.name()),
            ("vendor and device", &ids),
            ("driver", &driver),
            ("driver's version, in the vendor's encoding", &version),
            ("Vulkan", &vulkan),
            ("device UUID", &info.device_uuid),
            ("driver UUID", &info.driver_uuid),
            ("host", &host),
            ("corput", env!("CARGO_PKG_VERSION")),
            ("command", card.command),
        ],
    )
}

fn probe(document: &Value) -> String {
    let float_controls = document.pointer("/device/float_controls_32");
    let mut list: Vec<(String, String)> = Vec::new();
    for (what, object) in [
        ("", document.get("probe")),
        ("may be asked for: ", float_controls),
    ] {
        for (key, value) in object.and_then(Value::as_object).into_iter().flatten() {
            let value = value
                .as_str()
                .map_or_else(|| value.to_string(), str::to_owned);
            list.push((format!("{what}{}", key.replace('_', " ")), value));
        }
    }
    let list: Vec<(&str, &str)> = list.iter().map(|(a, b)| (a.as_str(), b.as_str())).collect();
    facts("What it does with floats", &list)
}

/// Exact and native of the same function, side by side.
fn both(rows: &[Row]) -> String {
    let mut lines = String::new();
    for native in rows.iter().filter(|row| row.profile == "native") {
        let name = native
            .name
            .trim_start_matches("native")
            .trim_start_matches(['_', ' ']);
        let exact = rows
            .iter()
            .find(|row| row.profile == "exact" && row.name == name);
        // Kernels of the native profile alone have none.
        let cells = exact.map_or(["none".to_owned(), String::new(), String::new()], |exact| {
            [
                exact.compared.to_string(),
                exact.mismatches.unwrap_or(0).to_string(),
                bounded(exact),
            ]
        });
        let _ = writeln!(
            lines,
            "<tr><th scope=\"row\">{}</th><td>{}</td><td>{}</td><td>{}</td>{}</tr>",
            escape(name),
            cells.join("</td><td>"),
            native.compared,
            bounded(native),
            verdict(native)
        );
    }
    table(
        "Exact and native",
        "Errors, and what is allowed: of the exact profile by its own bound, of the native one by Vulkan's \
         precision tables.",
        &[
            "function",
            "exact: compared",
            "differ",
            "error",
            "native: compared",
            "error",
            "verdict",
        ],
        &lines,
    )
}

/// With at most three decimals.
fn decimal(number: f64) -> String {
    ((1000.0 * number).round() / 1000.0).to_string()
}

/// Statistics and extreme inputs.
fn supplement(more: &Supplement) -> String {
    let mut lines = String::new();
    let passed = |passed: bool| match passed {
        true => "<td>passed</td>",
        false => "<td class=\"failed\">failed</td>",
    };
    for one in &more.statistics {
        let _ = writeln!(
            lines,
            "<tr><th scope=\"row\">{}</th><td>{}</td><td>{}</td><td>{}</td><td>{} to {}</td>{}</tr>",
            escape(&one.of),
            escape(&one.what),
            one.points,
            decimal(one.value),
            decimal(one.least),
            decimal(one.most),
            passed(one.passes())
        );
    }
    let statistics = table(
        "Statistics",
        "Of points that this device made.",
        &["of", "what", "points", "value", "must be", "verdict"],
        &lines,
    );
    lines.clear();
    let error = |error: Option<f64>| error.map_or(String::new(), figure);
    for row in &more.catalogue {
        let _ = writeln!(
            lines,
            "<tr><th scope=\"row\">{} {}</th><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td>{}</tr>",
            row.case.number,
            escape(&row.case.input),
            figure(row.case.naive),
            figure(row.case.ours),
            error(row.device),
            error(row.native),
            figure(row.case.bound),
            match row.verdict() {
                "refused" => "<td>refused</td>",
                verdict => passed(verdict == "passed"),
            }
        );
    }
    let catalogue = table(
        "Extreme inputs",
        "Errors of the common formula in float, of this crate on the CPU and on this device, and of the \
         native profile, which has no bound here: Vulkan says how far single operations may be off. Rows without \
         a device are of the host alone.",
        &[
            "case",
            "common formula",
            "CPU",
            "device",
            "native",
            "bound",
            "verdict",
        ],
        &lines,
    );
    statistics + &catalogue
}

fn not_proved(card: &Card) -> String {
    let list: String = card
        .not_proved()
        .iter()
        .map(|line| format!("<li>{}</li>\n", escape(line)))
        .collect();
    format!("<h2>Not proved</h2>\n<ul>\n{list}</ul>\n")
}

fn rows(rows: &[Row]) -> String {
    let mut lines = String::new();
    for row in rows {
        let _ = writeln!(
            lines,
            "<tr><th scope=\"row\">{}</th><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td>{}\
             <td><code>{}</code></td></tr>",
            escape(&row.name),
            escape(&row.kernel),
            row.tier,
            row.compared,
            row.mismatches
                .map_or("may".to_owned(), |count| count.to_string()),
            bounded(row),
            verdict(row),
            row.sha256
                .as_deref()
                .map_or("", |hash| &hash[..hash.len().min(16)])
        );
    }
    table(
        "Every row",
        "The first 16 digits of the SHA-256 of what the device gave; report.json has all.",
        &[
            "what", "kernel", "tier", "compared", "differ", "error", "verdict", "SHA-256",
        ],
        &lines,
    )
}

fn kernels(document: &Value) -> String {
    let mut lines = String::new();
    for kernel in document
        .get("kernels")
        .and_then(Value::as_array)
        .into_iter()
        .flatten()
    {
        let violations = kernel
            .get("violations")
            .and_then(Value::as_array)
            .map_or(0, Vec::len);
        let _ = writeln!(
            lines,
            "<tr><th scope=\"row\">{}</th><td>{}</td><td>{violations}</td><td><code>{}</code></td></tr>",
            escape(&text(kernel, "name")),
            text(kernel, "tier"),
            text(kernel, "sha256")
        );
    }
    table(
        "Kernels",
        "SPIR-V as it is shipped, and what the linter says of it.",
        &["kernel", "tier", "violations", "SHA-256"],
        &lines,
    )
}

/// Error and bound in one.
fn bounded(row: &Row) -> String {
    match (row.worst, row.bound) {
        (Some(worst), Some(bound)) => {
            format!(
                "{} of {} {}",
                figure(worst),
                figure(bound),
                row.unit.trim_start_matches("of ")
            )
        }
        _ => String::new(),
    }
}

fn verdict(row: &Row) -> String {
    match &row.verdict {
        Verdict::Passed => "<td>passed</td>".to_owned(),
        Verdict::Failed => format!("<td class=\"failed\">failed: {}</td>", escape(&row.witness)),
        Verdict::Defect => format!("<td>the driver's defect: {}</td>", escape(&row.witness)),
        Verdict::Refused(reason) => format!("<td>refused: {}</td>", escape(reason)),
    }
}

fn text(object: &Value, key: &str) -> String {
    object
        .get(key)
        .and_then(Value::as_str)
        .unwrap_or("")
        .to_owned()
}

fn facts(title: &str, list: &[(&str, &str)]) -> String {
    let lines: String = list
        .iter()
        .map(|(name, value)| format!("<dt>{}</dt><dd>{}</dd>\n", escape(name), escape(value)))
        .collect();
    format!("<h2>{title}</h2>\n<dl>\n{lines}</dl>\n")
}

fn table(title: &str, caption: &str, head: &[&str], lines: &str) -> String {
    let head: String = head
        .iter()
        .map(|name| format!("<th scope=\"col\">{name}</th>"))
        .collect();
    format!(
        "<h2>{title}</h2>\n<div class=\"scroll\" role=\"region\" aria-label=\"{title}\" tabindex=\"0\">\n\
         <table>\n<caption>{caption}</caption>\n<thead><tr>{head}</tr></thead>\n<tbody>\n{lines}</tbody>\n\
         </table>\n</div>\n"
    )
}
