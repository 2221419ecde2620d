//! Measures of point sets against slow judges, golden values and broken variants.

#[path = "stats/spectrum.rs"]
mod spectrum;

use corput::Result;

/// A progress that nobody watches.
fn unseen(_: u64, _: u64) -> Result<()> {
    Ok(())
}

/// Independent uniform numbers: SplitMix64 (Steele, Lea and Flood 2014).
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / 9_007_199_254_740_992.0
    }

    fn pairs(&mut self, count: usize) -> Vec<[f64; 2]> {
        (0..count).map(|_| [self.next(), self.next()]).collect()
    }
}
