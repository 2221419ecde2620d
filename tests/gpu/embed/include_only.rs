//! examples/include_only.comp: a shader with names of its own over the headers.

use crate::support::{on_each_device, pipeline, words};
use corput::compile::to_spirv;
use corput::glam::{UVec2, UVec4, uvec2, uvec4};
use corput::reference::disk::concentric_disk;
use corput::reference::domain::{domain, domain_child};
use corput::reference::domain_draw::draw_pairs;
use corput::reference::halton::halton;
use corput::reference::hemisphere::{cosine_hemisphere, cosine_hemisphere_pdf};
use corput::reference::random::random;
use corput::reference::sobol::sobol;
use corput::tables::sobol_directions;
use corput::vulkan::{Access, Buffer, Device};
use std::sync::Arc;

const SHADER: &str = include_str!("../../../examples/include_only.comp");

const GROUPS: u64 = 4;
const COUNT: u32 = 256;
const SEED: u32 = 7;

fn header(name: &str) -> Option<String> {
    let found = corput::headers().iter().find(|(known, _)| *known == name);
    found.map(|(_, text)| (*text).to_owned())
}

fn compiled(text: &str) -> Vec<u32> {
    to_spirv(text, &[], &mut header).unwrap_or_else(|error| panic!("{error}"))
}

fn made(device: &Arc<Device>, module: &[u32]) -> Vec<u32> {
    let pipeline = pipeline(device, module, &[0, 1], 0);
    let numbers = [sobol_directions(0), sobol_directions(1)].concat();
    let mut directions = Buffer::new(device, 4 * numbers.len() as u64, Access::Upload).unwrap();
    directions.write(0, bytemuck::cast_slice(&numbers)).unwrap();
    let bytes = 64 * u64::from(COUNT);
    let mut samples = Buffer::new(device, bytes, Access::Readback).unwrap();
    let buffers = [(0, &samples), (1, &directions)];
    device.run(&pipeline, &buffers, &[], GROUPS).unwrap();
    samples.read(0, bytes, words).unwrap()
}

/// What the shader writes for one invocation.
fn expected(i: u32) -> [UVec4; 4] {
    let coordinate = |d: u32| sobol(i, &sobol_directions(d));
    let point = uvec2(coordinate(0), coordinate(1));
    let disk = concentric_disk(point);
    let d = cosine_hemisphere(uvec2(halton(i, 2), halton(i, 3)));
    let pdf = cosine_hemisphere_pdf(d);
    let camera = domain(uvec2(i % 8, i / 8), 0, i, SEED);
    // The shader's own functions.
    let hash = |x: u32| (x ^ (x >> 16)).wrapping_mul(0x9e37_79b9);
    let own = UVec2::new(i / 3, i.reverse_bits()) ^ UVec2::splat(1);
    [
        uvec4(point.x, point.y, disk.x.to_bits(), disk.y.to_bits()),
        uvec4(d.x.to_bits(), d.y.to_bits(), d.z.to_bits(), pdf.to_bits()),
        draw_pairs(domain_child(camera, 1)),
        uvec4(
            hash(SEED + i),
            own.x.wrapping_add(own.y),
            (i + SEED) % 100,
            random(i, 0, uvec2(SEED, 0)),
        ),
    ]
}

fn expected_words() -> Vec<u32> {
    let rows = (0..COUNT).flat_map(expected);
    rows.flat_map(|row| row.to_array()).collect()
}

#[test]
fn headers_live_beside_an_engines_own_names() {
    let expected = expected_words();
    let module = compiled(SHADER);
    let flat = corput::strip::flatten(SHADER, &[], &mut header).unwrap();
    let flat = compiled(&flat.text);
    // Neither its own functions nor the headers' may change unnoticed.
    let breaks = [
        ("return u.yx ^ 1u;", "return u.yx ^ 2u;"),
        ("#define SEED 7u", "#define SEED 8u"),
        ("(d) == 0u ? 2u : 3u", "(d) == 0u ? 2u : 5u"),
    ];
    on_each_device(|device| {
        assert_eq!(made(device, &module), expected);
        assert_eq!(made(device, &flat), expected, "flattened");
        for (from, to) in breaks {
            assert!(SHADER.contains(from), "{from}");
            let broken = compiled(&SHADER.replacen(from, to, 1));
            assert_ne!(made(device, &broken), expected, "{to}");
        }
    });
}
