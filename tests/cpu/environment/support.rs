//! Maps to try, and an environment's tables with a reading of them of its own.

use corput::environment::{Environment, Kind, Options};
use corput::glam::{UVec2, UVec3, Vec3, uvec2, uvec3};
use corput::reference::environment as twin;
use corput::reference::permute::permute_mix as mix;

/// A name, columns, rows and texels.
pub type Map = (&'static str, u32, u32, Vec<[f32; 3]>);

/// Synthetic maps of all shapes: a texel, a row, a column, a checkerboard, a sky with a sun,
/// zero rows and columns, random light over 30 orders of magnitude.
pub fn maps() -> Vec<Map> {
    let make = |width: u32, height: u32, light: &dyn Fn(u32, u32) -> f32| {
        (0..height)
            .flat_map(|row| (0..width).map(move |column| (column, row)))
            .map(|(column, row)| [light(column, row); 3])
            .collect::<Vec<_>>()
    };
    let map = |name, width, height, light: &dyn Fn(u32, u32) -> f32| {
        (name, width, height, make(width, height, light))
    };
    let random = |column: u32, row: u32| {
        let word = mix(column ^ row << 16);
        f32::from_bits(0x3000_0000 + (word >> 3))
    };
    vec![
        map("gradient", 64, 32, &|column, row| (column + 2 * row) as f32),
        map("texel", 1, 1, &|_, _| 3.0),
        map("row", 7, 1, &|column, _| column as f32),
        map("column", 1, 9, &|_, row| 1.0 + row as f32),
        map("checkerboard", 33, 17, &|column, row| {
            ((column ^ row) & 1) as f32
        }),
        map("sun", 1024, 512, &|column, row| match (column, row) {
            (700..702, 150..152) => 33_664.0,
            _ => 0.1 + random(column, row).min(2.0),
        }),
        map("zero rows and columns", 40, 20, &|column, row| {
            if (5..12).contains(&row) || row == 19 || row == 0 || column < 3 || column > 36 {
                0.0
            } else {
                1.0 + column as f32
            }
        }),
        map("random", 256, 255, &random),
        map("wide", 8192, 3, &random),
        map("high", 2, 4096, &random),
    ]
}

/// Fractions of all kinds: edges of the square, then random ones.
pub fn fractions(i: u32) -> UVec3 {
    const ENDS: [u32; 8] = [
        0,
        1,
        u32::MAX,
        u32::MAX - 1,
        1 << 31,
        (1 << 31) - 1,
        1 << 8,
        0xffff_ff00,
    ];
    if i < 512 {
        let [a, b, c] = [i & 7, i >> 3 & 7, i >> 6 & 7].map(|k| ENDS[k as usize]);
        return uvec3(a, b, c);
    }
    uvec3(mix(3 * i), mix(3 * i + 1), mix(3 * i + 2))
}

/// An environment, and what its words say by themselves.
pub struct Tables {
    pub kind: Kind,
    pub size: UVec2,
    pub words: Vec<u32>,
    pub edges: Vec<f32>,
}

impl Tables {
    pub fn new(width: u32, height: u32, texels: &[[f32; 3]], kind: Kind) -> Self {
        let options = Options {
            kind,
            ..Options::default()
        };
        Self::of(&Environment::new(width, height, texels, options).unwrap())
    }

    pub fn of(environment: &Environment) -> Self {
        let words = environment.words().to_vec();
        let edges = words[..environment.height() as usize]
            .iter()
            .map(|&bits| f32::from_bits(bits))
            .collect();
        Self {
            kind: environment.kind(),
            size: uvec2(environment.width(), environment.height()),
            words,
            edges,
        }
    }

    pub fn sample(&self, u: UVec3) -> (Vec3, f32) {
        let sample = match self.kind {
            Kind::Hierarchical => twin::environment(self.size, u.truncate(), &self.words),
            Kind::Alias => twin::environment_alias(self.size, u, &self.words),
        };
        (sample.direction, sample.pdf)
    }

    pub fn pdf(&self, direction: Vec3) -> f32 {
        match self.kind {
            Kind::Hierarchical => {
                twin::environment_pdf(self.size, direction, &self.edges, &self.words)
            }
            Kind::Alias => {
                twin::environment_alias_pdf(self.size, direction, &self.edges, &self.words)
            }
        }
    }

    pub fn texel_pdf(&self, texel: UVec2) -> f32 {
        match self.kind {
            Kind::Hierarchical => twin::environment_texel_pdf(self.size, texel, &self.words),
            Kind::Alias => twin::environment_alias_texel_pdf(self.size, texel, &self.words),
        }
    }

    pub fn invert(&self, direction: Vec3) -> UVec2 {
        twin::environment_invert(self.size, direction, &self.edges, &self.words)
    }

    fn marginal(&self) -> usize {
        3 * self.size.y as usize + 2
    }

    fn conditional(&self, row: u32) -> usize {
        4 * self.size.y as usize + 2 + (row * self.size.x) as usize
    }

    /// Start and end of an item of the CDF of `count` items at a word, by a linear reading.
    fn item(&self, first: usize, index: u32) -> (u64, u64) {
        let positive = self.words[first];
        let start = |i: u32| match i {
            0 => 0,
            i if i >= positive => 1 << 32,
            i => u64::from(self.words[first + i as usize]),
        };
        if positive == 0 {
            return (0, 0);
        }
        (start(index), start(index + 1))
    }

    /// The item of a CDF that holds u, by a linear search.
    fn find(&self, first: usize, count: u32, u: u32) -> u32 {
        (0..count)
            .find(|&i| {
                let (start, end) = self.item(first, i);
                (start..end).contains(&u64::from(u))
            })
            .expect("an item")
    }

    /// Column and row that u draws.
    pub fn drawn(&self, u: UVec3) -> UVec2 {
        if self.kind == Kind::Alias {
            let count = u64::from(self.size.x * self.size.y);
            let product = u64::from(u.x) * count;
            let bin = (product >> 32) as usize;
            let at = self.marginal() + 3 * bin;
            let own = (product as u32) < self.words[at];
            let index = if own { bin as u32 } else { self.words[at + 1] };
            return uvec2(index % self.size.x, index / self.size.x);
        }
        let row = self.find(self.marginal(), self.size.y, u.x);
        uvec2(self.find(self.conditional(row), self.size.x, u.y), row)
    }

    /// Probability of a texel, out of 2^64.
    pub fn weight(&self, texel: UVec2) -> u128 {
        let width = |(start, end): (u64, u64)| u128::from(end - start);
        match self.kind {
            Kind::Hierarchical => {
                width(self.item(self.marginal(), texel.y))
                    * width(self.item(self.conditional(texel.y), texel.x))
            }
            Kind::Alias => {
                let index = texel.y * self.size.x + texel.x;
                let at = self.marginal() + 3 * index as usize;
                let own = self.words[at + 1] == index && self.words[at + 2] == 0;
                (u128::from(self.words[at + 2]) | u128::from(own) << 32) << 32
            }
        }
    }

    pub fn probability(&self, texel: UVec2) -> f64 {
        self.weight(texel) as f64 / f64::powi(2.0, 64)
    }

    /// Widths of the ranges of u.y and u.x that draw a texel.
    pub fn range(&self, texel: UVec2) -> (f64, f64) {
        let width = |(start, end): (u64, u64)| (end - start) as f64;
        (
            width(self.item(self.conditional(texel.y), texel.x)),
            width(self.item(self.marginal(), texel.y)),
        )
    }

    /// Difference of z of a row's edges, by another formula than the tables'.
    pub fn thickness(&self, row: u32) -> f64 {
        let angle = std::f64::consts::PI / f64::from(self.size.y);
        let middle = angle * (f64::from(row) + 0.5);
        2.0 * middle.sin() * (0.5 * angle).sin()
    }

    /// Solid angle of a texel of a row.
    pub fn solid_angle(&self, row: u32) -> f64 {
        self.thickness(row) * std::f64::consts::TAU / f64::from(self.size.x)
    }

    /// The direction that u draws from the hierarchical tables, in f64; `aside` moves it
    /// down by that part of its texel.
    pub fn judge(&self, u: UVec2, aside: f64) -> [f64; 3] {
        let texel = self.drawn(u.extend(0));
        let place = |first: usize, index: u32, u: u32| {
            let (start, end) = self.item(first, index);
            ((u64::from(u) - start) as f64 + 0.5) / (end - start) as f64
        };
        let across = place(self.conditional(texel.y), texel.x, u.y);
        let down = (place(self.marginal(), texel.y, u.x) + aside).clamp(0.0, 1.0);
        let angle = std::f64::consts::PI / f64::from(self.size.y);
        // The cap 1 - z above the texel's upper edge is 2 sin^2(t/2).
        let cap =
            2.0 * (0.5 * angle * f64::from(texel.y)).sin().powi(2) + down * self.thickness(texel.y);
        let radius = (cap * (2.0 - cap)).max(0.0).sqrt();
        let phi = std::f64::consts::TAU * (f64::from(texel.x) + across) / f64::from(self.size.x);
        [radius * phi.cos(), radius * phi.sin(), 1.0 - cap]
    }
}
