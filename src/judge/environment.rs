//! The tables of an environment map, read by themselves: linear searches, exact fractions,
//! directions in `f64`.

use std::f64::consts::{PI, TAU};

/// Tables of `width` x `height` texels.
#[derive(Clone, Copy, Debug)]
pub struct EnvironmentTables<'a> {
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// Whether they are an alias table.
    pub alias: bool,
    /// Edges, caps, and the tables.
    pub words: &'a [u32],
}

/// Half of what the azimuth keeps from the edges of a column, in turns: 2^-26.
const MARGIN: f64 = 1.0 / (1 << 26) as f64;

impl EnvironmentTables<'_> {
    /// Where the marginal CDF or the alias table begins.
    fn first(&self) -> usize {
        3 * self.height as usize + 2
    }

    /// Where the CDF of a row begins.
    fn conditional(&self, row: u32) -> usize {
        self.first() + self.height as usize + (row * self.width) as usize
    }

    /// Start and end of an item among the 2^32 fractions, of the CDF at a word.
    fn item(&self, first: usize, index: u32) -> [u64; 2] {
        let count = self.words[first];
        let start = |i: u32| match i {
            0 => 0,
            i if i >= count => 1 << 32,
            i => u64::from(self.words[first + i as usize]),
        };
        match count {
            0 => [0, 0],
            _ => [start(index), start(index + 1)],
        }
    }

    /// The item that holds u, of a CDF of `count` items: the last that begins at or before
    /// it and is not empty.
    fn find(&self, first: usize, count: u32, u: u32) -> u32 {
        let holds = |i: &u32| {
            let [start, end] = self.item(first, *i);
            (start..end).contains(&u64::from(u))
        };
        (0..count).find(holds).unwrap_or(u32::MAX)
    }

    /// Column and row that fractions draw.
    #[must_use]
    pub fn drawn(&self, u: [u32; 3]) -> [u32; 2] {
        if self.alias {
            let product = u64::from(u[0]) * u64::from(self.width * self.height);
            let bin = (product >> 32) as u32;
            let at = self.first() + 3 * bin as usize;
            let own = (product as u32) < self.words[at];
            let index = if own { bin } else { self.words[at + 1] };
            return [index % self.width, index / self.width];
        }
        let row = self.find(self.first(), self.height, u[0]);
        [self.find(self.conditional(row), self.width, u[1]), row]
    }

    /// Ranges of u.y and u.x that draw a texel from the hierarchical tables.
    #[must_use]
    pub fn ranges(&self, [column, row]: [u32; 2]) -> [[u64; 2]; 2] {
        [
            self.item(self.conditional(row), column),
            self.item(self.first(), row),
        ]
    }

    /// Probability of a texel, out of 2^64.
    #[must_use]
    pub fn weight(&self, texel: [u32; 2]) -> u128 {
        if self.alias {
            let index = texel[1] * self.width + texel[0];
            let at = self.first() + 3 * index as usize;
            let all = self.words[at + 1] == index && self.words[at + 2] == 0;
            return (u128::from(self.words[at + 2]) | u128::from(all) << 32) << 32;
        }
        let [column, row] = self.ranges(texel).map(|[a, b]| u128::from(b - a));
        column * row
    }

    /// Probability of a texel.
    #[must_use]
    pub fn probability(&self, texel: [u32; 2]) -> f64 {
        self.weight(texel) as f64 / f64::powi(2.0, 64)
    }

    /// Difference of z between a row's edges, by the product of two sines.
    #[must_use]
    pub fn thickness(&self, row: u32) -> f64 {
        let angle = PI / f64::from(self.height);
        2.0 * (angle * (f64::from(row) + 0.5)).sin() * (0.5 * angle).sin()
    }

    /// Solid angle of a texel of a row.
    #[must_use]
    pub fn solid_angle(&self, row: u32) -> f64 {
        self.thickness(row) * TAU / f64::from(self.width)
    }

    /// Direction and pdf that fractions draw.
    #[must_use]
    pub fn sample(&self, u: [u32; 3]) -> [f64; 4] {
        let texel = self.drawn(u);
        let row = texel[1];
        let [across, down] = if self.alias {
            [u[1], u[2]].map(|rest| f64::from(rest) + 0.5)
        } else {
            let [column, row] = self.ranges(texel);
            [place(column, u[1]), place(row, u[0])]
        };
        let part = down / f64::powi(2.0, 32);
        // From the nearer pole, so that no cap is a difference of large ones.
        let below = 2 * row >= self.height;
        let (from, part) = match below {
            true => (self.height - 1 - row, 1.0 - part),
            false => (row, part),
        };
        let edge = 2.0
            * (0.5 * PI * f64::from(from) / f64::from(self.height))
                .sin()
                .powi(2);
        let cap = edge + part * self.thickness(row);
        let radius = (cap * (2.0 - cap)).max(0.0).sqrt();
        let columns = f64::from(self.width);
        let turns = (f64::from(texel[0]) + across / f64::powi(2.0, 32)) / columns;
        let edges = [texel[0], texel[0] + 1].map(|edge| f64::from(edge) / columns);
        let phi = TAU * turns.clamp(edges[0] + MARGIN, edges[1] - MARGIN);
        let z = if below { cap - 1.0 } else { 1.0 - cap };
        let pdf = self.probability(texel) / self.solid_angle(row);
        [radius * phi.cos(), radius * phi.sin(), z, pdf]
    }
}

/// The middle of the fraction of 2^32 that holds u's place in a range of u.
fn place([start, end]: [u64; 2], u: u32) -> f64 {
    let twice = 2 * (u128::from(u) - u128::from(start)) + 1;
    let fraction = (twice << 31) / u128::from(end - start);
    fraction as f64 + 0.5
}
