//! Points from devices as integers, and the cells that hold them.

use std::sync::Arc;

use corput::catalog::{Engine, Options, Request};
use corput::kernels::Generator;
use corput::vulkan::Device;

/// A way to write coordinates: how many bits of the fraction there are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    Fractions,
    Floats,
}

impl Kind {
    pub const BOTH: [Self; 2] = [Self::Fractions, Self::Floats];

    pub fn bits(self) -> u32 {
        match self {
            Self::Fractions => 32,
            Self::Floats => 24,
        }
    }

    /// The last index of which base^k cells of a base other than 2 are promised.
    pub fn bound(self, cells: u64) -> u64 {
        (1 << self.bits()) - cells
    }
}

/// Kernels of either kind.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum By {
    /// The general one, which reads its columns from a table.
    Table,
    /// The one that the request gets: for 2^16 words or more a tile.
    Plan,
}

/// The ways to make points: either kernel, and either way to write them.
pub const WAYS: [(Kind, By); 4] = [
    (Kind::Fractions, By::Table),
    (Kind::Floats, By::Table),
    (Kind::Fractions, By::Plan),
    (Kind::Floats, By::Plan),
];

/// Rows of coordinates, in units of 2^-bits, from the kernel that the request gets.
pub fn points(device: &Arc<Device>, kind: Kind, options: Options) -> Vec<Vec<u64>> {
    points_by(device, (kind, By::Plan), options)
}

/// The same from either kernel.
pub fn points_by(
    device: &Arc<Device>,
    (kind, by): (Kind, By),
    mut options: Options,
) -> Vec<Vec<u64>> {
    options.fractions = kind == Kind::Fractions;
    let request = Request::new(&options).unwrap_or_else(|error| panic!("{error}"));
    requested(device, (kind, by), &request)
}

/// The same of a request, whose output is as `kind` says.
pub fn requested(device: &Arc<Device>, (kind, by): (Kind, By), request: &Request) -> Vec<Vec<u64>> {
    // Most requests of a test are of the same pipelines, and compiling them is what takes time.
    device.keep_pipelines();
    let width = request.columns.len();
    let mut rows = Vec::with_capacity(request.count as usize);
    let unit = |word: u32| match kind {
        Kind::Fractions => u64::from(word),
        Kind::Floats => {
            let scaled = f32::from_bits(word) * 16_777_216.0;
            assert!(scaled.fract() == 0.0 && (0.0..16_777_216.0).contains(&scaled));
            scaled as u64
        }
    };
    let generator = match by {
        By::Table => Generator::general(device, request),
        By::Plan => Generator::new(device, request),
    };
    generator
        .and_then(|mut generator| {
            let tiled = by == By::Plan && request.count * width as u64 >= 1 << 16 && width <= 4;
            assert_eq!(generator.kernel_name().contains("tile"), tiled);
            generator.make(0, request.count, &mut |words| {
                let parts = words.chunks_exact(width);
                rows.extend(parts.map(|row| row.iter().copied().map(unit).collect::<Vec<u64>>()));
                Ok(())
            })
        })
        .unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(rows.len() as u64, request.count);
    rows
}

/// Cells that do not hold exactly one point, of across[0] x across[1] for as many points.
pub fn wrong(rows: &[Vec<u64>], bits: u32, across: [u64; 2]) -> usize {
    let mut held = vec![0u32; (across[0] * across[1]) as usize];
    for row in rows {
        let cell = [0, 1].map(|d: usize| (row[d] * across[d]) >> bits);
        held[(cell[0] * across[1] + cell[1]) as usize] += 1;
    }
    held.iter().filter(|&&count| count != 1).count()
}

/// Strata of one axis, among as many as `strata`, that do not hold exactly one coordinate.
pub fn unfilled(column: impl Iterator<Item = u64>, bits: u32, strata: u64) -> usize {
    let mut held = vec![0u32; strata as usize];
    column.for_each(|x| held[((x * strata) >> bits) as usize] += 1);
    held.iter().filter(|&&count| count != 1).count()
}
