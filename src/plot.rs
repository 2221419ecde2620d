//! Figures as SVG text, and that text as PNG.
//!
//! Points in the square, directions seen from above, and lines of error against work.
//! The SVG is written by hand: panels of equal aspect side by side and series labelled at
//! their ends are the figures that are wanted, and a few shapes draw them. Text is set in
//! DejaVu Sans, of which the binary carries a subset (`assets/fonts/`), since a
//! rasteriser without a font drops text silently.
//!
//! Colours: points take a ramp by their first coordinate, dark blue to orange, whose
//! lightness rises along it; series take the palette of Okabe and Ito. Both survive the
//! common colour-vision deficiencies.

mod axis;
mod ends;
mod gallery;
mod labels;
mod lines;
mod numbers;
mod pairs;
mod palette;
mod png;
mod power;
mod room;
mod scatter;
mod sheet;
mod square;
mod svg;
mod text;
mod tradeoff;
mod work_precision;

pub use crate::report::escape;
pub use gallery::{GalleryStyle, Panel, Points, gallery};
pub use lines::{LinesStyle, Series, error_lines};
pub use numbers::{duration, grouped, scientific};
pub use pairs::{MAX_DIMENSIONS, pairs_points};
pub use palette::dark_rules;
pub use png::to_png;
pub use scatter::{ScatterStyle, points_and_directions, scatter, scatter_directions};
pub use sheet::{SheetStyle, Stack, View, sheet};
pub use tradeoff::{Tradeoff, TradeoffStyle, tradeoff};
pub use work_precision::{
    Curve, Key, MAX_CURVES, Measured, Work, WorkPrecisionStyle, key, work_precision,
};

use crate::error::{Error, Result};

/// The most points that one scatter plot takes: more is a grey square, and a large file.
pub const MAX_POINTS: usize = 65_536;

fn refuse<T>(asked: String, limit: &str, remedy: &str) -> Result<T> {
    Err(Error::Arguments {
        asked,
        limit: limit.to_owned(),
        remedy: remedy.to_owned(),
    })
}

fn check_count(count: usize) -> Result<()> {
    if count > MAX_POINTS {
        return refuse(
            format!("a plot of {count} points"),
            &format!("a plot takes at most {MAX_POINTS}"),
            "plot the first of them",
        );
    }
    Ok(())
}

fn check_points(points: &[[f32; 2]]) -> Result<()> {
    check_count(points.len())?;
    match points
        .iter()
        .find(|p| !p.iter().all(|u| (0.0..=1.0).contains(u)))
    {
        Some([u, v]) => refuse(
            format!("a plot of the point ({u}, {v})"),
            "points lie in the unit square",
            "plot the points before they are mapped",
        ),
        None => Ok(()),
    }
}

fn check_values(values: &[f32]) -> Result<()> {
    match values.iter().find(|u| !(0.0..=1.0).contains(*u)) {
        Some(value) => refuse(
            format!("a plot of the value {value}"),
            "values lie in the unit interval",
            "plot the values before they are mapped",
        ),
        None => Ok(()),
    }
}
