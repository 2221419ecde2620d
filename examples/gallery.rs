//! The README's picture of the sequences: 256 points of each, side by side.
//!
//! `cargo run --release --example gallery [FILE.svg|FILE.png]`, by default `docs/sequences.svg`.

use corput::blue_noise::blue_noise_points;
use corput::bulk::Reference;
use corput::catalog::{Engine, Options, Request, Scramble, Sequence};
use corput::plot::{GalleryStyle, Panel, Points, gallery, to_png};
use corput::reference::unit::unit_floor;
use corput::report::save;
use std::path::PathBuf;

const COUNT: usize = 256;

/// Title, sequence with its options, and what it is.
type Row = (&'static str, Options, &'static str);

fn rows() -> Vec<Row> {
    let plain = |sequence| Options::new(sequence, COUNT as u64);
    let owen = Options {
        scramble: Some(Scramble::Owen),
        ..plain(Sequence::Sobol)
    };
    vec![
        (
            "random",
            plain(Sequence::Random),
            "independent points: gaps and clumps",
        ),
        (
            "stratified",
            plain(Sequence::Stratified),
            "a random point in each cell of a 16 × 16 grid",
        ),
        (
            "Latin hypercube",
            plain(Sequence::LatinHypercube),
            "a point in each of 256 rows and of 256 columns",
        ),
        (
            "multi-jittered",
            plain(Sequence::MultiJittered),
            "stratified and a Latin hypercube at once, correlated (CMJ)",
        ),
        (
            "van der Corput",
            plain(Sequence::VanDerCorput),
            "the index’s digits mirrored: each value falls in a gap",
        ),
        (
            "Hammersley",
            plain(Sequence::Hammersley),
            "van der Corput and k/N: N is known beforehand",
        ),
        (
            "Halton",
            plain(Sequence::Halton),
            "van der Corput in bases 2 and 3: go on as long as you like",
        ),
        (
            "R2",
            plain(Sequence::R2),
            "multiples of a fixed step, from the plastic number",
        ),
        (
            "Sobol",
            plain(Sequence::Sobol),
            "equally many points in all dyadic cells of a size",
        ),
        (
            "Sobol, Owen-scrambled",
            owen,
            "that at random: unbiased, and without Sobol’s patterns",
        ),
        (
            "pmj02",
            plain(Sequence::Pmj02),
            "multi-jittered at every power of two",
        ),
    ]
}

/// The words of a request, as floats.
fn made(options: &Options) -> corput::Result<Vec<f32>> {
    let request = Request::new(options)?;
    let mut words = vec![0; COUNT * request.words_per_point() as usize];
    Reference::new(&request).fill(0, &mut words)?;
    Ok(words.into_iter().map(f32::from_bits).collect())
}

fn pairs(values: &[f32]) -> Vec<[f32; 2]> {
    values.chunks_exact(2).map(|p| [p[0], p[1]]).collect()
}

fn main() -> corput::Result<()> {
    let mut sets = Vec::new();
    for (title, options, caption) in rows() {
        let values = made(&options)?;
        sets.push((title, caption, pairs(&values), values));
    }
    let blue = blue_noise_points(COUNT as u64, 0)?;
    sets.push((
        "blue noise",
        "no two points near: of many, the most crowded left out",
        blue.into_iter().map(|p| p.map(unit_floor)).collect(),
        Vec::new(),
    ));
    let panels: Vec<Panel<'_>> = sets
        .iter()
        .map(|(title, caption, pairs, values)| Panel {
            title,
            caption,
            points: match values.len() {
                COUNT => Points::Line(values),
                _ => Points::Square(pairs),
            },
        })
        .collect();
    let style = GalleryStyle {
        title: "256 points of each sequence, the first quarter orange",
        ..GalleryStyle::default()
    };
    let svg = gallery(&panels, &style)?;
    let argument = std::env::args_os().nth(1);
    let path = argument.map_or_else(|| PathBuf::from("docs/sequences.svg"), PathBuf::from);
    if path.extension().is_some_and(|ending| ending == "png") {
        return save(&path, &to_png(&svg, 2.0)?);
    }
    save(&path, svg.as_bytes())
}
