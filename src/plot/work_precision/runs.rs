//! A curve in parts: what can be trusted, and what is drawn dotted and faint.

use super::frame::Frame;
use super::{Curve, Measured};
use crate::plot::palette::{class, colour};
use crate::plot::room::Room;
use crate::plot::svg::Canvas;

/// Points in a row that are joined in one way.
struct Run<'a> {
    points: Vec<&'a Measured>,
    faint: bool,
}

/// The runs of a curve: a step is faint where one of its ends is, and neighbours share the point
/// between them.
fn runs(curve: &Curve) -> Vec<Run<'_>> {
    let points: Vec<&Measured> = curve.drawable().collect();
    let mut runs: Vec<Run<'_>> = Vec::new();
    for pair in points.windows(2) {
        let &[from, to] = pair else { continue };
        let faint = from.faint || to.faint;
        match runs.last_mut().filter(|last| last.faint == faint) {
            Some(last) => last.points.push(to),
            None => runs.push(Run {
                points: vec![from, to],
                faint,
            }),
        }
    }
    if runs.is_empty() {
        let faint = points.iter().any(|one| one.faint);
        runs.push(Run { points, faint });
    }
    runs
}

/// Draws under the curve's class, faintly or not.
fn group(canvas: &mut Canvas, curve: &Curve, faint: bool, draw: impl FnOnce(&mut Canvas)) {
    match faint {
        true => canvas.faint_group(&class(curve.hue), draw),
        false => canvas.group(&class(curve.hue), draw),
    }
}

/// The area between the ends of the intervals.
pub fn band(canvas: &mut Canvas, curve: &Curve, frame: &Frame) {
    if curve.one_run {
        return;
    }
    for run in runs(curve) {
        let edge = |end: fn(&Measured) -> f64| {
            let place = |one: &&Measured| frame.place(one.work, end(one).max(f64::MIN_POSITIVE));
            run.points.iter().map(place).collect::<Vec<_>>()
        };
        let mut corners = edge(|one| one.low);
        corners.extend(edge(|one| one.high).iter().rev());
        let colour = colour(curve.hue);
        group(canvas, curve, run.faint, |canvas| {
            canvas.band(&corners, colour)
        });
    }
}

/// The curve with its markers; its last point.
pub fn line(
    canvas: &mut Canvas,
    curve: &Curve,
    frame: &Frame,
    room: &mut Room,
) -> Option<(f64, f64)> {
    let colour = colour(curve.hue);
    let place = |one: &Measured| frame.place(one.work, one.error);
    for run in runs(curve) {
        let placed: Vec<(f64, f64)> = run.points.iter().map(|one| place(one)).collect();
        let dash = match (run.faint, curve.one_run) {
            (true, _) => "1.5 3",
            (false, true) => "6 4",
            (false, false) => "",
        };
        group(canvas, curve, run.faint, |canvas| {
            canvas.polyline(&placed, colour, 1.7, dash);
        });
        room.line(&placed);
    }
    for faint in [true, false] {
        let marked: Vec<(f64, f64)> = curve
            .drawable()
            .filter(|one| one.faint == faint)
            .map(place)
            .collect();
        if !marked.is_empty() {
            group(canvas, curve, faint, |canvas| {
                for (x, y) in &marked {
                    canvas.marker(*x, *y, curve.hue, colour);
                }
            });
        }
    }
    curve.drawable().last().map(place)
}
