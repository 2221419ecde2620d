//! The power spectrum of points in the unit square.
//!
//! The periodogram P(f) = |sum_j exp(-2 pi i f.x_j)|^2 / N at integer frequencies f, of
//! which white noise has the mean 1 at each f but 0, where P is N. Its mean over rings of
//! width 1 and the variance within a ring over the square of that mean, the anisotropy,
//! are those of Ulichney, Dithering with blue noise, Proc. IEEE 76 (1988), eqs. 8 and 9;
//! Lagae and Dutre, A comparison of methods for generating Poisson disk distributions,
//! CGF 27 (2008), and Heck, Schloemer and Deussen, Blue noise sampling with controlled
//! aliasing, TOG 32 (2013), plot the same. A ring counts one of f and -f, whose powers
//! are equal.

use super::{Progress, refused, threads};
use crate::error::Result;
use std::f64::consts::TAU;

/// The highest frequency that can be asked for.
pub const MAX_RANGE: usize = 1024;

/// Points between two words of progress.
const BLOCK: usize = 4096;

/// A periodogram and its rings.
#[derive(Clone, Debug, PartialEq)]
pub struct Spectrum {
    points: usize,
    range: usize,
    image: Vec<f64>,
    rings: Vec<Ring>,
}

/// The frequencies whose length rounds to a number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ring {
    /// That number, at least 1.
    pub frequency: usize,
    /// Frequencies in it, one of f and -f.
    pub count: usize,
    /// Mean power; 1 for white noise.
    pub power: f64,
    /// Variance of the power over the square of its mean, in dB: 0 for white noise;
    /// -infinity where all powers are equal.
    pub anisotropy_db: f64,
}

impl Spectrum {
    /// Number of points.
    #[must_use]
    pub fn points(&self) -> usize {
        self.points
    }

    /// The highest frequency.
    #[must_use]
    pub fn range(&self) -> usize {
        self.range
    }

    /// The periodogram: 2 `range` + 1 rows by y, each of as many frequencies by x, both
    /// from -`range` up, so that frequency 0 is in the middle.
    #[must_use]
    pub fn image(&self) -> &[f64] {
        &self.image
    }

    /// Its value at a frequency; 0 beyond the range.
    #[must_use]
    pub fn power(&self, x: i32, y: i32) -> f64 {
        let side = 2 * self.range + 1;
        let at = |f: i32| usize::try_from(i64::from(f) + self.range as i64).ok();
        match (at(x), at(y)) {
            (Some(column), Some(row)) if column < side && row < side => {
                self.image[row * side + column]
            }
            _ => 0.0,
        }
    }

    /// Rings 1 to `range`: radial mean and anisotropy.
    #[must_use]
    pub fn rings(&self) -> &[Ring] {
        &self.rings
    }
}

/// The range that shows what a set of so many points is like: twice the frequency
/// sqrt(N) at which a grid of them would repeat, 8 to 256.
#[must_use]
pub fn spectrum_range(points: usize) -> usize {
    ((2.0 * (points as f64).sqrt()).ceil() as usize).clamp(8, 256)
}

/// The spectrum of points at frequencies up to `range` in x and y. Takes time in
/// proportion to N range^2: 10^9 of that product in about a second.
///
/// # Errors
/// [`crate::Error::Arguments`] for no points, or a range that is not 1 to [`MAX_RANGE`];
/// those of `progress`.
pub fn spectrum(points: &[[f64; 2]], range: usize, progress: Progress) -> Result<Spectrum> {
    if points.is_empty() || !(1..=MAX_RANGE).contains(&range) {
        return Err(refused(
            format!(
                "the spectrum of {} points to frequency {range}",
                points.len()
            ),
            format!("it takes at least 1 point and frequencies to 1 to {MAX_RANGE}"),
            "choose numbers in that range",
        ));
    }
    let side = 2 * range + 1;
    // For each x >= 0 `side` sums by y, first of cosines, then of sines: the rest of the
    // plane is symmetric.
    let mut sums = vec![0.0; (range + 1) * 2 * side];
    let share = (range + 1).div_ceil(threads());
    let mut done = 0;
    for block in points.chunks(BLOCK) {
        std::thread::scope(|scope| {
            for (i, part) in sums.chunks_mut(share * 2 * side).enumerate() {
                scope.spawn(move || add(block, range, i * share, part));
            }
        });
        done += block.len() as u64;
        progress(done, points.len() as u64)?;
    }
    let count = points.len() as f64;
    let mut image = vec![0.0; side * side];
    for (x, sums) in sums.chunks_exact(2 * side).enumerate() {
        let (cosines, sines) = sums.split_at(side);
        for (y, (re, im)) in cosines.iter().zip(sines).enumerate() {
            let power = (re * re + im * im) / count;
            image[y * side + range + x] = power;
            image[(2 * range - y) * side + range - x] = power;
        }
    }
    Ok(Spectrum {
        points: points.len(),
        range,
        rings: rings(&image, range),
        image,
    })
}

/// Points that are added at once, so that a sum is loaded and stored once for them.
const AT_ONCE: usize = 4;

/// Adds points to the sums of the frequencies from x = `first` on.
fn add(points: &[[f64; 2]], range: usize, first: usize, sums: &mut [f64]) {
    let side = 2 * range + 1;
    let mut cosines = vec![[0.0; AT_ONCE]; side];
    let mut sines = vec![[0.0; AT_ONCE]; side];
    for some in points.chunks(AT_ONCE) {
        for i in 0..side {
            // The rest of the last points stays without weight: its x phases are 0.
            for (k, point) in some.iter().enumerate() {
                [cosines[i][k], sines[i][k]] = turn((i as f64 - range as f64) * point[1]);
            }
        }
        for (i, sums) in sums.chunks_exact_mut(2 * side).enumerate() {
            let (mut c, mut s) = ([0.0; AT_ONCE], [0.0; AT_ONCE]);
            for (k, point) in some.iter().enumerate() {
                [c[k], s[k]] = turn((first + i) as f64 * point[0]);
            }
            let (re, im) = sums.split_at_mut(side);
            let phases = cosines.iter().zip(&sines);
            for ((re, im), (a, b)) in re.iter_mut().zip(im).zip(phases) {
                for k in 0..AT_ONCE {
                    *re += c[k] * a[k] - s[k] * b[k];
                    *im += c[k] * b[k] + s[k] * a[k];
                }
            }
        }
    }
}

/// Cosine and sine of so many turns.
fn turn(turns: f64) -> [f64; 2] {
    let (sine, cosine) = (TAU * (turns - turns.round())).sin_cos();
    [cosine, sine]
}

fn rings(image: &[f64], range: usize) -> Vec<Ring> {
    let side = 2 * range + 1;
    let mut members = vec![Vec::new(); range + 1];
    for y in 0..=range {
        for x in 0..side {
            let (fx, fy) = (x as f64 - range as f64, y as f64);
            let ring = fx.hypot(fy).round() as usize;
            // Of the axis y = 0 the positive half.
            if (1..=range).contains(&ring) && (y > 0 || x > range) {
                members[ring].push(image[(y + range) * side + x]);
            }
        }
    }
    let ring = |(frequency, powers): (usize, &Vec<f64>)| {
        let count = powers.len() as f64;
        let mean = powers.iter().sum::<f64>() / count;
        let squares: f64 = powers.iter().map(|power| (power - mean).powi(2)).sum();
        let variance = squares / (count - 1.0);
        Ring {
            frequency,
            count: powers.len(),
            power: mean,
            anisotropy_db: 10.0 * (variance / (mean * mean)).log10(),
        }
    };
    members.iter().enumerate().skip(1).map(ring).collect()
}
