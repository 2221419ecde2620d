//! Lines on two logarithmic axes, each labelled at its end.

use crate::error::Result;
use crate::plot::axis::{Axis, guide};
use crate::plot::ends::{End, spread};
use crate::plot::refuse;
use crate::plot::svg::{Anchor, BLUE, Canvas, FAINT, INK, QUIET, VERMILION};
use crate::plot::text;

/// A named line.
#[derive(Clone, Debug)]
pub struct Series {
    /// Stands at the line's end.
    pub name: String,
    /// (x, y), in the order to join them; what is not positive and finite is left out,
    /// since it has no place on logarithmic axes (an error of exactly 0).
    pub points: Vec<(f64, f64)>,
}

/// How lines of error look; start from `Default`.
#[derive(Clone, Debug)]
pub struct LinesStyle<'a> {
    /// Above the figure; may be empty.
    pub title: &'a str,
    /// Below the horizontal axis.
    pub x_label: &'a str,
    /// Left of the vertical axis.
    pub y_label: &'a str,
    /// Width and height of the axes in pixels at scale 1, 160 to 4000.
    pub size: [f64; 2],
    /// Guides: a name and the exponent of a power law, drawn dashed through the first
    /// point of the first series.
    pub slopes: &'a [(&'a str, f64)],
}

impl Default for LinesStyle<'_> {
    fn default() -> Self {
        Self {
            title: "",
            x_label: "N",
            y_label: "relative error",
            size: [520.0, 360.0],
            slopes: &[],
        }
    }
}

/// The palette of Okabe and Ito, without its yellow, which white swallows.
const COLOURS: [&str; 7] = [
    BLUE, VERMILION, "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#000000",
];
const LEFT: f64 = 78.0;
const BOTTOM: f64 = 54.0;
const LABEL_SIZE: f64 = 12.5;
const LABEL_GAP: f64 = 18.0;

/// Error against work, both logarithmic, as SVG. Powers of two on the horizontal
/// axis get ticks at powers of two, all else at powers of ten.
///
/// # Errors
///
/// [`Error::Arguments`](crate::Error::Arguments) if no point is positive and finite, or for
/// a size out of its range.
pub fn error_lines(series: &[Series], style: &LinesStyle<'_>) -> Result<String> {
    let [width, height] = style.size;
    if !style
        .size
        .iter()
        .all(|side| (160.0..=4000.0).contains(side))
    {
        return refuse(
            format!("axes of {width} x {height} pixels"),
            "a side has 160 to 4000 pixels",
            "choose a size in that range",
        );
    }
    let series: Vec<(&str, Vec<(f64, f64)>)> = series
        .iter()
        .map(|s| (s.name.as_str(), drawable(&s.points)))
        .collect();
    let all = || series.iter().flat_map(|(_, points)| points);
    let Some(&origin) = all().next() else {
        return refuse(
            "a plot of lines".to_owned(),
            "none has a point with both coordinates positive and finite",
            "check what was measured",
        );
    };
    let binary = all().all(|&(x, _)| x.log2().fract() == 0.0);
    let top = if style.title.is_empty() { 22.0 } else { 54.0 };
    let x = Axis::new(
        all().map(|p| p.0),
        if binary { 2.0 } else { 10.0 },
        [LEFT, LEFT + width],
        false,
    );
    let y = Axis::new(all().map(|p| p.1), 10.0, [top + height, top], true);
    let names = series
        .iter()
        .map(|(name, _)| *name)
        .chain(style.slopes.iter().map(|s| s.0));
    let label_width = names
        .map(|name| text::width(name, LABEL_SIZE))
        .fold(0.0, f64::max);

    let mut canvas = Canvas::new(
        LEFT + width + LABEL_GAP + label_width + 10.0,
        top + height + BOTTOM,
    );
    canvas.text(
        LEFT + width / 2.0,
        31.0,
        Anchor::Middle,
        17.0,
        INK,
        style.title,
    );
    for (tick, label) in x.ticks(64.0) {
        canvas.line((tick, top), (tick, top + height), FAINT, 0.8);
        canvas.text(tick, top + height + 19.0, Anchor::Middle, 12.0, INK, &label);
    }
    for (tick, label) in y.ticks(26.0) {
        canvas.line((LEFT, tick), (LEFT + width, tick), FAINT, 0.8);
        canvas.text(LEFT - 9.0, tick + 4.3, Anchor::End, 12.0, INK, &label);
    }
    let corner = (LEFT, top + height);
    canvas.line((LEFT, top), corner, INK, 1.2);
    canvas.line(corner, (LEFT + width, top + height), INK, 1.2);
    canvas.text(
        LEFT + width / 2.0,
        top + height + 42.0,
        Anchor::Middle,
        13.0,
        INK,
        style.x_label,
    );
    canvas.upright(22.0, top + height / 2.0, 13.0, style.y_label);

    let mut labels = Vec::new();
    for (name, exponent) in style.slopes {
        if let Some(ends) = guide(origin, *exponent, &x, &y) {
            canvas.polyline(&ends, "#9a9a9a", 1.1, "5 4");
            labels.push(End {
                name,
                mark: QUIET,
                at: ends[1],
                y: ends[1].1,
            });
        }
    }
    for (index, (name, points)) in series.iter().enumerate() {
        let colour = COLOURS[index % COLOURS.len()];
        let placed: Vec<(f64, f64)> = points
            .iter()
            .map(|p| (x.place(p.0), y.place(p.1)))
            .collect();
        canvas.polyline(&placed, colour, 1.8, "");
        for (px, py) in &placed {
            canvas.marker(*px, *py, index, colour);
        }
        if let Some(&end) = placed.last() {
            labels.push(End {
                name,
                mark: colour,
                at: end,
                y: end.1,
            });
        }
    }
    spread(&mut labels, top + 6.0, top + height - 6.0);
    for End {
        name,
        mark,
        at: end,
        y,
    } in labels
    {
        let at = LEFT + width + LABEL_GAP;
        if (y - end.1).abs() > 3.0 || at - end.0 > LABEL_GAP + 8.0 {
            canvas.line((end.0 + 6.0, end.1), (at - 4.0, y), "#b8b8b8", 0.8);
        }
        canvas.text(at, y + 4.4, Anchor::Start, LABEL_SIZE, mark, name);
    }
    Ok(canvas.finish())
}

fn drawable(points: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let positive = |v: f64| v.is_finite() && v > 0.0;
    points
        .iter()
        .copied()
        .filter(|p| positive(p.0) && positive(p.1))
        .collect()
}
