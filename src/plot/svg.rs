//! A page of SVG: the few shapes that the figures need.

mod described;

use crate::plot::square::Square;
use crate::report::escape;
use std::fmt::Write;

/// Axes and text.
pub const INK: &str = "#222222";
/// Text of less weight.
pub const QUIET: &str = "#666666";
/// Grids.
pub const FAINT: &str = "#d4d4d4";
/// Two of Okabe and Ito, for what stands against the rest.
pub const BLUE: &str = "#0072b2";
pub const VERMILION: &str = "#d55e00";

/// Which part of a text stands at its position.
#[derive(Clone, Copy)]
pub enum Anchor {
    Start,
    Middle,
    End,
}

impl Anchor {
    fn name(self) -> &'static str {
        match self {
            Self::Start => "start",
            Self::Middle => "middle",
            Self::End => "end",
        }
    }
}

/// The upper half of an image that looks the same upside down.
pub struct HalfImage<'a> {
    /// Levels from the first row to the middle one.
    pub rows: &'a [Vec<usize>],
    /// The colour of each level.
    pub colours: &'a [String],
    /// Left and top.
    pub at: [f64; 2],
    /// Side of a pixel.
    pub pixel: f64,
}

/// SVG text under construction; y grows downwards.
pub struct Canvas {
    width: f64,
    height: f64,
    body: String,
}

// Writing to a String cannot fail, so the results of `write!` are dropped.
impl Canvas {
    pub fn new(width: f64, height: f64) -> Self {
        // A sum of decimals may be a hair above its whole number.
        let whole = |side: f64| (side - 1e-6).ceil();
        Self {
            width: whole(width),
            height: whole(height),
            body: String::new(),
        }
    }

    pub fn text(&mut self, x: f64, y: f64, anchor: Anchor, size: f64, colour: &str, text: &str) {
        if text.is_empty() {
            return;
        }
        let _ = writeln!(
            self.body,
            r#"<text x="{x:.2}" y="{y:.2}" text-anchor="{}" font-size="{size}" fill="{colour}">{}</text>"#,
            anchor.name(),
            escape(text)
        );
    }

    /// The label of a vertical axis: a word turned to read upwards, a letter as it is.
    pub fn upright(&mut self, x: f64, y: f64, size: f64, text: &str) {
        if text.chars().count() < 3 {
            return self.text(x, y + 0.36 * size, Anchor::Middle, size, INK, text);
        }
        let _ = writeln!(
            self.body,
            r#"<g transform="translate({x:.2} {y:.2}) rotate(-90)">"#
        );
        self.text(0.0, 0.0, Anchor::Middle, size, INK, text);
        self.body.push_str("</g>\n");
    }

    pub fn line(&mut self, from: (f64, f64), to: (f64, f64), colour: &str, width: f64) {
        let _ = writeln!(
            self.body,
            r#"<path d="M{:.2} {:.2}L{:.2} {:.2}" stroke="{colour}" stroke-width="{width}"/>"#,
            from.0, from.1, to.0, to.1
        );
    }

    /// A broken line through points; `dash` as in SVG, empty for none.
    pub fn polyline(&mut self, points: &[(f64, f64)], colour: &str, width: f64, dash: &str) {
        let mut path = String::new();
        for (i, (x, y)) in points.iter().enumerate() {
            let _ = write!(path, "{}{x:.2} {y:.2}", if i == 0 { 'M' } else { 'L' });
        }
        let _ = writeln!(
            self.body,
            r#"<path d="{path}" fill="none" stroke="{colour}" stroke-width="{width}" stroke-linejoin="round" stroke-dasharray="{}"/>"#,
            if dash.is_empty() { "none" } else { dash }
        );
    }

    /// The outline of a rectangle.
    pub fn frame(&mut self, x: f64, y: f64, size: [f64; 2], colour: &str, width: f64) {
        let _ = writeln!(
            self.body,
            r#"<rect x="{x:.2}" y="{y:.2}" width="{:.2}" height="{:.2}" fill="none" stroke="{colour}" stroke-width="{width}"/>"#,
            size[0], size[1]
        );
    }

    pub fn circle(&mut self, x: f64, y: f64, radius: f64, colour: &str, width: f64) {
        let _ = writeln!(
            self.body,
            r#"<circle cx="{x:.2}" cy="{y:.2}" r="{radius:.2}" fill="none" stroke="{colour}" stroke-width="{width}"/>"#
        );
    }

    /// A filled marker; another shape for each kind, so that colour is not all.
    pub fn marker(&mut self, x: f64, y: f64, kind: usize, colour: &str) {
        let corners: &[(f64, f64)] = match kind % 4 {
            0 => {
                let _ = writeln!(
                    self.body,
                    r#"<circle cx="{x:.2}" cy="{y:.2}" r="3.6" fill="{colour}"/>"#
                );
                return;
            }
            1 => &[(-3.2, -3.2), (3.2, -3.2), (3.2, 3.2), (-3.2, 3.2)],
            2 => &[(0.0, -4.4), (4.1, 3.0), (-4.1, 3.0)],
            _ => &[(0.0, -4.6), (4.6, 0.0), (0.0, 4.6), (-4.6, 0.0)],
        };
        let corners: Vec<String> = corners
            .iter()
            .map(|(dx, dy)| format!("{:.2},{:.2}", x + dx, y + dy))
            .collect();
        let _ = writeln!(
            self.body,
            r#"<polygon points="{}" fill="{colour}"/>"#,
            corners.join(" ")
        );
    }

    /// Dots at (x, y) with a shade in [0, 1]: a path per shade, of strokes of no
    /// length with round ends, which is a quarter of the bytes of circles.
    pub fn dots(&mut self, dots: impl Iterator<Item = (f64, f64, f64)>, diameter: f64) {
        const SHADES: usize = 24;
        let mut shades = vec![Vec::new(); SHADES];
        for (x, y, shade) in dots {
            let index = ((shade * SHADES as f64) as usize).min(SHADES - 1);
            shades[index].push((x, y));
        }
        for (index, dots) in shades.iter().enumerate() {
            let colour = ramp((index as f64 + 0.5) / SHADES as f64);
            self.dots_of(dots.iter().copied(), diameter, &colour);
        }
    }

    /// Dots of one colour.
    pub fn dots_of(&mut self, dots: impl Iterator<Item = (f64, f64)>, diameter: f64, colour: &str) {
        let mut path = String::new();
        for (x, y) in dots {
            let _ = write!(path, "M{x:.2} {y:.2}h0");
        }
        if !path.is_empty() {
            let _ = writeln!(
                self.body,
                r#"<path d="{path}" fill="none" stroke="{colour}" stroke-width="{diameter:.2}" stroke-linecap="round"/>"#
            );
        }
    }

    /// A rectangle without an outline.
    pub fn fill(&mut self, [x, y]: [f64; 2], size: [f64; 2], colour: &str) {
        let _ = writeln!(
            self.body,
            r#"<rect x="{x:.2}" y="{y:.2}" width="{:.2}" height="{:.2}" fill="{colour}" shape-rendering="crispEdges"/>"#,
            size[0], size[1]
        );
    }

    /// What `draw` draws within a rectangle, in coordinates of the page.
    pub fn clipped(&mut self, area: Square, draw: impl FnOnce(&mut Self)) {
        let Square {
            left,
            top,
            width,
            height,
        } = area;
        let place = format!("{left:.2} {top:.2} {width:.2} {height:.2}");
        let _ = writeln!(
            self.body,
            r#"<svg x="{left:.2}" y="{top:.2}" width="{width:.2}" height="{height:.2}" viewBox="{place}">"#
        );
        draw(self);
        self.body.push_str("</svg>\n");
    }

    /// An image of levels, of which the rows down to the middle one are given: the others
    /// are these turned by 180 degrees. Level 0 stays white. A path per level, with a
    /// stroke per run of pixels: for noise that is less than a compressed image in base 64.
    pub fn half_turn_image(&mut self, image: &HalfImage<'_>) {
        let HalfImage {
            rows,
            colours,
            at: [x, y],
            pixel,
        } = *image;
        let side = rows.first().map_or(0, Vec::len);
        let id = self.body.len();
        let _ = writeln!(
            self.body,
            r#"<g transform="translate({x:.2} {y:.2}) scale({pixel:.5})" fill="none" shape-rendering="crispEdges"><g id="half{id}">"#
        );
        for (level, colour) in colours.iter().enumerate().skip(1) {
            let mut path = String::new();
            for (row, levels) in rows.iter().enumerate() {
                let mut column = 0;
                for run in levels.chunk_by(|a, b| a == b) {
                    if run[0] == level {
                        let _ = write!(path, "M{column} {row}.5h{}", run.len());
                    }
                    column += run.len();
                }
            }
            if !path.is_empty() {
                let _ = writeln!(self.body, r#"<path d="{path}" stroke="{colour}"/>"#);
            }
        }
        let middle = side as f64 / 2.0;
        let _ = writeln!(
            self.body,
            r##"</g><use href="#half{id}" transform="rotate(180 {middle} {middle})"/></g>"##
        );
    }

    pub fn finish(self) -> String {
        let Self {
            width,
            height,
            body,
        } = self;
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
             viewBox=\"0 0 {width} {height}\" font-family=\"DejaVu Sans, Verdana, sans-serif\">\n\
             <rect width=\"{width}\" height=\"{height}\" fill=\"#ffffff\"/>\n{body}</svg>\n"
        )
    }
}

/// Dark blue to orange, of rising lightness.
fn ramp(shade: f64) -> String {
    const STOPS: [[f64; 3]; 5] = [
        [13.0, 8.0, 135.0],
        [106.0, 0.0, 168.0],
        [177.0, 42.0, 144.0],
        [225.0, 100.0, 98.0],
        [247.0, 150.0, 50.0],
    ];
    let place = shade.clamp(0.0, 1.0) * (STOPS.len() - 1) as f64;
    let from = (place as usize).min(STOPS.len() - 2);
    let part = place - from as f64;
    let mix = |i: usize| (STOPS[from][i] + part * (STOPS[from + 1][i] - STOPS[from][i])) as u8;
    format!("#{:02x}{:02x}{:02x}", mix(0), mix(1), mix(2))
}
