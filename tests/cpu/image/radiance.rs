//! Radiance pictures: every encoding, what is refused, and files that are damaged.

use super::{Folder, refusal, refused};
use corput::image::{load, load_raw};

const WIDTH: usize = 301;
const HEIGHT: usize = 7;

/// Texels with runs of all lengths, and no exponent of 1, 1, 1.
fn texels() -> Vec<[u8; 4]> {
    (0..WIDTH * HEIGHT)
        .map(|i| {
            let run = match i % WIDTH {
                column @ 0..40 => column,
                column @ 40..200 => 40 + column / 60,
                column => 50 + column / 5,
            };
            [
                (run * 7) as u8,
                (i / WIDTH) as u8 + 2,
                200,
                (run % 9) as u8 + 125,
            ]
        })
        .collect()
}

/// As Radiance decodes them.
fn expected(exposure: f64) -> Vec<[f32; 3]> {
    texels()
        .iter()
        .map(|&[r, g, b, e]| {
            [r, g, b].map(|c| {
                ((f64::from(c) + 0.5) / 256.0 * f64::powi(2.0, i32::from(e) - 128) / exposure)
                    as f32
            })
        })
        .collect()
}

fn file(header: &str, rows: impl Fn(&[[u8; 4]]) -> Vec<u8>) -> Vec<u8> {
    let mut bytes = header.as_bytes().to_vec();
    for row in texels().chunks(WIDTH) {
        bytes.extend(rows(row));
    }
    bytes
}

fn header() -> String {
    format!("#?RADIANCE\n# a comment\nFORMAT=32-bit_rle_rgbe\n\n-Y {HEIGHT} +X {WIDTH}\n")
}

fn flat(row: &[[u8; 4]]) -> Vec<u8> {
    row.concat()
}

/// A texel, and then runs of it in the old way, in two bytes where it is long.
fn old(row: &[[u8; 4]]) -> Vec<u8> {
    let mut bytes = Vec::new();
    for run in row.chunk_by(|a, b| a == b) {
        bytes.extend(run[0]);
        let more = run.len() - 1;
        if more > 255 {
            bytes.extend([1, 1, 1, more as u8, 1, 1, 1, (more >> 8) as u8]);
        } else if more > 0 {
            bytes.extend([1, 1, 1, more as u8]);
        }
    }
    bytes
}

/// The four bytes apart, runs of three or more shortened.
fn new(row: &[[u8; 4]]) -> Vec<u8> {
    let mut bytes = vec![2, 2, (row.len() >> 8) as u8, row.len() as u8];
    for part in 0..4 {
        let values: Vec<u8> = row.iter().map(|texel| texel[part]).collect();
        for run in values.chunk_by(|a, b| a == b) {
            for piece in run.chunks(127) {
                match piece.len() {
                    1 | 2 => {
                        bytes.push(piece.len() as u8);
                        bytes.extend(piece);
                    }
                    n => bytes.extend([128 + n as u8, piece[0]]),
                }
            }
        }
    }
    bytes
}

#[test]
fn every_encoding_gives_the_same_texels() {
    let folder = Folder::new();
    for (name, rows) in [
        ("flat.hdr", flat as fn(&[[u8; 4]]) -> Vec<u8>),
        ("old.HDR", old),
        ("new.pic", new),
    ] {
        let image = load(&folder.bytes(name, &file(&header(), rows))).unwrap();
        assert_eq!((image.width, image.height), (WIDTH as u32, HEIGHT as u32));
        assert_eq!(image.texels, expected(1.0), "{name}");
    }
    // Exposures multiply, and what lies beside the format is passed over.
    let header =
        format!("#?RGBE\r\nEXPOSURE=4\r\nVIEW= -vtv\nEXPOSURE= 0.5\n\n-Y {HEIGHT} +X {WIDTH}\n");
    let image = load(&folder.bytes("exposed.hdr", &file(&header, new))).unwrap();
    assert_eq!(image.texels, expected(2.0));
    // One texel, and a zero exponent.
    let image =
        load(&folder.bytes("one.hdr", b"#?RADIANCE\n\n-Y 1 +X 1\n\x07\x08\x09\x00")).unwrap();
    assert_eq!(image.texels, [[0.0; 3]]);
}

#[test]
fn what_is_no_such_picture_is_refused() {
    let folder = Folder::new();
    let body = |lines: &str| file(lines, flat);
    let tell = |lines: &str, parts: &[&str]| {
        refused_by_load(&folder, &body(lines), parts);
    };
    tell("P6 7 7\n", &["no Radiance picture"]);
    tell(
        "#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 7 +X 301\n",
        &["32-bit_rle_xyze"],
    );
    tell("#?RADIANCE\n\n+X 301 -Y 7\n", &["run +X and -Y"]);
    tell("#?RADIANCE\n\n+Y 7 +X 301\n", &["run +Y and +X"]);
    tell("#?RADIANCE\n\n-Y 0 +X 301\n", &["301 x 0", "no texels"]);
    tell(
        "#?RADIANCE\n\n-Y 4097 +X 301\n",
        &["301 x 4097", "8192 x 4096"],
    );
    tell(
        "#?RADIANCE\n\n-Y 99999999999999999999 +X 301\n",
        &["8192 x 4096"],
    );
    tell("#?RADIANCE\n\n-Y -7 +X 301\n", &["8192 x 4096"]);
    tell("#?RADIANCE\n\n301 7\n", &["no size"]);
    tell(
        "#?RADIANCE\nEXPOSURE=0\n\n-Y 7 +X 301\n",
        &["exposure is 0"],
    );
    tell(
        "#?RADIANCE\nEXPOSURE=x\n\n-Y 7 +X 301\n",
        &["exposure is NaN"],
    );
    tell("#?RADIANCE\n\n-Y 4096 +X 8192\n", &["truncated"]);
    tell(
        &format!("#?RADIANCE\n{}", "x".repeat(1 << 17)),
        &["header does not end"],
    );
    tell(
        &format!("#?RADIANCE\n{}", "x\n".repeat(1 << 16)),
        &["header does not end"],
    );
    let mut bytes = header().into_bytes();
    bytes.extend([2, 2, 1, 44]);
    bytes.resize(bytes.len() + 4000, 1);
    refused_by_load(&folder, &bytes, &["300 texels, not 301"]);
    let mut bytes = header().into_bytes();
    bytes.extend([1, 1, 1, 9]);
    bytes.resize(bytes.len() + 4000, 1);
    refused_by_load(&folder, &bytes, &["longer than its row"]);
    refused(&folder.path("absent.hdr"), &["cannot be opened"]);
    refused(&folder.bytes("empty.hdr", b""), &["empty"]);
}

fn refused_by_load(folder: &Folder, bytes: &[u8], parts: &[&str]) {
    refused(&folder.bytes("bad.hdr", bytes), parts);
}

#[test]
fn no_damage_makes_the_reader_panic() {
    let folder = Folder::new();
    for rows in [flat as fn(&[[u8; 4]]) -> Vec<u8>, old, new] {
        let sound = file(&header(), rows);
        for length in (0..sound.len()).step_by(11).chain([sound.len() - 1]) {
            refusal(&folder.bytes("cut.hdr", &sound[..length]));
        }
        let mut state = 0x9e37_79b9_7f4a_7c15_u64;
        let mut draw = |below: usize| {
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            (state >> 16) as usize % below
        };
        let (mut read, mut refused) = (0, 0);
        for _ in 0..2000 {
            let mut bytes = sound.clone();
            for _ in 0..1 + draw(4) {
                let range = if draw(2) == 0 { 80 } else { bytes.len() };
                bytes[draw(range)] = draw(256) as u8;
            }
            match load_raw(&folder.bytes("damaged.hdr", &bytes)) {
                Ok(image) => {
                    let size = u64::from(image.width) * u64::from(image.height);
                    assert_eq!(image.texels.len() as u64, size);
                    read += 1;
                }
                Err(_) => refused += 1,
            }
        }
        println!("{read} read, {refused} refused");
        assert!(read > 100 && refused > 100);
    }
}

#[test]
fn pictures_longer_than_the_largest_are_not_read() {
    let folder = Folder::new();
    let path = folder.bytes("long.hdr", &file(&header(), flat));
    // Rows of 8192 texels whose every byte is a run, 4096 times, and headers.
    let most = (1 << 17) + 4096 * (4 + 8 * 8192);
    let longer = |length| {
        let file = std::fs::OpenOptions::new().write(true).open(&path).unwrap();
        file.set_len(length).unwrap();
    };
    longer(most + 1);
    refused(&path, &["it has 268582913 bytes; the limit is 268582912"]);
    longer(1 << 20);
    assert!(load(&path).is_ok());
}
