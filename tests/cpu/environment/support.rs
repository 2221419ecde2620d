//! Maps to try, and an environment's tables with a reading of them of its own.

use corput::environment::{Environment, Kind, Options};
use corput::glam::{UVec2, UVec3, Vec3, uvec2, uvec3};
use corput::judge::environment::EnvironmentTables;
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
            if (5..12).contains(&row) || row == 19 || row == 0 || !(3..=36).contains(&column) {
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

    /// The judge's reading of the words.
    pub fn judge(&self) -> EnvironmentTables<'_> {
        EnvironmentTables {
            width: self.size.x,
            height: self.size.y,
            alias: self.kind == Kind::Alias,
            words: &self.words,
        }
    }

    /// Column and row that u draws.
    pub fn drawn(&self, u: UVec3) -> UVec2 {
        UVec2::from(self.judge().drawn(u.to_array()))
    }

    pub fn probability(&self, texel: UVec2) -> f64 {
        self.judge().probability(texel.to_array())
    }

    pub fn solid_angle(&self, row: u32) -> f64 {
        self.judge().solid_angle(row)
    }
}
