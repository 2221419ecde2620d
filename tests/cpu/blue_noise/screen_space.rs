//! Screen-space indices: bijections, an independent shuffle, and the spectrum of an error.

use super::spectrum::low_energy;
use corput::glam::uvec2;
use corput::reference::screen_space::{screen_space_hash, screen_space_index};

const SIDE: u32 = 64;

/// The `n`-th permutation of 0 to 3 in lexicographic order.
fn permutation(n: usize) -> Vec<u32> {
    let mut all = Vec::new();
    for code in 0..256u32 {
        let images: Vec<u32> = (0..4).map(|i| code >> (6 - 2 * i) & 3).collect();
        if (0..4).all(|digit| images.contains(&digit)) {
            all.push(images);
        }
    }
    assert_eq!(all.len(), 24);
    all[n].clone()
}

/// The index from strings of digits.
fn slow_index(x: u32, y: u32, sample: u32, samples_log2: u32, seed: u32) -> u64 {
    let digits = (32 - samples_log2) / 2;
    let path: Vec<u32> = (0..digits)
        .rev()
        .map(|bit| (y >> bit & 1) * 2 + (x >> bit & 1))
        .collect();
    let mut index = 0;
    for (level, digit) in path.iter().enumerate() {
        let prefix = path[..level].iter().fold(0, |code, digit| 4 * code + digit);
        let hash = screen_space_hash(prefix, level as u32, seed);
        let chosen = ((u64::from(hash) * 24) >> 32) as usize;
        index = 4 * index + u64::from(permutation(chosen)[*digit as usize]);
    }
    (index << samples_log2) + u64::from(sample)
}

#[test]
fn indices_are_those_of_the_paper() {
    for samples_log2 in [0, 1, 2, 5, 8, 17, 31] {
        let sides = 1u64 << ((32 - samples_log2) / 2);
        for i in 0..200u32 {
            let mixed = i.wrapping_mul(0x9e37_79b9);
            let x = (u64::from(mixed) % sides) as u32;
            let y = (u64::from(mixed >> 7) % sides) as u32;
            let sample = mixed & ((1 << samples_log2) - 1);
            let found = screen_space_index(uvec2(x, y), sample, samples_log2, i);
            assert_eq!(u64::from(found), slow_index(x, y, sample, samples_log2, i));
        }
    }
    assert_eq!(screen_space_index(uvec2(3, 4), 9, 32, 1), 9);
}

#[test]
fn each_tile_has_a_block_of_indices_to_itself() {
    for (corner, log2) in [([0, 0], 5), ([32, 96], 5), ([4, 8], 2), ([640, 1024], 4)] {
        for (samples_log2, seed) in [(0, 1), (3, 2), (4, 0xffff_ffff)] {
            let mut indices = Vec::new();
            for i in 0..1u32 << (2 * log2) {
                let side = (1 << log2) - 1;
                let pixel = uvec2(corner[0] + (i & side), corner[1] + (i >> log2));
                let samples = 0..1 << samples_log2;
                indices.extend(samples.map(|s| screen_space_index(pixel, s, samples_log2, seed)));
            }
            indices.sort_unstable();
            let size = 1u32 << (2 * log2 + samples_log2);
            let first = indices[0];
            assert_eq!(first % size, 0);
            assert!(indices.iter().copied().eq(first..first + size));
        }
    }
}

/// Coordinates 0 and 1 of Sobol's sequence, scrambled by a hash of each bit's prefix.
fn scrambled_sobol(index: u32, seed: u32) -> [f64; 2] {
    let (mut column, mut second) = (1u32 << 31, 0);
    for bit in 0..32 {
        if index >> bit & 1 != 0 {
            second ^= column;
        }
        column ^= column >> 1;
    }
    [(index.reverse_bits(), 1), (second, 2)].map(|(word, salt)| {
        let mut result = 0u32;
        for bit in 0..32u32 {
            let prefix = if bit == 0 { 0 } else { word >> (32 - bit) };
            let flip = screen_space_hash(prefix, bit + 64 * salt, seed) >> 31;
            result = 2 * result + ((word >> (31 - bit) & 1) ^ flip);
        }
        f64::from(result) / 4_294_967_296.0
    })
}

/// A function on the unit square, and its integral.
type Integrand = (fn([f64; 2]) -> f64, f64);

/// A step: the area of x + y < 1.1.
const STEP: Integrand = (
    |[x, y]| f64::from(u8::from(x + y < 1.1)),
    1.0 - 0.9 * 0.9 / 2.0,
);

/// A smooth function.
const SMOOTH: Integrand = (|[x, y]| x * x + x * y, 1.0 / 3.0 + 1.0 / 4.0);

/// Errors of pixels that integrate by four samples each.
fn errors(integrand: Integrand, index: impl Fn(u32, u32, u32) -> u32, seed: u32) -> Vec<f64> {
    let (value, truth) = integrand;
    let pixels = (0..SIDE).flat_map(|y| (0..SIDE).map(move |x| (x, y)));
    let estimate = |(x, y)| {
        let samples = (0..4).map(|sample| value(scrambled_sobol(index(x, y, sample), seed)));
        samples.sum::<f64>() / 4.0 - truth
    };
    pixels.map(estimate).collect()
}

/// Neighbours share a stretch of the sequence, so errors cancel over them, the better the
/// smoother the integrand: below a quarter of Nyquist there is less than half of white
/// noise's power for a step, and less than 0.15 of it for a smooth function. Errors that
/// cancelled wholly over blocks of 2 x 2, and were white otherwise, would leave
/// 4/3 (1 - cos^2(pi fx) cos^2(pi fy)), 0.10 on average. Stretches of the sequence that are
/// dealt to the pixels at random leave all.
#[test]
fn the_error_is_blue_noise_in_screen_space() {
    for (integrand, bound) in [(STEP, 0.5), (SMOOTH, 0.15)] {
        for seed in 1..4 {
            let ordered = |x, y, sample| screen_space_index(uvec2(x, y), sample, 2, seed);
            let energy = low_energy(&errors(integrand, ordered, seed), [SIDE as usize; 2]);
            let dealt = super::white_ranks(SIDE * SIDE, seed.into());
            let random = |x, y, sample| dealt[(y * SIDE + x) as usize] * 4 + sample;
            let white = low_energy(&errors(integrand, random, seed), [SIDE as usize; 2]);
            println!("seed {seed}: {energy:.4} in Z-order, {white:.4} dealt at random");
            assert!(energy < bound, "seed {seed}: {energy}");
            assert!(white > 0.6, "seed {seed}: {white}");
        }
    }
}
