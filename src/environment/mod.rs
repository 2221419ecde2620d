//! Environment maps as distributions of directions: tables of integers.
//!
//! A texel weighs its luminance (or largest channel) times the exact solid angle of its
//! row, in 64-bit integers. Probabilities are these weights over 2^32, rounded so that they
//! sum to it exactly and none that is positive becomes 0; the tables hold the rounded ones
//! and the pdf is theirs, so that nothing drawn is off from what its pdf says.
//!
//! Two kinds of tables: [`Kind::Hierarchical`], a marginal CDF of rows and a conditional
//! one of each row, drawn by two fractions; [`Kind::Alias`], one alias table of all
//! texels, drawn by one fraction, with two more for the place in the texel.
//!
//! Words of a table, H rows and W columns: the row edges as `corput_envmap_texel` reads
//! them (H), the caps above them, two words each (2 H + 2), then either the marginal CDF (H)
//! and the conditional ones (H W), or the alias table (3 H W).

mod light;
mod quantise;
mod sphere;

pub use light::{Repairs, Weight, repair};
pub use quantise::{alias_table, cdf_table, quantise};

use crate::{Error, Result};

/// The widest map.
pub const MAX_WIDTH: u32 = 8192;
/// The highest map.
pub const MAX_HEIGHT: u32 = 4096;
/// The most texels of an alias table.
pub const MAX_ALIAS_TEXELS: u64 = 1 << 24;

/// Which tables.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Kind {
    /// Row, then column: two dimensions, an inverse, up to 8192 x 4096 texels.
    #[default]
    Hierarchical,
    /// All texels at once: three dimensions, no inverse, up to 2^24 texels.
    Alias,
}

/// How to build a distribution.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Options {
    /// Which tables.
    pub kind: Kind,
    /// What a texel weighs.
    pub weight: Weight,
    /// Whether the mean weight is subtracted, and less than that clamped to 0: for multiple
    /// importance sampling with another technique that reaches every direction (Karlik,
    /// Sik, Vevoda, Skrivan and Krivanek 2019, MIS compensation, ACM TOG 38(6)). Alone it
    /// is biased, for it never draws a texel below the mean.
    pub compensated: bool,
}

/// What was found and done while building.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// Texels with channels that were taken as 0.
    pub repairs: Repairs,
    /// Texels of weight 0, which are never drawn.
    pub dark: u64,
    /// Rows of such texels only.
    pub dark_rows: u32,
    /// Texels of positive weight below 2^-62 of all, taken as that.
    pub raised: u64,
    /// Whether no texel weighs anything: directions are then uniform over the sphere.
    pub black: bool,
    /// Whether compensation would leave nothing, since all texels are alike, and was not
    /// done.
    pub uncompensated: bool,
}

/// The distribution of an environment map.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Environment {
    kind: Kind,
    width: u32,
    height: u32,
    words: Vec<u32>,
    counts: Counts,
}

impl Environment {
    /// Builds the tables of a map of `width * height` linear RGB texels, row 0 (+z) first.
    ///
    /// Channels that are NaN, infinite, negative or denormal count as 0 and are reported. A
    /// map without any light gives the uniform distribution of the sphere, as a map of one
    /// texel, whose pdf is 1/(4 pi).
    ///
    /// # Errors
    ///
    /// [`Error::Arguments`] if the size is 0 or above [`MAX_WIDTH`] x [`MAX_HEIGHT`], or
    /// [`MAX_ALIAS_TEXELS`] with [`Kind::Alias`], or is not that of the texels.
    pub fn new(width: u32, height: u32, texels: &[[f32; 3]], options: Options) -> Result<Self> {
        check(width, height, texels.len(), options.kind)?;
        let caps = sphere::caps(height);
        let mut counts = Counts::default();
        let map = Map {
            width: width as usize,
            texels,
            caps: &caps,
            weight: options.weight,
        };
        for &texel in texels {
            // For the count; what is weighed is repaired on the way.
            let _ = counts.repairs.texel(texel);
        }
        let light = map.above(0.0);
        let (mut offset, mut total) = (0.0, light);
        if options.compensated {
            let mean = light / (SPHERE * f64::from(width));
            let above = map.above(mean);
            // What rounding alone leaves above the mean is no distribution.
            counts.uncompensated = above <= LEAST_ABOVE_MEAN * light;
            if !counts.uncompensated {
                (offset, total) = (mean, above);
            }
        }
        if total <= 0.0 {
            counts.black = true;
            counts.dark = texels.len() as u64;
            counts.dark_rows = height;
            let words = tables(1, &sphere::caps(1), options.kind, |_, row| row.push(1))?;
            return Ok(Self {
                kind: options.kind,
                width: 1,
                height: 1,
                words,
                counts,
            });
        }
        let scale = (1u64 << 62) as f64 / total;
        let words = tables(width as usize, &caps, options.kind, |row, weights| {
            let dark = counts.dark;
            map.row(row, |light, solid_angle| {
                let exact = (light - offset).max(0.0) * solid_angle * scale;
                let weight = (exact as u64).max(u64::from(exact > 0.0));
                counts.dark += u64::from(weight == 0);
                counts.raised += u64::from(exact > 0.0 && exact < 1.0);
                weights.push(weight);
            });
            counts.dark_rows += u32::from(counts.dark - dark == u64::from(width));
        })?;
        Ok(Self {
            kind: options.kind,
            width,
            height,
            words,
            counts,
        })
    }

    /// Which tables these are.
    #[must_use]
    pub fn kind(&self) -> Kind {
        self.kind
    }

    /// Texels in a row of the tables: 1 for a map without light.
    #[must_use]
    pub fn width(&self) -> u32 {
        self.width
    }

    /// Rows of the tables: 1 for a map without light.
    #[must_use]
    pub fn height(&self) -> u32 {
        self.height
    }

    /// What was found and done while building.
    #[must_use]
    pub fn counts(&self) -> &Counts {
        &self.counts
    }

    /// The tables, as the shader's hooks read them.
    #[must_use]
    pub fn words(&self) -> &[u32] {
        &self.words
    }

    /// The tables alone.
    #[must_use]
    pub fn into_words(self) -> Vec<u32> {
        self.words
    }
}

/// 4 pi in the units of a row's solid angle: the difference of its caps.
const SPHERE: f64 = (1u64 << 63) as f64;
/// Share of the light above the mean, below which all texels are alike.
const LEAST_ABOVE_MEAN: f64 = 1e-12;

/// A map being weighed.
struct Map<'m> {
    width: usize,
    texels: &'m [[f32; 3]],
    caps: &'m [u64],
    weight: Weight,
}

impl Map<'_> {
    /// Each texel's light and solid angle, times the width.
    fn row(&self, row: usize, mut each: impl FnMut(f64, f64)) {
        let solid_angle = (self.caps[row + 1] - self.caps[row]) as f64;
        let mut known = Repairs::default();
        for &texel in &self.texels[row * self.width..(row + 1) * self.width] {
            each(self.weight.of(known.texel(texel)), solid_angle);
        }
    }

    /// Integral of what exceeds a level, in units of [`SPHERE`] and the width.
    fn above(&self, level: f64) -> f64 {
        let rows = 0..self.caps.len() - 1;
        rows.map(|row| {
            let mut sum = 0.0;
            self.row(row, |light, solid_angle| {
                sum += (light - level).max(0.0) * solid_angle;
            });
            sum
        })
        .sum()
    }
}

fn check(width: u32, height: u32, texels: usize, kind: Kind) -> Result<()> {
    let size = u64::from(width) * u64::from(height);
    let refuse = |limit: String, remedy: &str| {
        Err(Error::Arguments {
            asked: format!("an environment map of {width} x {height} texels"),
            limit,
            remedy: remedy.into(),
        })
    };
    if size == 0 || width > MAX_WIDTH || height > MAX_HEIGHT {
        return refuse(
            format!("maps have 1 x 1 to {MAX_WIDTH} x {MAX_HEIGHT} texels"),
            "scale it",
        );
    }
    if size != texels as u64 {
        return refuse(
            format!("{texels} texels were given"),
            "give width * height texels",
        );
    }
    if kind == Kind::Alias && size > MAX_ALIAS_TEXELS {
        return refuse(
            format!("an alias table has at most {MAX_ALIAS_TEXELS} texels"),
            "scale it down, or use the hierarchical map `environment`",
        );
    }
    Ok(())
}

/// The words of the tables of rows that `fill` makes.
fn tables(
    width: usize,
    caps: &[u64],
    kind: Kind,
    mut fill: impl FnMut(usize, &mut Vec<u64>),
) -> Result<Vec<u32>> {
    let height = caps.len() - 1;
    let mut words: Vec<u32> = caps[..height]
        .iter()
        .map(|&cap| sphere::edge(cap).to_bits())
        .collect();
    words.extend(
        caps.iter()
            .flat_map(|&cap| [cap as u32, (cap >> 32) as u32]),
    );
    let mut weights = Vec::with_capacity(width);
    match kind {
        Kind::Hierarchical => {
            let marginal = words.len();
            words.reserve_exact(height * (width + 1));
            words.resize(marginal + height, 0);
            let mut sums = Vec::with_capacity(height);
            for row in 0..height {
                weights.clear();
                fill(row, &mut weights);
                sums.push(weights.iter().sum());
                words.extend(cdf_table(&weights)?);
            }
            words[marginal..marginal + height].copy_from_slice(&cdf_table(&sums)?);
        }
        Kind::Alias => {
            for row in 0..height {
                fill(row, &mut weights);
            }
            words.extend(alias_table(&weights)?);
        }
    }
    Ok(words)
}
