//! Void-and-cluster on the CPU.
//!
//! Source: Ulichney 1993, The void-and-cluster method for dither array generation, SPIE
//! 1913; over time Wolfe et al. 2022, Spatiotemporal blue noise masks, EGSR: two pixels
//! repel each other when they lie in the same frame, by a Gaussian of their distance, or
//! at the same place in two frames, by a Gaussian of their distance in time.
//!
//! Ulichney's third phase, above half, looks for the tightest cluster of the pixels that
//! are not set. The energies of both kinds of pixels sum to the same everywhere on a
//! torus, exactly so in integers; hence the tightest cluster of the ones is the largest
//! void of the others, and the second phase can go on to the end.

use super::{MaskShape, energies};

/// Marks a pixel that is set, above the bits of its energy.
const SET: u32 = 1 << 31;

/// The rank of each pixel, from 0 to their number less one, each once.
///
/// Cost: about a second for the largest masks.
#[must_use]
pub fn void_and_cluster(shape: MaskShape, seed: u64) -> Vec<u32> {
    let mut field = Field::scattered(shape, seed);
    field.relax();
    let mut ranks = vec![0; shape.pixels() as usize];
    let mut shrinking = field.clone();
    for rank in (0..shape.minority()).rev() {
        let pixel = shrinking.tightest_cluster();
        shrinking.toggle(pixel);
        ranks[pixel as usize] = rank;
    }
    for rank in shape.minority()..shape.pixels() {
        let pixel = field.largest_void();
        field.toggle(pixel);
        ranks[pixel as usize] = rank;
    }
    ranks
}

/// The words of the scattered pattern, from which a device goes on: the energy of each
/// pixel, and bit 31 where it is set.
#[must_use]
pub fn scattered_words(shape: MaskShape, seed: u64) -> Vec<u32> {
    Field::scattered(shape, seed).words
}

/// Every pixel's energy, and the extremes of each row.
#[derive(Clone)]
struct Field {
    shape: MaskShape,
    /// Energy by squared distance, and by squared distance in time.
    energies: Vec<u32>,
    /// How far energy reaches along an axis.
    reach: u32,
    /// Energies with [`SET`]: so the least word is the largest void, and the greatest the
    /// tightest cluster.
    words: Vec<u32>,
    /// The least and the greatest word of each row of each frame.
    extremes: Vec<(u32, u32)>,
}

impl Field {
    /// The initial pattern before it is relaxed.
    fn scattered(shape: MaskShape, seed: u64) -> Self {
        let energies = energies();
        let mut field = Self {
            shape,
            reach: (energies.len() - 1).isqrt() as u32,
            energies,
            words: vec![0; shape.pixels() as usize],
            extremes: vec![(0, 0); (shape.height * shape.frames) as usize],
        };
        for pixel in shape.scatter(seed) {
            field.toggle(pixel);
        }
        field
    }

    /// Moves the tightest cluster to the largest void until it would return.
    ///
    /// This ends: a move lowers the energy of the whole pattern, or keeps it and lowers
    /// the sum of the indices of its pixels.
    fn relax(&mut self) {
        loop {
            let cluster = self.tightest_cluster();
            self.toggle(cluster);
            let void = self.largest_void();
            self.toggle(void);
            if void == cluster {
                return;
            }
        }
    }

    /// The pixel with the most energy of those set, the first of equals.
    fn tightest_cluster(&self) -> u32 {
        let greatest = self.extremes.iter().map(|row| row.1).max();
        self.find(|row| Some(row.1) == greatest, greatest)
    }

    /// The pixel with the least energy of those not set, the first of equals.
    fn largest_void(&self) -> u32 {
        let least = self.extremes.iter().map(|row| row.0).min();
        self.find(|row| Some(row.0) == least, least)
    }

    /// The first pixel with this word, in the first row of these extremes.
    fn find(&self, holds: impl Fn(&(u32, u32)) -> bool, word: Option<u32>) -> u32 {
        let width = self.shape.width as usize;
        let row = self.extremes.iter().position(holds).unwrap_or(0);
        let pixels = &self.words[row * width..][..width];
        let column = pixels.iter().position(|found| Some(*found) == word);
        (row * width + column.unwrap_or(0)) as u32
    }

    /// Sets a pixel that is not set, or the other way round.
    fn toggle(&mut self, pixel: u32) {
        let MaskShape {
            width,
            height,
            frames,
        } = self.shape;
        let removes = self.words[pixel as usize] >= SET;
        self.words[pixel as usize] ^= SET;
        let (row, x) = (pixel / width, pixel % width);
        let (frame, y) = (row / height, row % height);
        for (other, dy) in around(y, height, self.reach) {
            let row = frame * height + other;
            for (other, dx) in around(x, width, self.reach) {
                self.add(row * width + other, dx * dx + dy * dy, removes);
            }
            self.measure(row);
        }
        for (other, distance) in around(frame, frames, self.reach) {
            if other != frame {
                let row = other * height + y;
                self.add(row * width + x, distance * distance, removes);
                self.measure(row);
            }
        }
    }

    /// Adds or takes away the energy at a squared distance.
    fn add(&mut self, pixel: u32, squared: u32, removes: bool) {
        if let Some(energy) = self.energies.get(squared as usize) {
            let word = &mut self.words[pixel as usize];
            *word = if removes {
                word.wrapping_sub(*energy)
            } else {
                word.wrapping_add(*energy)
            };
        }
    }

    /// Finds the extremes of a row anew.
    fn measure(&mut self, row: u32) {
        let width = self.shape.width as usize;
        let pixels = &self.words[row as usize * width..][..width];
        let extremes = pixels
            .iter()
            .fold((u32::MAX, 0), |(least, greatest), word| {
                (least.min(*word), greatest.max(*word))
            });
        self.extremes[row as usize] = extremes;
    }
}

/// The places within reach of one on a circle of `length`, each once, and how far they
/// are.
fn around(at: u32, length: u32, reach: u32) -> impl Iterator<Item = (u32, u32)> {
    let (before, after) = (reach.min((length - 1) / 2), reach.min(length / 2));
    let wrapped = move |offset: u32| (at + length + offset - before) % length;
    (0..=before + after).map(move |offset| (wrapped(offset), offset.abs_diff(before)))
}
