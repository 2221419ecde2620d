//! The unit square with its axes, which most figures hold.

use crate::error::Result;
use crate::plot::refuse;
use crate::plot::svg::{Anchor, Canvas, FAINT, INK};

/// Columns and rows of elementary cells.
pub type Cells = [u32; 2];

/// Refuses a grid that would be grey.
pub fn check_cells(cells: Option<Cells>) -> Result<()> {
    match cells {
        Some([columns, rows]) if columns > 1024 || rows > 1024 => refuse(
            format!("a grid of {columns} x {rows} cells"),
            "at most 1024 x 1024 can be told apart",
            "choose fewer cells",
        ),
        _ => Ok(()),
    }
}

/// The diameter of dots that neither touch everywhere nor get lost.
pub fn dot_diameter(side: f64, count: usize) -> f64 {
    (0.3 * side / (count.max(1) as f64).sqrt()).clamp(0.6, 8.0)
}

/// Where the square lies on the page; it may be wider than high.
#[derive(Clone, Copy)]
pub struct Square {
    pub left: f64,
    pub top: f64,
    pub width: f64,
    pub height: f64,
}

impl Square {
    pub fn new(left: f64, top: f64, side: f64) -> Self {
        Self {
            left,
            top,
            width: side,
            height: side,
        }
    }

    pub fn x(&self, u: f64) -> f64 {
        self.left + self.width * u
    }

    pub fn y(&self, v: f64) -> f64 {
        self.top + self.height * (1.0 - v)
    }

    pub fn right(&self) -> f64 {
        self.left + self.width
    }

    pub fn bottom(&self) -> f64 {
        self.top + self.height
    }

    pub fn outline(&self, canvas: &mut Canvas, colour: &str, width: f64) {
        canvas.frame(
            self.left,
            self.top,
            [self.width, self.height],
            colour,
            width,
        );
    }

    pub fn grid(&self, canvas: &mut Canvas, cells: Option<Cells>) {
        let [columns, rows] = cells.unwrap_or_default();
        let inner = |count: u32| (1..count).map(move |i| f64::from(i) / f64::from(count));
        for x in inner(columns).map(|u| self.x(u)) {
            canvas.line((x, self.top), (x, self.bottom()), FAINT, 0.8);
        }
        for y in inner(rows).map(|v| self.y(v)) {
            canvas.line((self.left, y), (self.right(), y), FAINT, 0.8);
        }
    }

    /// Ticks and labels of a horizontal axis: (part of the width, label).
    pub fn x_axis<S: AsRef<str>>(
        &self,
        canvas: &mut Canvas,
        ticks: impl IntoIterator<Item = (f64, S)>,
        name: &str,
    ) {
        let bottom = self.bottom();
        for (at, label) in ticks {
            let x = self.x(at);
            canvas.line((x, bottom), (x, bottom + 4.0), INK, 1.0);
            canvas.text(x, bottom + 18.0, Anchor::Middle, 12.0, INK, label.as_ref());
        }
        let middle = self.x(0.5);
        canvas.text(middle, bottom + 40.0, Anchor::Middle, 13.0, INK, name);
    }

    /// Ticks and labels of a vertical axis: (part of the height, label).
    pub fn y_axis<S: AsRef<str>>(
        &self,
        canvas: &mut Canvas,
        ticks: impl IntoIterator<Item = (f64, S)>,
        name: &str,
    ) {
        let left = self.left;
        for (at, label) in ticks {
            let y = self.y(at);
            canvas.line((left - 4.0, y), (left, y), INK, 1.0);
            canvas.text(left - 9.0, y + 4.3, Anchor::End, 12.0, INK, label.as_ref());
        }
        canvas.upright(left - 36.0, self.y(0.5), 13.0, name);
    }
}

/// Quarters of the unit interval.
pub const QUARTERS: [(f64, &str); 5] =
    [(0.0, "0"), (0.25, "¼"), (0.5, "½"), (0.75, "¾"), (1.0, "1")];
