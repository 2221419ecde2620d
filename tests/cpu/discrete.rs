//! Discrete distributions: probabilities that are exact integers, counted over every u.

use corput::environment::{alias_table, cdf_table, quantise};
use corput::glam::{UVec2, uvec2};
use corput::reference::discrete::*;
use corput::reference::permute::permute_mix as mix;

const ALL: u64 = 1 << 32;

fn weight(w: UVec2) -> u64 {
    u64::from(w.x) | u64::from(w.y) << 32
}

/// Weights of every kind: one item, all equal, one hot, zeros at both ends and inside,
/// tiny beside huge, random.
fn families() -> Vec<Vec<u64>> {
    let mut list = vec![
        vec![1],
        vec![1 << 62],
        vec![0, 0, 7, 0],
        vec![7, 0, 0],
        vec![0, 0, 7],
        vec![1, 1],
        vec![1, 1 << 62],
        vec![1 << 62, 1],
        vec![3, 0, 0, 5, 0, 1, 0],
        vec![1; 3],
        vec![1; 1000],
        (1..=257).collect(),
    ];
    let mut hot = vec![1; 4096];
    hot[1234] = 1_000_000_000;
    list.push(hot);
    for count in [2u32, 5, 64, 100, 1021] {
        list.push((0..count).map(|i| u64::from(mix(i))).collect());
        list.push(
            (0..count)
                .map(|i| u64::from(mix(i)) >> (mix(!i) % 40))
                .chain([1])
                .collect(),
        );
    }
    list
}

/// All u where something can change: the ends of every item and bin, and random ones.
fn probes(ends: impl Iterator<Item = u64>) -> Vec<u32> {
    let around = ends.flat_map(|end| [end.wrapping_sub(1), end, end + 1].map(|u| u as u32));
    around
        .chain([0, 1, u32::MAX - 1, u32::MAX])
        .chain((0..2000).map(mix))
        .collect()
}

#[test]
fn shares_sum_to_2_32_and_keep_what_is_possible() {
    for weights in families() {
        let total: u128 = weights.iter().map(|&w| u128::from(w)).sum();
        let shares = quantise(&weights).unwrap();
        assert_eq!(shares.iter().sum::<u64>(), ALL);
        let positive = weights.iter().filter(|&&w| w > 0).count() as f64;
        for (&w, &share) in weights.iter().zip(&shares) {
            assert_eq!(w > 0, share > 0);
            let exact = w as f64 / total as f64 * (ALL as f64 - positive);
            assert!((share as f64 - exact).abs() <= 2.0, "{w}: {share}, {exact}");
        }
    }
    assert_eq!(quantise(&[0, 0]).unwrap(), [0, 0]);
    let most = (1 << 63) - 1;
    assert_eq!(quantise(&[most, 0]).unwrap(), [1 << 32, 0]);
    for (error, words) in [
        (quantise(&[most, 1]).err(), "sum to less than 2^63"),
        (quantise(&[u64::MAX; 3]).err(), "scale them"),
        (cdf_table(&[u64::MAX]).err(), "sum to less than 2^63"),
        (cdf_table(&[]).err(), "no weights"),
        (alias_table(&[]).err(), "none of which is positive"),
        (alias_table(&[0, 0]).err(), "none of which is positive"),
    ] {
        let text = error.expect(words).to_string();
        assert!(text.contains(words), "{text}");
    }
}

#[test]
fn division_is_exact() {
    let words: Vec<u32> = (0..32)
        .flat_map(|bit| [-1i64, 0, 1].map(|o| ((1i64 << bit) + o) as u32))
        .chain((0..200).map(mix))
        .chain([0, u32::MAX, 0x8000_0000, 0xffff_0000, 0x8000_ffff])
        .collect();
    for &d in words.iter().filter(|&&d| d > 0) {
        for &high in &words {
            for &low in words.iter().step_by(3) {
                let high = high % d;
                let n = u64::from(high) << 32 | u64::from(low);
                let got = discrete_divide(uvec2(low, high), d);
                assert_eq!(u64::from(got), n / u64::from(d), "{n} / {d}");
            }
        }
        for &part in &words {
            let part = part % d;
            assert_eq!(
                discrete_part(discrete_rest(part, d), d),
                part,
                "{part} of {d}"
            );
        }
    }
    assert_eq!(discrete_rest(77, 0), 77);
    assert_eq!(discrete_part(77, 0), 77);
    // No division by zero, whatever the table.
    assert_eq!(discrete_divide(uvec2(5, 0), 0), 5);
}

/// Faults of a search of the CDF at each u: the item must hold u, and give it back.
fn cdf_faults(weights: &[u64], search: impl Fn(&[u32], u32) -> u32) -> usize {
    let shares = quantise(weights).unwrap();
    let words = cdf_table(weights).unwrap();
    let mut ends = vec![0u64];
    for share in &shares {
        ends.push(ends[ends.len() - 1] + share);
    }
    let mut faults = 0;
    for u in probes(ends.iter().copied()) {
        let index = search(&words, u) as usize;
        let held = (ends[index]..ends[index + 1]).contains(&u64::from(u));
        faults += usize::from(!held);
    }
    faults
}

#[test]
fn the_cdf_draws_each_item_for_its_weight() {
    for weights in families() {
        assert_eq!(cdf_faults(&weights, |words, u| cdf(0, u, words).index), 0);
        let shares = quantise(&weights).unwrap();
        let words = cdf_table(&weights).unwrap();
        for (index, &share) in (0..).zip(&shares) {
            assert_eq!(weight(cdf_weight(0, index, &words)), share);
        }
        for u in (0..1000).map(mix).chain([0, u32::MAX]) {
            let choice = cdf(0, u, &words);
            assert_eq!(weight(choice.weight), shares[choice.index as usize]);
            assert_eq!(cdf_invert(0, choice.index, choice.rest, &words), u);
        }
    }
}

#[test]
fn broken_searches_are_caught() {
    // <= in place of <: an item's end goes to it, also where it has no weight.
    let loose = |words: &[u32], u: u32| {
        let (mut low, mut high) = (0, words[0].max(1) - 1);
        while low < high {
            let middle = (low + high + 1) >> 1;
            if u <= words[middle as usize] {
                high = middle - 1;
            } else {
                low = middle;
            }
        }
        low
    };
    // The count of all items in place of those up to the last with a weight.
    let tail =
        |words: &[u32], u: u32| (1..words.len()).rev().find(|&i| words[i] <= u).unwrap_or(0) as u32;
    assert!(cdf_faults(&[3, 0, 0, 5, 0, 1, 0], loose) > 0);
    assert!(cdf_faults(&[7, 0, 0], tail) > 0);
}

/// How many u draw each item by an alias table, from its words alone: every bin by its
/// exact size, none by sampling.
fn alias_counts(words: &[u32]) -> Vec<u64> {
    let count = words.len() as u64 / 3;
    let mut counts = vec![0u64; count as usize];
    for bin in 0..count {
        let [end, other, _] = [0, 1, 2].map(|i| words[3 * bin as usize + i]);
        let first = (bin << 32).div_ceil(count);
        let size = ((bin + 1) << 32).div_ceil(count) - first;
        // u - first < own exactly where u * count mod 2^32 < end.
        let lowest = first * count - (bin << 32);
        let own = u64::from(end)
            .saturating_sub(lowest)
            .div_ceil(count)
            .min(size);
        counts[bin as usize] += own;
        counts[other as usize] += size - own;
    }
    counts
}

#[test]
fn the_alias_table_draws_each_item_for_its_weight() {
    for weights in families() {
        let shares = quantise(&weights).unwrap();
        let words = alias_table(&weights).unwrap();
        let count = weights.len() as u32;
        assert_eq!(alias_counts(&words), shares);
        for (index, &share) in (0..).zip(&shares) {
            assert_eq!(weight(alias_weight(0, index, &words)), share);
        }
        // An entry that is off by one item is caught.
        if weights.len() > 3 {
            let broken: Vec<u32> = words
                .iter()
                .enumerate()
                .map(|(i, &w)| if i % 3 == 1 { (w + 1) % count } else { w })
                .collect();
            assert_ne!(alias_counts(&broken), shares);
        }
        let bins = (0..u64::from(count)).map(|bin| (bin << 32).div_ceil(u64::from(count)));
        for u in probes(bins) {
            let bin = (u64::from(u) * u64::from(count)) >> 32;
            let index = alias_index(0, count, u, &words);
            assert!(shares[index as usize] > 0);
            assert!(u64::from(index) == bin || index == words[3 * bin as usize + 1]);
        }
    }
}

#[test]
fn bins_of_unequal_size_are_filled_exactly() {
    // Weights next to the size of a bin, and none: where a bin that is larger by one takes
    // what another has too much by one.
    for seed in 0..4000u32 {
        let count = 3 + mix(seed) % 13;
        let bin = ALL / u64::from(count);
        let mut left = ALL;
        let mut shares = Vec::new();
        for i in 0..count {
            let share = match mix(seed ^ i << 16) % 4 {
                0 => 0,
                k => (bin + u64::from(k) - 2).min(left),
            };
            left -= share;
            shares.push(share);
        }
        shares[0] += left;
        // Every positive weight gets 1, and the rest in proportion: these are the shares.
        let weights: Vec<u64> = shares.iter().map(|s| s.saturating_sub(1)).collect();
        assert_eq!(quantise(&weights).unwrap(), shares);
        assert_eq!(
            alias_counts(&alias_table(&weights).unwrap()),
            quantise(&weights).unwrap()
        );
    }
}

#[test]
fn a_stride_through_every_u_agrees() {
    for count in [3u64, 7, 12, 255] {
        let weights: Vec<u64> = (0..count).map(|i| u64::from(mix(i as u32) >> 20)).collect();
        let words = alias_table(&weights).unwrap();
        let step = 251;
        let mut counts = vec![0u64; count as usize];
        for u in (0..ALL).step_by(step) {
            counts[alias_index(0, count as u32, u as u32, &words) as usize] += 1;
        }
        for (found, share) in counts.iter().zip(quantise(&weights).unwrap()) {
            let expected = share as f64 / step as f64;
            // Each end of each part is off by at most one u.
            assert!((*found as f64 - expected).abs() <= 2.0 * count as f64);
        }
    }
}

/// The distance of Kolmogorov and Smirnov of fractions from the uniform distribution.
fn distance(mut fractions: Vec<f64>) -> f64 {
    fractions.sort_by(f64::total_cmp);
    let count = fractions.len() as f64;
    (0..)
        .zip(&fractions)
        .map(|(i, &x)| (x - f64::from(i) / count).max(f64::from(i + 1) / count - x))
        .fold(0.0, f64::max)
}

#[test]
fn the_rest_of_an_alias_bin_is_uniform_for_a_million_bins() {
    // Row 38 of the catalogue: 2^20 bins, where a float remainder keeps 4 bits.
    let count = 1u32 << 20;
    let weights: Vec<u64> = (0..count).map(|i| u64::from(mix(i) >> 12)).collect();
    let words = alias_table(&weights).unwrap();
    let samples = 1u32 << 18;
    let of = |rest: &dyn Fn(u32) -> f64| distance((0..samples).map(rest).collect());
    let ours = of(&|i| {
        let u = uvec2(mix(2 * i), mix(2 * i + 1));
        f64::from(alias_rest(0, count, u, &words)) / ALL as f64
    });
    let float = of(&|i| {
        // The common formula: the rest of a float product, scaled by the bin's own part.
        let scaled = (mix(2 * i) >> 8) as f32 / 16_777_216.0 * count as f32;
        let bin = scaled as usize;
        let up = scaled - bin as f32;
        let q = words[3 * bin] as f32 / ALL as f32;
        f64::from(if words[3 * bin + 1] == bin as u32 {
            up
        } else if up < q {
            up / q
        } else {
            (up - q) / (1.0 - q)
        })
    });
    // 1% of uniform sets of this size are farther off than 1.63 / sqrt(n).
    let critical = 1.63 / f64::from(samples).sqrt();
    println!("2^20 bins: rest off by {ours:.5}, by floats {float:.5}, critical {critical:.5}");
    assert!(ours < critical);
    assert!(float > critical);
}

#[test]
fn reservoirs_keep_an_item_in_proportion_to_its_weight() {
    let weights = [5u32, 0, 1, 1000, 0, 77, u32::MAX, 1 << 31, 3, 0];
    let total: f64 = weights.iter().map(|&w| f64::from(w)).sum();
    let runs = 1u32 << 18;
    let run = |k: u32, strict: bool| {
        let mut r = reservoir();
        for (i, &w) in (0..).zip(&weights) {
            let u = mix(k.wrapping_mul(16).wrapping_add(i)) ^ mix(k ^ 0x55);
            let next = reservoir_add(r, i, w, u);
            // The broken variant replaces also on a tie, which weight 0 has at u = 0.
            r = if !strict && w == 0 && u < 1 << 12 {
                Reservoir {
                    index: i,
                    weight: w,
                    total: next.total,
                }
            } else {
                next
            };
        }
        r
    };
    let mut counts = [0u32; 10];
    for k in 0..runs {
        let r = run(k, true);
        assert!(r.weight > 0 && r.weight == weights[r.index as usize]);
        assert_eq!(weight(r.total) as f64, total);
        let pdf = f64::from(r.weight) / total;
        assert!((f64::from(reservoir_pdf(r)) - pdf).abs() <= pdf * 6e-8);
        counts[r.index as usize] += 1;
    }
    for (&count, &w) in counts.iter().zip(&weights) {
        let p = f64::from(w) / total;
        let n = f64::from(runs);
        let spread = (n * p * (1.0 - p)).sqrt();
        assert!(
            (f64::from(count) - n * p).abs() <= 4.5 * spread.max(1.0),
            "{counts:?}"
        );
    }
    assert!((0..runs).any(|k| run(k, false).weight == 0));
    assert_eq!(reservoir_pdf(reservoir()), 0.0);
}

#[test]
fn reservoirs_merge_as_one_stream() {
    let stream = |from: u32, salt: u32| {
        (from..from + 8).fold(reservoir(), |r, i| {
            reservoir_add(r, i, 1 + i, mix(salt ^ mix(i)))
        })
    };
    let mut counts = [0u32; 16];
    let runs = 1u32 << 17;
    for k in 0..runs {
        let r = reservoir_merge(
            stream(0, mix(3 * k)),
            stream(8, mix(3 * k + 1)),
            mix(3 * k + 2),
        );
        assert_eq!(weight(r.total), 136);
        counts[r.index as usize] += 1;
    }
    let chi_square: f64 = (1u32..)
        .zip(&counts)
        .map(|(w, &count)| {
            let expected = f64::from(runs) * f64::from(w) / 136.0;
            (f64::from(count) - expected).powi(2) / expected
        })
        .sum();
    // The 0.999 quantile of 15 degrees of freedom.
    assert!(chi_square < 37.7, "{chi_square}: {counts:?}");
    // Nothing merged with something is that, and nothing with nothing is nothing.
    let some = stream(0, 1);
    assert_eq!(reservoir_merge(reservoir(), some, u32::MAX), some);
    assert_eq!(reservoir_merge(some, reservoir(), 0), some);
    assert_eq!(reservoir_merge(reservoir(), reservoir(), 0), reservoir());
}
