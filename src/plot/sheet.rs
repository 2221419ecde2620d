//! Views of point sets on one page: below each other for each set, sets side by side.

use crate::error::Result;
use crate::plot::square::{QUARTERS, Square, check_cells, dot_diameter};
use crate::plot::svg::{Anchor, Canvas, INK, QUIET};
use crate::plot::{check_points, check_values, numbers, refuse, text};
use crate::plot::{pairs, power};
use crate::stats::Spectrum;

/// One way to look at a point set. Dots are coloured by their order, from dark to light.
#[derive(Clone, Copy, Debug)]
pub enum View<'a> {
    /// Two coordinates of each point in the unit square.
    Scatter {
        /// The points.
        points: &'a [[f32; 2]],
        /// Which coordinates these are, for the axes.
        dimensions: [usize; 2],
    },
    /// One coordinate of each point against the point's index.
    Sequence {
        /// The values.
        values: &'a [f32],
        /// Which coordinate this is.
        dimension: usize,
    },
    /// Every pair of coordinates, as a triangle of small scatter plots.
    Pairs {
        /// The values of each coordinate, equally many.
        columns: &'a [Vec<f32>],
        /// Which coordinates these are.
        dimensions: &'a [usize],
        /// The worst pair: it is framed and, where there is room, enlarged.
        marked: Option<[usize; 2]>,
    },
    /// The power at each frequency, as an image.
    Power(&'a Spectrum),
    /// Radial mean power and anisotropy, as curves.
    Radial(&'a Spectrum),
}

/// A point set: its views in rows, with words above and below.
#[derive(Clone, Debug)]
pub struct Stack<'a> {
    /// Above the views; may be empty.
    pub title: &'a str,
    /// Below the views, in as many lines as it takes; may be empty.
    pub caption: &'a str,
    /// The views, row by row.
    pub rows: Vec<Vec<View<'a>>>,
}

/// How a sheet looks; start from `Default`.
#[derive(Clone, Debug)]
pub struct SheetStyle<'a> {
    /// Above the figure; may be empty.
    pub title: &'a str,
    /// Side of a square in pixels at scale 1, 200 to 1000.
    pub size: f64,
    /// Columns and rows of a light grid over points, to show elementary cells.
    pub cells: Option<[u32; 2]>,
}

impl Default for SheetStyle<'_> {
    fn default() -> Self {
        Self {
            title: "",
            size: 360.0,
            cells: None,
        }
    }
}

/// Room around the axes of a view, for its title, ticks and names.
pub const LEFT: f64 = 58.0;
pub const RIGHT: f64 = 24.0;
pub const TOP: f64 = 30.0;
pub const BOTTOM: f64 = 52.0;
const EDGE: f64 = 14.0;
const CAPTION: f64 = 12.0;
const CAPTION_STEP: f64 = 16.5;

/// Stacks side by side, as SVG.
///
/// # Errors
///
/// [`Error::Arguments`](crate::Error::Arguments) for no view at all, more than
/// [`MAX_POINTS`](crate::plot::MAX_POINTS) dots in a view, a value outside [0, 1], a marked pair that is not among
/// the dimensions, or a style out of its range.
pub fn sheet(stacks: &[Stack<'_>], style: &SheetStyle<'_>) -> Result<String> {
    check(stacks, style)?;
    let sizes: Vec<[f64; 2]> = stacks.iter().map(|stack| extent(stack, style)).collect();
    let width = 2.0 * EDGE + sizes.iter().map(|size| size[0]).sum::<f64>();
    let tallest = sizes.iter().map(|size| size[1]).fold(0.0, f64::max);
    let captions: Vec<Vec<String>> = stacks
        .iter()
        .zip(&sizes)
        .map(|(stack, size)| text::wrap(stack.caption, CAPTION, size[0] - LEFT - RIGHT))
        .collect();
    let lines = captions.iter().map(Vec::len).max().unwrap_or(0) as f64;
    let heading = heading(style.title, 38.0);
    let named = stacks.iter().any(|stack| !stack.title.is_empty());
    let top = EDGE / 2.0 + heading + if named { 28.0 } else { 0.0 };
    let foot = if lines > 0.0 { 6.0 } else { 0.0 } + lines * CAPTION_STEP;

    let mut canvas = Canvas::new(width, top + tallest + foot + EDGE / 2.0);
    let title = text::shorten(style.title, 17.0, width - 2.0 * EDGE);
    canvas.text(width / 2.0, 31.0, Anchor::Middle, 17.0, INK, &title);
    let mut left = EDGE;
    for ((stack, size), caption) in stacks.iter().zip(&sizes).zip(&captions) {
        let inner = left + LEFT;
        let title = text::shorten(stack.title, 15.0, size[0] - LEFT - RIGHT);
        canvas.text(inner, top - 6.0, Anchor::Start, 15.0, INK, &title);
        let mut y = top;
        for row in &stack.rows {
            let mut x = left;
            for view in row {
                view.draw(&mut canvas, [x, y], style);
                x += view.extent(style)[0];
            }
            y += row_height(row, style);
        }
        for (index, line) in caption.iter().enumerate() {
            let y = top + tallest + 12.0 + index as f64 * CAPTION_STEP;
            canvas.text(inner, y, Anchor::Start, CAPTION, QUIET, line);
        }
        left += size[0];
    }
    Ok(canvas.finish())
}

fn heading(title: &str, height: f64) -> f64 {
    if title.is_empty() { 0.0 } else { height }
}

fn row_height(row: &[View<'_>], style: &SheetStyle<'_>) -> f64 {
    let heights = row.iter().map(|view| view.extent(style)[1]);
    heights.fold(0.0, f64::max)
}

/// Width and height of the views of a stack.
fn extent(stack: &Stack<'_>, style: &SheetStyle<'_>) -> [f64; 2] {
    let width = |row: &Vec<View<'_>>| row.iter().map(|view| view.extent(style)[0]).sum();
    [
        stack.rows.iter().map(width).fold(0.0, f64::max),
        stack.rows.iter().map(|row| row_height(row, style)).sum(),
    ]
}

fn check(stacks: &[Stack<'_>], style: &SheetStyle<'_>) -> Result<()> {
    if !(200.0..=1000.0).contains(&style.size) {
        return refuse(
            format!("squares of {} pixels", style.size),
            "a square has 200 to 1000 pixels",
            "choose a size in that range",
        );
    }
    check_cells(style.cells)?;
    let views = || stacks.iter().flat_map(|stack| stack.rows.iter().flatten());
    if views().next().is_none() {
        return refuse(
            "a sheet without views".to_owned(),
            "it shows at least one",
            "give a view",
        );
    }
    views().try_for_each(View::check)
}

impl View<'_> {
    fn check(&self) -> Result<()> {
        match *self {
            Self::Scatter { points, .. } => check_points(points),
            Self::Sequence { values, .. } => {
                crate::plot::check_count(values.len())?;
                check_values(values)
            }
            Self::Pairs {
                columns,
                dimensions,
                marked,
            } => pairs::check(columns, dimensions, marked),
            Self::Power(_) | Self::Radial(_) => Ok(()),
        }
    }

    /// Width and height with ticks and names.
    fn extent(&self, style: &SheetStyle<'_>) -> [f64; 2] {
        let side = style.size;
        let (width, height) = match self {
            Self::Scatter { .. } | Self::Radial(_) => (side, side),
            Self::Sequence { .. } => (SEQUENCE_ASPECT * side, side),
            Self::Pairs { dimensions, .. } => {
                let side = pairs::side(dimensions.len(), style.size);
                (side, side)
            }
            Self::Power(_) => (side + power::LEGEND, side),
        };
        [LEFT + width + RIGHT, TOP + height + BOTTOM]
    }

    fn draw(&self, canvas: &mut Canvas, [x, y]: [f64; 2], style: &SheetStyle<'_>) {
        let area = Square::new(x + LEFT, y + TOP, style.size);
        match *self {
            Self::Scatter { points, dimensions } => {
                let [u, v] = dimensions.map(numbers::coordinate);
                caption(canvas, area, "points");
                area.grid(canvas, style.cells);
                scatter(canvas, area, points.len(), |i| points[i]);
                area.x_axis(canvas, QUARTERS, &u);
                area.y_axis(canvas, QUARTERS, "");
                name_beside(canvas, area, &v);
            }
            Self::Sequence { values, dimension } => {
                let area = Square {
                    width: SEQUENCE_ASPECT * style.size,
                    ..area
                };
                sequence(canvas, area, values, dimension, style);
            }
            Self::Pairs {
                columns,
                dimensions,
                marked,
            } => pairs::draw(canvas, area, columns, dimensions, marked),
            Self::Power(spectrum) => power::image(canvas, area, spectrum),
            Self::Radial(spectrum) => power::curves(canvas, area, spectrum),
        }
    }
}

/// What a view shows, above it.
pub fn caption(canvas: &mut Canvas, area: Square, words: &str) {
    let (x, y) = (area.left, area.top - 9.0);
    canvas.text(x, y, Anchor::Start, 13.0, INK, words);
}

/// A frame and its dots, coloured by their order.
pub fn scatter(canvas: &mut Canvas, area: Square, count: usize, point: impl Fn(usize) -> [f32; 2]) {
    let dots = (0..count).map(|i| {
        let [u, v] = point(i).map(f64::from);
        (area.x(u), area.y(v), i as f64 / count as f64)
    });
    canvas.dots(dots, dot_diameter(area.height, count).clamp(0.9, 5.0));
    area.outline(canvas, INK, 1.2);
}

/// Width over height.
const SEQUENCE_ASPECT: f64 = 2.2;

fn sequence(
    canvas: &mut Canvas,
    area: Square,
    values: &[f32],
    dimension: usize,
    style: &SheetStyle<'_>,
) {
    let count = values.len().max(1) as f64;
    caption(canvas, area, "values in their order");
    area.grid(canvas, style.cells);
    scatter(canvas, area, values.len(), |i| {
        [((i as f64 + 0.5) / count) as f32, values[i]]
    });
    let ticks = if values.len() >= 8 && values.len().is_multiple_of(4) {
        // Quarters, like those of the values; mostly powers of two.
        let at = |i: usize| {
            (
                i as f64 / 4.0,
                numbers::grouped((i * values.len() / 4) as i64),
            )
        };
        (0..=4).map(at).collect()
    } else {
        let mut ticks = numbers::ticks(0.0, count, 8.0);
        ticks.iter_mut().for_each(|tick| tick.0 /= count);
        ticks
    };
    area.x_axis(canvas, ticks, "index");
    area.y_axis(canvas, QUARTERS, "");
    name_beside(canvas, area, &numbers::coordinate(dimension));
}

/// The name of a vertical axis between two of its quarters, lest it be read with one.
fn name_beside(canvas: &mut Canvas, area: Square, name: &str) {
    canvas.text(
        area.left - 9.0,
        area.y(0.625) + 4.5,
        Anchor::End,
        13.0,
        INK,
        name,
    );
}
