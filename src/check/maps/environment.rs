//! Environment maps to check with: of the shapes and lights that have broken samplers.

use crate::Result;
use crate::catalog::{Map, Mapping};
use crate::check::mix;
use crate::environment::{Environment, Kind, Options};
use crate::interface::map;

/// Columns, rows, and the light of each texel.
type Light = (u32, u32, fn(u32, u32) -> f32);

/// A gradient; one texel; a row; a column; one hot texel among dim ones and alone; rows
/// and columns without light; nothing; light over 30 orders of magnitude; rows as thin as
/// those of the highest map, the thinnest bright, where few floats tell z.
const MAPS: &[Light] = &[
    (64, 32, |x, y| (x + 2 * y + 1) as f32),
    (1, 1, |_, _| 3.0),
    (7, 1, |x, _| x as f32),
    (1, 9, |_, y| 1.0 + y as f32),
    (64, 32, |x, y| if (x, y) == (37, 11) { 1e9 } else { 1.0 }),
    (16, 8, |x, y| if (x, y) == (15, 7) { 1e9 } else { 0.0 }),
    (40, 20, |x, y| {
        if (5..12).contains(&y) || y == 19 || y == 0 || !(3..=36).contains(&x) {
            0.0
        } else {
            1.0 + x as f32
        }
    }),
    (4, 2, |_, _| 0.0),
    (33, 17, |x, y| {
        f32::from_bits(0x3000_0000 + (mix(x ^ y << 16) >> 3))
    }),
    (2, 4096, |x, y| match y {
        16..4080 => 1.0 + (mix(x ^ y << 16) >> 16) as f32,
        _ => 1e9,
    }),
];

/// The mappings of a map of this group.
pub(super) fn examples(map: &'static Map) -> Result<Vec<Mapping>> {
    let kind = match map.id {
        map::ENVIRONMENT => Kind::Hierarchical,
        _ => Kind::Alias,
    };
    MAPS.iter()
        .map(|&(width, height, light)| {
            let texels: Vec<[f32; 3]> = (0..width * height)
                .map(|i| [light(i % width, i / width); 3])
                .collect();
            let options = Options {
                kind,
                ..Options::default()
            };
            let environment = Environment::new(width, height, &texels, options)?;
            Mapping::new(map, &[])?.with_environment(environment)
        })
        .collect()
}
