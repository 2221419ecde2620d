//! `generate blue-noise-mask` and `generate blue-noise`: shapes, values, formats, and what
//! is refused.

use super::parse::npy;
use super::{Desk, skips};
use corput::blue_noise::{MaskShape, blue_noise_points, void_and_cluster};
use corput::bulk;
use corput::catalog::{Map, Mapping, Profile};
use corput::reference::blue_noise::blue_noise_fraction;
use corput::reference::unit::unit_floor;

/// Shape and words of an `.npy` of any number of axes.
fn array(bytes: &[u8]) -> (String, Vec<u32>) {
    let header = String::from_utf8_lossy(&bytes[10..4096]).into_owned();
    let words = bytes[4096..].chunks(4);
    let words = words.map(|b| u32::from_le_bytes([b[0], b[1], b[2], b[3]]));
    (header, words.collect())
}

fn fractions(size: u64, frames: u64, seed: u64) -> Vec<u32> {
    let shape = MaskShape::new(size, size, frames).expect("a shape");
    let ranks = void_and_cluster(shape, seed);
    ranks
        .iter()
        .map(|rank| blue_noise_fraction(*rank, shape.pixels()))
        .collect()
}

#[test]
fn masks_hold_the_fractions_of_their_ranks() {
    if skips() {
        return;
    }
    let desk = Desk::new();
    for device in ["", "--device cpu"] {
        let line = |rest: &str| format!("blue-noise-mask --size 20 --seed 9 {rest} {device}");
        let expected = fractions(20, 1, 9);
        let (header, words) = array(&desk.make(&line("--fractions"), "f.npy"));
        assert!(
            header.contains("'<u4'") && header.contains("'shape': (20, 20,)"),
            "{header}"
        );
        assert_eq!(words, expected);
        let (header, words) = array(&desk.make(&line(""), "m.npy"));
        assert!(header.contains("'<f4'"), "{header}");
        assert!(
            words
                .into_iter()
                .eq(expected.iter().map(|f| unit_floor(*f).to_bits()))
        );

        let png = desk.make(&line(""), "m.png");
        let mut reader = png::Decoder::new(std::io::Cursor::new(png))
            .read_info()
            .expect("a PNG");
        let mut data = vec![0; reader.output_buffer_size().expect("a size")];
        reader.next_frame(&mut data).expect("a frame");
        let found = data
            .chunks(2)
            .map(|b| u32::from(b[0]) << 8 | u32::from(b[1]));
        assert!(found.eq(expected.iter().map(|f| f >> 16)));

        desk.make(&line(""), "m.exr");
        let image = corput::image::load_exr(&desk.path("m.exr")).expect("an image");
        let found = image.texels.iter().map(|texel| texel[0]);
        assert!(found.eq(expected.iter().map(|f| unit_floor(*f))));
    }
}

#[test]
fn channels_and_frames_are_axes() {
    if skips() {
        return;
    }
    let desk = Desk::new();
    let line = "blue-noise-mask --size 8 --frames 3 --channels 2 --fractions --seed 4";
    let (header, words) = array(&desk.make(line, "m.npy"));
    assert!(header.contains("'shape': (3, 8, 8, 2,)"), "{header}");
    let first: Vec<u32> = words.iter().step_by(2).copied().collect();
    assert_eq!(first, fractions(8, 3, 4));
    let second: Vec<u32> = words.iter().skip(1).step_by(2).copied().collect();
    assert_eq!(second, fractions(8, 3, MaskShape::channel_seed(4, 1)));
    // Frames lie one below the other in a picture.
    desk.make("blue-noise-mask --size 8 --frames 3", "m.exr");
    let image = corput::image::load_exr(&desk.path("m.exr")).expect("an image");
    assert_eq!((image.width, image.height), (8, 24));
}

#[test]
fn points_are_fractions_floats_and_samples() {
    if skips() {
        return;
    }
    let desk = Desk::new();
    let points = blue_noise_points(1024, 1).expect("points");
    let line = "blue-noise --count 1024 --seed 1";
    let found = npy(&desk.make(&format!("{line} --fractions"), "f.npy"));
    found.assert_is("<u4", 1024, 2);
    assert!((0..1024).all(|i| found.row(i) == points[i]));
    let found = npy(&desk.make(line, "p.npy"));
    found.assert_is("<f4", 1024, 2);
    assert!((0..1024).all(|i| found.row(i) == points[i].map(|u| unit_floor(u).to_bits())));
    let map = Map::from_name("cosine-hemisphere").expect("a map");
    let map = Mapping::new(map, &[]).expect("no parameters");
    let mapped = format!("{line} --map cosine-hemisphere --with-pdf");
    let found = npy(&desk.make(&mapped, "m.npy"));
    found.assert_is("<f4", 1024, 4);
    let sample = |p: [u32; 2]| bulk::map_sample(&map, Profile::Exact, [p[0], p[1], 0]);
    assert!((0..1024).all(|i| found.row(i) == sample(points[i])));
    let csv = desk.make(&format!("{line} --device cpu"), "p.csv");
    assert!(csv.starts_with(b"x0,x1\n") && csv.iter().filter(|b| **b == b'\n').count() == 1025);
}

#[test]
fn what_they_lack_is_refused() {
    let desk = Desk::new();
    for (line, words) in [
        ("blue-noise-mask", &["--size", "add --size 128"][..]),
        ("blue-noise-mask --size 0", &["0 x 0", "4 to 256"]),
        ("blue-noise-mask --size 257", &["257 x 257", "4 to 256"]),
        ("blue-noise-mask --size -3", &["negative"]),
        (
            "blue-noise-mask --size 64 --frames 17",
            &["17 frames", "1 to 16"],
        ),
        (
            "blue-noise-mask --size 64 --frames 0",
            &["0 frames", "1 to 16"],
        ),
        (
            "blue-noise-mask --size 128 --frames 16",
            &["262144", "at most 65536", "64 x 64"],
        ),
        (
            "blue-noise-mask --size 64 --channels 3",
            &["--channels 3", "1 or 2"],
        ),
        (
            "blue-noise-mask --size 64 --count 3",
            &["--count", "drop them"],
        ),
        (
            "blue-noise-mask --size 64 --map polar-disk",
            &["--map", "drop them"],
        ),
        (
            "blue-noise-mask --size 64 --format jpg",
            &["`jpg`", "npy, png, exr"],
        ),
        (
            "blue-noise-mask --size 64 --format png --fractions",
            &["--fractions", ".npy"],
        ),
        ("blue-noise", &["--count"]),
        ("blue-noise --count 0", &["--count is 0"]),
        ("blue-noise --count 65537", &["65537", "at most 65536"]),
        (
            "blue-noise --count 5 --size 5",
            &["--size", "blue-noise-mask"],
        ),
        (
            "blue-noise --count 5 --dims 3",
            &["3 dimensions", "it has 2:"],
        ),
        ("blue-noise --count 5 --first 1", &["--first"]),
        ("blue-noise --count 5 --bases 2,3", &["--bases"]),
        (
            "blue-noise --count 5 --profile native",
            &["--profile native", "--device cpu"],
        ),
        (
            "blue-noise --count 5 --fractions --map polar-disk",
            &["--fractions with --map"],
        ),
        ("halton --count 5 --frames 5", &["--frames with halton"]),
    ] {
        let run = desk.run(&format!("generate {line} --out m.npy"));
        run.expect(2, words);
        assert_eq!(desk.names(), [""; 0], "{line}");
    }
    let run = desk.run("generate blue-noise-mask --size 8 --device cpu --out none/m.png");
    run.expect(2, &["folder none does not exist"]);
    desk.run("generate blue-noise-mask --size 8 --device cpu --out m.gif")
        .expect(2, &["`gif`", "png"]);
    assert_eq!(desk.names(), [""; 0]);
}
