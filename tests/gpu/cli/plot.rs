//! `plot`: pictures of files, without a device.

use super::{Desk, Run};

/// A folder with points of 1, 2 and 8 dimensions.
fn desk() -> Desk {
    let desk = Desk::new();
    for (line, name) in [
        ("vdc --count 256", "one.npy"),
        ("halton --count 1024", "two.npy"),
        ("halton --count 4096 --dims 8", "eight.npy"),
    ] {
        desk.make(&format!("{line} --device cpu"), name);
    }
    desk
}

/// The same with no driver to be found.
fn run(desk: &Desk, line: &str) -> Run {
    let mut command = desk.command(line);
    command.env("VK_DRIVER_FILES", "/dev/null");
    Run::of(line, command)
}

/// Draws in silence, and returns the SVG.
fn draw(desk: &Desk, line: &str) -> String {
    let run = run(desk, &format!("plot {line} --out p.svg"));
    run.expect(0, &[]);
    assert_eq!((&*run.stderr, &*run.stdout), ("", &b""[..]), "{line}");
    String::from_utf8(desk.bytes("p.svg")).unwrap()
}

fn dots(svg: &str) -> usize {
    svg.matches("h0").count()
}

/// A file of 64-bit floats, as NumPy writes it.
fn write(desk: &Desk, name: &str, columns: usize, values: &[f64]) {
    let mut header = format!(
        "{{'descr': '<f8', 'fortran_order': False, 'shape': ({}, {columns}), }}",
        values.len() / columns
    );
    let room = 128 - 10 - 1;
    header.extend(std::iter::repeat_n(' ', room - header.len()));
    header.push('\n');
    let mut bytes = b"\x93NUMPY\x01\x00\x76\x00".to_vec();
    bytes.extend(header.as_bytes());
    bytes.extend(values.iter().flat_map(|value| value.to_le_bytes()));
    std::fs::write(desk.path(name), bytes).unwrap();
}

#[test]
fn the_views_follow_the_dimensions() {
    let desk = desk();
    let views = [
        "values in their order",
        "points</text>",
        "projections to pairs",
        "power spectrum",
        "radial mean power",
    ];
    for (line, shown, count) in [
        ("one.npy", &[0][..], 256),
        ("one.npy --kind all", &[0], 256),
        ("one.npy --kind scatter", &[0], 256),
        ("two.npy", &[1, 3, 4], 1024),
        ("two.npy --kind scatter", &[1], 1024),
        ("two.npy --kind spectrum", &[3, 4], 0),
        ("two.npy --kind pairs", &[2], 1024),
        ("two.npy --dims 1", &[0], 1024),
        ("eight.npy", &[2], 29 * 1024),
        ("eight.npy --kind pairs --points 100", &[2], 29 * 100),
        ("eight.npy --points 2000", &[2], 29 * 2000),
        ("eight.npy --points 4000", &[2], 29 * 2340),
        ("eight.npy --kind scatter", &[1], 4096),
        ("eight.npy --kind spectrum --points 64", &[3, 4], 0),
        ("eight.npy --kind all", &[1, 2, 3, 4], 29 * 1024 + 4096),
        ("eight.npy --dims 7,0", &[1, 3, 4], 4096),
        ("eight.npy --dims 7,0,3", &[2], 3 * 4096),
        ("one.npy two.npy", &[0, 1, 3, 4], 256 + 1024),
    ] {
        let svg = draw(&desk, line);
        for (index, view) in views.iter().enumerate() {
            assert_eq!(svg.contains(view), shown.contains(&index), "{line}: {view}");
        }
        assert_eq!(dots(&svg), count, "{line}");
    }
    let mut names = desk.names();
    names.retain(|name| !name.ends_with(".json"));
    assert_eq!(names, ["eight.npy", "one.npy", "p.svg", "two.npy"]);
}

#[test]
fn the_figure_says_what_it_shows() {
    let desk = desk();
    desk.make("halton --count 70000 --device cpu", "many.npy");
    let lacks = |line: &str, words: &[&str]| {
        let svg = draw(&desk, line);
        // A caption may go on in the next line.
        let texts = svg.lines().filter(|line| line.starts_with("<text"));
        let texts: Vec<&str> = texts
            .filter_map(|line| line.split_once('>')?.1.strip_suffix("</text>"))
            .collect();
        let texts = texts.join(" ");
        let missing = words.iter().filter(|words| !texts.contains(**words));
        missing.map(|words| (*words).to_owned()).collect::<Vec<_>>()
    };
    for (line, words) in [
        ("two.npy", &["two.npy", "1,024 points of 2 dimensions."][..]),
        ("one.npy", &["256 points of 1 dimension.", "index", "192"]),
        (
            "many.npy --kind scatter",
            &["70,000 points", "the first 65,536 points"],
        ),
        (
            "many.npy --points 4096",
            &["70,000 points", "the first 4,096 points"],
        ),
        (
            "eight.npy",
            &["4,096 points of 8 dimensions.", "the first 1,024 points"],
        ),
        (
            "eight.npy --dims 0,3,7",
            &["Shown: dimensions 0, 3, 7, counted from 0", "x₃"],
        ),
        ("two.npy --title <b>", &["&lt;b&gt;"]),
        ("two.npy one.npy --title Both", &["Both", "one.npy"]),
    ] {
        assert!(lacks(line, words).is_empty(), "{line}");
    }
    assert_eq!(lacks("two.npy --title T", &["two.npy"]), ["two.npy"]);
}

#[test]
fn the_worst_pair_is_found() {
    let desk = Desk::new();
    // Coordinates 2 and 4 are equal, and the others Halton's.
    let inverse = |base: u32, mut n: u32| {
        let (mut value, mut scale) = (0.0, 1.0);
        while n > 0 {
            scale /= f64::from(base);
            value += f64::from(n % base) * scale;
            n /= base;
        }
        value
    };
    let row = |n| [2, 3, 5, 7, 5].map(|base| inverse(base, n));
    let values: Vec<f64> = (0..500).flat_map(row).collect();
    write(&desk, "five.npy", 5, &values);
    let svg = draw(&desk, "five.npy");
    assert!(svg.contains("worst pair: x₂, x₄"), "{svg}");
    assert!(svg.contains("largest centred discrepancy"));
    let svg = draw(&desk, "five.npy --dims 4,0,1,2");
    assert!(svg.contains("worst pair: x₄, x₂"), "{svg}");
    // Below, the points of that pair, all on the diagonal.
    let svg = draw(&desk, "five.npy --kind all");
    assert_eq!(dots(&svg), 11 * 500 + 500);
    assert!(svg.contains("500 points of the worst pair"), "{svg}");
}

#[test]
fn every_type_of_number_gives_the_same_picture() {
    let desk = desk();
    desk.make("vdc --count 256 --fractions --device cpu", "fractions.npy");
    let values: Vec<f64> = (0..=255u8)
        .map(|n| f64::from(n.reverse_bits()) / 256.0)
        .collect();
    write(&desk, "doubles.npy", 1, &values);
    let picture = draw(&desk, "one.npy --title same");
    for name in ["fractions.npy", "doubles.npy", "one.npy"] {
        assert!(
            picture == draw(&desk, &format!("{name} --title same")),
            "{name}"
        );
    }
}

#[test]
fn a_png_has_twice_the_size() {
    let desk = desk();
    let size = |name: &str| {
        let bytes = desk.bytes(name);
        assert_eq!(&bytes[..8], b"\x89PNG\r\n\x1a\n");
        let side = |at: usize| u32::from_be_bytes(bytes[at..at + 4].try_into().unwrap());
        [side(16), side(20)]
    };
    std::fs::write(desk.path("p.png"), "old").unwrap();
    for (line, expected) in [
        ("two.npy --out p.png", [2812, 1034]),
        ("two.npy --cells 32x27 --out P.PNG", [2812, 1034]),
        ("two.npy --kind scatter --size 200 --out s.png", [620, 746]),
    ] {
        let run = run(&desk, &format!("plot {line}"));
        run.expect(0, &[]);
        assert_eq!(
            size(line.split(' ').next_back().unwrap()),
            expected,
            "{line}"
        );
    }
    assert_ne!(
        desk.bytes("p.png"),
        desk.bytes("P.PNG"),
        "the grid is drawn"
    );
}

#[test]
fn what_cannot_be_drawn_is_refused() {
    let desk = desk();
    let good = desk.bytes("two.npy");
    for (name, bytes) in [
        ("file", &b""[..]),
        ("empty.npy", b""),
        ("text.npy", b"0.5,0.5\n0.25,0.75\n"),
        ("cut.npy", &good[..good.len() - 3]),
        (
            "huge.npy",
            b"\x93NUMPY\x02\x00\xff\xff\xff\xff{'descr': '<f4'",
        ),
    ] {
        std::fs::write(desk.path(name), bytes).unwrap();
    }
    write(&desk, "nan.npy", 2, &[0.5, 0.5, 0.5, f64::NAN]);
    write(&desk, "outside.npy", 2, &[0.5, 0.5, 1.0, 0.25]);
    write(&desk, "none.npy", 2, &[]);
    desk.make(
        "halton --count 9 --map cosine-hemisphere --device cpu",
        "directions.npy",
    );
    let text = String::from_utf8_lossy(&good[10..4096]).into_owned();
    let solid = text.replacen("(1024, 2), }  ", "(512, 2, 2), }", 1);
    let solid = [&good[..10], solid.as_bytes(), &good[4096..]].concat();
    std::fs::write(desk.path("solid.npy"), solid).unwrap();
    let before = desk.names();
    let nine = "two.npy ".repeat(9);
    let many = format!("{nine} --out p.svg");
    let seventeen = "0,1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16";
    let long = format!("eight.npy --dims {seventeen} --out p.svg");
    for (line, words) in [
        ("--out p.svg", &["FILES"][..]),
        ("two.npy", &["--out"]),
        ("missing.npy --out p.svg", &["missing.npy", "No such file"]),
        (". --out p.svg", &["directory"]),
        ("empty.npy --out p.svg", &["empty.npy", "no .npy file"]),
        ("text.npy --out p.svg", &["text.npy", "no .npy file"]),
        ("cut.npy --out p.svg", &["cut.npy", "truncated"]),
        ("none.npy --out p.svg", &["none.npy", "empty"]),
        ("huge.npy --out p.svg", &["huge.npy", "4294967295 bytes"]),
        (
            "solid.npy --out p.svg",
            &["solid.npy", "3 dimensions", "must be 2-D"],
        ),
        (
            "nan.npy --out p.svg",
            &["nan.npy", "row 1, column 1", "NaN"],
        ),
        (
            "outside.npy --out p.svg",
            &["outside.npy", "row 1, column 0", "[0, 1)"],
        ),
        ("directions.npy --out p.svg", &["directions.npy", "[0, 1)"]),
        ("two.npy nan.npy --out p.svg", &["nan.npy"]),
        (&many, &["9 files", "at most 8"]),
        (
            "two.npy --out p.jpg",
            &["unknown format of a picture `.jpg`", ".svg, .png"],
        ),
        ("two.npy --out picture", &["`picture`", ".svg, .png"]),
        ("two.npy --out -", &[".svg, .png"]),
        (
            "two.npy --out missing/p.svg",
            &["missing/p.svg", "folder missing does not exist"],
        ),
        ("two.npy --out file/p.svg", &["file is not a folder"]),
        // Before the work, which could be long.
        ("nan.npy --out missing/p.svg", &["folder missing"]),
        (
            "two.npy --kind scater --out p.svg",
            &["unknown kind `scater`", "did you mean `scatter`", "pairs"],
        ),
        (
            "one.npy --kind spectrum --out p.svg",
            &["--kind spectrum", "one.npy", "it takes two"],
        ),
        ("one.npy --kind pairs --out p.svg", &["--kind pairs"]),
        (
            "eight.npy --kind pairs --dims 3 --out p.svg",
            &["--kind pairs", "it takes two"],
        ),
        (
            "eight.npy --kind scatter --dims 1,2,3 --out p.svg",
            &["--dims 1,2,3", "at most 2", "--kind pairs"],
        ),
        (
            "eight.npy --dims 0,8 --out p.svg",
            &["--dims 0,8", "eight.npy has dimensions 0 to 7"],
        ),
        (
            "eight.npy --dims 18446744073709551615 --out p.svg",
            &["0 to 7"],
        ),
        (
            "eight.npy --dims 3,3 --out p.svg",
            &["--dims 3,3", "3 is given twice"],
        ),
        ("eight.npy --dims -1 --out p.svg", &["-1 is negative"]),
        (
            "eight.npy --dims x --out p.svg",
            &["`x` is no whole number"],
        ),
        (&long, &["at most 16 dimensions", "give fewer"]),
        ("two.npy --points 0 --out p.svg", &["--points is 0"]),
        ("two.npy --points -3 --out p.svg", &["-3 is negative"]),
        (
            "two.npy --cells 16 --out p.svg",
            &["`16` is no grid", "16x9"],
        ),
        ("two.npy --cells 0x4 --out p.svg", &["`0x4`", "1 to 1024"]),
        ("two.npy --cells 4x1025 --out p.svg", &["1 to 1024"]),
        ("two.npy --size 199 --out p.svg", &["199", "200 to 1000"]),
        ("two.npy --size 1001 --out p.svg", &["200 to 1000"]),
    ] {
        let run = run(&desk, &format!("plot {line}"));
        run.expect(2, words);
        assert_eq!(run.stdout, b"", "{line}");
        assert_eq!(desk.names(), before, "`{line}` left files");
    }
}
