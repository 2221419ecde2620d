//! Two ways to do each of many things: error against speed on logarithmic axes.

use crate::error::Result;
use crate::plot::axis::Axis;
use crate::plot::labels::{Area, place};
use crate::plot::refuse;
use crate::plot::svg::{Anchor, BLUE, Canvas, FAINT, INK, QUIET, VERMILION};

/// One thing, done in two ways.
#[derive(Clone, Debug)]
pub struct Tradeoff {
    /// Stands at the second end.
    pub name: String,
    /// Speed and error of each way.
    pub ends: [(f64, f64); 2],
}

/// How the figure looks; start from `Default`.
#[derive(Clone, Debug)]
pub struct TradeoffStyle<'a> {
    /// Above the figure; may be empty.
    pub title: &'a str,
    /// Below the title; may be empty.
    pub subtitle: &'a str,
    /// Below the horizontal axis.
    pub x_label: &'a str,
    /// Left of the vertical axis.
    pub y_label: &'a str,
    /// What the two ways are called.
    pub ways: [&'a str; 2],
    /// Width and height of the axes in pixels at scale 1, 160 to 4000.
    pub size: [f64; 2],
}

impl Default for TradeoffStyle<'_> {
    fn default() -> Self {
        Self {
            title: "",
            subtitle: "",
            x_label: "results per second",
            y_label: "worst error",
            ways: ["first", "second"],
            size: [820.0, 620.0],
        }
    }
}

const LEFT: f64 = 72.0;
const RIGHT: f64 = 24.0;
const TOP: f64 = 78.0;
const BOTTOM: f64 = 54.0;
const LABEL_SIZE: f64 = 10.5;
const COLOURS: [&str; 2] = [BLUE, VERMILION];
const JOIN: &str = "#b8b8b8";

/// Pairs of points joined by lines, named at their second ends, as SVG. A pair with a
/// coordinate that is not positive and finite has no place on the axes and is left out.
///
/// # Errors
///
/// [`Error::Arguments`](crate::Error::Arguments) if no pair is left, or for a size out of its
/// range.
pub fn tradeoff(pairs: &[Tradeoff], style: &TradeoffStyle<'_>) -> Result<String> {
    let [width, height] = style.size;
    let in_range = |side: &f64| (160.0..=4000.0).contains(side);
    if !style.size.iter().all(in_range) {
        return refuse(
            format!("axes of {width} x {height} pixels"),
            "a side has 160 to 4000 pixels",
            "choose a size in that range",
        );
    }
    let positive = |v: f64| v.is_finite() && v > 0.0;
    let pairs: Vec<&Tradeoff> = pairs
        .iter()
        .filter(|pair| {
            pair.ends
                .iter()
                .all(|end| positive(end.0) && positive(end.1))
        })
        .collect();
    if pairs.is_empty() {
        return refuse(
            "a plot of error against speed".to_owned(),
            "no pair has all of its coordinates positive and finite",
            "check what was measured",
        );
    }
    let all = || pairs.iter().flat_map(|pair| pair.ends);
    let x = Axis::new(all().map(|end| end.0), 10.0, [LEFT, LEFT + width], false);
    let y = Axis::new(all().map(|end| end.1), 10.0, [TOP + height, TOP], true);

    let mut canvas = Canvas::new(LEFT + width + RIGHT, TOP + height + BOTTOM);
    canvas.text(LEFT, 28.0, Anchor::Start, 17.0, INK, style.title);
    canvas.text(LEFT, 48.0, Anchor::Start, 12.0, QUIET, style.subtitle);
    axes(&mut canvas, &x, &y, style);

    let placed: Vec<[(f64, f64); 2]> = pairs
        .iter()
        .map(|pair| pair.ends.map(|end| (x.place(end.0), y.place(end.1))))
        .collect();
    for [from, to] in &placed {
        canvas.line(*from, *to, JOIN, 0.9);
    }
    for (way, colour) in COLOURS.into_iter().enumerate() {
        for ends in &placed {
            canvas.marker(ends[way].0, ends[way].1, way, colour);
        }
    }
    let names: Vec<(&str, (f64, f64))> = pairs
        .iter()
        .zip(&placed)
        .map(|(pair, ends)| (pair.name.as_str(), ends[1]))
        .collect();
    let taken: Vec<(f64, f64)> = placed.iter().flatten().copied().collect();
    let bounds = Area([
        LEFT + 2.0,
        TOP,
        LEFT + width + RIGHT - 4.0,
        TOP + height - 2.0,
    ]);
    let places = place(&names, LABEL_SIZE, bounds, &taken, &placed);
    for ((name, point), place) in names.into_iter().zip(places) {
        if let Some(end) = place.leader {
            canvas.line(point, end, QUIET, 0.6);
        }
        let [left, _, _, bottom] = place.area.0;
        canvas.text(left, bottom - 1.6, Anchor::Start, LABEL_SIZE, INK, name);
    }
    Ok(canvas.finish())
}

/// Ticks, names of the axes, and what the markers are.
fn axes(canvas: &mut Canvas, x: &Axis, y: &Axis, style: &TradeoffStyle<'_>) {
    let [width, height] = style.size;
    let (right, bottom) = (LEFT + width, TOP + height);
    for (tick, label) in x.ticks(64.0) {
        canvas.line((tick, TOP), (tick, bottom), FAINT, 0.8);
        canvas.text(tick, bottom + 19.0, Anchor::Middle, 12.0, INK, &label);
    }
    for (tick, label) in y.ticks(26.0) {
        canvas.line((LEFT, tick), (right, tick), FAINT, 0.8);
        canvas.text(LEFT - 9.0, tick + 4.3, Anchor::End, 12.0, INK, &label);
    }
    canvas.line((LEFT, TOP), (LEFT, bottom), INK, 1.2);
    canvas.line((LEFT, bottom), (right, bottom), INK, 1.2);
    let middle = LEFT + width / 2.0;
    canvas.text(
        middle,
        bottom + 42.0,
        Anchor::Middle,
        13.0,
        INK,
        style.x_label,
    );
    canvas.upright(22.0, TOP + height / 2.0, 13.0, style.y_label);
    for (way, (name, colour)) in style.ways.into_iter().zip(COLOURS).enumerate() {
        let at = right - 150.0 + 80.0 * way as f64;
        canvas.marker(at, TOP - 14.0, way, colour);
        canvas.text(at + 9.0, TOP - 9.7, Anchor::Start, 12.5, colour, name);
    }
}
