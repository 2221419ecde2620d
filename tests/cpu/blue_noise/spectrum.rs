//! Power spectra by the definition.

use std::f64::consts::TAU;

/// A permutation of 0 to `count` - 1 without structure: a white mask.
pub fn white_ranks(count: u32, seed: u64) -> Vec<u32> {
    let mut state = seed | 1;
    let mut next = move || {
        // A step of xorshift64*.
        state ^= state >> 12;
        state ^= state << 25;
        state ^= state >> 27;
        state.wrapping_mul(0x2545_f491_4f6c_dd1d) >> 32
    };
    let mut ranks: Vec<u32> = (0..count).collect();
    for i in (1..ranks.len()).rev() {
        ranks.swap(i, next() as usize % (i + 1));
    }
    ranks
}

/// Power at a frequency, of `sides` [x, y] values less their mean: 1 is that of white noise
/// of the same variance.
pub fn power(values: &[f64], [width, height]: [usize; 2], [fx, fy]: [usize; 2]) -> f64 {
    let count = values.len() as f64;
    let mean = values.iter().sum::<f64>() / count;
    let variance = values.iter().map(|v| (v - mean).powi(2)).sum::<f64>() / count;
    let turn = |f: usize, at: usize, length: usize| (f * at % length) as f64 / length as f64;
    let (mut real, mut imaginary) = (0.0, 0.0);
    for (i, value) in values.iter().enumerate() {
        let phase = TAU * (turn(fx, i % width, width) + turn(fy, i / width, height));
        real += (value - mean) * phase.cos();
        imaginary += (value - mean) * phase.sin();
    }
    (real * real + imaginary * imaginary) / (count * variance)
}

/// Mean power at the frequencies below a quarter of Nyquist, 0 aside.
pub fn low_energy(values: &[f64], sides: [usize; 2]) -> f64 {
    let [width, height] = sides;
    let mut sum = 0.0;
    let mut number = 0;
    for fy in 0..height {
        for fx in 0..=width / 8 {
            let folded = fy.min(height - fy) as f64 / height as f64;
            let radius = (fx as f64 / width as f64).hypot(folded);
            if radius > 0.0 && radius < 0.125 {
                sum += power(values, sides, [fx, fy]);
                number += 1;
            }
        }
    }
    sum / f64::from(number)
}
