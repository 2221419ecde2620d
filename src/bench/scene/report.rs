//! Comparisons of scenes as rows, JSON and a page.

use super::{COMPILED_S, Comparison, Size, Speed};
use crate::report::{escape, page as frame};
use crate::scene::{Draw, Needs, Scene};
use serde_json::{Value, json};
use std::fmt::Write;

/// A row: what is compared, of the stock kernels, of the scene's own, and the first over the
/// second; empty where there is none.
pub type Row = [String; 4];

/// The rows of a comparison.
#[must_use]
pub fn rows(one: &Comparison) -> Vec<Row> {
    let (full, stripped) = (&one.full, &one.stripped);
    let counted = |name: &str, full: u64, stripped: u64| -> Row {
        let over = match stripped {
            0 => String::new(),
            _ => format!("{:.1}", full as f64 / stripped as f64),
        };
        [
            name.to_owned(),
            full.to_string(),
            stripped.to_string(),
            over,
        ]
    };
    let of = |name: &str, value: &dyn Fn(&Size) -> u64| counted(name, value(full), value(stripped));
    let mut rows = vec![
        of("modules", &|size| size.kernels.len() as u64),
        of("SPIR-V bytes", &|size| size.modules.bytes as u64),
        counted(
            "SPIR-V bytes, were the sampler any",
            one.any_bytes as u64,
            stripped.modules.bytes as u64,
        ),
        of("instructions", &|size| size.modules.instructions as u64),
        of("functions", &|size| size.modules.functions as u64),
        of("constants", &|size| size.modules.constants as u64),
        of("specialization constants", &|size| {
            size.modules.specialization as u64
        }),
        of("bound resources", &|size| size.resources as u64),
        of("bytes of tables in modules", &|size| {
            size.modules.table_bytes
        }),
        of("bytes of tables in buffers", &|size| size.buffer_bytes),
    ];
    let Some(speeds) = &one.speeds else {
        return rows;
    };
    let rate = |speed: &Speed| f64::from(speed.samples) / speed.median_s;
    let (whole, own) = (&speeds.full, &speeds.stripped);
    let milliseconds = |name: &str, whole: f64, own: f64| -> Row {
        [
            name.to_owned(),
            format!("{:.1}", whole * 1e3),
            format!("{:.1}", own * 1e3),
            format!("{:.1}", whole / own),
        ]
    };
    rows.extend([
        milliseconds("ms to make pipelines", whole.pipelines_s, own.pipelines_s),
        milliseconds("ms until the first 64 samples", whole.start_s, own.start_s),
    ]);
    let again = |name: String, seconds: f64| -> Row {
        [
            name,
            String::new(),
            format!("{:.1}", seconds * 1e3),
            String::new(),
        ]
    };
    let goal = format!(
        "ms from text to module, warm (goal {:.0})",
        COMPILED_S * 1e3
    );
    rows.extend([
        again("ms until they are, made again".to_owned(), speeds.warm_s),
        again(goal, speeds.compile_s),
    ]);
    rows.push([
        "million samples a second".to_owned(),
        format!("{:.3}", rate(whole) / 1e6),
        format!("{:.3}", rate(own) / 1e6),
        format!("1/{:.1}", rate(own) / rate(whole)),
    ]);
    let fills = |speed: &Speed| format!("{:.1}", speed.median_s / speed.fill_s);
    if let Some(baked) = &speeds.baked {
        rows.push([
            "the same, of the kernel that generate bakes".to_owned(),
            format!("{:.3}", rate(baked) / 1e6),
            format!("{:.3}", rate(own) / 1e6),
            format!("1/{:.2}", rate(own) / rate(baked)),
        ]);
    }
    let spread = |speed: &Speed| format!("{:.1}", 100.0 * speed.deviation_s / speed.median_s);
    for (name, of) in [
        (
            "% that their times deviate",
            &spread as &dyn Fn(&Speed) -> String,
        ),
        ("times a fill of the bytes stored", &fills),
    ] {
        rows.push([name.to_owned(), of(whole), of(own), String::new()]);
    }
    if let Some(baked) = &speeds.baked {
        let name = "the same, of the kernel that generate bakes".to_owned();
        rows.push([name, fills(baked), fills(own), String::new()]);
    }
    rows
}

/// A comparison as JSON.
#[must_use]
pub fn document(one: &Comparison) -> Value {
    let size = |size: &Size| {
        json!({
            "kernels": size.kernels,
            "spirv_bytes": size.modules.bytes,
            "instructions": size.modules.instructions,
            "functions": size.modules.functions,
            "constants": size.modules.constants,
            "specialization_constants": size.modules.specialization,
            "bound_resources": size.resources,
            "module_table_bytes": size.modules.table_bytes,
            "buffer_table_bytes": size.buffer_bytes,
        })
    };
    let speed = |speed: &Speed| {
        json!({
            "pipelines_s": speed.pipelines_s,
            "start_s": speed.start_s,
            "samples": speed.samples,
            "median_s": speed.median_s,
            "deviation_s": speed.deviation_s,
            "bytes": speed.bytes,
            "fill_s": speed.fill_s,
            "times_fill": speed.median_s / speed.fill_s,
        })
    };
    json!({
        "scene": one.name,
        "full": size(&one.full),
        "full_bytes_of_any_sampler": one.any_bytes,
        "stripped": size(&one.stripped),
        "speeds": one.speeds.as_ref().map(|speeds| json!({
            "full": speed(&speeds.full),
            "stripped": speed(&speeds.stripped),
            "baked": speeds.baked.as_ref().map(speed),
            "warm_s": speeds.warm_s,
            "compile_s": speeds.compile_s,
            "compile_s_at_most": COMPILED_S,
            "compile_goal_reached": speeds.compile_s <= COMPILED_S,
        })),
    })
}

const STYLE: &str = include_str!("page.css");

/// A page of a comparison: sizes and times, what is kept and what is left out, and why.
/// `device` is a line that names it; without one nothing was timed.
#[must_use]
pub fn page(scene: &Scene, needs: &Needs, one: &Comparison, device: Option<&str>) -> String {
    let name = escape(&scene.name);
    let mut main = format!("<h1>{name}: what its kernel leaves out</h1>\n");
    // Writing to a String cannot fail.
    let _ = writeln!(
        main,
        "<p>{} samples of {}, {} dimensions, profile {}. corput {}; {}.</p>",
        scene.samples.value,
        escape(&scene.sampler.value.name()),
        needs.dimensions(),
        scene.profile.name(),
        env!("CARGO_PKG_VERSION"),
        match device {
            Some(line) => format!("times on {}, samples verified first", escape(line)),
            None => "nothing was timed: no device".to_owned(),
        }
    );
    main += "<h2>Full against stripped</h2>\n<p>Full are the stock kernels that draw the same, \
             whose maps, bases, nets, scrambles and seeds are chosen at run time: ";
    main += &escape(&one.full.kernels.join(", "));
    main += ".</p>\n";
    main += &table(&["", "full", "stripped", "full / stripped"], &rows(one));
    main += "<h2>Kept</h2>\n";
    let kept: Vec<[String; 4]> = needs
        .domains
        .iter()
        .map(|domain| {
            let range = domain.range();
            let drawn = match &domain.draw {
                Draw::Between([low, high]) => format!("a number from {low} to {high}"),
                Draw::Choice(weights) => format!("a choice among {}", weights.len()),
                Draw::Map(mapping) => mapping.map().name.to_owned(),
            };
            let dimensions = match range.len() {
                1 => range.start.to_string(),
                _ => format!("{} to {}", range.start, range.end - 1),
            };
            [
                domain.key.clone(),
                drawn,
                dimensions,
                domain.cause.to_string(),
            ]
        })
        .collect();
    main += &table(&["domain", "drawn by", "dimensions", "decided by"], &kept);
    main += "<h2>Left out</h2>\n";
    let left: Vec<[String; 3]> = needs
        .left_out
        .iter()
        .map(|one| {
            [
                one.part.name().to_owned(),
                one.name.clone(),
                one.reason.clone(),
            ]
        })
        .collect();
    main += &table(&["what", "name", "decided by"], &left);
    frame(&format!("corput strip: {}", scene.name), STYLE, &main)
}

fn table<const N: usize>(head: &[&str; N], rows: &[[String; N]]) -> String {
    let mut text = "<div class=\"scroll\"><table>\n<thead><tr>".to_owned();
    for name in head {
        let _ = write!(text, "<th>{}</th>", escape(name));
    }
    text += "</tr></thead>\n<tbody>\n";
    for row in rows {
        text += "<tr>";
        for cell in row {
            let _ = write!(text, "<td>{}</td>", escape(cell));
        }
        text += "</tr>\n";
    }
    text += "</tbody></table></div>\n";
    text
}
