//! Words from a seed and a counter, for what the host draws.

/// The odd number nearest to 2^64 over the golden ratio.
const GAMMA: u64 = 0x9e37_79b9_7f4a_7c15;

/// The finaliser of SplitMix64 (Steele, Lea and Flood 2014, Fast splittable pseudorandom
/// number generators, OOPSLA): a bijection of 64 bits.
const fn scramble(z: u64) -> u64 {
    let z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

/// Word `counter` of the stream of a seed: SplitMix64 from a scrambled state, so that
/// streams of near seeds do not overlap.
pub(super) const fn word(seed: u64, counter: u64) -> u64 {
    let state = scramble(seed.wrapping_add(GAMMA));
    scramble(state.wrapping_add(counter.wrapping_add(1).wrapping_mul(GAMMA)))
}

#[cfg(test)]
mod tests {
    use super::{GAMMA, scramble};

    /// The first outputs of the published generator for the state 1234567.
    #[test]
    fn the_finaliser_is_splitmix64() {
        let outputs: Vec<u64> = (1..=3u64)
            .map(|i| scramble(1_234_567u64.wrapping_add(i.wrapping_mul(GAMMA))))
            .collect();
        assert_eq!(
            outputs,
            [
                6_457_827_717_110_365_317,
                3_203_168_211_198_807_973,
                9_817_491_932_198_370_423
            ]
        );
    }
}
