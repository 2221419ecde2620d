//! Points in the square, and directions of the hemisphere seen from above.

use crate::error::Result;
use crate::plot::square::{QUARTERS, Square, check_cells, dot_diameter};
use crate::plot::svg::{Anchor, Canvas, FAINT, INK, QUIET};
use crate::plot::{check_count, check_points, refuse};

/// How a scatter plot looks; start from `Default` or [`ScatterStyle::titled`].
#[derive(Clone, Debug)]
pub struct ScatterStyle<'a> {
    /// Above the figure; may be empty.
    pub title: &'a str,
    /// Below the horizontal axis.
    pub x_label: &'a str,
    /// Left of the vertical axis.
    pub y_label: &'a str,
    /// Side of a panel in pixels at scale 1, 120 to 4000.
    pub size: f64,
    /// Diameter of a dot in pixels; `None` chooses it by the number of points.
    pub dot: Option<f64>,
    /// Columns and rows of a light grid over the square, to show elementary cells.
    pub cells: Option<[u32; 2]>,
}

impl Default for ScatterStyle<'_> {
    fn default() -> Self {
        Self {
            title: "",
            x_label: "u",
            y_label: "v",
            size: 400.0,
            dot: None,
            cells: None,
        }
    }
}

impl<'a> ScatterStyle<'a> {
    /// The default look with a title.
    #[must_use]
    pub fn titled(title: &'a str) -> Self {
        Self {
            title,
            ..Self::default()
        }
    }

    fn check(&self) -> Result<()> {
        if !(120.0..=4000.0).contains(&self.size) {
            return refuse(
                format!("a panel of {} pixels", self.size),
                "panels have 120 to 4000 pixels",
                "choose a size in that range",
            );
        }
        check_cells(self.cells)
    }

    fn dot_for(&self, count: usize) -> f64 {
        self.dot
            .filter(|dot| dot.is_finite())
            .map_or(dot_diameter(self.size, count), |dot| dot.clamp(0.6, 8.0))
    }
}

/// Points in the unit square, as SVG.
///
/// # Errors
///
/// [`Error::Arguments`](crate::Error::Arguments) for more than [`MAX_POINTS`](crate::plot::MAX_POINTS) points, one outside [0, 1]^2, or a
/// style out of its range.
pub fn scatter(points: &[[f32; 2]], style: &ScatterStyle<'_>) -> Result<String> {
    check_points(points)?;
    let mut figure = Figure::new(1, style)?;
    figure.square(0, points, "");
    Ok(figure.finish())
}

/// Directions of the upper hemisphere seen from above (+z towards the viewer), as SVG.
/// The style's labels and cells belong to the square and are not used.
///
/// # Errors
///
/// [`Error::Arguments`](crate::Error::Arguments) for more than [`MAX_POINTS`](crate::plot::MAX_POINTS) directions, one that is not of unit
/// length, or a style out of its range.
pub fn scatter_directions(directions: &[[f32; 3]], style: &ScatterStyle<'_>) -> Result<String> {
    check_directions(directions)?;
    let mut figure = Figure::new(1, style)?;
    let shades = directions.iter().map(|d| 0.5 + 0.5 * f64::from(d[0]));
    figure.disk(0, directions, shades, "");
    Ok(figure.finish())
}

/// Points and the directions made of them, side by side, as SVG. A direction has the
/// colour of its point, so the figure shows where the map takes the square.
///
/// # Errors
///
/// As [`scatter`] and [`scatter_directions`], and [`Error::Arguments`](crate::Error::Arguments) if there are not as many
/// directions as points.
pub fn points_and_directions(
    points: &[[f32; 2]],
    directions: &[[f32; 3]],
    style: &ScatterStyle<'_>,
) -> Result<String> {
    check_points(points)?;
    check_directions(directions)?;
    if points.len() != directions.len() {
        return refuse(
            format!(
                "{} points beside {} directions",
                points.len(),
                directions.len()
            ),
            "each point has one direction",
            "give as many of one as of the other",
        );
    }
    let mut figure = Figure::new(2, style)?;
    figure.square(0, points, "points in the unit square");
    let shades = points.iter().map(|p| f64::from(p[0]));
    figure.disk(1, directions, shades, "directions seen from above");
    Ok(figure.finish())
}

fn check_directions(directions: &[[f32; 3]]) -> Result<()> {
    check_count(directions.len())?;
    let length = |d: &[f32; 3]| d.iter().map(|x| f64::from(*x).powi(2)).sum::<f64>().sqrt();
    match directions
        .iter()
        .find(|d| !(0.999..=1.001).contains(&length(d)))
    {
        Some([x, y, z]) => refuse(
            format!("a plot of the direction ({x}, {y}, {z})"),
            "directions have unit length",
            "normalise it",
        ),
        None => Ok(()),
    }
}

/// Panels of one size in a row, below a title.
struct Figure<'a> {
    canvas: Canvas,
    style: &'a ScatterStyle<'a>,
    top: f64,
}

const LEFT: f64 = 58.0;
const RIGHT: f64 = 24.0;
const BOTTOM: f64 = 52.0;

impl<'a> Figure<'a> {
    fn new(panels: u32, style: &'a ScatterStyle<'a>) -> Result<Self> {
        style.check()?;
        let titles = if panels > 1 { 26.0 } else { 0.0 };
        let top = titles + if style.title.is_empty() { 20.0 } else { 50.0 };
        let width = f64::from(panels) * (LEFT + style.size + RIGHT);
        let mut canvas = Canvas::new(width, top + style.size + BOTTOM);
        canvas.text(width / 2.0, 31.0, Anchor::Middle, 17.0, INK, style.title);
        Ok(Self { canvas, style, top })
    }

    /// Left and top of a panel, with its title drawn.
    fn panel(&mut self, index: u32, title: &str) -> (f64, f64) {
        let size = self.style.size;
        let left = LEFT + f64::from(index) * (LEFT + size + RIGHT);
        self.canvas.text(
            left + size / 2.0,
            self.top - 13.0,
            Anchor::Middle,
            13.0,
            INK,
            title,
        );
        (left, self.top)
    }

    fn square(&mut self, index: u32, points: &[[f32; 2]], title: &str) {
        let (left, top) = self.panel(index, title);
        let square = Square::new(left, top, self.style.size);
        let canvas = &mut self.canvas;
        square.grid(canvas, self.style.cells);
        let dots = points.iter().map(|p| {
            let [u, v] = p.map(f64::from);
            (square.x(u), square.y(v), u)
        });
        canvas.dots(dots, self.style.dot_for(points.len()));
        square.outline(canvas, INK, 1.2);
        square.x_axis(canvas, QUARTERS, self.style.x_label);
        square.y_axis(canvas, QUARTERS, self.style.y_label);
    }

    fn disk(
        &mut self,
        index: u32,
        directions: &[[f32; 3]],
        shades: impl Iterator<Item = f64>,
        title: &str,
    ) {
        let (left, top) = self.panel(index, title);
        let radius = self.style.size / 2.0;
        let (cx, cy) = (left + radius, top + radius);
        let canvas = &mut self.canvas;
        canvas.frame(left, top, [2.0 * radius; 2], FAINT, 0.8);
        canvas.line((cx - radius, cy), (cx + radius, cy), FAINT, 0.8);
        canvas.line((cx, cy - radius), (cx, cy + radius), FAINT, 0.8);
        // Rings of polar angle 30 and 60 degrees; the rim is the horizon.
        for sine in [0.5, 0.75_f64.sqrt()] {
            canvas.circle(cx, cy, radius * sine, FAINT, 0.8);
        }
        let dots = directions.iter().zip(shades).map(|(d, shade)| {
            let [x, y, _] = d.map(f64::from);
            (cx + radius * x, cy - radius * y, shade)
        });
        canvas.dots(dots, self.style.dot_for(directions.len()));
        canvas.circle(cx, cy, radius, INK, 1.2);
        let bottom = cy + radius;
        if radius >= 150.0 {
            // In the corner, where no direction is.
            let rings = "θ = 30°, 60°, 90°";
            canvas.text(
                cx + radius - 7.0,
                bottom - 8.0,
                Anchor::End,
                11.0,
                QUIET,
                rings,
            );
        }
        let square = Square::new(left, top, 2.0 * radius);
        let ticks = [(0.0, "−1"), (0.5, "0"), (1.0, "1")];
        square.x_axis(canvas, ticks, "x");
        square.y_axis(canvas, ticks, "y");
    }

    fn finish(self) -> String {
        self.canvas.finish()
    }
}
