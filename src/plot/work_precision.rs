//! Error against work: samplers with their intervals, the targets, and the floor.

mod frame;
mod guides;
mod key;
mod level;
mod runs;

use crate::error::Result;
use crate::plot::ends::{End, spread};
use crate::plot::palette::{class, colour};
use crate::plot::refuse;
use crate::plot::room::Room;
use crate::plot::svg::{Anchor, Canvas, INK};
use crate::plot::text;
use frame::{Frame, LEFT};
use guides::guides;
pub use key::{Key, key};
use level::levels;
use runs::{band, line};

/// The most curves of a figure: as many as there are colours.
pub const MAX_CURVES: usize = 8;

/// An error that was measured.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measured {
    /// Points, or seconds.
    pub work: f64,
    /// The error; one that is not positive and finite is not drawn.
    pub error: f64,
    /// The ends of its interval.
    pub low: f64,
    /// The upper one.
    pub high: f64,
    /// Whether the interval says too little: drawn dotted and faint.
    pub faint: bool,
}

/// Errors of rising work.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    /// Stands at the curve's end.
    pub name: String,
    /// In the order to join them.
    pub points: Vec<Measured>,
    /// Whether there is one run only: dashed, without a band, and named so.
    pub one_run: bool,
    /// Which of the eight colours and markers.
    pub hue: usize,
}

impl Curve {
    fn label(&self) -> String {
        match self.one_run {
            true => format!("{} (one run)", self.name),
            false => self.name.clone(),
        }
    }

    /// The points with a place on logarithmic axes.
    fn drawable(&self) -> impl Iterator<Item = &Measured> {
        let positive = |value: f64| value.is_finite() && value > 0.0;
        self.points
            .iter()
            .filter(move |one| positive(one.work) && positive(one.error))
    }
}

/// What the work is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Work {
    /// Numbers of points; with guides of slope -1/2, -1 and -3/2.
    Points,
    /// Seconds.
    Seconds,
}

/// What such a figure has besides its curves.
#[derive(Clone, Copy, Debug)]
pub struct WorkPrecisionStyle<'a> {
    /// For those who do not see it.
    pub title: &'a str,
    /// For them too: what the figure shows.
    pub description: &'a str,
    /// What the work is.
    pub work: Work,
    /// Left of the vertical axis.
    pub y_label: &'a str,
    /// Errors of interest.
    pub targets: &'a [f64],
    /// The error that no number of points removes; 0 of exact arithmetic.
    pub floor: f64,
    /// What the floor is called.
    pub floor_name: &'a str,
    /// Width and height of the axes in pixels, 160 to 4000.
    pub size: [f64; 2],
}

impl Default for WorkPrecisionStyle<'_> {
    fn default() -> Self {
        Self {
            title: "",
            description: "",
            work: Work::Points,
            y_label: "relative error",
            targets: &[],
            floor: 0.0,
            floor_name: "arithmetic floor",
            size: [300.0, 290.0],
        }
    }
}

const LABEL_SIZE: f64 = 12.0;
const LABEL_GAP: f64 = 12.0;
/// From a name's marker to the name.
const MARKER: f64 = 16.0;
const SMALL: f64 = 11.5;
/// Beyond so many decades below all errors the floor, and beyond all errors a target, has no
/// place on the axis.
const APART: f64 = 2.0;

/// Error against work, both logarithmic, as SVG with a class for each curve
/// ([`dark_rules`](super::dark_rules)). A floor far below all errors is drawn at the lower
/// edge, with an arrow.
///
/// # Errors
///
/// [`Error::Arguments`](crate::Error::Arguments) if no point is positive and finite, for more
/// than eight curves, or for a size out of its range.
pub fn work_precision(curves: &[Curve], style: &WorkPrecisionStyle<'_>) -> Result<String> {
    let [width, height] = style.size;
    if !style.size.iter().all(|s| (160.0..=4000.0).contains(s)) {
        return refuse(
            format!("axes of {width} x {height} pixels"),
            "a side has 160 to 4000 pixels",
            "choose a size in that range",
        );
    }
    if curves.len() > MAX_CURVES {
        return refuse(
            format!("a figure of {} curves", curves.len()),
            "eight can be told apart",
            "leave some out, and say so",
        );
    }
    let curves: Vec<&Curve> = curves
        .iter()
        .filter(|curve| curve.drawable().next().is_some())
        .collect();
    if curves.is_empty() {
        return refuse(
            "a plot of errors".to_owned(),
            "none is positive and finite",
            "check what was measured",
        );
    }
    let names: Vec<String> = curves.iter().map(|curve| curve.label()).collect();
    let frame = Frame::new(&curves, style);

    let mut canvas = Canvas::new(page_width(&names, style), frame.bottom + 46.0);
    frame.draw(&mut canvas, style);
    for curve in &curves {
        band(&mut canvas, curve, &frame);
    }
    let mut room = Room::default();
    let ends: Vec<(f64, f64)> = curves
        .iter()
        .filter_map(|curve| line(&mut canvas, curve, &frame, &mut room))
        .collect();
    let levels = levels(style, &frame);
    for level in &levels {
        room.line(&[(LEFT, level.at), (LEFT + width, level.at)]);
    }
    let guides = guides(&curves, style, &frame);
    for guide in &guides {
        room.line(&guide.ends);
    }
    // Words of levels have few places, those of guides any along the line.
    for level in &levels {
        level.draw(&mut canvas, width, &mut room);
    }
    for guide in &guides {
        guide.draw(&mut canvas, LEFT + width, frame.bottom, &mut room);
    }

    let labels = names.iter().zip(&ends).zip(&curves);
    let mut labels: Vec<End<'_, usize>> = labels
        .map(|((name, &end), curve)| End {
            name,
            mark: curve.hue,
            at: end,
            y: end.1,
        })
        .collect();
    spread(&mut labels, frame.top + 6.0, frame.bottom - 6.0);
    for label in &labels {
        name(&mut canvas, label, LEFT + width + LABEL_GAP);
    }
    Ok(canvas.finish_described(style.title, style.description))
}

/// The width of a figure with these names.
fn page_width(names: &[String], style: &WorkPrecisionStyle<'_>) -> f64 {
    let widest = names.iter().map(|name| text::width(name, LABEL_SIZE));
    let names_width = widest.fold(0.0, f64::max);
    LEFT + style.size[0] + LABEL_GAP + MARKER + names_width + 8.0
}

/// A name beside the axes, with its marker, and a line from the curve's end where it is far.
fn name(canvas: &mut Canvas, label: &End<'_, usize>, at: f64) {
    let End {
        name,
        mark,
        at: end,
        y,
    } = *label;
    if (y - end.1).abs() > 3.0 || at - end.0 > LABEL_GAP + 8.0 {
        canvas.group("grid", |canvas| {
            canvas.line((end.0 + 6.0, end.1), (at - 1.0, y), "#b8b8b8", 0.8);
        });
    }
    canvas.group(&class(mark), |canvas| {
        canvas.marker(at + 6.0, y, mark, colour(mark));
    });
    canvas.group("ink", |canvas| {
        canvas.text(at + MARKER, y + 4.3, Anchor::Start, LABEL_SIZE, INK, name);
    });
}
