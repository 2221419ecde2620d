//! Sheets: every view, alone and beside others.

use super::boxes::{assert_apart, texts};
use super::shapes::{dots, frames, strays};
use super::{drawn, halton, radical_inverse, refused};
use corput::plot::{MAX_DIMENSIONS, MAX_POINTS, SheetStyle, Stack, View, pairs_points, sheet};
use corput::stats::{Spectrum, spectrum};

fn measured(points: &[[f32; 2]], range: usize) -> Spectrum {
    let points: Vec<[f64; 2]> = points.iter().map(|p| p.map(f64::from)).collect();
    spectrum(&points, range, &mut |_, _| Ok(())).unwrap()
}

/// Coordinates in the first primes, `count` values of each.
fn columns(dimensions: usize, count: u32) -> Vec<Vec<f32>> {
    let primes = [2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43, 47, 53];
    let column = |base| (0..count).map(move |n| radical_inverse(base, n) as f32);
    primes[..dimensions]
        .iter()
        .map(|base| column(*base).collect())
        .collect()
}

fn one<'a>(views: &[View<'a>], caption: &'a str) -> [Stack<'a>; 1] {
    [Stack {
        title: "",
        caption,
        rows: vec![views.to_vec()],
    }]
}

fn has(svg: &str, words: &str) -> bool {
    texts(svg).iter().any(|(text, _)| text == words)
}

#[test]
fn points_stand_beside_their_spectrum() {
    let points = halton(1024);
    let spectrum = measured(&points, 64);
    let scatter = View::Scatter {
        points: &points,
        dimensions: [0, 12],
    };
    let views = [scatter, View::Power(&spectrum), View::Radial(&spectrum)];
    let style = SheetStyle {
        title: "halton.npy",
        cells: Some([32, 27]),
        ..SheetStyle::default()
    };
    let svg = sheet(
        &one(&views, "1,024 points. Colour: order, from dark to light."),
        &style,
    )
    .unwrap();
    drawn("sheet", &svg, [1406, 517]);
    assert_apart(&svg);
    assert_eq!(dots(&svg).len(), 1024);
    assert_eq!(strays(&svg), 0);
    for words in ["x₀", "x₁₂", "power spectrum", "anisotropy in dB", "−20"] {
        assert!(has(&svg, words), "{words}");
    }
    assert!(svg.len() < 110_000, "{} bytes", svg.len());
}

#[test]
fn dots_lie_where_their_values_are() {
    let at = |view| {
        let svg = sheet(&one(&[view], ""), &SheetStyle::default()).unwrap();
        let [left, top, right, bottom] = frames(&svg)[0];
        let part = |[x, y]: [f64; 2]| [(x - left) / (right - left), (bottom - y) / (bottom - top)];
        dots(&svg).into_iter().map(part).collect::<Vec<_>>()
    };
    let scatter = View::Scatter {
        points: &[[0.25, 0.75], [0.5, 0.0]],
        dimensions: [0, 1],
    };
    assert_eq!(at(scatter), [[0.25, 0.75], [0.5, 0.0]]);
    let sequence = View::Sequence {
        values: &[0.75, 0.125],
        dimension: 0,
    };
    assert_eq!(at(sequence), [[0.25, 0.75], [0.75, 0.125]]);
    let pairs = View::Pairs {
        columns: &[vec![0.25], vec![0.75]],
        dimensions: &[0, 1],
        marked: None,
    };
    assert_eq!(at(pairs), [[0.25, 0.75]]);
}

#[test]
fn values_stand_over_their_index() {
    let line: Vec<f32> = (0..256).map(|n| radical_inverse(2, n) as f32).collect();
    let ticks = |count: usize| {
        let view = View::Sequence {
            values: &line[..count],
            dimension: 3,
        };
        let svg = sheet(&one(&[view], ""), &SheetStyle::default()).unwrap();
        assert_apart(&svg);
        assert_eq!((dots(&svg).len(), strays(&svg)), (count, 0));
        assert!(has(&svg, "x₃"));
        let quarters = ["0", "¼", "½", "¾", "1"];
        texts(&svg)
            .into_iter()
            .map(|(text, _)| text)
            .filter(|text| !quarters.contains(&text.as_str()) && text.parse::<u32>().is_ok())
            .collect::<Vec<_>>()
    };
    assert_eq!(ticks(256), ["64", "128", "192", "256"]);
    assert_eq!(ticks(250), ["50", "100", "150", "200", "250"]);
    for few in 0..8 {
        ticks(few);
    }
}

#[test]
fn every_pair_is_shown_and_the_worst_is_enlarged() {
    for (dimensions, enlarged) in [(2, 0), (3, 0), (4, 1), (5, 1), (8, 1), (16, 1)] {
        let columns = columns(dimensions, 64);
        // Other numbers than the columns' places.
        let names: Vec<usize> = (0..dimensions).map(|i| 3 * i).collect();
        let last = 3 * (dimensions - 1);
        let view = View::Pairs {
            columns: &columns,
            dimensions: &names,
            marked: Some([last - 3, last]),
        };
        let svg = sheet(&one(&[view], "A caption."), &SheetStyle::default()).unwrap();
        let wide = [360, 576, 792][dimensions.saturating_sub(2).min(2)] + 110;
        drawn(&format!("pairs{dimensions}"), &svg, [wide, wide + 9]);
        assert_apart(&svg);
        let pairs = dimensions * (dimensions - 1) / 2;
        assert_eq!(dots(&svg).len(), 64 * (pairs + enlarged), "{dimensions}");
        assert_eq!(strays(&svg), 0);
        // The mark is a second outline, around the small one and the large one.
        assert_eq!(frames(&svg).len(), pairs + 1 + 2 * enlarged);
        let coordinate = format!("x{}", char::from_u32(0x2080 + 3).unwrap());
        assert!(has(&svg, &coordinate));
    }
    let crowd = |dimensions| pairs_points(dimensions, 360.0);
    assert_eq!([2, 3, 8, 16].map(crowd), [8192, 8192, 1024, 128]);
}

#[test]
fn frequencies_lie_where_they_are() {
    // Points on the lines 3 x + 5 y = 0 modulo 1: all power at multiples of (3, 5).
    let points: Vec<[f32; 2]> = (0..500)
        .map(|i| {
            let x = f64::from(i) / 500.0;
            [x, (f64::from(i % 5) / 5.0 - 3.0 * x / 5.0).rem_euclid(1.0)]
        })
        .map(|p| p.map(|u| u as f32))
        .collect();
    let spectrum = measured(&points, 8);
    assert!(spectrum.power(3, 5) > 400.0);
    let svg = sheet(&one(&[View::Power(&spectrum)], ""), &SheetStyle::default()).unwrap();
    let pixels = drawn("lines of points", &svg, [522, 456]);
    let [left, top, right, _] = frames(&svg)[0];
    let pixel = (right - left) / 17.0;
    for (x, y) in (-8..=8).flat_map(|x| (-8..=8).map(move |y| (x, y))) {
        let at = |f: f64| 2.0 * pixel * (8.5 + f);
        let (column, row) = (2.0 * left + at(f64::from(x)), 2.0 * top + at(-f64::from(y)));
        let dark = pixels.pixel(column as u32, row as u32).unwrap().red() < 100;
        let expected = (x, y) == (3, 5) || (x, y) == (-3, -5);
        assert_eq!(dark, expected, "({x}, {y})");
    }
}

#[test]
fn sharp_peaks_and_empty_rings_are_drawn() {
    // A grid has no power but at multiples of 16, and more there than an axis holds.
    let grid: Vec<[f32; 2]> = (0..256)
        .map(|i| [(i % 16) as f32 / 16.0, (i / 16) as f32 / 16.0])
        .collect();
    let spectrum = measured(&grid, 20);
    let svg = sheet(
        &one(&[View::Power(&spectrum), View::Radial(&spectrum)], ""),
        &SheetStyle::default(),
    )
    .unwrap();
    let pixels = drawn("grid", &svg, [964, 456]);
    assert_apart(&svg);
    // The peaks are cut off: below the caption and above the frame, nothing is drawn.
    let [left, top, right, _] = frames(&svg)[2];
    for x in (2.0 * left) as u32..(2.0 * right) as u32 {
        let pixel = pixels.pixel(x, (2.0 * top) as u32 - 5).unwrap();
        assert_eq!(pixel.green(), 255, "{x}");
    }
    assert!(!svg.contains("NaN") && !svg.contains("inf"), "{svg}");
    assert!(svg.contains("radial mean power, up to"), "{svg}");
}

#[test]
fn sets_stand_side_by_side() {
    let points = halton(256);
    let spectrum = measured(&points, 200);
    let line = vec![0.25; 1000];
    let five = columns(5, 32);
    let stack = |title, rows| Stack {
        title,
        caption: "A caption that is long enough to need a second line below its own views, \
                  and perhaps a third one.",
        rows,
    };
    let long = "a-name-of-a-file-that-is-far-too-long-for-the-room-above-its-column-of-views.npy";
    let stacks = [
        stack(
            long,
            vec![
                vec![View::Scatter {
                    points: &points,
                    dimensions: [0, 1],
                }],
                vec![View::Power(&spectrum)],
                vec![View::Radial(&spectrum)],
            ],
        ),
        stack(
            "one.npy",
            vec![vec![View::Sequence {
                values: &line,
                dimension: 0,
            }]],
        ),
        stack(
            "five.npy",
            vec![vec![View::Pairs {
                columns: &five,
                dimensions: &[0, 1, 2, 3, 4],
                marked: None,
            }]],
        ),
    ];
    for size in [200.0, 360.0] {
        let title = long.repeat(4);
        let style = SheetStyle {
            title: &title,
            size,
            cells: None,
        };
        let svg = sheet(&stacks, &style).unwrap();
        assert_apart(&svg);
        assert_eq!(strays(&svg), 0);
        assert_eq!(dots(&svg).len(), 256 + 1000 + 10 * 32);
        corput::plot::to_png(&svg, 1.0).unwrap();
    }
}

#[test]
fn bad_sheets_are_refused() {
    let plain = SheetStyle::default();
    let points = halton(4);
    let good = View::Scatter {
        points: &points,
        dimensions: [0, 1],
    };
    refused(sheet(&[], &plain), "without views");
    refused(sheet(&one(&[], ""), &plain), "without views");
    for size in [f64::NAN, 199.0, 1001.0] {
        let style = SheetStyle {
            size,
            ..plain.clone()
        };
        refused(sheet(&one(&[good], ""), &style), "200 to 1000");
    }
    let style = SheetStyle {
        cells: Some([1025, 1]),
        ..plain.clone()
    };
    refused(sheet(&one(&[good], ""), &style), "cells");
    let many = vec![[0.5; 2]; MAX_POINTS + 1];
    let outside = [[0.5, 1.5]];
    for (points, words) in [(&many[..], "65537"), (&outside[..], "unit square")] {
        let view = View::Scatter {
            points,
            dimensions: [0, 1],
        };
        refused(sheet(&one(&[view], ""), &plain), words);
    }
    for (values, words) in [
        (vec![0.5; MAX_POINTS + 1], "65537"),
        (vec![f32::NAN], "unit interval"),
    ] {
        let view = View::Sequence {
            values: &values,
            dimension: 0,
        };
        refused(sheet(&one(&[view], ""), &plain), words);
    }
    let all: Vec<usize> = (0..=MAX_DIMENSIONS).collect();
    let pairs = |columns: &[Vec<f32>], dimensions: &[usize], marked, words: &str| {
        let view = View::Pairs {
            columns,
            dimensions,
            marked,
        };
        refused(sheet(&one(&[view], ""), &plain), words);
    };
    pairs(&vec![vec![0.5]; 17], &all, None, "2 to 16");
    pairs(&[vec![0.5]], &[0], None, "2 to 16");
    pairs(
        &vec![vec![0.5]; 2],
        &[0, 1, 2],
        None,
        "each with its column",
    );
    pairs(&[vec![0.5], vec![]], &[0, 1], None, "different lengths");
    pairs(
        &vec![vec![0.5; 30_000]; 3],
        &[0, 1, 2],
        None,
        "90000 points",
    );
    pairs(&[vec![0.5], vec![-0.5]], &[0, 1], None, "unit interval");
    pairs(&vec![vec![0.5]; 2], &[4, 7], Some([4, 5]), "4, 5");
    pairs(&vec![vec![0.5]; 2], &[4, 7], Some([7, 7]), "7, 7");
}
