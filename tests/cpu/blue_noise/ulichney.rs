//! Void-and-cluster as the paper has it: three phases, and every energy summed anew.

use corput::blue_noise::MaskShape;

/// A mistake to make on purpose.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mistake {
    TiesToTheHighest,
    NoWrap,
    OtherSigma,
    NotRelaxed,
    FramesApart,
}

struct Paper {
    shape: MaskShape,
    mistake: Option<Mistake>,
}

impl Paper {
    fn place(&self, pixel: usize) -> [i64; 3] {
        let MaskShape { width, height, .. } = self.shape;
        let pixel = pixel as i64;
        let (width, height) = (i64::from(width), i64::from(height));
        [
            pixel % width,
            pixel / width % height,
            pixel / width / height,
        ]
    }

    /// The Gaussian of two pixels in units of 2^-24, rounded.
    fn energy(&self, a: usize, b: usize) -> u64 {
        let (p, q) = (self.place(a), self.place(b));
        let MaskShape {
            width,
            height,
            frames,
            ..
        } = self.shape;
        let sides = [width, height, frames].map(i64::from);
        let distance = |axis: usize| {
            let d = (p[axis] - q[axis]).abs();
            match self.mistake {
                Some(Mistake::NoWrap) => d,
                _ => d.min(sides[axis] - d),
            }
        };
        let [x, y, t] = [distance(0), distance(1), distance(2)];
        let apart = self.mistake == Some(Mistake::FramesApart);
        let squared = match (x, y, t) {
            (_, _, 0) => x * x + y * y,
            (0, 0, _) if !apart => t * t,
            _ => return 0,
        };
        let sigma = match self.mistake {
            Some(Mistake::OtherSigma) => 1.9,
            _ => 1.5f64,
        };
        let value = (-squared as f64 / (2.0 * sigma * sigma)).exp();
        (value * 16_777_216.0).round() as u64
    }

    /// Of the pixels that are `of`, the one with the greatest or least sum of energies to
    /// those that are `to`.
    fn extreme(&self, pattern: &[bool], of: bool, to: bool, greatest: bool) -> usize {
        let mut best: Option<(u64, usize)> = None;
        for pixel in (0..pattern.len()).filter(|pixel| pattern[*pixel] == of) {
            let others = (0..pattern.len()).filter(|other| pattern[*other] == to);
            let sum: u64 = others.map(|other| self.energy(pixel, other)).sum();
            let better = best.is_none_or(|(found, _)| match greatest {
                true => sum > found,
                false => sum < found,
            });
            let tied = best.is_some_and(|(found, _)| sum == found);
            if better || (tied && self.mistake == Some(Mistake::TiesToTheHighest)) {
                best = Some((sum, pixel));
            }
        }
        best.expect("a pixel").1
    }
}

/// The ranks.
pub fn ranks(shape: MaskShape, seed: u64, mistake: Option<Mistake>) -> Vec<u32> {
    let paper = Paper { shape, mistake };
    let mut initial = vec![false; shape.pixels() as usize];
    for pixel in shape.scatter(seed) {
        initial[pixel as usize] = true;
    }
    while mistake != Some(Mistake::NotRelaxed) {
        let cluster = paper.extreme(&initial, true, true, true);
        initial[cluster] = false;
        let void = paper.extreme(&initial, false, true, false);
        initial[void] = true;
        if void == cluster {
            break;
        }
    }
    let ones = initial.iter().filter(|one| **one).count();
    let mut ranks = vec![0; initial.len()];
    let mut pattern = initial.clone();
    for rank in (0..ones).rev() {
        let cluster = paper.extreme(&pattern, true, true, true);
        pattern[cluster] = false;
        ranks[cluster] = rank as u32;
    }
    let mut pattern = initial;
    for rank in ones..ranks.len() {
        // Beyond half the zeros are the minority: the tightest cluster of them is next.
        let next = if rank < ranks.len() / 2 {
            paper.extreme(&pattern, false, true, false)
        } else {
            paper.extreme(&pattern, false, false, true)
        };
        pattern[next] = true;
        ranks[next] = rank as u32;
    }
    ranks
}
