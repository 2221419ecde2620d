//! The shapes of a figure, read from its SVG.

/// A rectangle: left, top, right, bottom.
pub type Frame = [f64; 4];

fn attribute(line: &str, name: &str) -> Option<f64> {
    let rest = line.split_once(&format!(" {name}=\""))?.1;
    rest.split_once('"')?.0.parse().ok()
}

/// Rectangles with an outline.
pub fn frames(svg: &str) -> Vec<Frame> {
    let frame = |line: &str| {
        let [x, y, w, h] =
            ["x", "y", "width", "height"].map(|name| attribute(line, name).unwrap_or_default());
        [x, y, x + w, y + h]
    };
    let outlined = |line: &&str| line.starts_with("<rect") && line.contains("fill=\"none\"");
    svg.lines().filter(outlined).map(frame).collect()
}

/// Centres of dots.
pub fn dots(svg: &str) -> Vec<[f64; 2]> {
    let mut found = Vec::new();
    for line in svg
        .lines()
        .filter(|line| line.contains("linecap=\"round\""))
    {
        let path = line
            .split_once("d=\"M")
            .unwrap()
            .1
            .split('"')
            .next()
            .unwrap();
        for dot in path.split('M') {
            let (x, y) = dot.trim_end_matches("h0").split_once(' ').unwrap();
            found.push([x, y].map(|number| number.parse().unwrap()));
        }
    }
    found
}

/// Dots that lie in no frame.
pub fn strays(svg: &str) -> usize {
    let frames = frames(svg);
    // Coordinates have two decimals.
    let inside = |[x, y]: &[f64; 2], [left, top, right, bottom]: &Frame| {
        (left - 0.02..=right + 0.02).contains(x) && (top - 0.02..=bottom + 0.02).contains(y)
    };
    let stray = |dot: &&[f64; 2]| !frames.iter().any(|frame| inside(dot, frame));
    dots(svg).iter().filter(stray).count()
}

#[test]
fn strays_are_found() {
    let frame = "<rect x=\"10.00\" y=\"20.00\" width=\"30.00\" height=\"40.00\" fill=\"none\"/>\n";
    let dots = |path: &str| {
        format!("{frame}<path d=\"{path}\" fill=\"none\" stroke-linecap=\"round\"/>\n")
    };
    assert_eq!(frames(frame), [[10.0, 20.0, 40.0, 60.0]]);
    assert_eq!(strays(&dots("M10.00 20.00h0M40.00 60.00h0")), 0);
    assert_eq!(
        strays(&dots("M9.90 30.00h0M20.00 60.10h0M41.00 60.00h0")),
        3
    );
}
