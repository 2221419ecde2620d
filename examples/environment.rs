//! The irradiance of environment maps by three estimators: directions by the map's light,
//! cosine-weighted directions, and both by multiple importance sampling, beside the exact
//! sum over all texels.
//!
//! `cargo run --release --example environment` prints the table for the maps of
//! `tests/data`; paths of other maps may follow.

use corput::environment::{Environment, Options, Weight};
use corput::glam::{UVec2, Vec3, uvec2, uvec4};
use corput::image::{Image, load};
use corput::irradiance::irradiance;
use corput::reference::environment as map;
use corput::reference::envmap::envmap_texel;
use corput::reference::hemisphere::{cosine_hemisphere, cosine_hemisphere_pdf};
use corput::reference::mis::mis_balance;
use corput::reference::random::philox;
use std::path::{Path, PathBuf};

/// Samples of each estimator.
pub const SAMPLES: u32 = 1 << 20;

/// Normals: up, aside, down.
pub const NORMALS: [(&str, [f32; 3]); 3] = [
    ("+z", [0.0, 0.0, 1.0]),
    ("+x", [1.0, 0.0, 0.0]),
    ("-y", [0.0, -1.0, 0.0]),
];

/// A map to light with: its texels, and their light as a distribution.
pub struct Light {
    size: UVec2,
    luminance: Vec<f32>,
    words: Vec<u32>,
    edges: Vec<f32>,
}

/// The mean of an estimator, its standard error, and its variance for one sample.
#[derive(Clone, Copy, Debug)]
pub struct Estimate {
    /// The mean.
    pub mean: f64,
    /// The standard error of the mean.
    pub error: f64,
    /// The error squared, times the samples of all techniques.
    pub variance: f64,
}

/// An average of independent samples.
#[derive(Default)]
struct Average {
    count: f64,
    sum: f64,
    square: f64,
}

impl Average {
    fn add(&mut self, x: f64) {
        self.count += 1.0;
        self.sum += x;
        self.square += x * x;
    }

    fn mean(&self) -> f64 {
        self.sum / self.count
    }

    /// Variance of the mean.
    fn variance(&self) -> f64 {
        let spread = self.square / self.count - self.mean().powi(2);
        spread.max(0.0) / (self.count - 1.0)
    }
}

impl Light {
    /// Prepares an image.
    pub fn new(image: &Image, options: Options) -> corput::Result<Self> {
        let made = Environment::new(image.width, image.height, &image.texels, options)?;
        let luminance = image.texels.iter().map(|&t| Weight::Luminance.of(t) as f32);
        Ok(Self {
            size: uvec2(made.width(), made.height()),
            luminance: luminance.collect(),
            edges: made.words()[..made.height() as usize]
                .iter()
                .map(|&bits| f32::from_bits(bits))
                .collect(),
            words: made.into_words(),
        })
    }

    /// The irradiance by the exact sum over all texels.
    pub fn truth(&self, normal: [f32; 3]) -> f64 {
        let texels: Vec<[f32; 3]> = self.luminance.iter().map(|&l| [l; 3]).collect();
        irradiance(self.size.x, self.size.y, &texels, normal.map(f64::from))[0]
    }

    /// Radiance from a direction.
    fn radiance(&self, direction: Vec3) -> f64 {
        let texel = envmap_texel(direction, self.size, &self.edges);
        f64::from(self.luminance[(texel.y * self.size.x + texel.x) as usize])
    }

    /// A direction by the map's light, and its pdf.
    fn by_light(&self, i: u32, seed: u32) -> (Vec3, f32) {
        let u = philox(uvec4(i, 0, 0, 0), uvec2(seed, 1));
        let sample = map::environment(self.size, uvec2(u.x, u.y), &self.words);
        (sample.direction, sample.pdf)
    }

    fn pdf(&self, direction: Vec3) -> f32 {
        map::environment_pdf(self.size, direction, &self.edges, &self.words)
    }

    /// Directions by the map's light alone.
    pub fn environment(&self, normal: [f32; 3], seed: u32) -> Estimate {
        let mut average = Average::default();
        for i in 0..SAMPLES {
            let (direction, pdf) = self.by_light(i, seed);
            let cosine = f64::from(direction.dot(Vec3::from(normal)).max(0.0));
            average.add(self.radiance(direction) * cosine / f64::from(pdf));
        }
        estimate(&[average])
    }

    /// Cosine-weighted directions alone.
    pub fn cosine(&self, normal: [f32; 3], seed: u32) -> Estimate {
        let mut average = Average::default();
        for i in 0..SAMPLES {
            let direction = by_cosine(i, seed, normal);
            // The cosine over its own pdf is pi.
            average.add(self.radiance(direction) * std::f64::consts::PI);
        }
        estimate(&[average])
    }

    /// Half of either, by the balance heuristic.
    pub fn both(&self, normal: [f32; 3], seed: u32) -> Estimate {
        let each = SAMPLES / 2;
        let [mut light, mut cosine] = [Average::default(), Average::default()];
        for i in 0..each {
            let (direction, pdf) = self.by_light(i, seed);
            let z = direction.dot(Vec3::from(normal));
            let other = cosine_hemisphere_pdf(Vec3::new(0.0, 0.0, z));
            let weight = f64::from(mis_balance(each, pdf, each, other));
            let value = self.radiance(direction) * f64::from(z.max(0.0)) / f64::from(pdf);
            light.add(weight * value);
            let direction = by_cosine(i, seed, normal);
            let z = direction.dot(Vec3::from(normal));
            let pdf = cosine_hemisphere_pdf(Vec3::new(0.0, 0.0, z));
            let weight = f64::from(mis_balance(each, pdf, each, self.pdf(direction)));
            cosine.add(weight * self.radiance(direction) * std::f64::consts::PI);
        }
        estimate(&[light, cosine])
    }
}

/// A cosine-weighted direction around an axis.
fn by_cosine(i: u32, seed: u32, normal: [f32; 3]) -> Vec3 {
    let u = philox(uvec4(i, 0, 0, 0), uvec2(seed, 2));
    let d = cosine_hemisphere(uvec2(u.x, u.y));
    let axis = Vec3::from(normal);
    let aside = if axis.z == 0.0 { Vec3::Z } else { Vec3::X };
    d.x * aside + d.y * axis.cross(aside) + d.z * axis
}

/// The sum of independent averages.
fn estimate(parts: &[Average]) -> Estimate {
    let variance: f64 = parts.iter().map(Average::variance).sum();
    let samples: f64 = parts.iter().map(|part| part.count).sum();
    Estimate {
        mean: parts.iter().map(Average::mean).sum(),
        error: variance.sqrt(),
        variance: variance * samples,
    }
}

#[allow(dead_code, reason = "a test includes this file for its estimators")]
fn main() -> corput::Result<()> {
    let given: Vec<PathBuf> = std::env::args_os().skip(1).map(PathBuf::from).collect();
    let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data");
    let paths = match given.is_empty() {
        true => ["sunrise.exr", "studio.exr"]
            .map(|name| data.join(name))
            .to_vec(),
        false => given,
    };
    println!("{SAMPLES} samples; mean +- standard error, and the variance of one sample");
    for path in paths {
        let light = Light::new(&load(&path)?, Options::default())?;
        for (name, normal) in NORMALS {
            println!(
                "{}, normal {name}: exact {:.6}",
                path.file_name().unwrap_or_default().display(),
                light.truth(normal)
            );
            for (what, found) in [
                ("environment", light.environment(normal, 1)),
                ("cosine", light.cosine(normal, 1)),
                ("both, balance", light.both(normal, 1)),
            ] {
                let Estimate {
                    mean,
                    error,
                    variance,
                } = found;
                println!("  {what:<14} {mean:>10.6} +- {error:.6}   {variance:>12.6}");
            }
        }
    }
    Ok(())
}
