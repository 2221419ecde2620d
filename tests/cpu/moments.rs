//! Mean, variance and correlations of every randomisation over 1,024 seeds, against what
//! theory gives. The scrambles of nets have theirs in owen.rs.

mod significance;

use corput::bulk::Reference;
use corput::catalog::{Engine, Options, Request, Scramble, Sequence};
use significance::critical;

const SEEDS: u64 = 1024;

/// Points of each randomisation that are looked at: the first ones.
const POINTS: usize = 8;

/// What is expected of the pair of points (i, j) in one dimension: the correlation of its
/// coordinates, from their plain values, or that it is not derived here.
type Pair = fn(usize, usize, usize) -> Option<f64>;

/// A randomisation: its name, options, and the theory of its points.
struct Row {
    name: String,
    options: Options,
    /// Strata along each axis whose cell a point keeps, and how many points share a step.
    cells: Option<[u64; 2]>,
    pair: Pair,
}

/// Coordinates by seed, point and dimension, in [-1/2, 1/2).
fn samples(options: &Options) -> Vec<Vec<Vec<f64>>> {
    (0..SEEDS)
        .map(|seed| {
            let request = Request::new(&Options {
                seed: Some(seed),
                fractions: true,
                ..options.clone()
            })
            .expect("a request");
            let width = request.words_per_point() as usize;
            let mut words = vec![0; POINTS * width];
            Reference::new(&request).fill(0, &mut words).unwrap();
            let centred = |word: &u32| (f64::from(*word) + 0.5) / 4_294_967_296.0 - 0.5;
            let rows = words.chunks(width);
            rows.map(|row| row.iter().map(centred).collect()).collect()
        })
        .collect()
}

/// How many standard errors the mean of values lies from what is expected of it.
fn away(values: &[f64], expected: f64) -> f64 {
    let n = values.len() as f64;
    let mean = values.iter().sum::<f64>() / n;
    let square = values.iter().map(|v| (v - mean).powi(2)).sum::<f64>() / (n - 1.0);
    // Values that are all what is expected have no error.
    (mean - expected).abs() / (square / n).sqrt().max(1e-7)
}

/// The tests of a randomisation: what, and standard errors.
fn tests(row: &Row) -> Vec<(String, f64)> {
    let all = samples(&row.options);
    let width = all[0][0].len();
    let mut found = Vec::new();
    let over = |value: &dyn Fn(&Vec<Vec<f64>>) -> f64| all.iter().map(value).collect::<Vec<_>>();
    for i in 0..POINTS {
        for d in 0..width {
            // A point of a grid stays in its cell.
            let (mean, variance) = match row.cells {
                None => (0.0, 1.0 / 12.0),
                Some(grid) => {
                    let strata = grid[d] as f64;
                    let cell = (i as u64 / if d == 0 { 1 } else { grid[0] }) % grid[d];
                    (
                        (cell as f64 + 0.5) / strata - 0.5,
                        1.0 / (12.0 * strata * strata),
                    )
                }
            };
            found.push((format!("mean {i} {d}"), away(&over(&|s| s[i][d]), mean)));
            let squares = over(&|s| (s[i][d] - mean).powi(2));
            found.push((format!("variance {i} {d}"), away(&squares, variance)));
            for e in 0..d {
                let centre = |e: usize| match row.cells {
                    None => 0.0,
                    Some(grid) => {
                        let cell = (i as u64 / if e == 0 { 1 } else { grid[0] }) % grid[e];
                        (cell as f64 + 0.5) / grid[e] as f64 - 0.5
                    }
                };
                let (a, b) = (centre(d), centre(e));
                let products = over(&|s| 12.0 * (s[i][d] - a) * (s[i][e] - b));
                found.push((format!("dimensions {i} {e} {d}"), away(&products, 0.0)));
            }
            for j in 0..i {
                if row.cells.is_none()
                    && let Some(correlation) = (row.pair)(j, i, d)
                {
                    let products = over(&|s| 12.0 * s[i][d] * s[j][d]);
                    found.push((format!("points {j} {i} {d}"), away(&products, correlation)));
                }
            }
        }
    }
    found
}

fn independent(_: usize, _: usize, _: usize) -> Option<f64> {
    Some(0.0)
}

fn underived(_: usize, _: usize, _: usize) -> Option<f64> {
    None
}

/// Points of a permuted set of 64: no two share a stratum.
fn one_per_stratum(_: usize, _: usize, _: usize) -> Option<f64> {
    let n = 64.0;
    Some(-(n + 1.0) / (n * n))
}

const BASES: [usize; 3] = [2, 3, 5];

/// The sum over places of b^-2k (b^2 - 1) times the correlation of the digits there.
fn digits(i: usize, j: usize, base: usize, nested: bool) -> f64 {
    let b = base as f64;
    let (mut i, mut j, mut apart, mut sum) = (i, j, false, 0.0);
    for k in 1..60 {
        let equal = i % base == j % base;
        let correlation = match (equal, nested && apart) {
            (_, true) => 0.0,
            (true, false) => 1.0,
            (false, false) => -1.0 / (b - 1.0),
        };
        sum += b.powi(-2 * k) * (b * b - 1.0) * correlation;
        apart |= !equal;
        (i, j) = (i / base, j / base);
    }
    sum
}

fn permuted_digits(i: usize, j: usize, d: usize) -> Option<f64> {
    Some(digits(i, j, BASES[d], false))
}

fn nested_digits(i: usize, j: usize, d: usize) -> Option<f64> {
    Some(digits(i, j, BASES[d], true))
}

/// Of x and x + delta on the circle.
fn rotated(plain: &Options, i: usize, j: usize, d: usize) -> f64 {
    let request = Request::new(&Options {
        scramble: Some(Scramble::None),
        fractions: true,
        ..plain.clone()
    })
    .expect("a request");
    let width = request.words_per_point() as usize;
    let mut words = vec![0; POINTS * width];
    Reference::new(&request).fill(0, &mut words).unwrap();
    let step = words[j * width + d].wrapping_sub(words[i * width + d]);
    let delta = f64::from(step) / 4_294_967_296.0;
    1.0 - 6.0 * delta * (1.0 - delta)
}

fn lattice_options() -> Options {
    Options::new(Sequence::Lattice, 64)
}

fn korobov_options() -> Options {
    Options::new(Sequence::Korobov, 1021)
}

fn r2_options() -> Options {
    Options::new(Sequence::R2, 64)
}

/// Of two indices that first differ, from the top, in bit k, the shuffle leaves that bit
/// different and the k below it independent: digit k of x is the first that surely differs.
fn shuffled(i: usize, j: usize, d: usize) -> Option<f64> {
    let k = (i ^ j).ilog2() as i32;
    (d == 0).then(|| -3.0 * 2f64.powi(-k) * 4f64.powi(-k - 1))
}

fn rows() -> Vec<Row> {
    let row = |name: &str, options: Options, pair: Pair| Row {
        name: name.to_owned(),
        options,
        cells: None,
        pair,
    };
    let set = |sequence| Options::new(sequence, 64);
    let halton = |scramble| Options {
        scramble: Some(scramble),
        dimensions: Some(3),
        ..Options::new(Sequence::Halton, 64)
    };
    let rotate = |options: Options| Options {
        scramble: Some(Scramble::Rotate),
        ..options
    };
    let mut rows = vec![
        row("random", set(Sequence::Random), independent),
        row("random-fast", set(Sequence::RandomFast), independent),
        row(
            "latin-hypercube",
            set(Sequence::LatinHypercube),
            one_per_stratum,
        ),
        row("cmj", set(Sequence::MultiJittered), one_per_stratum),
        row("pmj02", set(Sequence::Pmj02), shuffled),
        row("halton permute", halton(Scramble::Permute), permuted_digits),
        row("halton owen", halton(Scramble::Owen), nested_digits),
        row("halton start", halton(Scramble::Start), underived),
        row("lattice", rotate(lattice_options()), |i, j, d| {
            Some(rotated(&lattice_options(), i, j, d))
        }),
        row("korobov", rotate(korobov_options()), |i, j, d| {
            Some(rotated(&korobov_options(), i, j, d))
        }),
        row("r2", rotate(r2_options()), |i, j, d| {
            Some(rotated(&r2_options(), i, j, d))
        }),
    ];
    rows.push(Row {
        cells: Some([8, 8]),
        ..row("stratified", set(Sequence::Stratified), independent)
    });
    rows
}

/// The worst test of a randomisation, and how many there are.
fn worst(row: &Row) -> (String, f64, usize) {
    let tests = tests(row);
    let count = tests.len();
    let (what, away) = tests
        .into_iter()
        .max_by(|a, b| a.1.total_cmp(&b.1))
        .expect("tests");
    (what, away, count)
}

#[test]
fn randomisations_have_the_moments_of_theory() {
    let found: Vec<_> = rows()
        .iter()
        .map(|row| (row.name.clone(), worst(row)))
        .collect();
    let count = found.iter().map(|(_, (_, _, count))| count).sum();
    let limit = critical(count);
    for (name, (what, away, count)) in &found {
        println!("{name}: {away:.2} of {limit:.2} at {what}, {count} tests");
    }
    for (name, (what, away, _)) in found {
        assert!(away < limit, "{name}, {what}: {away:.2} of {limit:.2}");
    }
}

/// Theory of another randomisation is refused, and so is one seed for all dimensions.
#[test]
fn wrong_moments_are_refused() {
    let all = rows();
    let find = |name: &str| all.iter().find(|row| row.name == name).expect(name);
    let limit = critical(4096);
    for (name, pair) in [
        ("halton owen", permuted_digits as Pair),
        ("halton permute", nested_digits),
        ("random", one_of_four_per_stratum),
        ("cmj", nested_digits),
        ("pmj02", independent),
        ("r2", independent),
    ] {
        let row = find(name);
        let wrong = Row {
            name: name.to_owned(),
            options: row.options.clone(),
            cells: row.cells,
            pair,
        };
        let (what, away, _) = worst(&wrong);
        assert!(
            away > limit,
            "{name} passes: {away:.2} of {limit:.2} at {what}"
        );
    }
    // Jitter without a grid.
    let wrong = Row {
        name: "random".to_owned(),
        options: find("random").options.clone(),
        cells: Some([8, 8]),
        pair: independent,
    };
    assert!(worst(&wrong).1 > limit);
}

/// Points of a permuted set of four.
fn one_of_four_per_stratum(_: usize, _: usize, _: usize) -> Option<f64> {
    Some(-5.0 / 16.0)
}
