//! The statistics, from Knuth, TAOCP vol. 2, 3.3.2, Marsaglia's DIEHARD, and L'Ecuyer and
//! Simard's TestU01. Each gives p-values that are uniform for independent uniform words.

use super::p_value::{cells, fair, normal, poisson};

/// One result: the family, what exactly, the p-value.
pub type Finding = (&'static str, String, f64);

/// Distances at which a stream is compared with itself.
const LAGS: [usize; 23] = [
    1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 64, 256, 1024, 4096, 65_536, 131_072,
    262_144,
];

/// The bits of a stream's words, each as a row over the stream.
struct Bits {
    rows: Vec<Vec<u64>>,
    length: usize,
}

impl Bits {
    fn new(words: &[u32]) -> Self {
        let mut rows = vec![vec![0u64; words.len().div_ceil(64)]; 32];
        for (i, &word) in words.iter().enumerate() {
            for (bit, row) in rows.iter_mut().enumerate() {
                row[i / 64] |= u64::from((word >> bit) & 1) << (i % 64);
            }
        }
        let length = words.len();
        Self { rows, length }
    }

    /// Ones of the sum of two rows, the second from `lag` on.
    fn sum(&self, first: usize, second: usize, lag: usize) -> (u64, u64) {
        let (a, b) = (&self.rows[first], &self.rows[second]);
        let trials = self.length - lag;
        let mut ones = 0;
        let shift = lag % 64;
        for (i, word) in a.iter().enumerate().take(trials.div_ceil(64)) {
            let at = i + lag / 64;
            let high = if shift == 0 {
                0
            } else {
                b.get(at + 1).map_or(0, |next| next << (64 - shift))
            };
            let valid = u64::MAX >> (64 - (trials - 64 * i).min(64));
            ones += ((word ^ ((b[at] >> shift) | high)) & valid).count_ones();
        }
        (u64::from(ones), trials as u64)
    }
}

/// Every family over one stream.
pub fn all(words: &[u32]) -> Vec<Finding> {
    let mut found = Vec::new();
    let bits = Bits::new(words);
    frequency(words, &bits, &mut found);
    serial(words, &bits, &mut found);
    runs(words, &mut found);
    // Three views: whole words, the lowest bits first, the upper halves of two.
    let reversed: Vec<u32> = words.iter().map(|word| word.reverse_bits()).collect();
    let pairs = words.chunks_exact(2);
    let halves: Vec<u32> = pairs.map(|w| (w[0] & !0xffff) | (w[1] >> 16)).collect();
    for (view, words) in [
        ("words", words),
        ("reversed", &reversed),
        ("halves", &halves),
    ] {
        gaps(view, words, &mut found);
        birthdays(view, words, &mut found);
        collisions(view, words, &mut found);
        ranks(view, words.chunks_exact(32), &mut found);
    }
    for (bit, row) in bits.rows.iter().enumerate() {
        let rows: Vec<u32> = row
            .iter()
            .flat_map(|w| [*w as u32, (w >> 32) as u32])
            .collect();
        ranks(&format!("bit {bit}"), rows.chunks_exact(32), &mut found);
    }
    found
}

/// Ones of each bit, bytes of each place, and each bit against each other.
fn frequency(words: &[u32], bits: &Bits, found: &mut Vec<Finding>) {
    let total = bits.length as u64;
    for (bit, row) in bits.rows.iter().enumerate() {
        let ones = row.iter().map(|word| u64::from(word.count_ones())).sum();
        found.push(("frequency", format!("bit {bit}"), fair(ones, total)));
        for other in 0..bit {
            let (ones, trials) = bits.sum(bit, other, 0);
            found.push((
                "frequency",
                format!("bits {bit}, {other}"),
                fair(ones, trials),
            ));
        }
    }
    for byte in 0..4 {
        let mut counts = [0; 256];
        for word in words {
            counts[word.to_le_bytes()[byte] as usize] += 1;
        }
        let p = cells(&counts, &[1.0 / 256.0; 256]);
        found.push(("bytes", format!("byte {byte}"), p));
    }
}

/// Correlation with the stream some steps on: of the numbers, and of each bit.
fn serial(words: &[u32], bits: &Bits, found: &mut Vec<Finding>) {
    let centred: Vec<f64> = words
        .iter()
        .map(|word| (f64::from(*word) + 0.5) / 4_294_967_296.0 - 0.5)
        .collect();
    for lag in LAGS {
        let sum: f64 = centred
            .iter()
            .zip(&centred[lag..])
            .map(|(x, y)| x * y)
            .sum();
        // Each product has mean 0 and variance 1/144.
        let z = sum * 12.0 / ((words.len() - lag) as f64).sqrt();
        found.push(("serial", format!("lag {lag}"), normal(z)));
        for bit in 0..32 {
            let (ones, trials) = bits.sum(bit, bit, lag);
            found.push((
                "bit serial",
                format!("bit {bit}, lag {lag}"),
                fair(ones, trials),
            ));
        }
    }
}

/// Lengths of ascending runs, of which each is followed by a number that belongs to none:
/// they are then independent, and of length r with probability 1/r! - 1/(r + 1)!.
fn runs(words: &[u32], found: &mut Vec<Finding>) {
    let mut counts = [0; 7];
    let (mut length, mut i) = (1, 1);
    while i < words.len() {
        if words[i] > words[i - 1] {
            length += 1;
            i += 1;
        } else {
            counts[length.min(7) - 1] += 1;
            length = 1;
            i += 2;
        }
    }
    let (mut probabilities, mut inverse) = ([0.0; 7], 1.0);
    for (r, p) in (1..).zip(&mut probabilities) {
        let next = inverse / f64::from(r + 1);
        *p = if r == 7 { inverse } else { inverse - next };
        inverse = next;
    }
    found.push(("runs", "up".into(), cells(&counts, &probabilities)));
}

/// Distances of successive numbers below 1/8.
fn gaps(view: &str, words: &[u32], found: &mut Vec<Finding>) {
    let mut counts = [0; 49];
    let mut last = None;
    for (i, _) in words
        .iter()
        .enumerate()
        .filter(|(_, word)| **word >> 29 == 0)
    {
        if let Some(last) = last.replace(i) {
            counts[(i - last).min(49) - 1] += 1;
        }
    }
    let mut probabilities = [0.0; 49];
    let mut left = 1.0;
    for p in &mut probabilities {
        *p = left / 8.0;
        left -= *p;
    }
    probabilities[48] += left;
    found.push(("gaps", view.into(), cells(&counts, &probabilities)));
}

/// Equal spacings of 2^12 birthdays in years of 2^32 days: Poisson with mean 4 a year.
fn birthdays(view: &str, words: &[u32], found: &mut Vec<Finding>) {
    let (mut equal, mut years) = (0, 0);
    for year in words.chunks_exact(1 << 12) {
        let mut days = year.to_vec();
        days.sort_unstable();
        let mut spacings: Vec<u32> = days.windows(2).map(|pair| pair[1] - pair[0]).collect();
        spacings.sort_unstable();
        equal += spacings
            .windows(2)
            .filter(|pair| pair[0] == pair[1])
            .count() as u64;
        years += 1;
    }
    let p = poisson(equal, 4.0 * f64::from(years));
    found.push(("birthdays", format!("{view}: {equal} in {years} years"), p));
}

/// Words that came before, in 2^32 urns: Poisson with mean n^2 / 2^33.
fn collisions(view: &str, words: &[u32], found: &mut Vec<Finding>) {
    let mut sorted = words.to_vec();
    sorted.sort_unstable();
    let equal = sorted.windows(2).filter(|pair| pair[0] == pair[1]).count() as u64;
    let n = words.len() as f64;
    let p = poisson(equal, n * (n - 1.0) / f64::powi(2.0, 33));
    found.push(("collisions", format!("{view}: {equal}"), p));
}

/// Ranks over {0, 1} of matrices of 32 words.
fn ranks<'a>(view: &str, matrices: impl Iterator<Item = &'a [u32]>, found: &mut Vec<Finding>) {
    let mut counts = [0; 4];
    for matrix in matrices {
        counts[(32 - rank(matrix)).min(3)] += 1;
    }
    // P(rank 32 - k) = 2^(-k^2) prod_{i > k} (1 - 2^-i) / prod_{i <= k} (1 - 2^-i), over
    // i up to 32.
    let mut probabilities = [0.0; 4];
    for (k, p) in probabilities.iter_mut().enumerate() {
        let factor = |i: usize| 1.0 - f64::powi(0.5, i as i32);
        let above: f64 = (k + 1..=32).map(factor).product();
        let below: f64 = (1..=k).map(factor).product();
        *p = f64::powi(0.5, (k * k) as i32) * above / below;
    }
    probabilities[3] = 1.0 - probabilities[..3].iter().sum::<f64>();
    found.push(("ranks", view.into(), cells(&counts, &probabilities)));
}

fn rank(matrix: &[u32]) -> usize {
    let mut rows = matrix.to_vec();
    let mut rank = 0;
    for bit in 0..32 {
        let Some(pivot) = (rank..rows.len()).find(|i| (rows[*i] >> bit) & 1 == 1) else {
            continue;
        };
        rows.swap(rank, pivot);
        for i in rank + 1..rows.len() {
            if (rows[i] >> bit) & 1 == 1 {
                rows[i] ^= rows[rank];
            }
        }
        rank += 1;
    }
    rank
}
