//! The names of a figure apart from it, for pages too narrow to show them beside the curves.

use super::frame::LEFT;
use super::{Curve, LABEL_GAP, WorkPrecisionStyle, page_width};
use crate::plot::palette::{class, colour};
use crate::plot::svg::Canvas;

/// What a narrow page needs to cut a figure off beside its axes.
#[derive(Clone, Debug, PartialEq)]
pub struct Key {
    /// The curves: a marker as SVG, in the classes of the figure, and the name, which is text.
    pub entries: Vec<(String, String)>,
    /// The figure's width over that of the part without the names.
    pub across: f64,
}

/// The key of the figure of these curves.
#[must_use]
pub fn key(curves: &[Curve], style: &WorkPrecisionStyle<'_>) -> Key {
    let curves = curves.iter();
    let drawn: Vec<&Curve> = curves
        .filter(|curve| curve.drawable().next().is_some())
        .collect();
    let names: Vec<String> = drawn.iter().map(|curve| curve.label()).collect();
    let across = page_width(&names, style).ceil() / (LEFT + style.size[0] + LABEL_GAP);
    let marks = drawn.iter().map(|curve| {
        let mut canvas = Canvas::new(12.0, 12.0);
        canvas.group(&class(curve.hue), |canvas| {
            canvas.marker(6.0, 6.0, curve.hue, colour(curve.hue));
        });
        canvas.finish_mark()
    });
    Key {
        entries: marks.zip(names.iter().cloned()).collect(),
        across,
    }
}
