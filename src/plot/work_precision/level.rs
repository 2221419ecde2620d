//! The targets and the floor: level lines with words on them.

use super::frame::{Frame, LEFT};
use super::{SMALL, WorkPrecisionStyle};
use crate::plot::numbers::scientific;
use crate::plot::room::Room;
use crate::plot::svg::{Anchor, Canvas, INK, QUIET};
use crate::plot::text;

/// A level line.
pub struct Level {
    /// Its height on the page.
    pub at: f64,
    words: String,
    class: &'static str,
    dash: &'static str,
    /// Of the line and of the words.
    colours: [&'static str; 2],
}

/// The targets that have a place, and the floor: at its height, or at the lower edge.
pub fn levels(style: &WorkPrecisionStyle<'_>, frame: &Frame) -> Vec<Level> {
    let targets = style.targets.iter().filter(|one| frame.y.holds(**one));
    let mut all: Vec<Level> = targets
        .map(|one| Level {
            at: frame.y.place(*one),
            words: format!("target {}", scientific(*one)),
            class: "target",
            dash: "",
            colours: ["#9a9a9a", QUIET],
        })
        .collect();
    let words = format!("{} {}", style.floor_name, scientific(style.floor));
    let (at, words) = match frame.y.holds(style.floor) {
        true => (frame.y.place(style.floor), words),
        false => (frame.bottom - 2.0, format!("↓ {words}")),
    };
    all.push(Level {
        at,
        words,
        class: "ink",
        dash: "8 3 2 3",
        colours: [INK, INK],
    });
    all
}

impl Level {
    /// The line across, with its words where there is room.
    pub fn draw(&self, canvas: &mut Canvas, across: f64, room: &mut Room) {
        let width = text::width(&self.words, SMALL);
        let places = [0.0, 1.0, 0.5, 0.25, 0.75].map(|part| {
            let free = across - width - 12.0;
            (LEFT + 6.0 + part * free, self.at - 4.0)
        });
        let ends = [(LEFT, self.at), (LEFT + across, self.at)];
        canvas.group(self.class, |canvas| {
            canvas.polyline(&ends, self.colours[0], 1.0, self.dash);
            if let Some((x, y)) = room.take(&places, [width, SMALL]) {
                canvas.text(x, y, Anchor::Start, SMALL, self.colours[1], &self.words);
            }
        });
    }
}
