//! What the lowest digits of permuted radical inverses contribute, place by place.

use crate::interface::{Column, DigitScramble};
use crate::reference::permute::{permute, permute_key, permute_mix};

/// Points of an invocation whose kernel has such tables: enough that few start in it.
pub(super) const PLACES_RUN: u32 = 120;

/// Whether a column has one.
pub(super) fn is_permuted(column: &Column) -> bool {
    matches!(
        column,
        Column::Digits {
            scramble: DigitScramble::Permuted,
            ..
        }
    )
}

/// For each place in a block of `base^low` indices, floor(2^32 x), where x has the permuted low
/// digits of the place mirrored at the point, as `radical_inverse_permuted` has them.
///
/// A kernel would permute them anew for each point, by some hundred instructions a digit.
pub(super) fn places(base: u32, seed: u32, low: u32) -> Vec<u32> {
    let stream = permute_mix(permute_key(seed, base));
    // Mirrored digits, and how many values they have.
    let mut mirrored = vec![0];
    let mut window = 1u64;
    for position in 0..low {
        let key = permute_mix(stream.wrapping_add(position.wrapping_mul(0x9e37_79b9)));
        let digits: Vec<u64> = (0..base)
            .map(|digit| permute(digit, base, key).into())
            .collect();
        // The digit at this position is the slowest of the place, and the last of the mirrored.
        mirrored = digits
            .iter()
            .flat_map(|digit| {
                mirrored
                    .iter()
                    .map(move |below: &u64| below * u64::from(base) + digit)
            })
            .collect();
        window *= u64::from(base);
    }
    mirrored
        .iter()
        .map(|digits| ((digits << 32) / window) as u32)
        .collect()
}
