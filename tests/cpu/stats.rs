//! Measures of point sets against slow judges, golden values and broken variants.

#[path = "stats/distance.rs"]
mod distance;
#[path = "stats/l2.rs"]
mod l2;
#[path = "stats/net.rs"]
mod net;
#[path = "stats/pairs.rs"]
mod pairs;
#[path = "stats/spectrum.rs"]
mod spectrum;
#[path = "stats/star.rs"]
mod star;

use corput::Result;
use corput::stats::{Points, Source};

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

    fn points(&mut self, rows: usize, columns: usize) -> Points {
        let values = (0..rows * columns).map(|_| self.next()).collect();
        Points::new(columns, values, Source::F64).unwrap()
    }

    fn pairs(&mut self, count: usize) -> Vec<[f64; 2]> {
        (0..count).map(|_| [self.next(), self.next()]).collect()
    }
}

/// Points in u0.32 by a function of index and dimension.
fn fractions(rows: u32, columns: usize, word: impl Fn(u32, usize) -> u32) -> Points {
    let value = |n: u32, k: usize| f64::from(word(n, k)) / 4_294_967_296.0;
    let values = (0..rows).flat_map(|n| (0..columns).map(move |k| (n, k)));
    let values = values.map(|(n, k)| value(n, k)).collect();
    Points::new(columns, values, Source::U32).unwrap()
}

/// Halton points in the first primes.
fn halton(rows: u32, columns: usize) -> Points {
    use corput::reference::radical_inverse::{radical_inverse, van_der_corput};
    fractions(rows, columns, |n, k| match [2, 3, 5, 7, 11, 13][k] {
        2 => van_der_corput(n),
        prime => radical_inverse(n, prime),
    })
}

/// The Hammersley set of 2^m points, a (0, m, 2)-net.
fn hammersley(m: u32) -> Points {
    fractions(1 << m, 2, |n, k| {
        if k == 0 {
            n << (32 - m)
        } else {
            n.reverse_bits()
        }
    })
}
