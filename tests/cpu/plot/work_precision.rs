//! Error against work: bands, dashes, targets, the floor and the guides are drawn.

use super::boxes::{collisions, texts};
use super::{drawn, refused};
use corput::plot::{Curve, Measured, Work, WorkPrecisionStyle, key, work_precision};
use resvg::usvg::{Options, Tree};

fn curve(name: &str, hue: usize, slope: f64) -> Curve {
    let point = |log: i32| {
        let work = f64::powi(2.0, log);
        let error = (0.2 - 0.01 * hue as f64) * (work / 16.0).powf(slope);
        Measured {
            work,
            error,
            low: 0.8 * error,
            high: 1.3 * error,
            faint: false,
        }
    };
    Curve {
        name: name.to_owned(),
        points: (4..=16).map(point).collect(),
        one_run: false,
        hue,
    }
}

const STYLE: WorkPrecisionStyle<'_> = WorkPrecisionStyle {
    title: "x-squared <b>",
    description: "random & others",
    work: Work::Points,
    y_label: "relative RMSE",
    targets: &[1e-2, 1e-3],
    floor: 1e-6,
    floor_name: "arithmetic floor",
    size: [300.0, 290.0],
};

fn saved(name: &str, svg: &str) {
    let size = Tree::from_str(svg, &Options::default()).unwrap().size();
    drawn(name, svg, [size.width() as u32, size.height() as u32]);
}

#[test]
fn bands_are_of_random_samplers_and_dashes_of_others() {
    let random = curve("random", 0, -0.5);
    let halton = Curve {
        one_run: true,
        ..curve("halton", 1, -1.0)
    };
    let svg = work_precision(&[random.clone(), halton.clone()], &STYLE).unwrap();
    saved("work", &svg);
    assert_eq!(svg.matches("fill-opacity").count(), 1, "bands");
    assert_eq!(svg.matches("stroke-dasharray=\"6 4\"").count(), 1, "dashes");
    assert!(svg.contains("halton (one run)") && !svg.contains("random (one run)"));
    assert!(svg.contains("<title>x-squared &lt;b&gt;</title>"));
    assert!(svg.contains("<desc>random &amp; others</desc>"));
    let both = work_precision(&[random.clone(), random], &STYLE).unwrap();
    assert_eq!(both.matches("fill-opacity").count(), 2);
}

/// Heights of the level lines of a pattern of dashes.
fn levels(svg: &str, dash: &str) -> Vec<f64> {
    let dash = format!("stroke-dasharray=\"{dash}\"");
    let lines = svg.lines().filter(|line| line.contains(&dash));
    let height = |line: &str| {
        let path = line.split("d=\"M").nth(1)?.split('"').next()?;
        path.split('L').next()?.split(' ').nth(1)?.parse().ok()
    };
    lines.filter_map(height).collect()
}

#[test]
fn the_floor_is_at_its_height_or_below_all() {
    let curves = [curve("random", 0, -0.5), curve("owen", 2, -1.5)];
    let height = |floor: f64| {
        let style = WorkPrecisionStyle { floor, ..STYLE };
        let svg = work_precision(&curves, &style).unwrap();
        let found = levels(&svg, "8 3 2 3");
        assert_eq!(found.len(), 1, "{floor}");
        (found[0], svg)
    };
    // Errors end near 7e-7: axes of 10^-8 to 10^0 hold this floor, seven eighths down.
    let (at, svg) = height(1e-7);
    assert!((at - (12.0 + 290.0 * 7.0 / 8.0)).abs() < 0.1, "{at}");
    assert!(svg.contains(">arithmetic floor 10⁻⁷<"));
    let (other, _) = height(1.5e-7);
    assert!(other < at - 5.0, "{other}");
    for (floor, words) in [
        (1e-12, "↓ arithmetic floor 10⁻¹²"),
        (0.0, "↓ arithmetic floor 0"),
    ] {
        let (at, svg) = height(floor);
        assert!((at - 300.0).abs() < 0.1, "{at}");
        assert!(svg.contains(words), "{words}");
    }
}

#[test]
fn targets_and_guides_are_named() {
    let curves = [curve("random", 0, -0.5), curve("owen", 2, -1.5)];
    let svg = work_precision(&curves, &STYLE).unwrap();
    let all: Vec<String> = texts(&svg).into_iter().map(|(text, _)| text).collect();
    for name in [
        "target 10⁻²",
        "target 10⁻³",
        "slope −1/2",
        "slope −1",
        "slope −3/2",
        "arithmetic floor 10⁻⁶",
    ] {
        assert!(all.iter().any(|text| text == name), "{name}: {all:?}");
    }
    let seconds = WorkPrecisionStyle {
        work: Work::Seconds,
        ..STYLE
    };
    let mut short = curves.clone();
    for point in short.iter_mut().flat_map(|curve| &mut curve.points) {
        point.work = 3e-5 * (point.work / 16.0).powf(0.2);
    }
    let svg = work_precision(&short, &seconds).unwrap();
    saved("work-time", &svg);
    assert!(!svg.contains("slope"), "guides are of points");
    for tick in [">50 µs<", ">100 µs<"] {
        assert!(svg.contains(tick), "{tick}");
    }
}

#[test]
fn eight_curves_have_names_apart() {
    let names = [
        "random",
        "stratified",
        "halton",
        "halton:permute",
        "hammersley",
        "sobol:owen-hash",
        "latin-hypercube",
        "korobov",
    ];
    let curves: Vec<Curve> = names
        .iter()
        .enumerate()
        .map(|(hue, name)| curve(name, hue, -1.0))
        .collect();
    for work in [Work::Points, Work::Seconds] {
        let svg = work_precision(&curves, &WorkPrecisionStyle { work, ..STYLE }).unwrap();
        saved("work-eight", &svg);
        assert_eq!(collisions(&svg), Vec::<String>::new());
        for name in names {
            assert!(svg.contains(&format!(">{name}<")), "{name}");
        }
    }
    let mut nine = curves.clone();
    nine.push(curve("r2", 8, -1.0));
    refused(work_precision(&nine, &STYLE), "9 curves");
}

#[test]
fn extreme_errors_are_drawn_or_refused() {
    let of = |points: Vec<Measured>| Curve {
        points,
        ..curve("one", 0, -1.0)
    };
    let point = |work, error, low, high| Measured {
        work,
        error,
        low,
        high,
        faint: false,
    };
    for points in [
        vec![point(16.0, 1e-3, 0.0, f64::INFINITY)],
        vec![point(16.0, 1e-3, 1e-3, 1e-3), point(32.0, 0.0, 0.0, 0.0)],
        vec![
            point(5e-324, 1e308, 1e300, 1e308),
            point(1e308, 5e-324, f64::NAN, 1.0),
        ],
    ] {
        let svg = work_precision(&[of(points)], &STYLE).unwrap();
        assert!(!svg.contains("NaN") && !svg.contains("inf"), "{svg}");
        saved("work-extreme", &svg);
    }
    for points in [
        Vec::new(),
        vec![point(16.0, 0.0, 0.0, 0.0), point(32.0, f64::NAN, 0.0, 0.0)],
    ] {
        refused(work_precision(&[of(points)], &STYLE), "positive and finite");
    }
    let small = WorkPrecisionStyle {
        size: [10.0, 290.0],
        ..STYLE
    };
    refused(
        work_precision(&[curve("a", 0, -1.0)], &small),
        "160 to 4000",
    );
}

/// Steep curves end at the lower edge, where the floor and the guides have their words too.
#[test]
fn names_of_steep_curves_are_apart() {
    let names = [
        "random",
        "halton (2, 3)",
        "sobol:owen-hash",
        "stratified",
        "korobov",
    ];
    let mut tried = 0;
    for slope in [-0.8, -1.0, -1.3, -1.5, -2.0] {
        for many in [1, 2, 3, 5] {
            for (floor, targets) in [
                (0.0, &[1e-2, 1e-3, 1e-4][..]),
                (2.3e-10, &[1e-2, 1e-3, 1e-4]),
                (1e-7, &[1e-5, 1e-6]),
                (3e-5, &[]),
            ] {
                let curves: Vec<Curve> = names[..many]
                    .iter()
                    .zip(0..)
                    .map(|(name, hue)| curve(name, hue, slope))
                    .collect();
                for work in [Work::Points, Work::Seconds] {
                    let style = WorkPrecisionStyle {
                        work,
                        floor,
                        targets,
                        ..STYLE
                    };
                    let svg = work_precision(&curves, &style).unwrap();
                    let found = collisions(&svg);
                    assert_eq!(
                        found,
                        Vec::<String>::new(),
                        "{slope} {many} {floor} {work:?}"
                    );
                    tried += 1;
                }
            }
        }
    }
    assert_eq!(tried, 160);
}

/// A step is dotted where one of its ends has an interval that says too little.
#[test]
fn what_says_too_little_is_faint() {
    let mut one = curve("random", 0, -0.5);
    for point in &mut one.points[..3] {
        point.faint = true;
    }
    let svg = work_precision(&[one.clone()], &STYLE).unwrap();
    saved("work-faint", &svg);
    let dotted: Vec<&str> = svg
        .lines()
        .filter(|line| line.contains("stroke-dasharray=\"1.5 3\""))
        .collect();
    assert_eq!(dotted.len(), 1);
    // Three points and the one after them.
    assert_eq!(dotted[0].matches('L').count(), 3);
    // Its band, its line and its markers.
    assert_eq!(svg.matches("opacity=\"0.45\"").count(), 3);
    assert_eq!(svg.matches("fill-opacity").count(), 2);
    for point in &mut one.points {
        point.faint = false;
    }
    let whole = work_precision(&[one], &STYLE).unwrap();
    assert!(!whole.contains("1.5 3") && !whole.contains("0.45"));
}

#[test]
fn a_key_names_the_curves_that_are_drawn() {
    let halton = Curve {
        one_run: true,
        ..curve("halton <2>", 1, -1.0)
    };
    let none = Curve {
        points: Vec::new(),
        ..curve("none", 2, -1.0)
    };
    let curves = [curve("random", 0, -0.5), halton, none];
    let made = key(&curves, &STYLE);
    let names: Vec<&str> = made.entries.iter().map(|(_, name)| name.as_str()).collect();
    assert_eq!(names, ["random", "halton <2> (one run)"]);
    assert!(
        made.entries
            .iter()
            .all(|(mark, _)| mark.contains("class=\"c"))
    );
    let svg = work_precision(&curves, &STYLE).unwrap();
    let width = f64::from(
        Tree::from_str(&svg, &Options::default())
            .unwrap()
            .size()
            .width(),
    );
    assert!((made.across - width / (66.0 + 300.0 + 12.0)).abs() < 1e-9);
}
