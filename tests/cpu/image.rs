//! Environment maps are read rightly, and every bad file is refused with a message.

#[path = "image/radiance.rs"]
mod radiance;

use std::fs;
use std::path::{Path, PathBuf};

use corput::Error;
use corput::image::{Image, load, load_exr, load_raw};
use exr::prelude::*;

const WIDTH: usize = 37;
const HEIGHT: usize = 21;

/// Small integers, exact in f16, f32 and u32, another for each texel and channel.
fn expected() -> Vec<[f32; 3]> {
    (0..WIDTH * HEIGHT)
        .map(|i| [0, 1, 2].map(|c| ((i * 3 + c) % 2003) as f32))
        .collect()
}

fn channel(name: &str, kind: SampleType, value: impl Fn(usize) -> f32) -> AnyChannel<FlatSamples> {
    let values = (0..WIDTH * HEIGHT).map(value);
    let samples = match kind {
        SampleType::F16 => FlatSamples::F16(values.map(f16::from_f32).collect()),
        SampleType::F32 => FlatSamples::F32(values.collect()),
        SampleType::U32 => FlatSamples::U32(values.map(|v| v as u32).collect()),
    };
    AnyChannel::new(name, samples)
}

/// The named channels; the last letter of a name says what it holds.
fn layer(names: &[&str], kind: SampleType, encoding: Encoding) -> Layer<AnyChannels<FlatSamples>> {
    let texels = expected();
    let channels = names
        .iter()
        .map(|name| {
            let index = match name.chars().last() {
                Some('G') => 1,
                Some('B') => 2,
                _ => 0,
            };
            channel(name, kind, |i| texels[i][index])
        })
        .collect();
    let name = LayerAttributes::named(names.concat().as_str());
    Layer::new((WIDTH, HEIGHT), name, encoding, AnyChannels::sort(channels))
}

fn plain(names: &[&str]) -> Layer<AnyChannels<FlatSamples>> {
    layer(names, SampleType::F32, Encoding::UNCOMPRESSED)
}

struct Folder(tempfile::TempDir);

impl Folder {
    fn new() -> Self {
        Self(tempfile::tempdir().unwrap())
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    fn bytes(&self, name: &str, bytes: &[u8]) -> PathBuf {
        let path = self.path(name);
        fs::write(&path, bytes).unwrap();
        path
    }

    fn layers(&self, name: &str, layers: Vec<Layer<AnyChannels<FlatSamples>>>) -> PathBuf {
        let path = self.path(name);
        let window = IntegerBounds::from_dimensions((WIDTH, HEIGHT));
        let image = exr::image::Image::from_layers(ImageAttributes::new(window), layers);
        image.write().non_parallel().to_file(&path).unwrap();
        path
    }
}

fn data(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("tests/data")
        .join(name)
}

fn check(path: &Path, texels: &[[f32; 3]]) {
    let Image {
        width,
        height,
        texels: read,
        ..
    } = load_exr(path).unwrap();
    assert_eq!(
        (width as usize, height as usize),
        (WIDTH, HEIGHT),
        "{}",
        path.display()
    );
    assert_eq!(read, texels, "{}", path.display());
}

/// The message of a refusal, which names the file and ends in a remedy.
fn refusal(path: &Path) -> String {
    match load(path) {
        Ok(_) => panic!("{} was read", path.display()),
        Err(Error::Image {
            path: named,
            problem,
            remedy,
        }) => {
            assert_eq!(named, path);
            assert!(!remedy.is_empty());
            problem
        }
        Err(other) => panic!("{other}"),
    }
}

fn refused(path: &Path, parts: &[&str]) {
    let problem = refusal(path);
    for part in parts {
        assert!(problem.contains(part), "`{problem}` lacks `{part}`");
    }
}

#[test]
fn real_maps_are_read() {
    // The peaks and counts are those that OpenEXR 3.5 decodes.
    for (name, peak, clamped) in [("sunrise.exr", 33_664.0, 570), ("studio.exr", 118.375, 3)] {
        let image = load_exr(&data(name)).unwrap();
        assert_eq!((image.width, image.height), (1024, 512));
        assert_eq!(image.texels.len(), 1024 * 512);
        let most = image
            .texels
            .iter()
            .flatten()
            .fold(0.0, |a: f32, &b| a.max(b));
        assert_eq!((most, image.clamped), (peak, clamped), "{name}");
        assert!(
            image
                .texels
                .iter()
                .flatten()
                .all(|l| l.is_finite() && *l >= 0.0)
        );
    }
}

#[test]
fn every_encoding_and_sample_type_is_read() {
    let folder = Folder::new();
    let texels = expected();
    for kind in [SampleType::F16, SampleType::F32, SampleType::U32] {
        for compression in [
            Compression::Uncompressed,
            Compression::RLE,
            Compression::ZIP1,
            Compression::ZIP16,
            Compression::PIZ,
            Compression::PXR24,
        ] {
            for blocks in [Blocks::ScanLines, Blocks::Tiles(Vec2(16, 8))] {
                for line_order in [LineOrder::Increasing, LineOrder::Decreasing] {
                    let encoding = Encoding {
                        compression,
                        blocks,
                        line_order,
                    };
                    let name = format!("{kind:?}-{compression}-{blocks:?}-{line_order:?}.exr");
                    let path = folder.layers(&name, vec![layer(&["R", "G", "B"], kind, encoding)]);
                    check(&path, &texels);
                }
            }
        }
    }
}

#[test]
fn channels_and_parts_in_any_order_are_read() {
    let folder = Folder::new();
    let texels = expected();
    check(
        &folder.layers("rgba.exr", vec![plain(&["A", "B", "G", "R"])]),
        &texels,
    );
    check(
        &folder.layers(
            "layer.exr",
            vec![plain(&["dR", "Z", "v.w.R", "v.w.G", "v.w.B"])],
        ),
        &texels,
    );
    check(
        &folder.layers("parts.exr", vec![plain(&["Z"]), plain(&["R", "G", "B"])]),
        &texels,
    );
    check(
        &folder.layers(
            "luminance.exr",
            vec![plain(&["Y"]), plain(&["B", "G", "R"])],
        ),
        &texels,
    );
    let grey: Vec<[f32; 3]> = texels.iter().map(|t| [t[0]; 3]).collect();
    check(&folder.layers("grey.exr", vec![plain(&["A", "Y"])]), &grey);
}

#[test]
fn files_that_are_no_images_are_refused() {
    let folder = Folder::new();
    refused(&folder.path("absent.exr"), &["cannot be opened"]);
    refused(folder.0.path(), &["no regular file"]);
    refused(&folder.bytes("empty.exr", b""), &["empty"]);
    refused(
        &folder.bytes("text.exr", b"not an image, but a line of text\n"),
        &["no sound OpenEXR"],
    );
    refused(
        &folder.bytes("zeros.exr", &[0; 4096]),
        &["no sound OpenEXR"],
    );
    refused(
        &folder.layers("depth.exr", vec![plain(&["Z"])]),
        &["no colour channels", "(it has Z)"],
    );
    refused(
        &folder.layers("two.exr", vec![plain(&["R", "B"])]),
        &["no colour channels", "B, R"],
    );
    let chroma = vec![plain(&["RY", "BY", "Y"])];
    refused(
        &folder.layers("chroma.exr", chroma),
        &["luminance and chroma"],
    );
}

#[test]
fn texels_that_no_light_has_are_counted_and_located() {
    let folder = Folder::new();
    for (name, value, kind) in [
        ("nan.exr", f32::NAN, "not finite"),
        ("inf.exr", f32::INFINITY, "not finite"),
        ("negative.exr", -0.25, "negative"),
    ] {
        let at = |i: usize| {
            if i == 5 * WIDTH + 7 || i == 600 {
                value
            } else {
                1.0
            }
        };
        let mut part = plain(&["R", "G", "B"]);
        part.channel_data.list[0] = channel("B", SampleType::F32, |_| 1.0);
        part.channel_data.list[1] = channel("G", SampleType::F32, at);
        part.channel_data.list[2] = channel("R", SampleType::F32, |_| 1.0);
        let path = folder.layers(name, vec![part]);
        refused(&path, &["2 texels", kind, "column 7, row 5"]);
    }
    let mut part = plain(&["R", "G", "B"]);
    part.channel_data.list[2] = channel("R", SampleType::F16, |i| if i == 0 { 7e4 } else { -0.0 });
    refused(
        &folder.layers("one.exr", vec![part]),
        &["1 texel (column 0, row 0", "is not finite"],
    );
    // For an environment, which counts them, they are read as they are.
    let raw = load_raw(&folder.path("nan.exr")).unwrap();
    assert!(raw.texels[600][1].is_nan() && raw.clamped == 0);
    // What lossy compression leaves below 0 is clamped and counted.
    let mut part = plain(&["R", "G", "B"]);
    part.channel_data.list[1] = channel("G", SampleType::F32, |i| if i == 9 { -1e-3 } else { 2.0 });
    let image = load_exr(&folder.layers("ringing.exr", vec![part])).unwrap();
    assert_eq!((image.clamped, image.texels[9][1]), (1, 0.0));
}

/// The file with bytes after an attribute's name and type replaced.
fn patched(bytes: &[u8], attribute: &[u8], offset: usize, values: &[u8]) -> Vec<u8> {
    let start = bytes
        .windows(attribute.len())
        .position(|w| w == attribute)
        .unwrap();
    let at = start + attribute.len() + 4 + offset;
    let mut bytes = bytes.to_vec();
    bytes[at..at + values.len()].copy_from_slice(values);
    bytes
}

#[test]
fn sizes_are_judged_before_anything_is_allocated() {
    let folder = Folder::new();
    let sound = fs::read(folder.layers("sound.exr", vec![plain(&["R", "G", "B"])])).unwrap();
    let window: &[u8] = b"dataWindow\0box2i\0";
    for (x, y) in [
        (8192, 20),
        (36, 4096),
        (i32::MAX - 1, i32::MAX - 1),
        (100_000, 100_000),
    ] {
        let corner = [x, y].map(i32::to_le_bytes).concat();
        let name = format!("{x}-{y}.exr");
        let problem = refusal(&folder.bytes(&name, &patched(&sound, window, 8, &corner)));
        let limit = problem.contains("the limit is 8192 x 4096");
        assert!(limit || problem.contains("no sound OpenEXR"), "{problem}");
        assert!(limit || x > 100_000, "{problem}");
    }
    // As large as allowed, but nothing there: no more is allocated than the file is long.
    let corner = [8191, 4095].map(i32::to_le_bytes).concat();
    refused(
        &folder.bytes("void.exr", &patched(&sound, window, 8, &corner)),
        &["truncated"],
    );
    let corner = [36, 19].map(i32::to_le_bytes).concat();
    let cropped = patched(&sound, b"displayWindow\0box2i\0", 8, &corner);
    refused(
        &folder.bytes("cropped.exr", &cropped),
        &["37 x 21 in a display window of 37 x 20"],
    );
    // A channel is its name, type, linearity with padding, then the two samplings.
    let sampled = patched(
        &sound,
        b"channels\0chlist\0",
        2 + 4 + 4,
        &2_i32.to_le_bytes(),
    );
    refusal(&folder.bytes("subsampled.exr", &sampled));
}

#[test]
fn truncation_is_refused_at_every_offset() {
    let folder = Folder::new();
    for compression in [
        Compression::Uncompressed,
        Compression::ZIP16,
        Compression::PIZ,
    ] {
        let encoding = Encoding {
            compression,
            ..Encoding::UNCOMPRESSED
        };
        let part = layer(&["R", "G", "B"], SampleType::F16, encoding);
        let sound = fs::read(folder.layers("sound.exr", vec![part])).unwrap();
        for length in (0..sound.len()).step_by(7).chain([sound.len() - 1]) {
            refusal(&folder.bytes("cut.exr", &sound[..length]));
        }
    }
    let sunrise = fs::read(data("sunrise.exr")).unwrap();
    for part in 0..16 {
        refusal(&folder.bytes("cut.exr", &sunrise[..sunrise.len() * part / 16]));
    }
}

#[test]
fn damaged_files_never_panic() {
    let folder = Folder::new();
    let mut files = vec![fs::read(data("studio.exr")).unwrap()];
    for (compression, blocks) in [
        (Compression::Uncompressed, Blocks::ScanLines),
        (Compression::ZIP16, Blocks::Tiles(Vec2(16, 16))),
        (Compression::RLE, Blocks::ScanLines),
        (Compression::PIZ, Blocks::ScanLines),
        (Compression::PXR24, Blocks::Tiles(Vec2(16, 16))),
        (Compression::B44, Blocks::ScanLines),
        (Compression::DWAA(None), Blocks::ScanLines),
    ] {
        let encoding = Encoding {
            compression,
            blocks,
            line_order: LineOrder::Increasing,
        };
        let part = layer(&["R", "G", "B"], SampleType::F16, encoding);
        files.push(fs::read(folder.layers("sound.exr", vec![part])).unwrap());
    }
    let mut state = 0x1234_5678_9abc_def1_u64;
    let mut draw = |below: usize| {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 16) as usize % below
    };
    let (mut read, mut refused, mut unwound) = (0, 0, 0);
    for round in 0..corruptions() {
        // The large file, slow to decode, once in 24.
        let which = if round % 24 == 0 {
            0
        } else {
            1 + draw(files.len() - 1)
        };
        let mut bytes = files[which].clone();
        for _ in 0..1 + draw(4) {
            // Half of the damage goes to the header, which is short.
            let range = if draw(2) == 0 {
                bytes.len().min(400)
            } else {
                bytes.len()
            };
            let at = draw(range);
            match draw(3) {
                0 => bytes[at] ^= 1 << draw(8),
                1 => bytes[at] = draw(256) as u8,
                _ => bytes[at] = [0, 0xff, 0x7f, 0x80][draw(4)],
            }
        }
        match load_exr(&folder.bytes("damaged.exr", &bytes)) {
            Ok(image) => {
                assert!(
                    image
                        .texels
                        .iter()
                        .flatten()
                        .all(|l| l.is_finite() && *l >= 0.0)
                );
                read += 1;
            }
            Err(Error::Image { problem, .. }) => {
                unwound += usize::from(problem.contains("made the decoder fail"));
                refused += 1;
            }
            Err(other) => panic!("{other}"),
        }
    }
    println!("{read} read, {refused} refused, of which {unwound} unwound the decoder");
}

/// 300, or as many as `CORPUT_CORRUPTIONS` says.
fn corruptions() -> usize {
    std::env::var("CORPUT_CORRUPTIONS").map_or(300, |n| n.parse().unwrap())
}
