//! The irradiance of an environment map in `f64`, sample by sample.

use super::{EnvironmentTables, cosine_hemisphere, uniform_hemisphere};
use std::f64::consts::{PI, TAU};

/// A surface under a map.
#[derive(Clone, Copy, Debug)]
pub struct Lit<'a> {
    /// The distribution of the map.
    pub tables: EnvironmentTables<'a>,
    /// The luminance of each texel.
    pub lights: &'a [f32],
    /// The axis that the surface faces: +x, -x, +y, -y, +z, -z.
    pub axis: usize,
}

/// Directions are floats: what they may be off, in radians, with some to spare.
const ANGLE: f64 = 1.0 / (1 << 20) as f64;

impl Lit<'_> {
    /// The least and the greatest that an estimator may give for these fractions: a
    /// direction near the edge of a texel may meet its neighbour. NaN for a name that is no
    /// estimator.
    #[must_use]
    pub fn sample(&self, estimator: &str, u: [u32; 3]) -> [f64; 2] {
        let pair = [u[0], u[1]];
        match estimator {
            "uniform" => {
                let d = uniform_hemisphere(pair);
                self.met(d, |_| TAU * d[2])
            }
            "cosine" => self.met(cosine_hemisphere(pair), |_| PI),
            "environment" => self.drawn(u, |pdf, _| pdf),
            "mis" if u[2] < 1 << 31 => {
                let d = cosine_hemisphere(pair);
                self.met(d, |texel| 2.0 * d[2] / (d[2] / PI + self.density(texel)))
            }
            "mis" => self.drawn(u, |pdf, cosine| 0.5 * (pdf + cosine / PI)),
            _ => [f64::NAN; 2],
        }
    }

    fn density(&self, texel: [u32; 2]) -> f64 {
        self.tables.probability(texel) / self.tables.solid_angle(texel[1])
    }

    fn light(&self, [column, row]: [u32; 2]) -> f64 {
        self.lights[(row * self.tables.width + column) as usize].into()
    }

    /// Of a direction that the tables draw, whose texel is no question.
    fn drawn(&self, u: [u32; 3], density: impl Fn(f64, f64) -> f64) -> [f64; 2] {
        let [x, y, z, pdf] = self.tables.sample(u);
        let along = [x, -x, y, -y, z, -z][self.axis].max(0.0);
        let value = self.light(self.tables.drawn(u)) * along / density(pdf, along);
        [value, value]
    }

    /// Of a direction around +z, to be turned, and the cosine over its density in a texel.
    fn met(&self, [a, b, c]: [f64; 3], weight: impl Fn([u32; 2]) -> f64) -> [f64; 2] {
        let turned = match self.axis {
            0 => [c, a, b],
            1 => [-c, -a, b],
            2 => [b, c, a],
            3 => [b, -c, -a],
            4 => [a, b, c],
            _ => [-a, b, -c],
        };
        let mut range = [f64::INFINITY, f64::NEG_INFINITY];
        for texel in self.texels(turned) {
            // A dark texel has no density either.
            let value = match self.light(texel) {
                0.0 => 0.0,
                light => light * weight(texel),
            };
            range = [range[0].min(value), range[1].max(value)];
        }
        range
    }

    /// The texels within [`ANGLE`] of a direction.
    fn texels(&self, [x, y, z]: [f64; 3]) -> Vec<[u32; 2]> {
        let (width, height) = (self.tables.width, self.tables.height);
        let side = x.hypot(y);
        let polar = side.atan2(z);
        let row = |angle: f64| ((angle / PI * f64::from(height)).max(0.0) as u32).min(height - 1);
        let (upper, lower) = (row(polar - ANGLE), row(polar + ANGLE));
        let turns = (y.atan2(x) / TAU).rem_euclid(1.0);
        // Half a turn and more is all of them.
        let spread = (ANGLE / side / TAU).min(0.5);
        let column = |turns: f64| (turns * f64::from(width)).floor() as i64;
        let columns = column(turns - spread)..=column(turns + spread);
        let all = columns.flat_map(|column| {
            let column = column.rem_euclid(i64::from(width)) as u32;
            (upper..=lower).map(move |row| [column, row])
        });
        all.collect()
    }
}
