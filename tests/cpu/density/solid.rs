//! Distributions over solid angles.

use super::laws::{Law, axes, concentric, polar, turns};
use corput::glam::{DVec2, DVec3, dvec2, dvec3};
use corput::judge::spherical_triangle::{
    rectangle_solid_angle, solid_angle, spherical_triangle_invert,
};
use std::f64::consts::{FRAC_1_PI, FRAC_PI_2, PI, TAU};

/// How a map spreads its first fraction over a cone.
#[derive(Clone, Copy, PartialEq)]
enum Spread {
    /// By 1 - cos.
    Uniform,
    /// The hemisphere's, by cos.
    Hemisphere,
    /// cos / pi, by the squared sine.
    Cosine,
    /// cos / pi, by the concentric disk.
    Concentric,
    /// This power of cos, by one more.
    Power(f64),
}

/// Directions up to an angle from an axis, by that angle.
struct Cone {
    axes: [DVec3; 3],
    widest: f64,
    spread: Spread,
}

impl Cone {
    fn local(&self, x: DVec3) -> DVec3 {
        dvec3(
            self.axes[0].dot(x),
            self.axes[1].dot(x),
            self.axes[2].dot(x),
        )
    }

    /// ln cos, which near the axis the sine tells better.
    fn log_cosine(&self, x: DVec3) -> f64 {
        let l = self.local(x);
        if l.z > 0.5 {
            0.5 * (-l.truncate().length_squared()).ln_1p()
        } else {
            l.z.max(0.0).ln()
        }
    }
}

impl Law for Cone {
    fn at(&self, t: DVec2) -> DVec3 {
        let (s, c) = (t.x * self.widest).sin_cos();
        let side = polar(s, t.y);
        self.axes[0] * side.x + self.axes[1] * side.y + self.axes[2] * c
    }
    fn stretch(&self, t: DVec2) -> f64 {
        TAU * self.widest * (t.x * self.widest).sin()
    }
    fn chart(&self, x: DVec3) -> DVec2 {
        let l = self.local(x);
        let angle = l.truncate().length().atan2(l.z);
        dvec2(angle / self.widest, turns(l.x, l.y))
    }
    fn pdf(&self, x: DVec3) -> f64 {
        match self.spread {
            Spread::Hemisphere => 0.5 * FRAC_1_PI,
            Spread::Uniform => 0.25 * FRAC_1_PI / (0.5 * self.widest).sin().powi(2),
            Spread::Power(n) => (n + 1.0) / TAU * (n * self.log_cosine(x)).exp(),
            _ => self.local(x).z.max(0.0) * FRAC_1_PI,
        }
    }
    fn fractions(&self, x: DVec3) -> DVec2 {
        let l = self.local(x);
        let square = l.truncate().length_squared();
        let versine = if l.z > 0.0 {
            square / (1.0 + l.z)
        } else {
            1.0 - l.z
        };
        let first = match self.spread {
            Spread::Uniform => versine / (2.0 * (0.5 * self.widest).sin().powi(2)),
            Spread::Hemisphere => l.z,
            Spread::Cosine => square,
            Spread::Concentric => return concentric(l.truncate()),
            Spread::Power(n) => -((n + 1.0) * self.log_cosine(x)).exp_m1(),
        };
        dvec2(first, turns(l.x, l.y))
    }
}

/// Directions towards a disk, by polar coordinates there.
struct Disk {
    center: DVec3,
    axes: [DVec3; 3],
    radius: f64,
}

impl Disk {
    fn point(&self, x: DVec3) -> DVec3 {
        x * (self.axes[2].dot(self.center) / self.axes[2].dot(x))
    }

    fn place(&self, x: DVec3) -> DVec2 {
        let side = (self.point(x) - self.center) / self.radius;
        dvec2(self.axes[0].dot(side), self.axes[1].dot(side))
    }

    fn at_place(&self, t: DVec2) -> DVec3 {
        let p = polar(t.x * self.radius, t.y);
        self.center + self.axes[0] * p.x + self.axes[1] * p.y
    }

    /// Solid angle of a unit of area.
    fn seen(&self, point: DVec3) -> f64 {
        self.axes[2].dot(point).abs() / point.length().powi(3)
    }
}

impl Law for Disk {
    fn at(&self, t: DVec2) -> DVec3 {
        self.at_place(t).normalize()
    }
    fn stretch(&self, t: DVec2) -> f64 {
        TAU * t.x * self.radius.powi(2) * self.seen(self.at_place(t))
    }
    fn chart(&self, x: DVec3) -> DVec2 {
        let p = self.place(x);
        dvec2(p.length(), turns(p.x, p.y))
    }
    fn pdf(&self, x: DVec3) -> f64 {
        1.0 / (PI * self.radius.powi(2) * self.seen(self.point(x)))
    }
    fn fractions(&self, x: DVec3) -> DVec2 {
        concentric(self.place(x))
    }
}

/// Directions of a triangle of unit vectors, by collapsed coordinates of the plane one.
struct Triangle([DVec3; 3]);

impl Triangle {
    fn flat(&self, t: DVec2) -> DVec3 {
        let [a, b, c] = self.0;
        a + t.x * ((b - a) + t.y * (c - b))
    }

    fn area(&self) -> f64 {
        let [a, b, c] = self.0.map(|v| v.to_array());
        solid_angle(a, b, c)
    }
}

impl Law for Triangle {
    fn at(&self, t: DVec2) -> DVec3 {
        self.flat(t).normalize()
    }
    fn stretch(&self, t: DVec2) -> f64 {
        let [a, b, c] = self.0;
        let volume = a.dot((b - a).cross(c - a)).abs();
        t.x * volume / self.flat(t).length().powi(3)
    }
    fn chart(&self, x: DVec3) -> DVec2 {
        let [a, b, c] = self.0;
        let part = |p: DVec3, q: DVec3| x.dot(p.cross(q - p));
        let [a, b, c] = [part(b, c), part(c, a), part(a, b)];
        dvec2((b + c) / (a + b + c), c / (b + c))
    }
    fn pdf(&self, _: DVec3) -> f64 {
        1.0 / self.area()
    }
    fn fractions(&self, x: DVec3) -> DVec2 {
        let vertices = self.0.map(|v| v.to_array());
        DVec2::from_array(spherical_triangle_invert(vertices, x.to_array()))
    }
}

/// Directions of a rectangle, by its sides.
struct Rectangle {
    corner: DVec3,
    x: DVec3,
    y: DVec3,
    area: f64,
}

impl Law for Rectangle {
    fn at(&self, t: DVec2) -> DVec3 {
        (self.corner + self.x * t.x + self.y * t.y).normalize()
    }
    fn stretch(&self, t: DVec2) -> f64 {
        let point = self.corner + self.x * t.x + self.y * t.y;
        self.corner.dot(self.x.cross(self.y)).abs() / point.length().powi(3)
    }
    fn chart(&self, d: DVec3) -> DVec2 {
        let normal = self.x.cross(self.y);
        let away = d * (normal.dot(self.corner) / normal.dot(d)) - self.corner;
        dvec2(
            away.dot(self.x) / self.x.length_squared(),
            away.dot(self.y) / self.y.length_squared(),
        )
    }
    fn pdf(&self, _: DVec3) -> f64 {
        1.0 / self.area
    }
    /// Of the half beside x, and then of that beside y.
    fn fractions(&self, d: DVec3) -> DVec2 {
        let t = self.chart(d);
        let far = self.corner + self.x + self.y;
        let half = |from: DVec3, to: DVec3| [from, self.corner, to].map(|v| v.to_array());
        let (first, second) = (
            half(self.corner + self.x, far),
            half(far, self.corner + self.y),
        );
        let area = |[a, b, c]: [[f64; 3]; 3]| solid_angle(a, b, c) / self.area;
        if t.x > t.y {
            let [part, along] = spherical_triangle_invert(first, d.to_array());
            return dvec2(part * area(first), along);
        }
        let [part, along] = spherical_triangle_invert(second, d.to_array());
        dvec2(1.0 - (1.0 - part) * area(second), along)
    }
}

/// The distributions over solid angles.
pub fn solid(name: &str, p: &[f64]) -> Option<Box<dyn Law>> {
    let vector = |i: usize| dvec3(p[i], p[i + 1], p[i + 2]);
    let cone = |axis: DVec3, widest, spread| -> Option<Box<dyn Law>> {
        Some(Box::new(Cone {
            axes: axes(axis),
            widest,
            spread,
        }))
    };
    match name {
        "uniform-sphere" => cone(DVec3::Z, PI, Spread::Uniform),
        "uniform-hemisphere" => cone(DVec3::Z, FRAC_PI_2, Spread::Hemisphere),
        "cosine-hemisphere" => cone(DVec3::Z, FRAC_PI_2, Spread::Concentric),
        "cosine-hemisphere-polar" => cone(DVec3::Z, FRAC_PI_2, Spread::Cosine),
        "cosine-power-hemisphere" => {
            // Beyond this angle lies e^-28 of the mass.
            let versine = -(-28.0 / (p[0] + 1.0)).exp_m1();
            let widest = 2.0 * (0.5 * versine).sqrt().asin();
            cone(DVec3::Z, widest, Spread::Power(p[0]))
        }
        "cone" => cone(DVec3::Z, 2.0 * (0.5 * p[0]).sqrt().asin(), Spread::Uniform),
        "sphere-light" => {
            let (center, radius) = (vector(0), p[3]);
            let rest = center.length_squared() - radius * radius;
            let widest = if rest < 0.0 {
                PI
            } else {
                radius.atan2(rest.sqrt())
            };
            cone(center.normalize_or(DVec3::Z), widest, Spread::Uniform)
        }
        "disk-light" => Some(Box::new(Disk {
            center: vector(0),
            axes: axes(vector(3).normalize()),
            radius: p[6],
        })),
        "spherical-triangle" => Some(Box::new(Triangle(
            [vector(0), vector(3), vector(6)].map(DVec3::normalize),
        ))),
        "spherical-rectangle" => Some(Box::new(Rectangle {
            corner: vector(0),
            x: vector(3),
            y: vector(6),
            area: rectangle_solid_angle([vector(0), vector(3), vector(6)].map(|v| v.to_array())),
        })),
        _ => None,
    }
}
