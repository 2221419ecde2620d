//! The integrands: functions of the unit cube with a known integral, for estimators.
//!
//! An integrand is a row here. A new one needs its functions in a header of
//! `shaders/corput` with their twin, an id in `interface::integrand`, its lines in
//! `shaders/kernels/integrand.glsl` and in `bulk/integrand.rs`, and an independent form of it
//! in `judge`. Then `estimate` and `integrands` know it.
//!
//! Problems of rendering have several estimators of one integral, as of the irradiance of a
//! map by directions that are uniform, cosine-weighted or drawn by the map's light: the term
//! of a point is then the integrand over the density of the direction that it draws. They
//! lie in groups with a kernel each, `shaders/kernels/integrand_*.glsl`.

mod cells;
mod examples;
mod genz;
mod highlight;
mod irradiance;
mod light;
mod low;
mod optics;
mod pixel;
mod problem;
mod product;
mod quadrature;
mod raster;
mod scenes;

pub use examples::examples;
pub use light::{AXES, LightMap};
pub use problem::Problem;
pub use raster::Raster;

use super::Parameter;
use crate::{Error, Result};

/// The least mean of an integrand, as a share of its peak.
const LEAST_SHARE: f64 = 1.0 / 17_179_869_184.0;

/// What kernels take of an integrand: words, and the unit of its terms.
#[derive(Clone, Debug, PartialEq)]
pub struct Coefficients {
    /// Words for all dimensions.
    pub head: [u32; 4],
    /// Words for each.
    pub columns: Vec<[u32; 4]>,
    /// Terms are in units of 2^-scale.
    pub scale: i32,
    /// The largest magnitude of the integrand.
    pub peak: f64,
}

impl Coefficients {
    /// None, of terms that have a unit of their own.
    fn exact(scale: i32, peak: f64) -> Self {
        Self {
            head: [0; 4],
            columns: Vec::new(),
            scale,
            peak,
        }
    }

    /// Those of an integrand of reals: terms use 63 bits.
    fn real(head: [u32; 4], columns: Vec<[u32; 4]>, peak: f64) -> Self {
        Self {
            head,
            columns,
            scale: 63 - peak.log2().ceil() as i32,
            peak,
        }
    }

    /// Whether a mean is not lost below the unit of terms, 2^-63 of the peak.
    fn resolves(&self, mean: f64) -> bool {
        mean >= LEAST_SHARE * self.peak
    }
}

/// What an integrand is asked for.
#[derive(Clone, Copy, Debug)]
pub struct Setting<'a> {
    /// The numbers of its parameters, in their order.
    pub values: &'a [f64],
    /// Its dimensions, without the one that [`MIS`] takes besides.
    pub dimensions: u32,
    /// Which of its estimators.
    pub estimator: usize,
    /// The map of one that needs it.
    pub map: Option<&'a LightMap>,
}

/// The coefficients; or the number of the parameter that is outside its domain.
pub type Prepare = fn(&Setting) -> core::result::Result<Coefficients, usize>;

/// The parameters at a pixel, from those in the middle of the picture: given x to the right and
/// y upwards from there in pixels, and half the picture's height.
pub type Picture = fn(&[f64], [f64; 2], f64) -> Vec<f64>;

/// The estimator that combines techniques by the balance heuristic, one sample a point: a
/// coordinate more than the others have chooses the technique.
pub const MIS: &str = "mis";

/// A function of the unit cube.
#[derive(Clone, Copy, Debug)]
pub struct Integrand {
    /// The name on the command line.
    pub name: &'static str,
    /// Value of the specialization constant `INTEGRAND`, of its first estimator.
    pub id: u32,
    /// The fewest and the most dimensions.
    pub dimensions: (u32, u32),
    /// Dimensions where none are given.
    pub default_dimensions: u32,
    /// Its parameters, one number each, besides the dimensions d.
    pub parameters: &'static [Parameter],
    /// Its estimators, the default first, of which number k has the id `id + k`. None: the
    /// integrand itself at points of the cube.
    pub estimators: &'static [&'static str],
    /// Whether it needs an environment map, as the parameter `map`.
    pub needs_map: bool,
    /// Checks the parameters, and makes of them what kernels take.
    pub prepare: Prepare,
    /// Its integral, whatever the estimator; NaN where none is known.
    pub truth: fn(&Setting) -> f64,
    /// Worst error of a term as a share of the estimator's peak; its unit comes to 2^-63 of
    /// it. 0: terms are exact.
    pub error: f64,
    /// Its parameters over a picture, where it is one.
    pub picture: Option<Picture>,
    /// Whether its variance is finite, so that mean squares of errors say something.
    pub finite_variance: bool,
    /// Parameters and dimensions that checks try: usual ones, and the most extreme.
    pub examples: &'static [(&'static [f64], u32)],
    /// What it is, in a line.
    pub summary: &'static str,
    /// The formula.
    pub formula: &'static str,
    /// The paper.
    pub source: &'static str,
}

impl Integrand {
    /// The integrand with this name.
    ///
    /// # Errors
    /// [`Error::UnknownName`], with the nearest name.
    pub fn from_name(name: &str) -> Result<&'static Self> {
        integrands().find(|one| one.name == name).ok_or_else(|| {
            let known: Vec<&str> = integrands().map(|one| one.name).collect();
            Error::unknown_name("integrand", name, &known)
        })
    }
}

impl Parameter {
    /// The words that stand for a parameter's numbers 0, 1, 2 and so on, of an integrand's
    /// parameter that takes no others: those of `axis`.
    #[must_use]
    pub fn words(&self) -> &'static [&'static str] {
        match self.name {
            "axis" => &AXES,
            _ => &[],
        }
    }
}

/// Two integrands of the same name are the same.
impl PartialEq for Integrand {
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name
    }
}

/// Every integrand, in the order of the documentation.
pub fn integrands() -> impl Iterator<Item = &'static Integrand> {
    low::INTEGRANDS
        .iter()
        .chain(genz::INTEGRANDS)
        .chain(product::INTEGRANDS)
        .chain(irradiance::INTEGRANDS)
        .chain(scenes::INTEGRANDS)
        .chain(optics::INTEGRANDS)
        .chain(highlight::INTEGRANDS)
        .chain(pixel::INTEGRANDS)
}

/// The two words of x > 0 as a real: a significand of 32 bits, rounded, and an exponent.
/// 0 gives those of 0.
fn real_words(x: f64) -> [u32; 2] {
    if x <= 0.0 {
        return [0, 0];
    }
    // Of a normal number: 53 bits to 32, where a carry raises the exponent.
    let exponent = (x.to_bits() >> 52) as i32 - 1023;
    let significand = (x.to_bits() & ((1 << 52) - 1)) | (1 << 52);
    let rounded = (significand + (1 << 20)) >> 21;
    let carry = (rounded >> 32) as i32;
    [(rounded >> carry) as u32, (exponent - 31 + carry) as u32]
}

/// A fraction of 2^32 as a number.
fn unit(w: u32) -> f64 {
    f64::from(w) / 4_294_967_296.0
}

/// Refuses a parameter outside its bounds.
fn within(values: &[f64], index: usize, least: f64, most: f64) -> core::result::Result<f64, usize> {
    let value = values.get(index).copied().ok_or(index)?;
    // Not a number is in no range.
    (least..=most)
        .contains(&value)
        .then_some(value)
        .ok_or(index)
}
