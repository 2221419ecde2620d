//! The gallery: panels in rows, nothing on top of anything else.

use super::boxes::{assert_apart, texts};
use super::{drawn, halton, radical_inverse, refused};
use corput::plot::{GalleryStyle, MAX_POINTS, Panel, Points, gallery};

/// A small generator: good enough to look random.
fn random(count: usize) -> Vec<[f32; 2]> {
    let mut state = 1_u64;
    let mut next = || {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (state >> 40) as f32 / (1 << 24) as f32
    };
    (0..count).map(|_| [next(), next()]).collect()
}

fn r2(count: usize) -> Vec<[f32; 2]> {
    const PLASTIC: f64 = 1.324_717_957_244_746;
    let steps = [1.0 / PLASTIC, 1.0 / (PLASTIC * PLASTIC)];
    (0..count)
        .map(|n| steps.map(|step| (0.5 + n as f64 * step).fract() as f32))
        .collect()
}

fn stratified(side: usize) -> Vec<[f32; 2]> {
    random(side * side)
        .iter()
        .enumerate()
        .map(|(i, [u, v])| {
            [
                ((i % side) as f32 + u) / side as f32,
                ((i / side) as f32 + v) / side as f32,
            ]
        })
        .collect()
}

#[test]
fn panels_stand_in_rows() {
    let line: Vec<f32> = (0..256).map(|n| radical_inverse(2, n) as f32).collect();
    let (halton, random, stratified) = (halton(256), random(256), stratified(16));
    let (r2, none) = (r2(256), Vec::new());
    let sets = [&random, &stratified, &halton, &r2, &none];
    let mut panels = vec![Panel {
        title: "van der Corput",
        caption: "the index in base 2, mirrored at the point: each value halves a gap",
        points: Points::Line(&line),
    }];
    for i in 0..11 {
        panels.push(Panel {
            title: ["random", "Owen-scrambled Sobol’", "R2"][i % 3],
            caption: [
                "short",
                "a caption of the length that two lines of text need",
            ][i % 2],
            points: Points::Square(sets[i % sets.len()]),
        });
    }
    let style = GalleryStyle {
        title: "256 points of each sequence, the first quarter orange",
        ..GalleryStyle::default()
    };
    let svg = gallery(&panels, &style).unwrap();
    drawn("gallery", &svg, [850, 848]);
    assert!(svg.len() < 90_000, "{} bytes", svg.len());
    assert_apart(&svg);
    // A title and a caption for each, the lines of the strip, the heading.
    assert!(texts(&svg).len() > 12 * 2 + 6);
}

#[test]
fn points_lie_in_their_panels() {
    // The centres of both panels' dots, in the order of the file: the rest, then the first.
    let svg = gallery(
        &[[0.0, 0.0], [1.0, 1.0]].map(|p| Panel {
            title: "",
            caption: "",
            points: Points::Square(if p[0] == 0.0 {
                &[[0.0, 0.0], [0.25, 0.5]]
            } else {
                &[[1.0, 1.0]]
            }),
        }),
        &GalleryStyle::default(),
    )
    .unwrap();
    let dots: Vec<&str> = svg
        .lines()
        .filter_map(|line| line.strip_prefix("<path d=\"")?.split_once("h0\""))
        .map(|(dots, _)| dots)
        .collect();
    assert_eq!(dots, ["M59.50 123.00", "M12.00 218.00", "M414.00 28.00"]);
}

#[test]
fn bad_galleries_are_refused() {
    fn panel(points: Points<'_>) -> Panel<'_> {
        Panel {
            title: "",
            caption: "",
            points,
        }
    }
    let plain = GalleryStyle::default();
    refused(gallery(&[], &plain), "no panels");
    let many = vec![[0.0; 2]; MAX_POINTS + 1];
    refused(gallery(&[panel(Points::Square(&many))], &plain), "65537");
    let many = vec![0.0; MAX_POINTS + 1];
    refused(gallery(&[panel(Points::Line(&many))], &plain), "65537");
    for bad in [f32::NAN, -0.1, 1.5, f32::INFINITY] {
        let points = [[0.5, bad]];
        refused(
            gallery(&[panel(Points::Square(&points))], &plain),
            "unit square",
        );
        refused(
            gallery(&[panel(Points::Line(&[0.5, bad]))], &plain),
            "unit interval",
        );
    }
    for (columns, size) in [(0, 190.0), (17, 190.0), (4, 79.0), (4, f64::NAN)] {
        let style = GalleryStyle {
            columns,
            size,
            ..plain.clone()
        };
        refused(gallery(&[panel(Points::Line(&[]))], &style), "1 to 16");
    }
    // Nothing to draw is drawn as such.
    for points in [Points::Line(&[]), Points::Line(&[0.5]), Points::Square(&[])] {
        gallery(&[panel(points)], &plain).unwrap();
    }
}
