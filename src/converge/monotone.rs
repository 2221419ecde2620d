//! The rising sequence nearest to measured times: more points do not take less.

/// The least-squares fit that never falls, of equal weights: pool adjacent violators (Ayer,
/// Brunk, Ewing, Reid and Silverman 1955).
pub fn rising(values: &[f64]) -> Vec<f64> {
    // Means of the pools so far, and how many values each has.
    let mut pools: Vec<(f64, usize)> = Vec::new();
    for &value in values {
        let mut pool = (value, 1);
        while let Some(&(mean, count)) = pools.last().filter(|last| last.0 > pool.0) {
            let both = count + pool.1;
            pool = (
                (mean * count as f64 + pool.0 * pool.1 as f64) / both as f64,
                both,
            );
            pools.pop();
        }
        pools.push(pool);
    }
    let repeat = |(mean, count)| std::iter::repeat_n(mean, count);
    pools.into_iter().flat_map(repeat).collect()
}

#[cfg(test)]
mod tests {
    use super::rising;

    #[test]
    fn violators_are_pooled() {
        assert_eq!(rising(&[1.0, 2.0, 4.0]), [1.0, 2.0, 4.0]);
        assert_eq!(rising(&[3.0, 1.0, 2.0, 5.0]), [2.0, 2.0, 2.0, 5.0]);
        assert_eq!(
            rising(&[1.0, 4.0, 2.0, 3.0, 3.0]),
            [1.0, 3.0, 3.0, 3.0, 3.0]
        );
        assert!(rising(&[]).is_empty());
    }
}
