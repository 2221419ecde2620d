//! The README's picture of the sequences: 256 points of each, side by side.
//!
//! `cargo run --release --example gallery [FILE.svg|FILE.png]`, by default `docs/sequences.svg`.

use corput::bulk::Reference;
use corput::catalog::{Options, Request, Sequence};
use corput::plot::{GalleryStyle, Panel, Points, gallery, to_png};
use corput::report::save;
use std::path::PathBuf;

const COUNT: usize = 256;

/// Title, sequence with its options, and what it is.
type Row = (&'static str, Options, &'static str);

fn rows() -> Vec<Row> {
    let plain = |sequence| Options::new(sequence, COUNT as u64);
    vec![
        (
            "van der Corput",
            plain(Sequence::VanDerCorput),
            "digits of the index mirrored at the point: each value halves a gap",
        ),
        (
            "Halton",
            plain(Sequence::Halton),
            "van der Corput in the bases 2 and 3: any number of points",
        ),
        (
            "Hammersley",
            plain(Sequence::Hammersley),
            "k/N and van der Corput: a set, of N points known beforehand",
        ),
    ]
}

fn main() -> corput::Result<()> {
    let rows = rows();
    let mut sets = Vec::new();
    for (_, options, _) in &rows {
        let request = Request::new(options)?;
        let mut words = vec![0; COUNT * request.words_per_point() as usize];
        Reference::new(&request).fill(0, &mut words);
        sets.push(words.into_iter().map(f32::from_bits).collect::<Vec<f32>>());
    }
    let pairs: Vec<Vec<[f32; 2]>> = sets
        .iter()
        .map(|set| set.chunks_exact(2).map(|p| [p[0], p[1]]).collect())
        .collect();
    let panels: Vec<Panel<'_>> = rows
        .iter()
        .zip(sets.iter().zip(&pairs))
        .map(|((title, _, caption), (set, pairs))| Panel {
            title,
            caption,
            points: match set.len() {
                COUNT => Points::Line(set),
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
