//! Pictures: an integral for each pixel.

use super::{Problem, integrands};
use crate::catalog::{Options, Request};
use crate::interface::purpose;
use crate::reference::hash::seed;
use crate::{Error, Result};
use glam::uvec2;

/// Pixels at most: their estimates take 80 bytes each.
const MOST: u64 = 1 << 24;

/// An integrand whose parameters change over a picture, and the points of each pixel.
///
/// Where points are random, each pixel has a seed of its own, a hash of the seed and of its
/// number; otherwise all pixels share them.
#[derive(Clone, Debug)]
pub struct Raster {
    problem: Problem,
    options: Options,
    width: u32,
    height: u32,
}

impl Raster {
    /// The picture of so many columns and rows around what the problem says. The options are
    /// those of a pixel's points, of as many dimensions as the problem has.
    ///
    /// # Errors
    /// [`Error::Arguments`] for an integrand that is no picture, and for no pixels or more than
    /// 2^24; those of [`Request::new`] and [`Problem::check`].
    pub fn new(problem: &Problem, options: &Options, [width, height]: [u32; 2]) -> Result<Self> {
        let name = problem.integrand().name;
        let refused = |limit: String, remedy: &str| Error::Arguments {
            asked: format!("{name} over {width} x {height} pixels"),
            limit,
            remedy: remedy.to_owned(),
        };
        if problem.integrand().picture.is_none() {
            let known: Vec<&str> = integrands()
                .filter(|one| one.picture.is_some())
                .map(|one| one.name)
                .collect();
            let limit = format!("of the integrands {} are pictures", known.join(" and "));
            return Err(refused(limit, "take one of these, or drop --pixels"));
        }
        if !(1..=MOST).contains(&(u64::from(width) * u64::from(height))) {
            let limit = format!("a picture has 1 to {MOST} pixels");
            return Err(refused(limit, "take another size"));
        }
        let mut options = Options {
            dimensions: Some(problem.dimensions().into()),
            fractions: true,
            ..options.clone()
        };
        let request = Request::new(&options)?;
        problem.check(&request, 0, request.count)?;
        // The seeds of pixels must not choose a scramble where none is asked for.
        let scrambles = !options.sequence.scrambles().is_empty();
        options.scramble = scrambles.then_some(request.scramble);
        Ok(Self {
            problem: problem.clone(),
            options,
            width,
            height,
        })
    }

    /// What the middle of the picture sees.
    #[must_use]
    pub fn problem(&self) -> &Problem {
        &self.problem
    }

    /// Columns and rows.
    #[must_use]
    pub fn size(&self) -> [u32; 2] {
        [self.width, self.height]
    }

    /// Pixels.
    #[must_use]
    pub fn pixels(&self) -> u32 {
        self.width * self.height
    }

    /// Points of a pixel.
    #[must_use]
    pub fn count(&self) -> u64 {
        self.options.count
    }

    /// The problem of a pixel, and its points; pixels count row by row from the upper left.
    ///
    /// # Errors
    /// [`Error::Arguments`] for a pixel that the picture does not have, and where its parameters
    /// leave their domain.
    pub fn pixel(&self, index: u32) -> Result<(Problem, Request)> {
        let picture = self.problem.integrand().picture;
        let picture = picture.filter(|_| index < self.pixels());
        let picture = picture.ok_or_else(|| Error::Arguments {
            asked: format!("pixel {index}"),
            limit: format!("the picture has {}", self.pixels()),
            remedy: "count them from 0, row by row".into(),
        })?;
        let [column, row] = [index % self.width, index / self.width].map(f64::from);
        let half = [self.width, self.height].map(|side| 0.5 * f64::from(side));
        let place = [column + 0.5 - half[0], half[1] - (row + 0.5)];
        let values = picture(self.problem.values(), place, half[1]);
        let base = self.options.seed.unwrap_or(0);
        let base = uvec2(base as u32, (base >> 32) as u32);
        let [low, high] =
            [purpose::PIXEL, purpose::PIXEL_HIGH].map(|word| u64::from(seed(base, index, word)));
        let request = Request::new(&Options {
            seed: Some(low | high << 32),
            ..self.options.clone()
        })?;
        Ok((self.problem.moved(&values)?, request))
    }
}
