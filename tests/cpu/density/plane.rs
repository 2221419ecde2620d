//! Uniform points of plane figures.

use super::laws::{Law, concentric, polar, turns};
use corput::glam::{DVec2, DVec3, dvec2};
use std::f64::consts::{PI, TAU};

/// Between two circles: by polar coordinates.
struct Annulus {
    inner: f64,
    concentric: bool,
}

impl Law for Annulus {
    fn at(&self, t: DVec2) -> DVec3 {
        polar(self.inner + t.x * (1.0 - self.inner), t.y).extend(0.0)
    }
    fn stretch(&self, t: DVec2) -> f64 {
        let width = 1.0 - self.inner;
        TAU * (self.inner + t.x * width) * width
    }
    fn chart(&self, x: DVec3) -> DVec2 {
        let radius = x.truncate().length();
        dvec2((radius - self.inner) / (1.0 - self.inner), turns(x.x, x.y))
    }
    fn pdf(&self, _: DVec3) -> f64 {
        1.0 / (PI * (1.0 - self.inner) * (1.0 + self.inner))
    }
    fn fractions(&self, x: DVec3) -> DVec2 {
        if self.concentric {
            return concentric(x.truncate());
        }
        let radius = x.truncate().length();
        let part = (radius - self.inner) * (radius + self.inner);
        let whole = (1.0 - self.inner) * (1.0 + self.inner);
        dvec2(part / whole, turns(x.x, x.y))
    }
}

/// By collapsed coordinates: a + s (b - a) + s t (c - b).
struct Triangle([DVec2; 3]);

impl Triangle {
    fn doubled(&self) -> f64 {
        let [a, b, c] = self.0;
        (b - a).perp_dot(c - a).abs()
    }

    /// Barycentric coordinates of b and c.
    fn weights(&self, x: DVec3) -> [f64; 2] {
        let [a, b, c] = self.0;
        let (p, q, d) = (b - a, c - a, x.truncate() - a);
        [d.perp_dot(q) / p.perp_dot(q), p.perp_dot(d) / p.perp_dot(q)]
    }
}

impl Law for Triangle {
    fn at(&self, t: DVec2) -> DVec3 {
        let [a, b, c] = self.0;
        (a + t.x * ((b - a) + t.y * (c - b))).extend(0.0)
    }
    fn stretch(&self, t: DVec2) -> f64 {
        t.x * self.doubled()
    }
    fn chart(&self, x: DVec3) -> DVec2 {
        let [b, c] = self.weights(x);
        dvec2(b + c, c / (b + c))
    }
    fn pdf(&self, _: DVec3) -> f64 {
        2.0 / self.doubled()
    }
    /// Heitz 2019, backwards.
    fn fractions(&self, x: DVec3) -> DVec2 {
        let [b, c] = self.weights(x);
        let a = 1.0 - b - c;
        if b > a {
            dvec2(2.0 * a, a + b)
        } else {
            dvec2(a + b, 2.0 * b)
        }
    }
}

/// By polar coordinates up to the edge.
struct Polygon(f64);

impl Polygon {
    /// The distance of the edge at an angle in turns.
    fn edge(&self, turns: f64) -> f64 {
        let side = turns * self.0;
        let away = TAU / self.0 * (side - side.floor() - 0.5);
        (PI / self.0).cos() / away.cos()
    }
}

impl Law for Polygon {
    fn at(&self, t: DVec2) -> DVec3 {
        polar(t.x * self.edge(t.y), t.y).extend(0.0)
    }
    fn stretch(&self, t: DVec2) -> f64 {
        TAU * t.x * self.edge(t.y).powi(2)
    }
    fn chart(&self, x: DVec3) -> DVec2 {
        let angle = turns(x.x, x.y);
        dvec2(x.truncate().length() / self.edge(angle), angle)
    }
    fn pdf(&self, _: DVec3) -> f64 {
        2.0 / (self.0 * (TAU / self.0).sin())
    }
    /// The parts of both ends of a side, from which the point lies off the centre.
    fn fractions(&self, x: DVec3) -> DVec2 {
        let side = (turns(x.x, x.y) * self.0).floor();
        let [p, q] = [side, side + 1.0].map(|k| polar(1.0, k / self.0));
        let [a, b] = [x.truncate().perp_dot(q), p.perp_dot(x.truncate())];
        let radius = (a + b) / p.perp_dot(q);
        dvec2((side + b / (a + b)) / self.0, radius * radius)
    }
}

/// Uniform points of plane figures.
pub fn figure(name: &str, p: &[f32]) -> Option<Box<dyn Law>> {
    let vertex = |i: usize| dvec2(p[i].into(), p[i + 1].into());
    let disk = |inner, concentric| -> Option<Box<dyn Law>> {
        Some(Box::new(Annulus { inner, concentric }))
    };
    match name {
        "concentric-disk" => disk(0.0, true),
        "polar-disk" => disk(0.0, false),
        "annulus" => disk(p[0].into(), false),
        "triangle" => Some(Box::new(Triangle([vertex(0), vertex(2), vertex(4)]))),
        "regular-polygon" => Some(Box::new(Polygon(p[0].to_bits().into()))),
        _ => None,
    }
}
