//! An environment map as integrands take it: its luminance, and the tables that draw by it.

use crate::environment::{Environment, Options, Weight, repair};
use crate::interface::TABLE_WORDS;
use crate::irradiance::irradiance;
use crate::judge::environment::EnvironmentTables;
use crate::{Error, Result};

/// The axes that a surface may face, in the order of their numbers.
pub const AXES: [&str; 6] = ["+x", "-x", "+y", "-y", "+z", "-z"];

/// A map of luminances (Rec. 709, rounded to floats), and its distribution of directions.
#[derive(Clone, Debug, PartialEq)]
pub struct LightMap {
    name: String,
    size: [u32; 2],
    edges: Vec<f32>,
    words: Vec<u32>,
    luminances: Vec<f32>,
}

/// What rounded floats may add to a weight.
const ROUNDING: f64 = 1.0 + 1.0 / (1 << 20) as f64;

impl LightMap {
    /// The map of `width * height` linear RGB texels, row 0 (+z) first; `name` is what
    /// messages call it. Channels that are no light count as 0, and so do luminances below
    /// 2^-126.
    ///
    /// # Errors
    /// Those of [`Environment::new`], and [`Error::Arguments`] for a map without light or
    /// with more texels than one buffer of a kernel holds, 2^24 less its rows.
    pub fn new(name: &str, width: u32, height: u32, texels: &[[f32; 3]]) -> Result<Self> {
        let mut texels = texels.to_vec();
        let _ = repair(&mut texels);
        for texel in &mut texels {
            let light = Weight::Luminance.of(*texel) as f32;
            *texel = [if light.is_normal() { light } else { 0.0 }; 3];
        }
        let environment = Environment::new(width, height, &texels, Options::default())?;
        let asked = || format!("the light of {name}, {width} x {height} texels");
        if environment.counts().black {
            return Err(Error::Arguments {
                asked: asked(),
                limit: "no texel has any, so that nothing can be drawn by it".into(),
                remedy: "take a map with light".into(),
            });
        }
        if environment.words().len() + texels.len() > TABLE_WORDS {
            return Err(Error::Arguments {
                asked: asked(),
                limit: format!("its tables have more than {TABLE_WORDS} words"),
                remedy: "scale it down, as to 4096 x 2048".into(),
            });
        }
        let edges = environment.words().iter().take(height as usize);
        let edges = edges.map(|&bits| f32::from_bits(bits)).collect();
        let mut words = environment.into_words();
        let luminances: Vec<f32> = texels.iter().map(|[light, ..]| *light).collect();
        words.extend(luminances.iter().map(|light| light.to_bits()));
        Ok(Self {
            name: name.to_owned(),
            size: [width, height],
            edges,
            words,
            luminances,
        })
    }

    /// Reads a map, an OpenEXR file or a Radiance picture.
    ///
    /// # Errors
    /// Those of [`crate::image::load`], and of [`Self::new`].
    #[cfg(feature = "images")]
    pub fn read(path: &std::path::Path) -> Result<Self> {
        let image = crate::image::load(path)?;
        let name = path.display().to_string();
        Self::new(&name, image.width, image.height, &image.texels)
    }

    /// Without the feature `images` no map can be read.
    ///
    /// # Errors
    /// [`Error::Arguments`], always.
    #[cfg(not(feature = "images"))]
    pub fn read(path: &std::path::Path) -> Result<Self> {
        Err(Error::Arguments {
            asked: format!("the map {}", path.display()),
            limit: "this build reads no images".into(),
            remedy: "build with the feature `images`".into(),
        })
    }

    /// What messages call it: the file.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Columns and rows.
    #[must_use]
    pub fn size(&self) -> [u32; 2] {
        self.size
    }

    /// The row edges as floats: what [`crate::reference::envmap`] takes.
    #[must_use]
    pub fn edges(&self) -> &[f32] {
        &self.edges
    }

    /// The tables of [`Environment`], then the luminances as the bits of floats.
    #[must_use]
    pub fn words(&self) -> &[u32] {
        &self.words
    }

    /// The luminance of each texel.
    #[must_use]
    pub fn luminances(&self) -> &[f32] {
        &self.luminances
    }

    /// The tables as [`crate::judge`] reads them.
    #[must_use]
    pub fn tables(&self) -> EnvironmentTables<'_> {
        let [width, height] = self.size;
        EnvironmentTables {
            width,
            height,
            alias: false,
            words: &self.words,
        }
    }

    /// The irradiance of a surface that faces along an axis, by its number in [`AXES`]: the
    /// sum over texels of luminance times projected solid angle.
    #[must_use]
    pub fn irradiance(&self, axis: usize) -> f64 {
        let mut normal = [0.0; 3];
        if let Some(component) = normal.get_mut(axis / 2) {
            *component = if axis.is_multiple_of(2) { 1.0 } else { -1.0 };
        }
        let texels: Vec<[f32; 3]> = self.luminances.iter().map(|&light| [light; 3]).collect();
        let [width, height] = self.size;
        irradiance(width, height, &texels, normal)[0]
    }

    /// A bound of `of(luminance, density)` over the texels with light, for the density with
    /// which the tables draw a direction in one.
    pub fn largest(&self, of: impl Fn(f64, f64) -> f64) -> f64 {
        let tables = self.tables();
        let mut largest = 0f64;
        for (index, &light) in (0..).zip(&self.luminances) {
            if light > 0.0 {
                let texel = [index % tables.width, index / tables.width];
                let density = tables.probability(texel) / tables.solid_angle(texel[1]);
                largest = largest.max(of(light.into(), density));
            }
        }
        ROUNDING * largest
    }
}
