//! Projections to every pair of coordinates, as a triangle of small scatter plots.

use crate::error::Result;
use crate::plot::numbers::coordinate;
use crate::plot::sheet::{caption, scatter};
use crate::plot::square::Square;
use crate::plot::svg::{Anchor, Canvas, INK, VERMILION};
use crate::plot::{MAX_POINTS, check_count, check_values, refuse};

/// The most coordinates that are shown: 120 pairs, each of the size of a thumbnail.
pub const MAX_DIMENSIONS: usize = 16;

const GAP: f64 = 8.0;

pub fn check(columns: &[Vec<f32>], dimensions: &[usize], marked: Option<[usize; 2]>) -> Result<()> {
    if !(2..=MAX_DIMENSIONS).contains(&dimensions.len()) || columns.len() != dimensions.len() {
        return refuse(
            format!(
                "pairs of {} dimensions of {} columns",
                dimensions.len(),
                columns.len()
            ),
            &format!("a plot of pairs takes 2 to {MAX_DIMENSIONS}, each with its column"),
            "choose some of them",
        );
    }
    let count = columns[0].len();
    if columns.iter().any(|column| column.len() != count) {
        return refuse(
            "columns of different lengths".to_owned(),
            "each point has every coordinate",
            "give equally many values of each",
        );
    }
    check_count(count * dimensions.len() * (dimensions.len() - 1) / 2)?;
    columns.iter().try_for_each(|column| check_values(column))?;
    if let Some([a, b]) = marked
        && (a == b || !dimensions.contains(&a) || !dimensions.contains(&b))
    {
        return refuse(
            format!("the pair {a}, {b} marked"),
            "a marked pair is two of the dimensions that are shown",
            "mark one of those",
        );
    }
    Ok(())
}

/// The side of the triangle for so many dimensions, where a single square has `single`.
pub fn side(dimensions: usize, single: f64) -> f64 {
    match dimensions {
        0..=2 => single,
        3 => 1.6 * single,
        _ => 2.2 * single,
    }
}

/// How many points a projection shows with room between them: a power of two, at which
/// sequences are even.
///
/// `dimensions` is the number of those shown, `size` that of the style.
#[must_use]
pub fn pairs_points(dimensions: usize, size: f64) -> usize {
    const SPACING: f64 = 3.0;
    let budget = MAX_POINTS / (dimensions * dimensions.saturating_sub(1) / 2).max(1);
    let room = (cell(dimensions, size) / SPACING).powi(2) as usize;
    1 << budget.min(room).max(1).ilog2()
}

fn cell(dimensions: usize, size: f64) -> f64 {
    let count = dimensions.saturating_sub(1).max(1) as f64;
    (side(dimensions, size) - GAP * (count - 1.0)) / count
}

/// Rows are the coordinates from the second on, columns those up to the last but one; the
/// marked pair is repeated large in the free corner.
pub fn draw(
    canvas: &mut Canvas,
    area: Square,
    columns: &[Vec<f32>],
    dimensions: &[usize],
    marked: Option<[usize; 2]>,
) {
    let count = dimensions.len() - 1;
    let whole = side(dimensions.len(), area.width);
    let cell = cell(dimensions.len(), area.width);
    let step = cell + GAP;
    caption(
        canvas,
        Square::new(area.left, area.top, whole),
        "projections to pairs of dimensions",
    );
    let points = columns[0].len();
    let is_marked = |a: usize, b: usize| {
        marked.is_some_and(|pair| {
            let [a, b] = [dimensions[a], dimensions[b]];
            pair == [a, b] || pair == [b, a]
        })
    };
    for row in 1..=count {
        for column in 0..row {
            let square = Square::new(
                area.left + column as f64 * step,
                area.top + (row - 1) as f64 * step,
                cell,
            );
            scatter(canvas, square, points, |i| {
                [columns[column][i], columns[row][i]]
            });
            if is_marked(column, row) {
                square.outline(canvas, VERMILION, 2.6);
            }
        }
    }
    let small = if cell < 60.0 { 11.0 } else { 13.0 };
    for (index, dimension) in dimensions.iter().enumerate() {
        let name = coordinate(*dimension);
        if index < count {
            let x = area.left + index as f64 * step + cell / 2.0;
            let y = area.top + whole + 18.0;
            canvas.text(x, y, Anchor::Middle, small, INK, &name);
        }
        if index > 0 {
            let y = area.top + (index - 1) as f64 * step + cell / 2.0 + 4.5;
            canvas.text(area.left - 9.0, y, Anchor::End, small, INK, &name);
        }
    }
    let free = count / 2;
    let find = |dimension: usize| dimensions.iter().position(|d| *d == dimension);
    if let Some([a, b]) = marked
        && let (Some(a), Some(b)) = (find(a), find(b))
        && free > 0
        && count > 2
    {
        let (a, b) = (a.min(b), a.max(b));
        // Room for its axes' names at the left and below.
        let large = free as f64 * step - GAP - 20.0;
        let square = Square::new(area.left + whole - large, area.top, large);
        scatter(canvas, square, points, |i| [columns[a][i], columns[b][i]]);
        square.outline(canvas, VERMILION, 2.6);
        let [u, v] = [a, b].map(|i| coordinate(dimensions[i]));
        caption(canvas, square, &format!("worst pair: {u}, {v}"));
        let (x, y) = (square.x(0.5), square.bottom() + 15.0);
        canvas.text(x, y, Anchor::Middle, small, INK, &u);
        let (x, y) = (square.left - 8.0, square.y(0.5) + 4.5);
        canvas.text(x, y, Anchor::End, small, INK, &v);
    }
}
