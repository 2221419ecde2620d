//! Figures are well formed, of the right size, and their text is drawn.

#[path = "plot/boxes.rs"]
mod boxes;
#[path = "plot/gallery.rs"]
mod gallery;
#[path = "plot/shapes.rs"]
mod shapes;
#[path = "plot/sheet.rs"]
mod sheet;
#[path = "plot/tradeoff.rs"]
mod tradeoff;
#[path = "plot/work_precision.rs"]
mod work_precision;

use corput::Error;
use corput::plot::{
    LinesStyle, MAX_POINTS, ScatterStyle, Series, error_lines, points_and_directions, scatter,
    scatter_directions, to_png,
};
use resvg::tiny_skia::Pixmap;
use resvg::usvg::{Options, Tree};

fn radical_inverse(base: u32, mut n: u32) -> f64 {
    let (mut value, mut scale) = (0.0, 1.0);
    while n > 0 {
        scale /= f64::from(base);
        value += f64::from(n % base) * scale;
        n /= base;
    }
    value
}

fn halton(count: u32) -> Vec<[f32; 2]> {
    (0..count)
        .map(|n| [2, 3].map(|base| radical_inverse(base, n) as f32))
        .collect()
}

/// The concentric map of the square to the disk, lifted to the hemisphere.
fn cosine_weighted([u, v]: [f32; 2]) -> [f32; 3] {
    let (a, b) = (2.0 * f64::from(u) - 1.0, 2.0 * f64::from(v) - 1.0);
    let quarter = std::f64::consts::FRAC_PI_4;
    let (r, p) = if a == 0.0 && b == 0.0 {
        (0.0, 0.0)
    } else if a.abs() > b.abs() {
        (a, quarter * b / a)
    } else {
        (b, 2.0 * quarter - quarter * a / b)
    };
    [r * p.cos(), r * p.sin(), (1.0 - r * r).max(0.0).sqrt()].map(|x| x as f32)
}

/// Root-mean-square errors of the mean of u v, as a plot would have them.
fn series() -> Vec<Series> {
    type Law = fn(f64) -> f64;
    let laws: [(&str, Law); 3] = [
        ("Halton (2, 3)", |n| 0.7 * (n.log2() / 4.0) / n),
        ("random", |n| 0.22 / n.sqrt()),
        ("Hammersley", |n| 0.55 * (n.log2() / 4.0) / n),
    ];
    laws.map(|(name, law)| Series {
        name: name.to_owned(),
        points: (10..=20)
            .map(|k| f64::from(1 << k))
            .map(|n| (n, law(n)))
            .collect(),
    })
    .to_vec()
}

const LINES: LinesStyle<'_> = LinesStyle {
    title: "Irradiance of sunrise.exr, normal +z",
    x_label: "directions N",
    y_label: "relative error",
    size: [520.0, 360.0],
    slopes: &[("∝ 1/√N", -0.5), ("∝ 1/N", -1.0)],
};

/// The SVG parses, and its PNG has its size times the scale; saved where `CORPUT_PLOTS` says.
fn drawn(name: &str, svg: &str, size: [u32; 2]) -> Pixmap {
    let tree = Tree::from_str(svg, &Options::default()).unwrap();
    assert_eq!(
        [tree.size().width(), tree.size().height()],
        size.map(|s| s as f32),
        "{name}"
    );
    let png = to_png(svg, 2.0).unwrap();
    if let Ok(folder) = std::env::var("CORPUT_PLOTS") {
        std::fs::write(format!("{folder}/{name}.svg"), svg).unwrap();
        std::fs::write(format!("{folder}/{name}.png"), &png).unwrap();
    }
    let pixels = Pixmap::decode_png(&png).unwrap();
    assert_eq!(
        [pixels.width(), pixels.height()],
        size.map(|s| 2 * s),
        "{name}"
    );
    pixels
}

/// Refused, in words that hold this part.
fn refused<T>(result: corput::Result<T>, part: &str) {
    match result {
        Err(error @ Error::Arguments { .. }) => {
            assert!(error.to_string().contains(part), "`{error}` lacks `{part}`");
        }
        Err(other) => panic!("{other}"),
        Ok(_) => panic!("not refused: {part}"),
    }
}

#[test]
fn points_are_drawn_in_the_square() {
    let style = ScatterStyle {
        cells: Some([8, 9]),
        ..ScatterStyle::titled("Halton (2, 3), N = 576")
    };
    drawn(
        "square",
        &scatter(&halton(576), &style).unwrap(),
        [482, 502],
    );
    drawn(
        "none",
        &scatter(&[], &ScatterStyle::default()).unwrap(),
        [482, 472],
    );
    let corners = [[0.0, 0.0], [1.0, 1.0], [0.0, 1.0], [1.0, 0.0]];
    drawn(
        "corners",
        &scatter(&corners, &ScatterStyle::default()).unwrap(),
        [482, 472],
    );
}

#[test]
fn directions_are_drawn_from_above() {
    let directions: Vec<_> = halton(4096).into_iter().map(cosine_weighted).collect();
    let style = ScatterStyle::titled("cosine-weighted directions, N = 4096");
    drawn(
        "disk",
        &scatter_directions(&directions, &style).unwrap(),
        [482, 502],
    );
}

#[test]
fn points_stand_beside_their_directions() {
    let points = halton(1024);
    let directions: Vec<_> = points.iter().copied().map(cosine_weighted).collect();
    let style = ScatterStyle::titled("Halton (2, 3) → cosine-weighted hemisphere, N = 1024");
    let svg = points_and_directions(&points, &directions, &style).unwrap();
    drawn("both", &svg, [964, 528]);
    assert!(svg.len() < 60_000, "{} bytes", svg.len());
}

#[test]
fn dots_lie_where_their_points_are() {
    // One dot of 8 pixels in each panel; the ramp's colours are far from greys.
    let style = ScatterStyle {
        dot: Some(8.0),
        ..ScatterStyle::default()
    };
    let svg = points_and_directions(&[[0.3, 0.9]], &[[0.6, -0.64, 0.48]], &style).unwrap();
    let pixels = drawn("one", &svg, [964, 498]);
    let is_coloured = |x: f64, y: f64| {
        let pixel = pixels.pixel((2.0 * x) as u32, (2.0 * y) as u32).unwrap();
        pixel.red().abs_diff(pixel.green()) > 60
    };
    let top = 46.0;
    assert!(is_coloured(58.0 + 400.0 * 0.3, top + 400.0 * 0.1));
    assert!(!is_coloured(58.0 + 400.0 * 0.3, top + 400.0 * 0.2));
    assert!(is_coloured(58.0 + 482.0 + 200.0 * 1.6, top + 200.0 * 1.64));
}

#[test]
fn lines_are_labelled_at_their_ends() {
    let svg = error_lines(&series(), &LINES).unwrap();
    let tree = Tree::from_str(&svg, &Options::default()).unwrap();
    drawn("lines", &svg, [tree.size().width() as u32, 468]);
    for name in ["Halton (2, 3)", "random", "Hammersley", "∝ 1/N"] {
        assert!(svg.contains(name), "{name}");
    }
    assert!(svg.contains("2¹⁰") && svg.contains("10⁻³"), "ticks");
    // Labels of lines that end at one height stand apart.
    let same = |name: &str| Series {
        name: name.to_owned(),
        points: vec![(1.0, 0.5), (3.0, 1e-3)],
    };
    let crowd: Vec<Series> = ["a", "b", "c", "d", "e"].map(same).to_vec();
    let svg = error_lines(&crowd, &LinesStyle::default()).unwrap();
    let mut heights: Vec<f64> = svg
        .lines()
        .filter(|line| line.contains("font-size=\"12.5\""))
        .filter_map(|line| line.split(" y=\"").nth(1)?.split('"').next()?.parse().ok())
        .collect();
    heights.sort_by(f64::total_cmp);
    assert_eq!(heights.len(), 5);
    assert!(
        heights.windows(2).all(|pair| pair[1] - pair[0] > 12.5),
        "{heights:?}"
    );
    drawn("crowd", &svg, [634, 436]);
}

#[test]
fn text_is_drawn() {
    let blank = |text: &str| {
        let mut bare = String::new();
        for line in text.lines().filter(|line| !line.starts_with("<text")) {
            bare.push_str(line);
            bare.push('\n');
        }
        bare
    };
    let svg = error_lines(&series(), &LINES).unwrap();
    assert_ne!(
        to_png(&svg, 1.0).unwrap(),
        to_png(&blank(&svg), 1.0).unwrap()
    );
    // Each sign of a figure leaves ink of its own, that of no missing glyph.
    let sign = |text: &str| {
        let svg = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"60\" height=\"40\" \
             font-family=\"DejaVu Sans, sans-serif\"><text x=\"5\" y=\"30\" font-size=\"30\">{text}</text></svg>"
        );
        to_png(&svg, 1.0).unwrap()
    };
    let (empty, missing) = (sign(" "), sign("\u{4e00}"));
    let mut seen = vec![empty, missing];
    for character in "aZ09%ωφθπΣΩ°±·×−→↑∝≈≤≥√∞∫½¼¾⁰¹²³⁴⁵⁶⁷⁸⁹⁻₀₁₂₃₄₅₆₇₈₉…’".chars()
    {
        let ink = sign(&character.to_string());
        assert!(!seen.contains(&ink), "`{character}` is missing in the font");
        seen.push(ink);
    }
}

#[test]
fn markup_in_text_stays_text() {
    let style = ScatterStyle {
        x_label: "a < b & \"c\" \u{0}\u{7}",
        ..ScatterStyle::titled("</svg>")
    };
    let svg = scatter(&halton(4), &style).unwrap();
    drawn("markup", &svg, [482, 502]);
    assert!(svg.contains("&lt;/svg&gt;") && svg.contains("a &lt; b &amp; &quot;c&quot;"));
}

#[test]
fn bad_input_is_refused() {
    let plain = ScatterStyle::default();
    refused(
        scatter(&vec![[0.0; 2]; MAX_POINTS + 1], &plain),
        "65537 points",
    );
    for bad in [f32::NAN, -0.1, 1.5, f32::INFINITY] {
        refused(scatter(&[[0.5, bad]], &plain), "unit square");
        refused(
            scatter_directions(&[[bad, 0.3, 0.2]], &plain),
            "unit length",
        );
    }
    refused(
        points_and_directions(&halton(3), &[[0.0, 0.0, 1.0]], &plain),
        "3 points",
    );
    for size in [f64::NAN, 0.0, -1.0, 1e9] {
        refused(
            scatter(
                &[],
                &ScatterStyle {
                    size,
                    ..plain.clone()
                },
            ),
            "120 to 4000",
        );
    }
    refused(
        scatter(
            &[],
            &ScatterStyle {
                cells: Some([2, u32::MAX]),
                ..plain.clone()
            },
        ),
        "cells",
    );
    refused(error_lines(&[], &LINES), "positive and finite");
    let zero = Series {
        name: "exact".to_owned(),
        points: vec![(1.0, 0.0), (f64::NAN, 1.0)],
    };
    refused(error_lines(&[zero], &LINES), "positive and finite");
    let svg = scatter(&[], &plain).unwrap();
    for scale in [0.0, -1.0, f32::NAN, f32::INFINITY, 1e4] {
        refused(to_png(&svg, scale), "16384 pixels");
    }
    refused(to_png("no picture", 1.0), "no SVG");
}

#[test]
fn extreme_lines_are_drawn() {
    for points in [
        vec![(1.0, 1.0)],
        vec![(5e-324, 1e308), (1e308, 5e-324)],
        vec![(1024.0, 1e-3), (1024.0, 1e-3)],
    ] {
        let one = Series {
            name: "one".to_owned(),
            points,
        };
        let svg = error_lines(&[one], &LINES).unwrap();
        assert!(!svg.contains("NaN") && !svg.contains("inf"), "{svg}");
        to_png(&svg, 1.0).unwrap();
    }
}
