//! Distributions of one coordinate, and of two that are alike.

use super::laws::{Law, turns};
use corput::glam::{DVec2, DVec3, dvec2, dvec3};
use corput::judge::line::mitchell;
use corput::judge::{normal_density, normal_mass};
use std::f64::consts::PI;

/// One coordinate: density and mass below.
#[derive(Clone, Copy)]
enum Coordinate {
    /// Rate.
    Exponential(f64),
    /// Deviation.
    Normal(f64),
    /// Radius.
    Box(f64),
    /// Radius.
    Tent(f64),
    /// Radius and deviation.
    Truncated(f64, f64),
    /// The radius of Blackman and Harris' window.
    Window(f64),
    /// Radius, B and C of the magnitude of Mitchell's filter.
    Mitchell([f64; 3]),
}

/// The integral of `|f|` from 0 to t, of Mitchell's filter, by the powers of its two cubics.
fn mitchell_below([b, c]: [f64; 2], t: f64) -> f64 {
    let inner = |x: f64| {
        let fourth = (12.0 - 9.0 * b - 6.0 * c) / 4.0 * x;
        (((fourth + (12.0 * b + 6.0 * c - 18.0) / 3.0) * x * x) + 6.0 - 2.0 * b) * x / 6.0
    };
    // By the distance from the end, where it has a double zero.
    let outer = |x: f64| {
        let y = 2.0 - x;
        ((b + 6.0 * c) / 4.0 * y - 2.0 * c) * y * y * y / -6.0
    };
    let zero = 2.0 - 6.0 * c / (b + 6.0 * c).max(f64::MIN_POSITIVE);
    let crossed = t.clamp(1.0, zero);
    inner(t.min(1.0)) + outer(crossed) - outer(1.0) + outer(crossed) - outer(t.max(crossed))
}

/// 1 and the terms of Blackman and Harris' window, each of k pi s and over the first.
fn window(s: f64, one: f64, term: impl Fn(f64, f64) -> f64) -> f64 {
    let terms = [(1.0, 0.488_29), (2.0, 0.141_28), (3.0, 0.011_68)];
    let sum: f64 = terms.iter().map(|&(k, a)| a * term(k * PI, s)).sum();
    one + sum / 0.358_75
}

impl Coordinate {
    /// Beyond these lies less than 2^-40 of the mass.
    fn ends(self) -> [f64; 2] {
        match self {
            Self::Exponential(rate) => [0.0, 28.0 / rate],
            Self::Normal(s) => [-7.5 * s, 7.5 * s],
            Self::Box(r) | Self::Tent(r) | Self::Window(r) | Self::Mitchell([r, ..]) => [-r, r],
            Self::Truncated(r, s) => [-r.min(7.5 * s), r.min(7.5 * s)],
        }
    }

    fn density(self, x: f64) -> f64 {
        match self {
            Self::Exponential(rate) => rate * (-rate * x).exp(),
            Self::Normal(s) => normal_density(x / s) / s,
            Self::Box(r) => 0.5 / r,
            Self::Tent(r) => (1.0 - x.abs() / r) / r,
            Self::Truncated(r, s) => normal_density(x / s) / (2.0 * s * normal_mass(r / s)),
            Self::Window(r) => window(x / r, 1.0, |k, s| (k * s).cos()) / (2.0 * r),
            Self::Mitchell([r, b, c]) => {
                mitchell(b, c, 2.0 * x / r).abs() / (r * mitchell_below([b, c], 2.0))
            }
        }
    }

    fn below(self, x: f64) -> f64 {
        let half = |part: f64| 0.5 + (0.5 * part).copysign(x);
        match self {
            Self::Exponential(rate) => -(-rate * x).exp_m1(),
            Self::Normal(s) => half(2.0 * normal_mass((x / s).abs())),
            Self::Box(r) => 0.5 + 0.5 * x / r,
            Self::Tent(r) => {
                let s = (x / r).abs();
                half(s * (2.0 - s))
            }
            Self::Truncated(r, s) => half(normal_mass((x / s).abs()) / normal_mass(r / s)),
            Self::Window(r) => {
                let s = (x / r).abs();
                half(window(s, s, |k, s| (k * s).sin() / k))
            }
            Self::Mitchell([r, b, c]) => {
                let of = |t| mitchell_below([b, c], t);
                half(of(2.0 * (x / r).abs()) / of(2.0))
            }
        }
    }
}

struct Line(Coordinate);

impl Law for Line {
    fn at(&self, t: DVec2) -> DVec3 {
        let [low, high] = self.0.ends();
        dvec3(low + t.x * (high - low), 0.0, 0.0)
    }
    fn stretch(&self, _: DVec2) -> f64 {
        let [low, high] = self.0.ends();
        high - low
    }
    fn chart(&self, x: DVec3) -> DVec2 {
        let [low, high] = self.0.ends();
        dvec2((x.x - low) / (high - low), 0.0)
    }
    fn pdf(&self, x: DVec3) -> f64 {
        self.0.density(x.x)
    }
    /// The second is what the first has below a 32nd.
    fn fractions(&self, x: DVec3) -> DVec2 {
        let u = self.0.below(x.x);
        dvec2(u, (32.0 * u).fract())
    }
}

/// Two independent ones, whose fractions are those of the coordinates or, of the normal
/// distribution, of radius and angle.
struct Pair {
    each: Coordinate,
    around: bool,
}

impl Law for Pair {
    fn at(&self, t: DVec2) -> DVec3 {
        let [low, high] = self.each.ends();
        (low + t * (high - low)).extend(0.0)
    }
    fn stretch(&self, _: DVec2) -> f64 {
        let [low, high] = self.each.ends();
        (high - low).powi(2)
    }
    fn chart(&self, x: DVec3) -> DVec2 {
        let [low, high] = self.each.ends();
        (x.truncate() - low) / (high - low)
    }
    fn pdf(&self, x: DVec3) -> f64 {
        self.each.density(x.x) * self.each.density(x.y)
    }
    fn fractions(&self, x: DVec3) -> DVec2 {
        match self.each {
            Coordinate::Normal(s) if self.around => {
                let half = 0.5 * x.truncate().length_squared() / (s * s);
                dvec2(-(-half).exp_m1(), turns(x.x, x.y))
            }
            each => dvec2(each.below(x.x), each.below(x.y)),
        }
    }
}

/// The distributions of one and two coordinates.
pub fn line(name: &str, p: &[f64]) -> Option<Box<dyn Law>> {
    use Coordinate::{Box as Flat, Exponential, Mitchell, Normal, Tent, Truncated, Window};
    let pair = |each, around| -> Option<Box<dyn Law>> { Some(Box::new(Pair { each, around })) };
    match name {
        "exponential" => Some(Box::new(Line(Exponential(p[0])))),
        "gaussian" => Some(Box::new(Line(Normal(p[0])))),
        "normal-pair" => pair(Normal(p[0]), false),
        "box-muller" => pair(Normal(p[0]), true),
        "filter-box" => pair(Flat(p[0]), false),
        "filter-tent" => pair(Tent(p[0]), false),
        "filter-gaussian" => pair(Truncated(p[0], p[1]), false),
        "filter-blackman-harris" => pair(Window(p[0]), false),
        "filter-mitchell" => pair(Mitchell([p[0], p[1], p[2]]), false),
        _ => None,
    }
}
