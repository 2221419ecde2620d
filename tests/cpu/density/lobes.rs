//! Phase functions, and microsurfaces by the normals of the sphere that their stretching by
//! alpha makes of them.

use super::laws::{Law, polar, turns};
use corput::glam::{DVec2, DVec3, dvec2, dvec3};
use std::f64::consts::{FRAC_1_PI, FRAC_PI_2, TAU};

/// By ln(1 + (1 - |cos|) / rest^2), along which the lobe is wide.
struct Phase {
    /// 1 - |g|.
    rest: f64,
    backward: bool,
}

impl Phase {
    fn length(&self) -> f64 {
        (2.0 / self.rest.powi(2)).ln_1p()
    }

    /// 1 - the cosine to the axis of the lobe.
    fn versine(&self, x: DVec3) -> f64 {
        let z = if self.backward { -x.z } else { x.z };
        if z > 0.0 {
            x.truncate().length_squared() / (1.0 + z)
        } else {
            1.0 - z
        }
    }

    /// |g|, and 1 + g^2 - 2 |g| cos.
    fn square(&self, x: DVec3) -> [f64; 2] {
        let g = 1.0 - self.rest;
        [g, self.rest.powi(2) + 2.0 * g * self.versine(x)]
    }
}

impl Law for Phase {
    fn at(&self, t: DVec2) -> DVec3 {
        let versine = self.rest.powi(2) * (t.x * self.length()).exp_m1();
        let side = polar((versine * (2.0 - versine)).max(0.0).sqrt(), t.y);
        let z = 1.0 - versine;
        side.extend(if self.backward { -z } else { z })
    }
    fn stretch(&self, t: DVec2) -> f64 {
        TAU * self.rest.powi(2) * self.length() * (t.x * self.length()).exp()
    }
    fn chart(&self, x: DVec3) -> DVec2 {
        let part = (self.versine(x) / self.rest.powi(2)).ln_1p();
        dvec2(part / self.length(), turns(x.x, x.y))
    }
    fn pdf(&self, x: DVec3) -> f64 {
        let [g, square] = self.square(x);
        0.25 * FRAC_1_PI * (1.0 - g) * (1.0 + g) / square.powf(1.5)
    }
    fn fractions(&self, x: DVec3) -> DVec2 {
        let [g, square] = self.square(x);
        // From behind the lobe to its axis.
        let part = if g == 0.0 {
            1.0 - 0.5 * self.versine(x)
        } else {
            (self.rest * (1.0 + g) / square.sqrt() - self.rest) / (2.0 * g)
        };
        let first = if self.backward { 1.0 - part } else { part };
        dvec2(first, turns(x.x, x.y))
    }
}

/// What is sampled.
#[derive(Clone, Copy, PartialEq)]
pub enum Kind {
    Vndf,
    Normal,
    Cap,
    Beckmann,
    BeckmannNormal,
}

/// Directions or normals of a microsurface, by polar angles of the sphere's normals.
pub struct Lobe {
    kind: Kind,
    /// Along both axes, and 1.
    alpha: DVec3,
    wo: DVec3,
    /// Of the bounded cap.
    k: f64,
}

impl Lobe {
    pub fn new(kind: Kind, p: &[f64], bounded: bool) -> Self {
        let (alpha, wo) = (dvec3(p[0], p[1], 1.0), dvec3(p[2], p[3], p[4]));
        let wo = wo.normalize_or(DVec3::Z);
        let (a, s) = (p[0].min(p[1]).min(1.0), 1.0 + wo.truncate().length());
        let bound = (1.0 - a * a) * s * s / (s * s + a * a * wo.z * wo.z);
        Self {
            kind,
            alpha,
            wo,
            k: if bounded && wo.z > 0.0 { bound } else { 1.0 },
        }
    }

    fn normals(&self) -> bool {
        matches!(self.kind, Kind::Normal | Kind::BeckmannNormal)
    }

    /// The microfacet normal of a point.
    fn normal(&self, x: DVec3) -> DVec3 {
        if self.normals() {
            return x;
        }
        let sum = x + self.wo;
        // On opposite sides there are two, and z > 0 tells which.
        sum.normalize() * if sum.z < 0.0 { -1.0 } else { 1.0 }
    }

    /// The normal of the unit sphere.
    fn inner(&self, x: DVec3) -> DVec3 {
        (self.normal(x) / self.alpha).normalize()
    }

    /// The view from the unit sphere.
    fn view(&self) -> DVec3 {
        (self.alpha * self.wo).normalize()
    }

    /// The view reflected at the normal of the sphere, and b of the cap z > -b.
    fn cap(&self, x: DVec3) -> (DVec3, f64) {
        let (v, n) = (self.view(), self.inner(x));
        (2.0 * v.dot(n) * n - v, self.k * v.z)
    }

    /// The density of normals (Walter et al. 2007, by tangents).
    fn distribution(&self, h: DVec3) -> f64 {
        if h.z <= 0.0 {
            return 0.0;
        }
        let slope = dvec2(h.x / (self.alpha.x * h.z), h.y / (self.alpha.y * h.z));
        let area = self.alpha.x * self.alpha.y * h.z.powi(4);
        let square = slope.length_squared();
        FRAC_1_PI / area
            * match self.kind {
                Kind::Beckmann | Kind::BeckmannNormal => (-square).exp(),
                _ => (1.0 + square).powi(-2),
            }
    }

    /// Heitz's disk, backwards.
    fn disk(&self, x: DVec3) -> DVec2 {
        let (v, n) = (self.view(), self.inner(x));
        let flat = v.truncate().length();
        let first = if flat > 0.0 {
            dvec3(-v.y, v.x, 0.0) / flat
        } else {
            DVec3::X
        };
        let (p, q) = (n.dot(first), n.dot(v.cross(first)));
        let half = 0.5 * (1.0 + v.z);
        let q = (q - (1.0 - half) * (1.0 - p * p).max(0.0).sqrt()) / half;
        dvec2(p * p + q * q, turns(p, q))
    }
}

impl Law for Lobe {
    fn at(&self, t: DVec2) -> DVec3 {
        let (s, c) = (t.x * FRAC_PI_2).sin_cos();
        let h = (self.alpha * polar(s, t.y).extend(c)).normalize();
        if self.normals() {
            return h;
        }
        2.0 * self.wo.dot(h) * h - self.wo
    }
    fn stretch(&self, t: DVec2) -> f64 {
        let (s, c) = (t.x * FRAC_PI_2).sin_cos();
        let h = self.alpha * polar(s, t.y).extend(c);
        // Of normals per normal of the sphere, and of directions per normal.
        let normals = self.alpha.x * self.alpha.y / h.length().powi(3);
        let reflected = 4.0 * self.wo.dot(h.normalize()).abs();
        let around = TAU * FRAC_PI_2 * s * normals;
        around * if self.normals() { 1.0 } else { reflected }
    }
    fn chart(&self, x: DVec3) -> DVec2 {
        let n = self.inner(x);
        let angle = n.truncate().length().atan2(n.z);
        dvec2(angle / FRAC_PI_2, turns(n.x, n.y))
    }
    fn pdf(&self, x: DVec3) -> f64 {
        let h = self.normal(x);
        let (cosine, d) = (self.wo.dot(h), self.distribution(h));
        match self.kind {
            Kind::BeckmannNormal => return d * h.z,
            Kind::Beckmann => return d * h.z / (4.0 * cosine.abs()),
            _ if cosine <= 0.0 => return 0.0,
            _ => {}
        }
        // D G1 (wo.h) / wo.z, with G1 / wo.z = 2 / area.
        let area = self.k * self.wo.z + (self.alpha * self.wo).length();
        match self.kind {
            Kind::Normal => return 2.0 * cosine * d / area,
            Kind::Cap if self.k < 1.0 => {
                let (reflected, b) = self.cap(x);
                if reflected.z < -b {
                    return 0.0;
                }
            }
            _ => {}
        }
        d / (2.0 * area)
    }
    fn fractions(&self, x: DVec3) -> DVec2 {
        match self.kind {
            Kind::Vndf | Kind::Normal => self.disk(x),
            Kind::Cap => {
                let (reflected, b) = self.cap(x);
                let part = (1.0 - reflected.z) / (1.0 + b);
                dvec2(part, turns(reflected.x, reflected.y))
            }
            Kind::Beckmann | Kind::BeckmannNormal => {
                let n = self.inner(x);
                let square = n.truncate().length_squared() / (n.z * n.z);
                dvec2(-(-square).exp_m1(), turns(n.x, n.y))
            }
        }
    }
}

/// The scattering distributions.
pub fn lobe(name: &str, p: &[f64]) -> Option<Box<dyn Law>> {
    let (kind, bounded) = match name {
        "henyey-greenstein" => {
            return Some(Box::new(Phase {
                rest: p[0],
                backward: p[1] > 0.0,
            }));
        }
        "ggx-vndf" => (Kind::Vndf, false),
        "ggx-vndf-normal" => (Kind::Normal, false),
        "ggx-vndf-cap" => (Kind::Cap, false),
        "ggx-vndf-bounded" => (Kind::Cap, true),
        "beckmann" => (Kind::Beckmann, false),
        "beckmann-normal" => (Kind::BeckmannNormal, false),
        _ => return None,
    };
    Some(Box::new(Lobe::new(kind, p, bounded)))
}
