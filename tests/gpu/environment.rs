//! The largest environment maps: tables in two buffers, and one texel of 1e9 among 2^25
//! (row 35 of the catalogue of extreme cases).

mod support;

use corput::bulk::map_sample;
use corput::catalog::{Map, Mapping, Profile};
use corput::check::mix;
use corput::environment::{Counts, Environment, Kind, Options};
use corput::interface::{TABLE_WORDS, task};
use corput::judge::environment::EnvironmentTables;
use corput::kernels::Mapper;
use std::time::Instant;

/// The hot texel: near the lower end, behind the first buffer's words.
const HOT: [u32; 2] = [8000, 4000];

fn build(width: u32, height: u32, kind: Kind) -> Environment {
    let [column, row] = HOT.map(|at| at % width);
    let mut texels = vec![[1.0f32; 3]; (width * height) as usize];
    texels[(row * width + column) as usize] = [1e9; 3];
    let options = Options {
        kind,
        ..Options::default()
    };
    let start = Instant::now();
    let made =
        Environment::new(width, height, &texels, options).unwrap_or_else(|error| panic!("{error}"));
    println!(
        "{width} x {height} {kind:?}: {:.2} s, {} MiB of tables",
        start.elapsed().as_secs_f64(),
        made.words().len() >> 18
    );
    assert_eq!(made.counts(), &Counts::default());
    assert!(made.words().len() > TABLE_WORDS);
    made
}

/// All probabilities sum to 2^64, none is 0, and the hot texel has its share.
fn sound(made: &Environment) {
    let (width, height) = (made.width(), made.height());
    let tables = EnvironmentTables {
        width,
        height,
        alias: made.kind() == Kind::Alias,
        words: made.words(),
    };
    let mut sum = 0u128;
    for row in 0..height {
        for column in 0..width {
            let weight = tables.weight([column, row]);
            assert!(weight > 0, "{column} {row}");
            sum += weight;
        }
    }
    assert_eq!(sum, 1 << 64);
    let [column, row] = HOT.map(|at| at % width);
    let texels = f64::from(width) * f64::from(height);
    let light = 1e9 * tables.solid_angle(row) * texels / (4.0 * std::f64::consts::PI);
    let truth = light / (light + texels);
    let got = tables.probability([column, row]);
    // Each of up to 2^24 texels of an alias table takes 1 of 2^32 besides its share.
    let raised = match made.kind() {
        Kind::Alias => texels / f64::powi(2.0, 32),
        Kind::Hierarchical => f64::from(width.max(height)) / f64::powi(2.0, 31),
    };
    println!("the hot texel: {got:.7}, by its light {truth:.7}");
    assert!((got - truth).abs() < raised, "{got} {truth}");
}

fn equal(made: Environment, name: &str) {
    let map = Map::from_name(name).unwrap_or_else(|error| panic!("{error}"));
    let mapping = Mapping::new(map, &[])
        .and_then(|mapping| mapping.with_environment(made))
        .unwrap_or_else(|error| panic!("{error}"));
    let words: Vec<u32> = (0..3 << 12).map(mix).collect();
    let words = &words[..(map.dimensions << 12) as usize];
    support::on_each_device(|device| {
        let start = Instant::now();
        let got = Mapper::new(device, &mapping, true, Profile::Exact, task::SAMPLE)
            .and_then(|mapper| mapper.run(words))
            .unwrap_or_else(|error| panic!("{error}"))
            .0;
        println!(
            "{}: {:.2} s with the upload",
            device.info().name,
            start.elapsed().as_secs_f64()
        );
        let mut cold = 0;
        for (u, got) in words
            .chunks_exact(map.dimensions as usize)
            .zip(got.chunks_exact(4))
        {
            let u = [u[0], u[1], u.get(2).copied().unwrap_or(0)];
            let expected = map_sample(&mapping, Profile::Exact, u);
            assert_eq!(got, expected, "{u:08x?}");
            cold += u32::from(f32::from_bits(got[3]) < 1.0);
        }
        assert!(cold > 10, "{cold} samples of the dim texels");
    });
}

#[test]
fn a_map_of_8192_by_4096_has_exact_tables_in_two_buffers() {
    let made = build(8192, 4096, Kind::Hierarchical);
    sound(&made);
    equal(made, "environment");
}

#[test]
fn a_map_of_2_24_texels_has_an_exact_alias_table_in_two_buffers() {
    let made = build(4096, 4096, Kind::Alias);
    sound(&made);
    equal(made, "environment-alias");
}
