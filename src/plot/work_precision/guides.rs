//! Power laws to compare slopes with.

use super::frame::Frame;
use super::{Curve, SMALL, Work, WorkPrecisionStyle};
use crate::plot::axis::guide;
use crate::plot::room::Room;
use crate::plot::svg::{Anchor, Canvas, QUIET};
use crate::plot::text;

const GUIDES: [(&str, f64); 3] = [
    ("slope −1/2", -0.5),
    ("slope −1", -1.0),
    ("slope −3/2", -1.5),
];

/// A power law on the page.
pub struct Guide {
    name: &'static str,
    pub ends: [(f64, f64); 2],
}

/// Power laws from the largest error of the fewest points.
pub fn guides(curves: &[&Curve], style: &WorkPrecisionStyle<'_>, frame: &Frame) -> Vec<Guide> {
    if style.work != Work::Points {
        return Vec::new();
    }
    let firsts = curves.iter().filter_map(|curve| curve.drawable().next());
    let first = firsts.clone().map(|one| one.work).fold(f64::MAX, f64::min);
    let worst = firsts.map(|one| one.error).fold(0.0, f64::max);
    let ends = |exponent| guide((first, worst), exponent, &frame.x, &frame.y);
    GUIDES
        .iter()
        .filter_map(|&(name, exponent)| ends(exponent).map(|ends| Guide { name, ends }))
        .collect()
}

impl Guide {
    /// The line, with its name beside it, from its end back where there is room, left of `right`
    /// and above `bottom`.
    pub fn draw(&self, canvas: &mut Canvas, right: f64, bottom: f64, room: &mut Room) {
        let words = text::width(self.name, SMALL);
        let [(x0, y0), (x1, y1)] = self.ends;
        let along = (0..20).map(|step| 1.0 - 0.045 * f64::from(step));
        let places: Vec<(f64, f64)> = along
            .flat_map(|t| {
                let (x, y) = (x0 + t * (x1 - x0), y0 + t * (y1 - y0));
                [(x + 7.0, y - 2.0), (x - words - 7.0, y + 8.0)]
            })
            .filter(|(x, y)| x + words < right && *y < bottom - 4.0)
            .collect();
        canvas.group("quiet", |canvas| {
            canvas.polyline(&self.ends, "#9a9a9a", 1.0, "2 3");
            if let Some((x, y)) = room.take(&places, [words, SMALL]) {
                canvas.text(x, y, Anchor::Start, SMALL, QUIET, self.name);
            }
        });
    }
}
