//! The axes: what they cover, and their ticks.

use super::{APART, Curve, LABEL_GAP, Measured, Work, WorkPrecisionStyle};
use crate::plot::axis::Axis;
use crate::plot::numbers::duration;
use crate::plot::svg::{Anchor, Canvas, FAINT, INK};
use crate::plot::text;

/// Left end of the horizontal axis.
pub const LEFT: f64 = 66.0;
const TOP: f64 = 12.0;
const TICK_SIZE: f64 = 11.5;
const AXIS_SIZE: f64 = 12.0;
/// Below so many decades, 2 and 5 times a power of ten have ticks too.
const SHORT: f64 = 2.05;

/// Axes on the page.
pub struct Frame {
    pub x: Axis,
    pub y: Axis,
    pub top: f64,
    pub bottom: f64,
}

impl Frame {
    /// Covers the curves, their intervals to a decade from all errors, and what targets and
    /// floor are near.
    pub fn new(curves: &[&Curve], style: &WorkPrecisionStyle<'_>) -> Self {
        let [width, height] = style.size;
        let all = || curves.iter().flat_map(|curve| curve.drawable());
        let errors = || all().map(|one| one.error);
        let (least, most) = (
            errors().fold(f64::MAX, f64::min),
            errors().fold(0.0, f64::max),
        );
        let intervals = curves.iter().filter(|curve| !curve.one_run);
        let ends = intervals.flat_map(|curve| curve.drawable());
        let near = |factor: f64| (least / factor)..=(most * factor);
        let ends = ends
            .flat_map(|one: &Measured| [one.low, one.high])
            .filter(|end| near(10.0).contains(end));
        let apart = 10f64.powf(APART);
        let targets = style.targets.iter().copied();
        let levels = targets.chain([style.floor]);
        // Half of it: what lies on the lowest tick would lie on the axis.
        let levels = levels
            .filter(|level| near(apart).contains(level))
            .map(|level| 0.5 * level);
        let bottom = TOP + height;
        let base = match style.work {
            Work::Points => 2.0,
            Work::Seconds => 10.0,
        };
        Self {
            x: Axis::new(all().map(|one| one.work), base, [LEFT, LEFT + width], false),
            y: Axis::new(
                errors().chain(ends).chain(levels),
                10.0,
                [bottom, TOP],
                true,
            ),
            top: TOP,
            bottom,
        }
    }

    /// Where a value lies; at the nearer end of the vertical axis where it has no place.
    pub fn place(&self, work: f64, error: f64) -> (f64, f64) {
        (self.x.place(work), self.y.place_within(error))
    }

    /// Grid, ticks and names of the axes.
    pub fn draw(&self, canvas: &mut Canvas, style: &WorkPrecisionStyle<'_>) {
        let [width, height] = style.size;
        let (top, bottom, right) = (self.top, self.bottom, LEFT + width);
        let across = self.ticks(style.work);
        let up = self.y.ticks(24.0);
        canvas.group("grid", |canvas| {
            for (tick, _) in &across {
                canvas.line((*tick, top), (*tick, bottom), FAINT, 0.8);
            }
            for (tick, _) in &up {
                canvas.line((LEFT, *tick), (right, *tick), FAINT, 0.8);
            }
        });
        canvas.group("ink", |canvas| {
            for (tick, label) in &across {
                let (x, y) = (label_middle(*tick, label, right), bottom + 16.0);
                canvas.text(x, y, Anchor::Middle, TICK_SIZE, INK, label);
            }
            for (tick, label) in &up {
                let x = LEFT - 7.0;
                canvas.text(x, tick + 4.0, Anchor::End, TICK_SIZE, INK, label);
            }
            canvas.line((LEFT, top), (LEFT, bottom), INK, 1.2);
            canvas.line((LEFT, bottom), (right, bottom), INK, 1.2);
            let name = match style.work {
                Work::Points => "points N",
                Work::Seconds => "time of one replicate",
            };
            let middle = LEFT + width / 2.0;
            let y = bottom + 36.0;
            canvas.text(middle, y, Anchor::Middle, AXIS_SIZE, INK, name);
            canvas.upright(17.0, top + height / 2.0, AXIS_SIZE, style.y_label);
        });
    }

    /// Places and names of the ticks of the horizontal axis.
    fn ticks(&self, work: Work) -> Vec<(f64, String)> {
        if work == Work::Points {
            return self.x.ticks(40.0);
        }
        let parts: &[f64] = match self.x.high - self.x.low < SHORT {
            true => &[1.0, 2.0, 5.0],
            false => &[1.0],
        };
        let exponents = match self.x.high - self.x.low < SHORT {
            true => (-12..=6).collect(),
            false => self.x.exponents(46.0),
        };
        exponents
            .into_iter()
            .flat_map(|exponent| {
                let decade = 10f64.powi(exponent as i32);
                parts.iter().map(move |part| part * decade)
            })
            .filter(|value| self.x.holds(*value))
            .map(|value| (self.x.place(value), duration(value)))
            .collect()
    }
}

/// The middle of a tick's label: below the tick, or as near as it stays whole where narrow
/// pages cut the figure off beside axes that end at `right`.
fn label_middle(tick: f64, label: &str, right: f64) -> f64 {
    tick.min(right + LABEL_GAP - 1.0 - text::width(label, TICK_SIZE) / 2.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn labels_at_the_end_of_an_axis_are_whole() {
        let right = LEFT + 300.0;
        assert_eq!(label_middle(200.0, "10 ms", right), 200.0);
        for label in ["10 ms", "100 ms", "2²²"] {
            let half = text::width(label, TICK_SIZE) / 2.0;
            let end = label_middle(right - 1.0, label, right) + half;
            assert!(end < right + LABEL_GAP, "{label} ends at {end}");
        }
    }
}
