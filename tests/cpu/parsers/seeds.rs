//! Small files of every kind that the parsers know. `CORPUT_WRITE_TABLES=1 cargo test --release
//! --all-features --test parsers` writes them.

use exr::prelude::*;

const WIDTH: usize = 19;
const HEIGHT: usize = 6;

type Seed = (&'static str, String, Vec<u8>);

/// Parser, file name and bytes of each.
pub fn seeds() -> Vec<Seed> {
    let mut seeds = pictures();
    seeds.extend(radiance());
    seeds.extend(arrays());
    let text = |parser, name: &str, text: &str| (parser, name.to_owned(), text.as_bytes().to_vec());
    seeds.push(text(
        "study",
        "whole.toml",
        include_str!("../../data/study.toml"),
    ));
    seeds.push(text("study", "estimators.toml", STUDY));
    seeds.push(text("check", "rows.json", CHECK));
    let none =
        r#"{"rows": [{"name": "r2", "kernel": "tile", "profile": "exact", "sha256": null}]}"#;
    seeds.push(text("check", "none.json", none));
    seeds.extend(scenes());
    seeds
}

/// Scene files without images, and glTF of both kinds with its bytes inside.
fn scenes() -> Vec<Seed> {
    let text = |name: &str, text: &str| ("scene", name.to_owned(), text.as_bytes().to_vec());
    let mut lantern: serde_json::Value =
        serde_json::from_str(include_str!("../../data/scenes/lantern.gltf")).expect("JSON");
    let bytes = include_bytes!("../../data/scenes/lantern.bin");
    lantern["buffers"][0]["uri"] = format!("data:;base64,{}", base64(bytes)).into();
    vec![
        text("fog.toml", include_str!("../../data/scenes/fog.toml")),
        text(
            "glossy.toml",
            include_str!("../../data/scenes/glossy_sphere.toml"),
        ),
        text(
            "layered.toml",
            include_str!("../../data/scenes/layered.toml"),
        ),
        text(
            "lights.toml",
            include_str!("../../data/scenes/many_lights.toml"),
        ),
        text("lantern.gltf", &lantern.to_string()),
        ("scene", "triangle.glb".to_owned(), triangle()),
    ]
}

fn base64(bytes: &[u8]) -> String {
    const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let group = |three: &[u8]| {
        let word = (0..3).fold(0, |word, k| {
            word << 8 | usize::from(three.get(k).copied().unwrap_or(0))
        });
        let digit = |k: usize| char::from(DIGITS[word >> (18 - 6 * k) & 63]);
        let padded = |k: usize| if k <= three.len() { digit(k) } else { '=' };
        [padded(0), padded(1), padded(2), padded(3)]
    };
    bytes.chunks(3).flat_map(group).collect()
}

/// One triangle that emits, and a point light.
fn triangle() -> Vec<u8> {
    let mut json = TRIANGLE.replace('\n', "").into_bytes();
    json.resize(json.len().next_multiple_of(4), b' ');
    let vertices = [0.0f32, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0];
    let data: Vec<u8> = vertices.iter().flat_map(|x| x.to_le_bytes()).collect();
    let word = |n: usize| (n as u32).to_le_bytes();
    let mut bytes = b"glTF".to_vec();
    bytes.extend(word(2));
    bytes.extend(word(28 + json.len() + data.len()));
    for (kind, chunk) in [(b"JSON", json), (b"BIN\0", data)] {
        bytes.extend(word(chunk.len()));
        bytes.extend(kind);
        bytes.extend(chunk);
    }
    bytes
}

const TRIANGLE: &str = r#"{"asset":{"version":"2.0"},"scene":0,
"extensionsRequired":["KHR_lights_punctual"],
"extensions":{"KHR_lights_punctual":{"lights":[{"type":"point"}]}},
"scenes":[{"nodes":[0,1]}],
"nodes":[{"mesh":0},{"extensions":{"KHR_lights_punctual":{"light":0}}}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0},"material":0}]}],
"materials":[{"emissiveFactor":[1,1,1]}],
"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}],
"bufferViews":[{"buffer":0,"byteLength":36}],
"buffers":[{"byteLength":36}]}"#;

const STUDY: &str = r#"replicates = 32
seed = 7
min-count = 16
max-count = 64
targets = [1e-2, 1e-3]
samplers = ["random", "sobol:owen"]

[[integrand]]
name = "soft-shadow"
estimators = ["uniform", "light"]

[[integrand]]
name = "product:d=4,decay=2"
samplers = ["halton"]
"#;

const CHECK: &str = r#"{"schema": 1, "rows": [
 {"name": "sobol", "kernel": "generate", "profile": "exact", "sha256": "00ff"},
 {"name": "disk", "kernel": "map_planar", "profile": "native", "sha256": null}]}
"#;

fn texel(i: usize, channel: usize) -> f32 {
    ((i * 3 + channel) % 61) as f32 / 4.0
}

fn pictures() -> Vec<Seed> {
    let tiles = Blocks::Tiles(Vec2(8, 4));
    let encodings = [
        ("plain", Compression::Uncompressed, Blocks::ScanLines),
        ("rle", Compression::RLE, Blocks::ScanLines),
        ("zip1", Compression::ZIP1, Blocks::ScanLines),
        ("zip16-tiles", Compression::ZIP16, tiles),
        ("piz", Compression::PIZ, Blocks::ScanLines),
        ("pxr24-tiles", Compression::PXR24, tiles),
        ("b44", Compression::B44, Blocks::ScanLines),
        ("b44a", Compression::B44A, Blocks::ScanLines),
        ("dwaa", Compression::DWAA(None), Blocks::ScanLines),
        ("dwab", Compression::DWAB(None), Blocks::ScanLines),
    ];
    let seed = |(name, compression, blocks): (&str, _, _)| {
        let encoding = Encoding {
            compression,
            blocks,
            line_order: LineOrder::Increasing,
        };
        let channel = |(c, name): (usize, &str)| {
            let values = (0..WIDTH * HEIGHT).map(|i| f16::from_f32(texel(i, c)));
            AnyChannel::new(name, FlatSamples::F16(values.collect()))
        };
        let channels = ["R", "G", "B"]
            .into_iter()
            .enumerate()
            .map(channel)
            .collect();
        let channels = AnyChannels::sort(channels);
        let layer = Layer::new(
            (WIDTH, HEIGHT),
            LayerAttributes::default(),
            encoding,
            channels,
        );
        let window = IntegerBounds::from_dimensions((WIDTH, HEIGHT));
        let image = Image::from_layers(ImageAttributes::new(window), vec![layer]);
        let mut bytes = std::io::Cursor::new(Vec::new());
        let written = image.write().non_parallel().to_buffered(&mut bytes);
        written.expect("an image is written");
        ("exr", format!("{name}.exr"), bytes.into_inner())
    };
    encodings.map(seed).into()
}

fn radiance() -> Vec<Seed> {
    let head =
        format!("#?RADIANCE\nEXPOSURE=2\nFORMAT=32-bit_rle_rgbe\n\n-Y {HEIGHT} +X {WIDTH}\n");
    let texel = |i: usize| [(i / 5 * 9) as u8, 7, 200, 126 + (i % 3) as u8];
    let mut flat = head.clone().into_bytes();
    flat.extend((0..WIDTH * HEIGHT).flat_map(texel));
    let mut old = head.clone().into_bytes();
    let mut new = head.into_bytes();
    for row in 0..HEIGHT {
        old.extend([row as u8, 8, 9, 130, 1, 1, 1, WIDTH as u8 - 1]);
        new.extend([2, 2, 0, WIDTH as u8]);
        for part in 0..4 {
            new.extend([128 + 9, 100 + part, (WIDTH - 9) as u8]);
            new.extend((9..WIDTH).map(|i| texel(row * WIDTH + i)[usize::from(part)]));
        }
    }
    [("flat", flat), ("old-runs", old), ("new-runs", new)]
        .map(|(name, bytes)| ("hdr", format!("{name}.hdr"), bytes))
        .into()
}

fn arrays() -> Vec<Seed> {
    let array = |version: u8, kind: &str, fortran: &str, data: &[u8]| {
        let text =
            format!("{{'descr': '{kind}', 'fortran_order': {fortran}, 'shape': (3, 2), }}\n");
        let mut bytes = b"\x93NUMPY".to_vec();
        bytes.extend([version, 0]);
        match version {
            1 => bytes.extend((text.len() as u16).to_le_bytes()),
            _ => bytes.extend((text.len() as u32).to_le_bytes()),
        }
        bytes.extend(text.as_bytes());
        bytes.extend(data);
        bytes
    };
    let values = [0.0f64, 0.25, 0.5, 0.999, 1e-9, 0.125];
    let f4: Vec<u8> = values
        .iter()
        .flat_map(|&x| (x as f32).to_le_bytes())
        .collect();
    let f8: Vec<u8> = values.iter().flat_map(|&x| x.to_be_bytes()).collect();
    let u4: Vec<u8> = (0..6u32).flat_map(|n| (n << 29).to_le_bytes()).collect();
    [
        ("f4", array(1, "<f4", "False", &f4)),
        ("f8-big", array(2, ">f8", "True", &f8)),
        ("u4", array(3, "<u4", "False", &u4)),
    ]
    .map(|(name, bytes)| ("npy", format!("{name}.npy"), bytes))
    .into()
}
