//! Problems to check with: each integrand's examples, by each of its estimators.

use super::{Integrand, LightMap, Problem};
use crate::Result;
use std::sync::Arc;

/// Columns, rows and the light of each texel: a sky with a sun of a texel, and ground; a
/// sun alone, which the surface may not see; a single texel.
type Light = (u32, u32, fn(u32, u32) -> f32);

const MAPS: &[Light] = &[
    (16, 8, |x, y| match (x, y) {
        (11, 2) => 5e4,
        (_, 0..4) => 1.0 + (3 * x % 7) as f32,
        _ => 0.125,
    }),
    (9, 5, |x, y| if (x, y) == (1, 2) { 1e9 } else { 0.0 }),
    (1, 1, |_, _| 3.0),
];

/// An integrand with each of its examples, by each of its estimators; one that needs a map
/// gets a few small ones in turn.
///
/// # Errors
/// None, if the catalogue is right.
pub fn examples(integrand: &'static Integrand) -> Result<Vec<Problem>> {
    let mut list = Vec::new();
    for ((values, dimensions), light) in integrand.examples.iter().zip(MAPS.iter().cycle()) {
        let map = integrand.needs_map.then(|| map(light)).transpose()?;
        let first = Problem::made(integrand, values, *dimensions, 0, map)?;
        for name in integrand.estimators {
            list.push(first.with_estimator(name)?);
        }
        if integrand.estimators.is_empty() {
            list.push(first);
        }
    }
    Ok(list)
}

fn map(&(width, height, light): &Light) -> Result<Arc<LightMap>> {
    let texels: Vec<[f32; 3]> = (0..width * height)
        .map(|i| [light(i % width, i / width); 3])
        .collect();
    Ok(Arc::new(LightMap::new(
        "an example",
        width,
        height,
        &texels,
    )?))
}
