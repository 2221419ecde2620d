//! what: the irradiance of an equirectangular map, as a truth to judge estimators by
//! source: Lambert's cosine law over one texel, in closed form (below)
//! domain → range: a map of W x H texels and a unit normal → E = sum of L * integral of max(0, n.w) dw
//! cost: two `atan2` per column, one multiply-add per texel and channel; pure f64
//!
//! Map convention: column c covers the azimuths 2 pi c/W to 2 pi (c+1)/W, row r
//! the polar angles pi r/H to pi (r+1)/H from +z, and the direction is
//! (sin t cos p, sin t sin p, cos t). A texel is constant (nearest texel).
//!
//! With q = p - azimuth(n) and n = (r, 0, n_z) in that frame,
//! n.w = r sin t cos q + n_z cos t, and a texel falls into one of three kinds.
//!
//! - **Lit**, wholly above the horizon: the integral separates,
//!   (n_x C + n_y S) A + n_z B P, with A = int sin^2 t, B = int sin t cos t, C = int cos p,
//!   S = int sin p, P = int 1. Every factor is written as a product of the mean angle and
//!   the half width, so no two near-equal numbers are subtracted.
//! - **Dark**, wholly below: zero.
//! - **Cut** by the horizon. On the meridian q the horizon is crossed once, at
//!   t*(q) = atan2(n_z, -r cos q) for n_z >= 0 (n_z < 0 is the mirror image), and
//!   n.w = R sin(t* - t) with R = hypot(r cos q, n_z), so the integral over t is closed:
//!   G(q) = R/2 (cos t0 (sin d - d cos d) + d sin t0 sin d), d = t* - t0.
//!   The q at which the horizon enters or leaves the texel are arc cosines; between them
//!   lie pieces that are lit, dark, or where G is analytic. Those are bisected until a piece
//!   is at most twice as wide as its distance to the nearest singularity of G,
//!   q = ±pi/2 ± i asinh(n_z/r), where a Gauss rule of 20 nodes errs by some
//!   (1 + sqrt 2)^-40 = 5e-16 of the piece (the Bernstein ellipse of that distance).
//!
//! So a texel's weight is right to about 1e-14 of itself, and the sum, carried in
//! two words, adds nothing to that; tests hold the whole to 1e-12.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// Irradiance of a map on a surface with the given unit normal.
///
/// `texels` holds `width * height` radiances, row 0 (at +z) first. For a normal of
/// another length the result scales with it; radiances are taken as they are, and a
/// texel that is not finite spoils the sum only if it is above the horizon.
///
/// # Panics
///
/// If `texels.len()` is not `width * height`.
///
/// ```
/// let white = [[1.0_f32; 3]; 8];
/// let e = corput::irradiance::irradiance(4, 2, &white, [0.6, 0.0, 0.8]);
/// assert!((e[0] - std::f64::consts::PI).abs() < 1e-13);
/// ```
#[must_use]
pub fn irradiance(width: u32, height: u32, texels: &[[f32; 3]], normal: [f64; 3]) -> [f64; 3] {
    assert!(
        texels.len() as u64 == u64::from(width) * u64::from(height),
        "a map of {width} x {height} has {} texels, not {}",
        u64::from(width) * u64::from(height),
        texels.len()
    );
    if texels.is_empty() {
        return [0.0; 3];
    }
    if !normal.iter().all(|n| n.is_finite()) {
        return [f64::NAN; 3];
    }
    let horizon = Horizon::new(normal);
    let columns: Vec<Column> = (0..width)
        .map(|c| Column::new(c, width, normal, &horizon))
        .collect();
    let mut sums = [TwoWords::default(); 3];
    for (row, line) in (0..height).zip(texels.chunks_exact(width as usize)) {
        // Mirrored, so that the lit part of every meridian starts at its upper end.
        let row = if normal[2] < 0.0 {
            height - 1 - row
        } else {
            row
        };
        let band = Band::new(row, height);
        for (column, texel) in columns.iter().zip(line) {
            let weight = if column.latest <= band.start {
                continue;
            } else if column.earliest >= band.end {
                column.across * band.sin_squared + column.width * horizon.up * band.sin_cos
            } else {
                horizon.cut(&band, column)
            };
            for (sum, &radiance) in sums.iter_mut().zip(texel) {
                sum.add(f64::from(radiance) * weight);
            }
        }
    }
    sums.map(TwoWords::value)
}

/// The horizon of a normal: n = (`side` at azimuth `azimuth` in turns, `up`), `up` >= 0.
struct Horizon {
    side: f64,
    up: f64,
    azimuth: f64,
    /// Distance of G's singularities from the real axis, above q = ±pi/2.
    pole: f64,
}

impl Horizon {
    fn new(normal: [f64; 3]) -> Self {
        let side = normal[0].hypot(normal[1]);
        let up = normal[2].abs();
        let azimuth = normal[1].atan2(normal[0]) / TAU;
        Self {
            side,
            up,
            azimuth,
            pole: (up / side).asinh(),
        }
    }

    /// Polar angle at which the meridian of this cosine meets the horizon; lit above it.
    fn crossing(&self, cos_q: f64) -> f64 {
        // The sum with zero turns -0 into 0: a normal along z has side = 0.
        self.up.atan2(-self.side * cos_q + 0.0)
    }

    /// Weight of a texel that the horizon may cut.
    fn cut(&self, band: &Band, column: &Column) -> f64 {
        let mut ends = vec![column.from, column.to];
        for (sin, cos) in [band.start.sin_cos(), band.end.sin_cos()] {
            let bound = (-self.up * cos / (self.side * sin)).acos();
            for end in [-bound, bound, TAU - bound, TAU + bound] {
                // NaN, where the parallel does not meet the horizon, is in no range.
                if column.from < end && end < column.to {
                    ends.push(end);
                }
            }
        }
        ends.sort_by(f64::total_cmp);
        let mut weight = 0.0;
        for piece in ends.windows(2) {
            let (from, to) = (piece[0], piece[1]);
            let crossing = self.crossing((0.5 * (from + to)).cos());
            if crossing >= band.end {
                let sines = 2.0 * (0.5 * (from + to)).cos() * (0.5 * (to - from)).sin();
                weight +=
                    self.side * sines * band.sin_squared + self.up * (to - from) * band.sin_cos;
            } else if crossing > band.start {
                weight += self.graded(band, from, to);
            }
        }
        weight
    }

    /// Integral of G over a piece, bisected towards the singularities.
    fn graded(&self, band: &Band, from: f64, to: f64) -> f64 {
        // Real distance to the nearest odd multiple of pi/2, then the complex one.
        let aside = |q: f64| (q / PI - (q / PI).floor() - 0.5).abs() * PI;
        let holds = ((from - FRAC_PI_2) / PI).floor() != ((to - FRAC_PI_2) / PI).floor();
        let along = if holds {
            0.0
        } else {
            aside(from).min(aside(to))
        };
        let middle = 0.5 * (from + to);
        if to - from <= 2.0 * along.hypot(self.pole) || middle <= from || middle >= to {
            self.gauss(band, from, to)
        } else {
            self.graded(band, from, middle) + self.graded(band, middle, to)
        }
    }

    fn gauss(&self, band: &Band, from: f64, to: f64) -> f64 {
        let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
        let (sin_start, cos_start) = band.start.sin_cos();
        let sum: f64 = GAUSS
            .iter()
            .flat_map(|&(node, weight)| [(node, weight), (-node, weight)])
            .map(|(node, weight)| {
                let cos_q = (middle + half * node).cos();
                let depth = (self.crossing(cos_q) - band.start).max(0.0);
                let bulk = cos_start * sin_less_cos(depth) + depth * sin_start * depth.sin();
                weight * 0.5 * (self.side * cos_q).hypot(self.up) * bulk
            })
            .sum();
        half * sum
    }
}

/// A column: its azimuths relative to the normal's, and integrals over them.
struct Column {
    from: f64,
    to: f64,
    width: f64,
    /// n_x int cos p + n_y int sin p.
    across: f64,
    /// Least and greatest polar angle of the horizon within the column.
    earliest: f64,
    latest: f64,
}

impl Column {
    fn new(column: u32, columns: u32, normal: [f64; 3], horizon: &Horizon) -> Self {
        let count = f64::from(columns);
        let turns = f64::from(column) / count - horizon.azimuth;
        let turns = turns - (turns + 0.5).floor();
        let (from, to) = (TAU * turns, TAU * (turns + 1.0 / count));
        // cos q is 1 at multiples of 2 pi and -1 half way between, and monotone elsewhere.
        let (a, b) = (from.cos(), to.cos());
        let most = if (from <= 0.0 && to >= 0.0) || to >= TAU {
            1.0
        } else {
            a.max(b)
        };
        let least = if to >= PI { -1.0 } else { a.min(b) };
        let (sin, cos) = sin_cos_turns(2 * u64::from(column) + 1, 2 * u64::from(columns));
        let chord = 2.0 * (PI / count).sin();
        Self {
            from,
            to,
            width: TAU / count,
            across: chord * (normal[0] * cos + normal[1] * sin),
            earliest: horizon.crossing(least),
            latest: horizon.crossing(most),
        }
    }
}

/// A row: its polar angles, and int sin^2 t and int sin t cos t over them.
struct Band {
    start: f64,
    end: f64,
    sin_squared: f64,
    sin_cos: f64,
}

impl Band {
    fn new(row: u32, rows: u32) -> Self {
        let count = f64::from(rows);
        let (start, end) = (
            PI * (f64::from(row) / count),
            PI * (f64::from(row + 1) / count),
        );
        let width = PI / count;
        // The mean angle is (2 row + 1) / (4 rows) turns.
        let middle = 2 * u64::from(row) + 1;
        let sin = sin_cos_turns(middle, 4 * u64::from(rows)).0;
        let sin_twice = sin_cos_turns(middle, 2 * u64::from(rows)).0;
        Self {
            start,
            end,
            sin_squared: 0.5 * angle_less_sin(width) + width.sin() * sin * sin,
            sin_cos: 0.5 * sin_twice * width.sin(),
        }
    }
}

/// Sine and cosine of `part / whole` turns, reduced in integers so that the
/// symmetries of the circle hold to the last bit.
fn sin_cos_turns(part: u64, whole: u64) -> (f64, f64) {
    let eighths = 8 * (part % whole);
    let (octant, rest) = (eighths / whole, eighths % whole);
    let odd = octant % 2 == 1;
    let rest = if odd { whole - rest } else { rest };
    let (mut sin, mut cos) = (TAU / 8.0 * rest as f64 / whole as f64).sin_cos();
    if matches!(octant, 1 | 2 | 5 | 6) {
        (sin, cos) = (cos, sin);
    }
    (
        if octant >= 4 { -sin } else { sin },
        if matches!(octant, 2..=5) { -cos } else { cos },
    )
}

/// x - sin x for x >= 0, without cancellation.
fn angle_less_sin(x: f64) -> f64 {
    if x > 1.0 {
        x - x.sin()
    } else {
        alternating(x, 1.0)
    }
}

/// sin x - x cos x for x >= 0, without cancellation.
fn sin_less_cos(x: f64) -> f64 {
    if x > 1.0 {
        x.sin() - x * x.cos()
    } else {
        alternating(x, 2.0)
    }
}

/// x^3/3! - ... of the two functions above: sum of (-1)^(k+1) x^(2k+1) f(k) / (2k+1)!,
/// with f(k) = 1 for `kind` 1 and 2k for `kind` 2.
fn alternating(x: f64, kind: f64) -> f64 {
    let mut term = x;
    let mut sum = 0.0;
    for k in (1..=10).map(f64::from) {
        term *= -x * x / ((2.0 * k) * (2.0 * k + 1.0));
        sum -= term * if kind == 1.0 { 1.0 } else { 2.0 * k };
    }
    sum
}

/// A sum in two words (Knuth's error-free addition), so that order does not show.
#[derive(Clone, Copy, Default)]
struct TwoWords {
    high: f64,
    low: f64,
}

impl TwoWords {
    fn add(&mut self, x: f64) {
        let sum = self.high + x;
        let part = sum - self.high;
        self.low += (self.high - (sum - part)) + (x - part);
        self.high = sum;
    }

    fn value(self) -> f64 {
        self.high + self.low
    }
}

/// Positive nodes and weights of the Gauss-Legendre rule of 20 nodes on [-1, 1].
const GAUSS: [(f64, f64); 10] = [
    (0.07652652113349734, 0.15275338713072584),
    (0.22778585114164507, 0.14917298647260374),
    (0.37370608871541955, 0.14209610931838204),
    (0.5108670019508271, 0.13168863844917664),
    (0.636053680726515, 0.11819453196151841),
    (0.7463319064601508, 0.10193011981724044),
    (0.8391169718222188, 0.08327674157670475),
    (0.912234428251326, 0.06267204833410907),
    (0.9639719272779138, 0.04060142980038694),
    (0.9931285991850949, 0.017614007139152118),
];
