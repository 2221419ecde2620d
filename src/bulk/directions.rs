//! Points of disk and hemisphere in the exact profile, by loops over batches of columns: all of
//! their arithmetic is of integers and a few floats, without a branch, of which the compiler makes
//! vectors.

use super::points::{Batch, STRIDE};
use crate::catalog::{Mapping, Profile};
use crate::interface::map;
use crate::reference::{disk, hemisphere};
use fearless_simd::{Level, dispatch};
use glam::{UVec2, Vec2, Vec3, uvec2, vec3};

/// Words of a sample at most: coordinates and pdf.
const WORDS: usize = 4;

/// One of these maps.
#[derive(Clone, Copy, Debug)]
pub struct Directions {
    id: u32,
    width: usize,
}

/// Columns of the samples of a batch, [`STRIDE`] words each.
pub type Samples = [u32; WORDS * STRIDE];

impl Directions {
    /// The map of a mapping, whose samples have so many words; `None` where it is another.
    pub fn of(mapping: &Mapping, profile: Profile, width: usize) -> Option<Self> {
        let id = mapping.map().id;
        let known = matches!(
            id,
            map::CONCENTRIC_DISK
                | map::POLAR_DISK
                | map::UNIFORM_HEMISPHERE
                | map::COSINE_HEMISPHERE
                | map::COSINE_HEMISPHERE_POLAR
        );
        (known && profile == Profile::Exact).then_some(Self { id, width })
    }

    /// Writes the samples of a batch of two columns of fractions.
    pub fn fill(self, level: Level, batch: &Batch, samples: &mut Samples) {
        dispatch!(level, _ => self.columns(batch, samples));
    }

    #[inline(always)]
    #[rustfmt::skip]
    #[expect(clippy::redundant_closure, reason = "functions as such are not inlined, which vectors need")]
    fn columns(self, batch: &Batch, samples: &mut Samples) {
        match self.id {
            map::CONCENTRIC_DISK => {
                planar(batch, samples, #[inline(always)] |u| disk::concentric_disk(u));
            }
            map::POLAR_DISK => {
                planar(batch, samples, #[inline(always)] |u| disk::polar_disk(u));
            }
            map::UNIFORM_HEMISPHERE => {
                spatial(batch, samples, #[inline(always)] |u| hemisphere::uniform_hemisphere(u));
                self.densities(batch, samples, #[inline(always)] |d| hemisphere::uniform_hemisphere_pdf(d));
            }
            map::COSINE_HEMISPHERE => {
                spatial(batch, samples, #[inline(always)] |u| hemisphere::cosine_hemisphere(u));
                self.densities(batch, samples, #[inline(always)] |d| hemisphere::cosine_over_pi(d.z));
            }
            _ => {
                spatial(batch, samples, #[inline(always)] |u| hemisphere::cosine_hemisphere_polar(u));
                self.densities(batch, samples, #[inline(always)] |d| hemisphere::cosine_over_pi(d.z));
            }
        }
    }

    /// The pdf of each direction, where it is asked for.
    #[inline(always)]
    fn densities(self, batch: &Batch, samples: &mut Samples, pdf: impl Fn(Vec3) -> f32) {
        if self.width < WORDS {
            return;
        }
        let (_, _, [x, y, z, to_pdf]) = parts(batch, samples);
        for i in 0..batch.rows {
            let [x, y, z] = [x[i], y[i], z[i]].map(f32::from_bits);
            to_pdf[i] = pdf(vec3(x, y, z)).to_bits();
        }
    }
}

/// Points of a disk, and the pdf that all have.
#[inline(always)]
fn planar(batch: &Batch, samples: &mut Samples, map: impl Fn(UVec2) -> Vec2) {
    let (x, y, [to_x, to_y, to_pdf, _]) = parts(batch, samples);
    for i in 0..batch.rows {
        let p = map(uvec2(x[i], y[i]));
        to_x[i] = p.x.to_bits();
        to_y[i] = p.y.to_bits();
    }
    to_pdf.fill(disk::concentric_disk_pdf().to_bits());
}

#[inline(always)]
fn spatial(batch: &Batch, samples: &mut Samples, map: impl Fn(UVec2) -> Vec3) {
    let (x, y, [to_x, to_y, to_z, _]) = parts(batch, samples);
    for i in 0..batch.rows {
        let d = map(uvec2(x[i], y[i]));
        to_x[i] = d.x.to_bits();
        to_y[i] = d.y.to_bits();
        to_z[i] = d.z.to_bits();
    }
}

/// The columns of the fractions and of the samples, each of the batch's rows.
type Parts<'a> = (&'a [u32], &'a [u32], [&'a mut [u32]; WORDS]);

#[inline(always)]
fn parts<'a>(batch: &Batch<'a>, samples: &'a mut Samples) -> Parts<'a> {
    let (x, rest) = batch.words.split_at(STRIDE);
    let (a, samples) = samples.split_at_mut(STRIDE);
    let (b, samples) = samples.split_at_mut(STRIDE);
    let (c, d) = samples.split_at_mut(STRIDE);
    let columns = [a, b, c, d].map(|column| &mut column[..batch.rows]);
    (&x[..batch.rows], &rest[..batch.rows], columns)
}

#[cfg(test)]
mod tests {
    use super::super::maps::map_sample;
    use super::super::points::levels;
    use super::*;
    use crate::catalog::Map;

    /// Fractions that are 0, 1 and 2^32 less 1, halves and quarters with their neighbours, and others.
    fn fractions() -> Vec<u32> {
        let corners = (0..8).flat_map(|eighth| {
            let at = eighth << 29;
            [u32::wrapping_sub(at, 1), at, at + 1]
        });
        let powers = (0..32).map(|bit| 1u32 << bit);
        let others = (0..40).map(|n: u32| n.wrapping_mul(0x9e37_79b9));
        corners.chain(powers).chain(others).collect()
    }

    #[test]
    fn batches_are_the_samples_of_the_headers_by_all_vectors() {
        let some = fractions();
        let pairs: Vec<(u32, u32)> = some
            .iter()
            .flat_map(|x| some.iter().map(move |y| (*x, *y)))
            .collect();
        for name in [
            "concentric-disk",
            "polar-disk",
            "uniform-hemisphere",
            "cosine-hemisphere",
            "cosine-hemisphere-polar",
        ] {
            let mapping = Mapping::new(Map::from_name(name).unwrap(), &[]).unwrap();
            let width = mapping.map().coordinates as usize + 1;
            let directions = Directions::of(&mapping, Profile::Exact, width).unwrap();
            // Batches of a length that no vector divides.
            for pairs in pairs.chunks(509) {
                let mut words = vec![0; 2 * STRIDE];
                for (i, (x, y)) in pairs.iter().enumerate() {
                    (words[i], words[STRIDE + i]) = (*x, *y);
                }
                let batch = Batch {
                    start: 0,
                    rows: pairs.len(),
                    first: 0,
                    words: &words,
                };
                let wanted = pairs
                    .iter()
                    .map(|(x, y)| map_sample(&mapping, Profile::Exact, [*x, *y, 0]));
                let wanted: Vec<_> = wanted.collect();
                for level in levels() {
                    let mut samples = [0; WORDS * STRIDE];
                    directions.fill(level, &batch, &mut samples);
                    for (i, (wanted, pair)) in wanted.iter().zip(pairs).enumerate() {
                        for (column, word) in wanted.iter().enumerate().take(width) {
                            let made = samples[column * STRIDE + i];
                            assert_eq!(made, *word, "{name} {pair:?} {column} {level:?}");
                        }
                    }
                }
            }
        }
    }

    #[test]
    fn only_the_exact_profile_of_these_maps_is_known() {
        let of = |name: &str, values: &[f64], profile| {
            let map = Map::from_name(name).unwrap();
            let mapping = Mapping::with_values(map, values).unwrap();
            Directions::of(&mapping, profile, 4).is_some()
        };
        assert!(of("cosine-hemisphere", &[], Profile::Exact));
        assert!(!of("cosine-hemisphere", &[], Profile::Native));
        assert!(!of("cone", &[0.1], Profile::Exact));
    }
}
