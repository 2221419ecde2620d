//! Grids of a given number of cells.

use super::is_prime;

/// d factors whose product is n and whose ratio of largest to smallest is least; of several
/// such sets the one with the least sum. Largest first. A prime n gives n and ones.
///
/// Domain: n >= 1 and d >= 1; n = 0 gives zeros, d = 0 an empty list. Factors are found by
/// trial division: quick for n <= 2^40.
#[must_use]
pub fn nearly_equal_factors(n: u64, d: usize) -> Vec<u64> {
    if n == 0 || d == 0 {
        return vec![0; d];
    }
    let primes = prime_factors(n);
    let mut best = if d >= primes.len() {
        // Fewer primes than factors: none can be joined.
        let ones = std::iter::repeat_n(1, d - primes.len());
        ones.chain(primes).collect()
    } else {
        let mut search = Search {
            divisors: divisors(&primes),
            chosen: Vec::new(),
            best: None,
        };
        search.extend(n, d);
        search.best.unwrap_or_default()
    };
    best.reverse();
    best
}

/// The numbers next to a prime n >= 5 that are products of two factors of at least 2, as
/// multi-jittered sets of more than 4 points want; `None` for any other n, which will do.
#[must_use]
pub fn composite_neighbours(n: u64) -> Option<[u64; 2]> {
    // Next to an odd prime lie even numbers.
    (n >= 5 && is_prime(n)).then(|| [n - 1, n.saturating_add(1)])
}

/// The prime factors, least first, each as often as it divides.
fn prime_factors(mut n: u64) -> Vec<u64> {
    let mut list = Vec::new();
    let mut p = 2;
    while p <= n / p {
        while n.is_multiple_of(p) {
            list.push(p);
            n /= p;
        }
        p += 1;
    }
    if n > 1 {
        list.push(n);
    }
    list
}

/// All divisors of the product of primes, in order.
fn divisors(primes: &[u64]) -> Vec<u64> {
    let mut list = vec![1];
    for prime in primes {
        let more: Vec<u64> = list.iter().map(|divisor| divisor * prime).collect();
        list.extend(more);
        list.sort_unstable();
        list.dedup();
    }
    list
}

/// Factors in rising order, branch and bound.
struct Search {
    divisors: Vec<u64>,
    chosen: Vec<u64>,
    best: Option<Vec<u64>>,
}

impl Search {
    /// Chooses `left` more factors whose product is `rest`.
    fn extend(&mut self, rest: u64, left: usize) {
        if left == 1 {
            self.chosen.push(rest);
            if self.better() {
                self.best = Some(self.chosen.clone());
            }
            self.chosen.pop();
            return;
        }
        let least = self.chosen.last().copied().unwrap_or(1);
        let end = self
            .divisors
            .partition_point(|&f| power(f, left) <= u128::from(rest));
        let begin = self.divisors.partition_point(|&f| f < least);
        // From the root down: the first find is near the best, and bounds the others.
        for i in (begin..end.max(begin)).rev() {
            let factor = self.divisors[i];
            if !rest.is_multiple_of(factor) {
                continue;
            }
            let first = self.chosen.first().copied().unwrap_or(factor);
            if power(self.limit(first), left - 1) >= u128::from(rest / factor) {
                self.chosen.push(factor);
                self.extend(rest / factor, left - 1);
                self.chosen.pop();
            }
        }
    }

    /// The most that a factor may be where the smallest is `first`.
    fn limit(&self, first: u64) -> u64 {
        match self.best.as_deref() {
            Some([small, .., large]) => {
                let limit = u128::from(*large) * u128::from(first) / u128::from(*small);
                u64::try_from(limit).unwrap_or(u64::MAX)
            }
            _ => u64::MAX,
        }
    }

    /// Whether the chosen factors beat the best so far.
    fn better(&self) -> bool {
        let (Some([small, .., large]), [first, .., last]) =
            (self.best.as_deref(), &self.chosen[..])
        else {
            return self.best.is_none();
        };
        let old = u128::from(*large) * u128::from(*first);
        let new = u128::from(*last) * u128::from(*small);
        let sum = |list: &[u64]| list.iter().map(|&f| u128::from(f)).sum::<u128>();
        let best = self.best.as_deref().unwrap_or_default();
        new < old || (new == old && sum(&self.chosen) < sum(best))
    }
}

/// factor^count, or the largest u128.
fn power(factor: u64, count: usize) -> u128 {
    let wide = u128::from(factor);
    (0..count).fold(1u128, |power, _| power.saturating_mul(wide))
}
