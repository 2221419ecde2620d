//! The power spectrum: an image of the frequencies, and curves over their length.

use crate::plot::numbers::ticks;
use crate::plot::sheet::caption;
use crate::plot::square::Square;
use crate::plot::svg::{Anchor, BLUE, Canvas, FAINT, HalfImage, INK, QUIET, VERMILION};
use crate::plot::text;
use crate::stats::{Ring, Spectrum};

/// Room for the legend of the image.
pub const LEGEND: f64 = 52.0;

/// The most frequencies along a side of the image: more are averaged by blocks.
const MOST: usize = 129;

/// Levels of darkness that an eye tells apart.
const LEVELS: usize = 16;

/// Darkness of a power: white for 0, half for the 1 of white noise, black without end.
fn darkness(power: f64) -> f64 {
    power / (1.0 + power)
}

/// The periodogram, frequency 0 in the middle and left white: its power is N whatever the
/// points.
pub fn image(canvas: &mut Canvas, area: Square, spectrum: &Spectrum) {
    caption(canvas, area, "power spectrum");
    let range = spectrum.range();
    // An odd block, so that one of them has frequency 0 in its middle.
    let block = (2 * range + 1).div_ceil(MOST) | 1;
    let half = (range - (block - 1) / 2) / block;
    let side = 2 * half + 1;
    let pixel = area.width / side as f64;
    let mean = |row: usize, column: usize| {
        let first = |index: usize| (index as i32 - half as i32) * block as i32 - block as i32 / 2;
        let (x, y) = (first(column), first(row));
        let powers = (0..block as i32).flat_map(|i| (0..block as i32).map(move |j| [x + i, y + j]));
        let powers = powers.filter(|f| *f != [0, 0]);
        let (sum, count) = powers.fold((0.0, 0.0), |(sum, count), [x, y]| {
            (sum + spectrum.power(x, y), count + 1.0)
        });
        if count > 0.0 { sum / count } else { 0.0 }
    };
    // The upper half and the middle row: P(-f) = P(f), so the other half is these turned.
    let rows = (half..side).map(|row| {
        (0..side)
            .map(|column| (darkness(mean(row, column)) * LEVELS as f64) as usize)
            .collect()
    });
    let rows: Vec<Vec<usize>> = rows.rev().collect();
    canvas.half_turn_image(&HalfImage {
        rows: &rows,
        colours: &(0..LEVELS).map(grey).collect::<Vec<_>>(),
        at: [area.left, area.top],
        pixel,
    });
    area.outline(canvas, INK, 1.2);
    let reach = (half * block + block / 2) as f64 + 0.5;
    let axis = |(f, label): (f64, String)| (0.5 + 0.5 * f / reach, label);
    let marks: Vec<_> = ticks(-reach, reach, 6.0).into_iter().map(axis).collect();
    area.x_axis(canvas, marks.clone(), "horizontal frequency");
    area.y_axis(canvas, marks, "");
    let x = area.left - 46.0;
    canvas.upright(x, area.y(0.5), 13.0, "vertical frequency");
    legend(canvas, area);
}

/// The scale of darkness, right of the image.
fn legend(canvas: &mut Canvas, area: Square) {
    let bar = Square {
        left: area.right() + 12.0,
        width: 11.0,
        ..area
    };
    let step = bar.height / LEVELS as f64;
    for level in 0..LEVELS {
        let top = bar.bottom() - (level + 1) as f64 * step;
        canvas.fill([bar.left, top], [bar.width, step], &grey(level));
    }
    bar.outline(canvas, INK, 1.0);
    for (power, label) in [(0.0, "0"), (0.5, "½"), (1.0, "1"), (2.0, "2"), (5.0, "5")] {
        let y = bar.y(darkness(power));
        canvas.line((bar.right(), y), (bar.right() + 3.0, y), INK, 1.0);
        let x = bar.right() + 6.0;
        canvas.text(x, y + 4.0, Anchor::Start, 11.0, INK, label);
    }
    let (x, y) = (bar.right() + 6.0, bar.top + 8.0);
    canvas.text(x, y, Anchor::Start, 11.0, INK, "∞");
}

fn grey(level: usize) -> String {
    let part = level as f64 / (LEVELS - 1) as f64;
    let mix = |dark: f64| (255.0 + part * (dark - 255.0)) as u8;
    format!("#{:02x}{:02x}{:02x}", mix(8.0), mix(20.0), mix(48.0))
}

/// The axis of the mean power, and that of the anisotropy in dB: the same in every figure,
/// so that figures compare. Curves that leave them are cut off.
const POWERS: [f64; 2] = [0.0, 3.0];
const ANISOTROPIES: [f64; 2] = [-20.0, 30.0];

/// Radial mean power above anisotropy, over the same frequencies.
pub fn curves(canvas: &mut Canvas, area: Square, spectrum: &Spectrum) {
    const BETWEEN: f64 = 34.0;
    let upper = Square {
        height: 0.55 * (area.height - BETWEEN),
        ..area
    };
    let lower = Square {
        top: upper.bottom() + BETWEEN,
        height: 0.45 * (area.height - BETWEEN),
        ..area
    };
    let reach = spectrum.range() as f64;
    let marks: Vec<(f64, String)> = ticks(0.0, reach, 6.0)
        .into_iter()
        .map(|(f, label)| (f / reach, label))
        .collect();
    let rings = spectrum.rings();
    let at = |frequency: usize| upper.x(frequency as f64 / reach);

    let peak = rings.iter().max_by(|a, b| a.power.total_cmp(&b.power));
    let words = match peak {
        Some(peak) if peak.power > POWERS[1] => format!(
            "radial mean power, up to {:.1} at {}",
            peak.power, peak.frequency
        ),
        _ => "radial mean power".to_owned(),
    };
    caption(canvas, upper, &words);
    let powers: Vec<_> = rings
        .iter()
        .map(|ring| (at(ring.frequency), ring.power))
        .collect();
    curve(canvas, upper, POWERS, 1.0, &powers, BLUE);
    reference(canvas, upper);
    upper.x_axis(canvas, marks.iter().map(|(at, _)| (*at, "")), "");

    caption(canvas, lower, "anisotropy in dB");
    let level = |ring: &Ring| match ring.power {
        // Of a ring without power only rounding is left, which has no direction.
        power if power < 1e-9 => f64::NEG_INFINITY,
        _ => ring.anisotropy_db,
    };
    let levels: Vec<_> = rings
        .iter()
        .map(|ring| (at(ring.frequency), level(ring)))
        .collect();
    curve(canvas, lower, ANISOTROPIES, 0.0, &levels, VERMILION);
    lower.x_axis(canvas, marks, "length of the frequency");
}

/// A curve of (pixel across, value), with a dashed line where white noise is.
fn curve(
    canvas: &mut Canvas,
    area: Square,
    [low, high]: [f64; 2],
    white: f64,
    values: &[(f64, f64)],
    colour: &str,
) {
    let part = |value: f64| (value - low) / (high - low);
    let heights = ticks(low, high, 5.0);
    for (height, _) in &heights {
        let y = area.y(part(*height));
        canvas.line((area.left, y), (area.right(), y), FAINT, 0.8);
    }
    let white = area.y(part(white));
    canvas.polyline(
        &[(area.left, white), (area.right(), white)],
        QUIET,
        1.0,
        DASHES,
    );
    // A ring of equal powers has an anisotropy of minus infinity: far below the frame.
    let far = low - (high - low);
    let points: Vec<(f64, f64)> = values
        .iter()
        .map(|(x, value)| (*x, area.y(part(value.max(far)))))
        .collect();
    canvas.clipped(area, |canvas| canvas.polyline(&points, colour, 1.6, ""));
    area.outline(canvas, INK, 1.2);
    let marks = heights.into_iter();
    let marks = marks.map(|(height, label)| (part(height), label));
    area.y_axis(canvas, marks, "");
}

const DASHES: &str = "5 4";

/// What the dashed line is, above the frame, where no curve comes.
fn reference(canvas: &mut Canvas, area: Square) {
    const NAME: &str = "white noise";
    let y = area.top - 9.0;
    canvas.text(area.right(), y, Anchor::End, 11.0, QUIET, NAME);
    let right = area.right() - text::width(NAME, 11.0) - 5.0;
    let line = [(right - 24.0, y - 4.0), (right, y - 4.0)];
    canvas.polyline(&line, QUIET, 1.0, DASHES);
}
