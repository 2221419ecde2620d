//! Dither masks and point sets of blue noise: against slow implementations from the
//! papers, their spectra against white noise, and that broken ones are seen.

#[path = "blue_noise/points.rs"]
mod points;
#[path = "blue_noise/screen_space.rs"]
mod screen_space;
#[path = "blue_noise/spectrum.rs"]
mod spectrum;
#[path = "blue_noise/ulichney.rs"]
mod ulichney;

use corput::blue_noise::{MaskShape, energies, void_and_cluster};
use corput::reference::blue_noise as lookup;
use glam::{uvec2, uvec3};
use sha2::{Digest, Sha256};
use spectrum::{low_energy, white_ranks};

use corput::glam;

fn shape(width: u64, height: u64, frames: u64) -> MaskShape {
    MaskShape::new(width, height, frames).unwrap_or_else(|error| panic!("{error}"))
}

/// A seed that no other test uses, for the `i`-th of a series.
fn seed(i: u64) -> u64 {
    0x5eed_0000_0000_0000 | i
}

#[test]
fn energies_are_the_rounded_gaussian() {
    let list = energies();
    for (squared, energy) in (0u32..).zip(&list) {
        let truth = (-f64::from(squared) / 4.5).exp() * 16_777_216.0;
        assert_eq!(f64::from(*energy), truth.round(), "at {squared}");
        // So far from a tie that neither the powers nor `exp` decide the rounding.
        assert!(
            (truth.fract() - 0.5).abs() > 1e-6 || squared == 0,
            "{squared}"
        );
    }
    assert!((-(list.len() as f64) / 4.5).exp() * 16_777_216.0 < 0.5);
    let reach = 8i64;
    let plane: u64 = (-reach..=reach)
        .flat_map(|y| (-reach..=reach).map(move |x| (x * x + y * y) as usize))
        .filter_map(|squared| list.get(squared))
        .map(|energy| u64::from(*energy))
        .sum();
    let time: u64 = (1..=reach as usize)
        .filter_map(|t| list.get(t * t))
        .map(|energy| 2 * u64::from(*energy))
        .sum();
    assert!(plane < 1 << 28 && time < 1 << 26, "{plane} {time}");
}

#[test]
fn every_rank_occurs_once() {
    for (sides, seeds) in [
        ([4, 4, 1], 20),
        ([5, 4, 1], 20),
        ([17, 31, 1], 4),
        ([33, 33, 1], 2),
        ([64, 64, 1], 1),
        ([100, 37, 1], 1),
        ([7, 5, 3], 4),
        ([16, 16, 16], 1),
        ([256, 256, 1], 1),
    ] {
        let shape = shape(sides[0], sides[1], sides[2]);
        for i in 0..seeds {
            let mut ranks = void_and_cluster(shape, seed(i));
            ranks.sort_unstable();
            assert!(ranks.into_iter().eq(0..shape.pixels()), "{sides:?}");
        }
    }
}

/// Ulichney's three phases, energies summed anew for every step: the same ranks. Each
/// mistake of the slow one gives others.
#[test]
fn masks_are_those_of_the_paper() {
    use ulichney::{Mistake, ranks};
    for sides in [
        [4, 4, 1],
        [5, 7, 1],
        [16, 16, 1],
        [20, 13, 1],
        [19, 18, 1],
        [6, 5, 4],
        [5, 4, 13],
    ] {
        let shape = shape(sides[0], sides[1], sides[2]);
        for i in 0..2 {
            let found = void_and_cluster(shape, seed(i));
            assert_eq!(found, ranks(shape, seed(i), None), "{sides:?}");
        }
    }
    let (still, moving) = (shape(20, 13, 1), shape(6, 5, 4));
    for (mistake, shape) in [
        (Mistake::TiesToTheHighest, still),
        (Mistake::NoWrap, still),
        (Mistake::OtherSigma, still),
        (Mistake::NotRelaxed, still),
        (Mistake::FramesApart, moving),
    ] {
        let wrong = ranks(shape, seed(0), Some(mistake));
        assert_ne!(void_and_cluster(shape, seed(0)), wrong, "{mistake:?}");
    }
}

/// What a mask is for: little energy below a quarter of Nyquist, as a whole and when
/// it is a threshold. White noise, and the initial pattern without more, have it all.
#[test]
fn masks_have_little_energy_at_low_frequencies() {
    let halved = |ranks: &[u32], share: f64| -> Vec<f64> {
        let level = share * ranks.len() as f64;
        ranks
            .iter()
            .map(|r| f64::from(u8::from(f64::from(*r) < level)))
            .collect()
    };
    let whole = |ranks: &[u32]| -> Vec<f64> { ranks.iter().map(|r| f64::from(*r)).collect() };
    for (side, seeds) in [(33, 3), (64, 3), (128, 1)] {
        let shape = shape(side, side, 1);
        let sides = [side as usize; 2];
        for i in 0..seeds {
            let ranks = void_and_cluster(shape, seed(i));
            let white = white_ranks(shape.pixels(), seed(i));
            let energy = low_energy(&whole(&ranks), sides);
            assert!(energy < 0.002, "{side}: {energy}");
            assert!(low_energy(&whole(&white), sides) > 0.5);
            for share in [0.1, 0.25, 0.5, 0.75, 0.9] {
                let energy = low_energy(&halved(&ranks, share), sides);
                assert!(energy < 0.1, "{side} at {share}: {energy}");
                assert!(low_energy(&halved(&white, share), sides) > 0.5);
            }
        }
    }
}

/// Over time each frame is blue, and so is each pixel; masks made apart are white there.
#[test]
fn masks_over_time_are_blue_in_space_and_time() {
    let shape = shape(32, 32, 16);
    let frame = 32 * 32;
    let ranks = void_and_cluster(shape, seed(0));
    let floats: Vec<f64> = ranks.iter().map(|r| f64::from(*r)).collect();
    for image in floats.chunks(frame) {
        let energy = low_energy(image, [32, 32]);
        assert!(energy < 0.02, "{energy}");
    }
    let still = MaskShape::new(32, 32, 1).expect("a shape");
    let apart: Vec<f64> = (0..16)
        .flat_map(|i| void_and_cluster(still, seed(i)))
        .map(f64::from)
        .collect();
    let over_time = |values: &[f64]| -> f64 {
        let energy = |pixel: usize| {
            let line: Vec<f64> = values.iter().skip(pixel).step_by(frame).copied().collect();
            spectrum::power(&line, [16, 1], [1, 0]) + spectrum::power(&line, [16, 1], [2, 0])
        };
        (0..frame).map(energy).sum::<f64>() / (2 * frame) as f64
    };
    assert!(over_time(&floats) < 0.12, "{}", over_time(&floats));
    assert!(over_time(&apart) > 0.8, "{}", over_time(&apart));
}

/// Two channels are two masks: blue each, and as good as uncorrelated.
#[test]
fn channels_are_not_correlated() {
    let shape = shape(64, 64, 1);
    for i in 0..3 {
        let channels = [0, 1].map(|c| void_and_cluster(shape, MaskShape::channel_seed(seed(i), c)));
        assert_eq!(channels[0], void_and_cluster(shape, seed(i)));
        let correlated = correlation(&channels[0], &channels[1]);
        // Four standard deviations of white noise, 1/sqrt(4096).
        assert!(correlated.abs() < 4.0 / 64.0, "{correlated}");
        assert!(correlation(&channels[0], &channels[0]) > 0.99);
    }
}

fn correlation(a: &[u32], b: &[u32]) -> f64 {
    let mean = (a.len() - 1) as f64 / 2.0;
    let product = |a: &[u32], b: &[u32]| -> f64 {
        let pairs = a.iter().zip(b);
        pairs
            .map(|(x, y)| (f64::from(*x) - mean) * (f64::from(*y) - mean))
            .sum()
    };
    product(a, b) / product(a, a)
}

/// The bits of one mask, so that a change of any kind is seen.
#[test]
fn a_mask_keeps_its_bits() {
    let ranks = void_and_cluster(shape(64, 64, 1), 1);
    let bytes: Vec<u8> = ranks.iter().flat_map(|rank| rank.to_le_bytes()).collect();
    let hash: String = Sha256::digest(&bytes)
        .iter()
        .map(|b| format!("{b:02x}"))
        .collect();
    assert_eq!(hash, MASK_SHA256);
}

const MASK_SHA256: &str = "d87b45421dfae6b8dc011bfd871af2c77f4c534dce96ef3bef02df5fe50b7899";

#[test]
fn shapes_outside_the_limits_are_refused() {
    for (sides, words) in [
        ([0, 4, 1], "4 to 256"),
        ([3, 4, 1], "4 to 256"),
        ([4, 257, 1], "4 to 256"),
        ([u64::MAX, 4, 1], "4 to 256"),
        ([64, 64, 0], "1 to 16"),
        ([64, 64, 17], "1 to 16"),
        ([65, 64, 16], "at most 65536 pixels"),
        ([4, 256, 5], "at most 1024 rows"),
    ] {
        let error = MaskShape::new(sides[0], sides[1], sides[2]).expect_err("refused");
        assert!(error.to_string().contains(words), "{error}");
        assert_eq!(error.exit_code(), 2);
    }
    for sides in [[4, 4, 1], [256, 256, 1], [64, 64, 16], [4, 64, 16]] {
        assert!(
            MaskShape::new(sides[0], sides[1], sides[2]).is_ok(),
            "{sides:?}"
        );
    }
}

#[test]
fn fractions_are_the_middles_of_equal_parts() {
    let counts = (1..=300).chain([4095, 4096, 4097, 65535, 65536]);
    for count in counts {
        let ranks = (0..count)
            .step_by(1 + count as usize / 1000)
            .chain([count - 1]);
        for rank in ranks {
            let truth = (u128::from(2 * rank + 1) << 31) / u128::from(count);
            let found = lookup::blue_noise_fraction(rank, count);
            assert_eq!(u128::from(found), truth, "{rank} of {count}");
        }
    }
}

#[test]
fn look_ups_wrap_around() {
    let (size, frames) = (uvec2(5, 7), 3);
    let ranks: Vec<u32> = (0..105).collect();
    for (x, y) in (0..40).flat_map(|x| (0..40).map(move |y| (x, y))) {
        let rank = y % 7 * 5 + x % 5;
        let pixel = uvec2(x, y);
        assert_eq!(lookup::blue_noise_rank(pixel, size, &ranks), rank);
        let fraction = lookup::blue_noise_fraction(rank, 35);
        assert_eq!(lookup::blue_noise(pixel, size, &ranks), fraction);
        for frame in 0..9 {
            let fraction = lookup::blue_noise_fraction(frame % 3 * 35 + rank, 105);
            let found = lookup::blue_noise_frame(pixel, frame, uvec3(5, 7, frames), &ranks);
            assert_eq!(found, fraction);
        }
    }
}

/// Over time a pixel's values keep the distances of the golden ratio's sequence: among N
/// no gap is more than 2.618 / N wide.
#[test]
fn animated_values_fill_the_interval() {
    for count in [2u32, 5, 16, 100] {
        let values = (100..100 + count).map(|frame| lookup::blue_noise_animate(77, frame));
        let mut values: Vec<u32> = values.collect();
        values.sort_unstable();
        let gaps =
            (0..values.len()).map(|i| values[(i + 1) % values.len()].wrapping_sub(values[i]));
        let widest = f64::from(gaps.max().unwrap_or(u32::MAX)) / 4_294_967_296.0;
        assert!(widest * f64::from(count) < 2.619, "{count}: {widest}");
    }
}

/// Shifts of sixteen dimensions lie apart, and each is a shift of the whole mask.
#[test]
fn shifts_are_spread() {
    let size = uvec2(64, 48);
    let of = |dimension| lookup::blue_noise_shift(uvec2(64, 96), dimension, size);
    assert_eq!(of(0), uvec2(0, 0));
    for (a, b) in (0..16).flat_map(|a| (0..a).map(move |b| (a, b))) {
        let along = |x: u32, y: u32, length: u32| {
            let d = (x + length - y) % length;
            d.min(length - d)
        };
        let (p, q) = (of(a), of(b));
        let (x, y) = (along(p.x, q.x, 64), along(p.y, q.y, 48));
        assert!(x * x + y * y >= 64, "{a} and {b}: {p} {q}");
    }
    for dimension in [1, 2, 1000] {
        let shift = of(dimension);
        let moved = lookup::blue_noise_shift(uvec2(3, 5), dimension, size);
        assert_eq!(moved, shift + uvec2(3, 5));
    }
}
