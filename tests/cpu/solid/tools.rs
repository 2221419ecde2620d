//! What the tests of the distributions share.

use corput::glam::{UVec2, Vec3, uvec2, vec3};
use corput::judge::ulp_error;
use corput::reference::permute::permute_mix as mix;

/// A fraction of 2^32 as a number.
pub fn unit(u: u32) -> f64 {
    f64::from(u) / 4_294_967_296.0
}

/// Fractions at the ends and in the middle, and others between them.
pub fn fractions() -> Vec<u32> {
    let ends = (0..32).flat_map(|k| [1u32 << k, (1u32 << k) - 1, 0u32.wrapping_sub(1 << k)]);
    let mut list: Vec<u32> = ends.chain((0..40).map(mix)).collect();
    list.sort_unstable();
    list.dedup();
    list
}

/// Pairs of [`fractions`].
pub fn grid() -> Vec<UVec2> {
    let list = fractions();
    let pairs = list
        .iter()
        .flat_map(|&x| list.iter().map(move |&y| uvec2(x, y)));
    pairs.collect()
}

/// Random pairs of fractions.
pub fn random(count: u32) -> impl Iterator<Item = UVec2> {
    (0..count).map(|i| uvec2(mix(2 * i), mix(2 * i + 1)))
}

/// The distance of two fractions of a turn.
pub fn turn_distance(a: u32, b: u32) -> f64 {
    unit(a.wrapping_sub(b).min(b.wrapping_sub(a)))
}

/// The truth of one extreme case.
#[derive(Debug)]
pub struct Truth {
    pub map: String,
    pub parameters: Vec<f64>,
    pub u: UVec2,
    pub quantity: String,
    pub value: f64,
}

/// The committed truth of one map.
pub fn truth(map: &str) -> Vec<Truth> {
    let text = include_str!("../../../assets/truth/solid_truth.csv");
    let numbers = |list: &str| -> Vec<f64> {
        let words = list.split_whitespace();
        words.map(|word| word.parse().expect("a number")).collect()
    };
    let lines = text.lines().map(|line| {
        let fields: Vec<&str> = line.split(',').collect();
        let u = numbers(fields[3]);
        Truth {
            map: fields[1].to_owned(),
            parameters: numbers(fields[2]),
            u: uvec2(u[0] as u32, u[1] as u32),
            quantity: fields[4].to_owned(),
            value: fields[5].parse().expect("a value"),
        }
    });
    let found: Vec<Truth> = lines.filter(|truth| truth.map == map).collect();
    assert!(!found.is_empty(), "no truth of {map}");
    found
}

/// The error of a result relative to the truth; infinite for an infinity or NaN.
pub fn relative(got: f64, truth: f64) -> f64 {
    let error = (got - truth).abs() / truth.abs();
    if error.is_nan() { f64::INFINITY } else { error }
}

/// The coordinates as `f64`.
pub fn doubles(v: Vec3) -> [f64; 3] {
    v.to_array().map(f64::from)
}

/// What a coordinate errs beyond 0.6 ULP, relative to the longest side.
pub fn excess(got: Vec3, truth: [f64; 3], size: f64) -> f64 {
    let beyond = |(got, truth): (f32, f64)| {
        let ulps = ulp_error(got, truth);
        let error = (f64::from(got) - truth).abs();
        if error == 0.0 {
            return 0.0;
        }
        error * (1.0 - 0.6 / ulps).max(0.0) / size
    };
    let all = got.to_array().into_iter().zip(truth).map(beyond);
    all.fold(0.0, f64::max)
}

/// The integral of the solid angle over the plane triangle, halved until it stands still:
/// cos / r^2 dA = volume / |p|^3.
pub fn integrated(corners: [[f64; 3]; 3], depth: u32) -> f64 {
    let middle = |a: [f64; 3], b: [f64; 3]| [0, 1, 2].map(|i| 0.5 * (a[i] + b[i]));
    let [a, b, c] = corners;
    let inner = [middle(a, b), middle(b, c), middle(c, a)];
    let [x, y, z] = inner;
    let centre = [0, 1, 2].map(|i| (a[i] + b[i] + c[i]) / 3.0);
    let cross = |v: [f64; 3], w: [f64; 3]| {
        [0, 1, 2].map(|i| v[(i + 1) % 3] * w[(i + 2) % 3] - v[(i + 2) % 3] * w[(i + 1) % 3])
    };
    let dot = |v: [f64; 3], w: [f64; 3]| v[0] * w[0] + v[1] * w[1] + v[2] * w[2];
    let less = |v: [f64; 3], w: [f64; 3]| [v[0] - w[0], v[1] - w[1], v[2] - w[2]];
    let volume = 0.5 * dot(a, cross(less(b, a), less(c, a))).abs();
    let density = |p: [f64; 3]| dot(p, p).powf(-1.5);
    let corner = (density(a) + density(b) + density(c)) / 3.0;
    let edge = (density(x) + density(y) + density(z)) / 3.0;
    // The rule of degree 3 where that of the corners is near it, not by chance at the first.
    if depth == 0 || (depth < 36 && (corner / edge - 1.0).abs() < 2e-4) {
        return volume * (3.0 * corner + 8.0 * edge + 9.0 * density(centre)) / 20.0;
    }
    [[a, x, z], [x, b, y], [z, y, c], [x, y, z]]
        .into_iter()
        .map(|part| integrated(part, depth - 1))
        .sum()
}

/// Three vectors, from their coordinates.
pub fn vectors(p: [f32; 9]) -> [Vec3; 3] {
    [
        vec3(p[0], p[1], p[2]),
        vec3(p[3], p[4], p[5]),
        vec3(p[6], p[7], p[8]),
    ]
}
