//! Point sets side by side, small and alike, so that only the points differ.

use crate::error::Result;
use crate::plot::square::{Square, dot_diameter};
use crate::plot::svg::{Anchor, BLUE, Canvas, FAINT, INK, QUIET, VERMILION};
use crate::plot::{check_count, check_points, check_values, refuse, text};

/// What a panel shows.
#[derive(Clone, Copy, Debug)]
pub enum Points<'a> {
    /// Points of the unit square, in their order.
    Square(&'a [[f32; 2]]),
    /// A sequence of the unit interval, drawn as its first 1, 2, 4, ... values below each
    /// other: as many as can be told apart.
    Line(&'a [f32]),
}

/// One of the point sets.
#[derive(Clone, Copy, Debug)]
pub struct Panel<'a> {
    /// Above the panel.
    pub title: &'a str,
    /// Below it, in as many lines as it takes.
    pub caption: &'a str,
    /// In it.
    pub points: Points<'a>,
}

/// How a gallery looks; start from `Default`.
#[derive(Clone, Debug)]
pub struct GalleryStyle<'a> {
    /// Above the figure; may be empty.
    pub title: &'a str,
    /// Panels in a row, 1 to 16.
    pub columns: usize,
    /// Side of a panel in pixels at scale 1, 80 to 2000.
    pub size: f64,
}

impl Default for GalleryStyle<'_> {
    /// Four columns, 850 pixels wide: a page of a repository.
    fn default() -> Self {
        Self {
            title: "",
            columns: 4,
            size: 190.0,
        }
    }
}

const MARGIN: f64 = 12.0;
const GAP: f64 = 22.0;
const TITLE: f64 = 14.0;
const CAPTION: f64 = 11.0;
const CAPTION_STEP: f64 = 14.5;
/// The first quarter of each set, and the rest.
const FIRST: &str = VERMILION;
const REST: &str = BLUE;

/// Panels in rows of [`GalleryStyle::columns`], as SVG. The first quarter of each set is
/// orange: of a sequence it is as even as the whole, of a set it need not be.
///
/// # Errors
///
/// [`Error::Arguments`](crate::Error::Arguments) for no panel, more than
/// [`MAX_POINTS`](crate::plot::MAX_POINTS) points in one, a point outside the square or the
/// interval, or a style out of its range.
pub fn gallery(panels: &[Panel<'_>], style: &GalleryStyle<'_>) -> Result<String> {
    check(panels, style)?;
    let side = style.size;
    let columns = style.columns.min(panels.len());
    let width = 2.0 * MARGIN + columns as f64 * (side + GAP) - GAP;
    let captions: Vec<Vec<String>> = panels
        .iter()
        .map(|panel| text::wrap(panel.caption, CAPTION, side))
        .collect();
    let lines = |row: &[Vec<String>]| row.iter().map(Vec::len).max().unwrap_or(0);
    let below: Vec<f64> = captions
        .chunks(columns)
        .map(|row| lines(row) as f64 * CAPTION_STEP)
        .collect();
    let rows = below.len() as f64;
    let heading = if style.title.is_empty() { 0.0 } else { 34.0 };
    let height = heading + rows * (side + 2.0 * TITLE + 18.0) + below.iter().sum::<f64>();

    let mut canvas = Canvas::new(width, height + 4.0);
    let title = text::shorten(style.title, 17.0, width - 2.0 * MARGIN);
    canvas.text(width / 2.0, 27.0, Anchor::Middle, 17.0, INK, &title);
    let mut top = heading;
    for (row, panels) in panels.chunks(columns).enumerate() {
        top += 2.0 * TITLE;
        for (column, panel) in panels.iter().enumerate() {
            let left = MARGIN + column as f64 * (side + GAP);
            let title = text::shorten(panel.title, TITLE, side);
            canvas.text(left, top - 8.0, Anchor::Start, TITLE, INK, &title);
            match panel.points {
                Points::Square(points) => square(&mut canvas, left, top, side, points),
                Points::Line(values) => prefixes(&mut canvas, left, top, side, values),
            }
            for (i, line) in captions[row * columns + column].iter().enumerate() {
                let y = top + side + 16.0 + i as f64 * CAPTION_STEP;
                canvas.text(left, y, Anchor::Start, CAPTION, QUIET, line);
            }
        }
        top += side + below[row] + 18.0;
    }
    Ok(canvas.finish())
}

fn check(panels: &[Panel<'_>], style: &GalleryStyle<'_>) -> Result<()> {
    if panels.is_empty() {
        return refuse(
            "a gallery of no panels".to_owned(),
            "it shows at least one",
            "give the points to show",
        );
    }
    if !(1..=16).contains(&style.columns) || !(80.0..=2000.0).contains(&style.size) {
        return refuse(
            format!(
                "a gallery of {} columns and panels of {} pixels",
                style.columns, style.size
            ),
            "it has 1 to 16 columns, and panels of 80 to 2000 pixels",
            "choose both in their ranges",
        );
    }
    for panel in panels {
        match panel.points {
            Points::Square(points) => check_points(points)?,
            Points::Line(values) => {
                check_count(values.len())?;
                check_values(values)?;
            }
        }
    }
    Ok(())
}

fn square(canvas: &mut Canvas, left: f64, top: f64, side: f64, points: &[[f32; 2]]) {
    let square = Square::new(left, top, side);
    let (first, rest) = points.split_at(points.len().div_ceil(4));
    for (part, colour) in [(rest, REST), (first, FIRST)] {
        let dots = part.iter().map(|p| {
            let [u, v] = p.map(f64::from);
            (square.x(u), square.y(v))
        });
        canvas.dots_of(dots, dot_diameter(side, points.len()), colour);
    }
    square.outline(canvas, INK, 1.0);
}

/// The first 1, 2, 4, ... values as ticks on a line each.
fn prefixes(canvas: &mut Canvas, left: f64, top: f64, side: f64, values: &[f32]) {
    // Room for the number of values at the left of each line.
    const LABEL: f64 = 26.0;
    /// Ticks nearer than this cannot be told apart.
    const NEAREST: f64 = 2.4;
    let (start, length) = (left + LABEL, side - LABEL - 8.0);
    let most = values.len().min((length / NEAREST) as usize);
    let counts: Vec<usize> = (0..=most.checked_ilog2().unwrap_or(0))
        .map(|k| (1 << k).min(most))
        .collect();
    let step = side / counts.len() as f64;
    for (row, &count) in counts.iter().enumerate() {
        let middle = top + (row as f64 + 0.5) * step;
        let half = 0.27 * step;
        canvas.line((start, middle), (start + length, middle), FAINT, 0.8);
        let label = count.to_string();
        canvas.text(start - 6.0, middle + 3.4, Anchor::End, 9.5, QUIET, &label);
        let first = counts.last().unwrap_or(&0).div_ceil(4);
        for (index, &value) in values[..count].iter().enumerate() {
            let x = start + length * f64::from(value);
            let colour = if index < first { FIRST } else { REST };
            canvas.line((x, middle - half), (x, middle + half), colour, 1.3);
        }
    }
    canvas.frame(left, top, [side; 2], INK, 1.0);
}
