//! Scattering distributions as the papers print them, cancellations and all, in numbers of
//! 106 bits, where what cancels does no harm.

use super::functions::sin_cos;
use super::transcendental::negative_log;
use super::wide::Wide;

/// A vector.
type Vector = [Wide; 3];

fn wide(x: f64) -> Wide {
    x.into()
}

fn dot(a: Vector, b: Vector) -> Wide {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn scale(a: Vector, k: Wide) -> Vector {
    a.map(|x| x * k)
}

fn sum(a: Vector, b: Vector) -> Vector {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

fn cross(a: Vector, b: Vector) -> Vector {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

fn normalized(a: Vector) -> Vector {
    let length = dot(a, a).sqrt();
    a.map(|x| x / length)
}

fn max(a: Wide, b: f64) -> Wide {
    if a < wide(b) { wide(b) } else { a }
}

/// u as a fraction of 2^32.
fn unit(u: u32) -> Wide {
    wide(f64::from(u) / 4_294_967_296.0)
}

/// (cos, sin) of 2 pi u 2^-32: an angle 2^-53 off, but a unit vector to 106 bits.
fn circle(u: u32) -> [Wide; 2] {
    let (s, c) = sin_cos(u);
    let (s, c) = (wide(s), wide(c));
    let length = (s * s + c * c).sqrt();
    [c / length, s / length]
}

/// A direction and its pdf.
fn result(d: Vector, pdf: Wide) -> [f64; 4] {
    [d[0].value(), d[1].value(), d[2].value(), pdf.value()]
}

/// Henyey and Greenstein's directions: (1 + g^2 - ((1 - g^2) / (1 - g + 2 g u))^2) / (2 g)
/// for the cosine, with |g| = 1 - rest, and pdf (1 - g^2) / (4 pi (1 + g^2 - 2 g cos)^1.5).
#[must_use]
pub fn henyey_greenstein(rest: f32, backward: bool, u: [u32; 2]) -> [f64; 4] {
    let one = wide(1.0);
    let two = wide(2.0);
    let magnitude = one - rest.into();
    let g = if backward { -magnitude } else { magnitude };
    let x = unit(u[0]);
    let [c, s] = circle(u[1]);
    let z = if magnitude.value() == 0.0 {
        two * x - one
    } else {
        let ratio = (one - g * g) / (one - g + two * g * x);
        (one + g * g - ratio * ratio) / (two * g)
    };
    let radius = ((one - z) * (one + z)).sqrt();
    let square = one + g * g - two * g * z;
    let pdf = (one - g * g) / (wide(4.0) * Wide::pi() * square * square.sqrt());
    result([radius * c, radius * s, z], pdf)
}

/// Henyey and Greenstein's pdf at a direction: near the poles x and y say more of the
/// cosine than z does.
#[must_use]
pub fn henyey_greenstein_pdf(rest: f32, backward: bool, d: [f64; 3]) -> f64 {
    let one = wide(1.0);
    let magnitude = one - rest.into();
    let g = if backward { -magnitude } else { magnitude };
    let [x, y, z] = d.map(Wide::from);
    let polar = (one - x * x - y * y).sqrt();
    let cosine = match z.value() {
        v if v > 0.7 => polar,
        v if v < -0.7 => -polar,
        _ => z,
    };
    let square = one + g * g - wide(2.0) * g * cosine;
    ((one - g * g) / (wide(4.0) * Wide::pi() * square * square.sqrt())).value()
}

/// The fractions that give a direction: u = ((1 - g^2) / sqrt(1 + g^2 - 2 g cos) - 1 + g) / (2 g).
#[must_use]
pub fn henyey_greenstein_fractions(rest: f32, backward: bool, d: [f64; 3]) -> [f64; 2] {
    let one = wide(1.0);
    let magnitude = one - rest.into();
    let g = if backward { -magnitude } else { magnitude };
    let [x, y, z] = d.map(Wide::from);
    let polar = (one - x * x - y * y).sqrt();
    let cosine = match z.value() {
        v if v > 0.7 => polar,
        v if v < -0.7 => -polar,
        _ => z,
    };
    let u = if magnitude.value() == 0.0 {
        (one + cosine) / wide(2.0)
    } else {
        let root = (one + g * g - wide(2.0) * g * cosine).sqrt();
        ((one - g * g) / root - one + g) / (wide(2.0) * g)
    };
    [u.value(), turns(d[1], d[0])]
}

/// A GGX lobe, by the formulas of Walter et al. 2007 and Heitz 2014.
#[derive(Clone, Copy, Debug)]
pub struct Ggx {
    alpha: [Wide; 2],
    wo: Vector,
    /// k of Eto and Tokuyoshi: 1 for all visible normals.
    k: Wide,
}

impl Ggx {
    /// The lobe of all visible normals; wo is normalised.
    #[must_use]
    pub fn new(alpha: [f32; 2], wo: [f32; 3]) -> Self {
        Self {
            alpha: alpha.map(Wide::from),
            wo: normalized(wo.map(Wide::from)),
            k: wide(1.0),
        }
    }

    /// The lobe of those within the bound of Eto and Tokuyoshi 2023, eq. 5 and 6.
    #[must_use]
    pub fn bounded(alpha: [f32; 2], wo: [f32; 3]) -> Self {
        let mut lobe = Self::new(alpha, wo);
        let one = wide(1.0);
        let a = wide(f64::from(alpha[0].min(alpha[1]).min(1.0)));
        let [x, y, z] = lobe.wo;
        let s = one + (x * x + y * y).sqrt();
        if z.value() > 0.0 {
            lobe.k = (one - a * a) * s * s / (s * s + a * a * z * z);
        }
        lobe
    }

    /// (alpha_x x, alpha_y y, z).
    fn stretched(&self, v: Vector) -> Vector {
        [self.alpha[0] * v[0], self.alpha[1] * v[1], v[2]]
    }

    /// wo.z + |stretched wo|, the former times k.
    fn area(&self) -> Wide {
        let s = self.stretched(self.wo);
        self.k * self.wo[2] + dot(s, s).sqrt()
    }

    /// D of a unit normal (Heitz 2014, eq. 85 in Cartesian form).
    fn density(&self, h: Vector) -> Wide {
        let [x, y, z] = h;
        if z.value() <= 0.0 {
            return wide(0.0);
        }
        let [a, b] = self.alpha;
        let sum = x * x / (a * a) + y * y / (b * b) + z * z;
        wide(1.0) / (Wide::pi() * a * b * sum * sum)
    }

    /// The visible normal of Heitz 2018, appendix A.
    fn visible(&self, u: [u32; 2]) -> Vector {
        let (zero, one) = (wide(0.0), wide(1.0));
        let v = normalized(self.stretched(self.wo));
        let flat = v[0] * v[0] + v[1] * v[1];
        let t1 = if flat.value() > 0.0 {
            scale([-v[1], v[0], zero], one / flat.sqrt())
        } else {
            [one, zero, zero]
        };
        let t2 = cross(v, t1);
        let r = unit(u[0]).sqrt();
        let [c, s] = circle(u[1]);
        let (p1, p2) = (r * c, r * s);
        let half = wide(0.5) * (one + v[2]);
        let p2 = (one - half) * (one - p1 * p1).sqrt() + half * p2;
        let up = max(one - p1 * p1 - p2 * p2, 0.0).sqrt();
        let n = sum(sum(scale(t1, p1), scale(t2, p2)), scale(v, up));
        let [x, y, z] = self.stretched(n);
        normalized([x, y, max(z, 0.0)])
    }

    /// The normal that the cap of Dupuy and Benyoub 2023, listing 3, or its bounded form
    /// gives.
    fn cap(&self, u: [u32; 2]) -> Vector {
        let one = wide(1.0);
        let v = normalized(self.stretched(self.wo));
        let b = self.k * v[2];
        let z = (one - unit(u[0])) * (one + b) - b;
        let radius = max(one - z * z, 0.0).sqrt();
        let [c, s] = circle(u[1]);
        normalized(self.stretched(sum([radius * c, radius * s, z], v)))
    }

    /// wo reflected at h, and D / (2 area).
    fn reflected(&self, h: Vector) -> [f64; 4] {
        let wi = sum(
            scale(h, wide(2.0) * dot(self.wo, h)),
            scale(self.wo, wide(-1.0)),
        );
        result(wi, self.density(h) / (wide(2.0) * self.area()))
    }

    /// A direction by visible normals as Heitz has them, and its pdf.
    #[must_use]
    pub fn vndf(&self, u: [u32; 2]) -> [f64; 4] {
        self.reflected(self.visible(u))
    }

    /// A visible normal as Heitz has them, and its pdf.
    #[must_use]
    pub fn normal(&self, u: [u32; 2]) -> [f64; 4] {
        let h = self.visible(u);
        result(h, self.normal_density(h))
    }

    /// A direction by caps, bounded if the lobe is, and its pdf.
    #[must_use]
    pub fn vndf_cap(&self, u: [u32; 2]) -> [f64; 4] {
        self.reflected(self.cap(u))
    }

    /// 2 (wo.h) D / area.
    fn normal_density(&self, h: Vector) -> Wide {
        wide(2.0) * max(dot(self.wo, h), 0.0) * self.density(h) / self.area()
    }

    /// The pdf of visible normals at a normal.
    #[must_use]
    pub fn normal_pdf(&self, h: [f64; 3]) -> f64 {
        self.normal_density(normalized(h.map(Wide::from))).value()
    }

    /// The pdf of reflected directions at a direction, taken as exact: 0 outside the cap.
    #[must_use]
    pub fn pdf(&self, wi: [f64; 3]) -> f64 {
        let wi = normalized(wi.map(Wide::from));
        let h = normalized(sum(wi, self.wo));
        let v = normalized(self.stretched(self.wo));
        // The same facet of the unit sphere reflects V to V'.
        let n = normalized([h[0] / self.alpha[0], h[1] / self.alpha[1], h[2]]);
        let reflected = sum(scale(n, wide(2.0) * dot(v, n)), scale(v, wide(-1.0)));
        if wi[2].value() < 0.0 && reflected[2] < -(self.k * v[2]) {
            return 0.0;
        }
        (self.density(h) / (wide(2.0) * self.area())).value()
    }

    /// The cosine between view and normal on the unit sphere, for a reflected direction.
    #[must_use]
    pub fn sphere_cosine(&self, wi: [f64; 3]) -> f64 {
        let h = sum(normalized(wi.map(Wide::from)), self.wo);
        let n = normalized([h[0] / self.alpha[0], h[1] / self.alpha[1], h[2]]);
        dot(normalized(self.stretched(self.wo)), n).value()
    }

    /// The fractions of [`Self::vndf_cap`] for a direction.
    #[must_use]
    pub fn cap_fractions(&self, wi: [f64; 3]) -> [f64; 2] {
        let h = sum(normalized(wi.map(Wide::from)), self.wo);
        let v = normalized(self.stretched(self.wo));
        let n = normalized([h[0] / self.alpha[0], h[1] / self.alpha[1], h[2]]);
        let [x, y, z] = sum(scale(n, wide(2.0) * dot(v, n)), scale(v, wide(-1.0)));
        let b = self.k * v[2];
        let height = (z + b) / (wide(1.0) + b);
        [(wide(1.0) - height).value(), turns(y.value(), x.value())]
    }

    /// The fractions of [`Self::normal`] for a normal.
    #[must_use]
    pub fn normal_fractions(&self, h: [f64; 3]) -> [f64; 2] {
        let one = wide(1.0);
        let h = h.map(Wide::from);
        let v = normalized(self.stretched(self.wo));
        let n = normalized([h[0] / self.alpha[0], h[1] / self.alpha[1], h[2]]);
        let flat = v[0] * v[0] + v[1] * v[1];
        let t1 = if flat.value() > 0.0 {
            scale([-v[1], v[0], wide(0.0)], one / flat.sqrt())
        } else {
            [one, wide(0.0), wide(0.0)]
        };
        let t2 = cross(v, t1);
        let (p1, p2) = (dot(n, t1), dot(n, t2));
        let half = wide(0.5) * (one + v[2]);
        let p2 = (p2 - (one - half) * (one - p1 * p1).sqrt()) / half;
        [(p1 * p1 + p2 * p2).value(), turns(p2.value(), p1.value())]
    }

    /// G2 D cos / (4 cos cos' pdf), by Lambda (Heitz 2014, eq. 72 and 99).
    #[must_use]
    pub fn weight(&self, wi: [f64; 3]) -> f64 {
        let wi = wi.map(Wide::from);
        if wi[2].value() <= 0.0 || self.wo[2].value() <= 0.0 {
            return 0.0;
        }
        let g2 = wide(1.0) / (wide(1.0) + self.lambda(self.wo) + self.lambda(wi));
        // f cos / pdf = G2 / (4 wo.z) D / (D / (2 area)).
        (g2 * self.area() / (wide(2.0) * self.wo[2])).value()
    }

    fn lambda(&self, w: Vector) -> Wide {
        let [x, y, z] = self.stretched(w);
        let tan = (x * x + y * y) / (z * z);
        wide(0.5) * ((wide(1.0) + tan).sqrt() - wide(1.0))
    }
}

/// A Beckmann normal by its angles, and D cos there (Walter et al. 2007, eq. 25, 28, 29, with
/// one roughness for each axis).
#[must_use]
pub fn beckmann_normal(alpha: [f32; 2], u: [u32; 2]) -> [f64; 4] {
    let [a, b] = alpha.map(f64::from);
    let (s, c) = sin_cos(u[1]);
    let length = (a * c).hypot(b * s);
    // Cosine and sine of atan(b / a tan phi), in the quadrant of phi.
    let [x, y] = [a * c / length, b * s / length];
    let tangent = negative_log(u[0]).sqrt() * length;
    let cosine = 1.0 / 1f64.hypot(tangent);
    let sine = tangent * cosine;
    let inside = tangent.powi(2) * ((x / a).powi(2) + (y / b).powi(2));
    let pdf = (-inside).exp() / (std::f64::consts::PI * a * b * cosine.powi(3));
    [sine * x, sine * y, cosine, pdf]
}

/// wo reflected at the same normal, and D cos / (4 |wo.h|).
#[must_use]
pub fn beckmann(alpha: [f32; 2], wo: [f32; 3], u: [u32; 2]) -> [f64; 4] {
    let [x, y, z, pdf] = beckmann_normal(alpha, u);
    let (h, o) = ([x, y, z].map(Wide::from), normalized(wo.map(Wide::from)));
    let cosine = dot(o, h);
    let wi = sum(scale(h, wide(2.0) * cosine), scale(o, wide(-1.0)));
    result(wi, wide(pdf / (4.0 * cosine.value().abs())))
}

/// The angle of (x, y) as a fraction of a turn in [0, 1).
fn turns(y: f64, x: f64) -> f64 {
    let turns = y.atan2(x) / std::f64::consts::TAU;
    if turns < 0.0 { turns + 1.0 } else { turns }
}
