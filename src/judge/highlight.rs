//! The highlight of a spherical light on a GGX surface, sample by sample, and its integral over
//! the light by brute force.

use super::Ggx;
use super::lights::sphere_light;
use super::spherical::around;
use std::f64::consts::{PI, TAU};

type Vector = [f64; 3];

/// Reals of 32 bits: how far from the light's rim a direction may be on its other side.
const NEAR: f64 = 1.0 / (1 << 26) as f64;

/// The scene of these parameters: roughness, cosine of the view, the light's half angle, and
/// its centre's angle from the mirror direction in such.
struct Scene {
    lobe: Ggx,
    view: Vector,
    centre: Vector,
    radius: f64,
}

impl Scene {
    fn new(values: &[f64]) -> Self {
        let [alpha, cosine, half, offset] = [0, 1, 2, 3].map(|i| values[i]);
        let (up, along) = (cosine.asin() + offset * half).sin_cos();
        // The scene is what its floats are.
        let wo = [(1.0 - cosine * cosine).sqrt() as f32, 0.0, cosine as f32];
        Self {
            lobe: Ggx::new([alpha as f32; 2], wo),
            view: unit(wo.map(f64::from)),
            centre: [-along, 0.0, up].map(|x| f64::from(x as f32)),
            radius: f64::from(half.sin() as f32),
        }
    }

    /// Half the angle under which the light is seen.
    fn half(&self) -> f64 {
        (self.radius / length(self.centre)).asin()
    }

    /// D G2 / (4 cos): the weight by visible normals times their pdf.
    fn reflected(&self, d: Vector) -> f64 {
        self.lobe.weight(d) * self.lobe.pdf(d)
    }

    /// A value where a direction meets the light, 0 where not, and both near its rim.
    fn met(&self, d: Vector, value: f64) -> [f64; 2] {
        let centre = unit(self.centre);
        let chord = length([0, 1, 2].map(|i| d[i] - centre[i]));
        let inside = 2.0 * (0.5 * self.half()).sin() - chord;
        match inside {
            inside if inside > NEAR => [value; 2],
            inside if inside < -NEAR => [0.0; 2],
            _ => [0.0, value],
        }
    }
}

/// The least and the greatest that an estimator may give, as [`super::scene`] says.
pub(super) fn sample(estimator: &str, values: &[f64], [x, y, choice]: [u32; 3]) -> [f64; 2] {
    let (scene, u) = (Scene::new(values), [x, y]);
    let (drawn, pdf) = sphere_light(scene.centre, scene.radius, u);
    let [a, b, c, _] = scene.lobe.vndf(u);
    let mirrored = [a, b, c];
    let mixed = |d: Vector| scene.reflected(d) / (0.5 * (scene.lobe.pdf(d) + pdf));
    match estimator {
        "uniform" => {
            let d = around(1.0, u);
            scene.met(d, TAU * scene.reflected(d))
        }
        "ggx" => scene.met(mirrored, scene.lobe.weight(mirrored)),
        "light" => [scene.reflected(drawn) / pdf; 2],
        "mis" if choice < 1 << 31 => scene.met(mirrored, mixed(mirrored)),
        "mis" => [mixed(drawn); 2],
        _ => [f64::NAN; 2],
    }
}

/// The integral of D G2 / (4 cos) over the directions of the light, in polar coordinates around
/// its centre: by Gauss's rule of 12 nodes on panels that halve towards the mirror direction,
/// where the lobe's peak is, and towards the ends. Takes a second.
///
/// # Panics
/// For fewer parameters than the integrand has.
#[must_use]
pub fn highlight(values: &[f64]) -> f64 {
    let scene = Scene::new(values);
    let centre = unit(scene.centre);
    let half = scene.half();
    let mirror = [-scene.view[0], 0.0, scene.view[2]];
    // At right angles to the centre in the plane of incidence, towards the mirror direction.
    let side = [centre[2], 0.0, -centre[0]];
    let across = dot(side, mirror);
    let towards = if across < 0.0 { -1.0 } else { 1.0 };
    let apart = across.abs().atan2(dot(centre, mirror));
    let fine = 0.2 * values[0];
    let nodes = gauss();
    let polar = graded(0.0, half, apart, fine.min(0.2 * half));
    let azimuths = graded(0.0, PI, 0.0, fine);
    integrate(&nodes, &polar, |angle| {
        let (sine, cosine) = angle.sin_cos();
        let ring = integrate(&nodes, &azimuths, |azimuth| {
            let (out, along) = azimuth.sin_cos();
            let along = towards * sine * along;
            let d = [0, 1, 2].map(|i| cosine * centre[i] + along * side[i]);
            scene.reflected([d[0], sine * out, d[2]])
        });
        2.0 * sine * ring
    })
}

/// Nodes and weights of Gauss's rule on (-1, 1), by Newton's iteration.
fn gauss() -> [(f64, f64); 12] {
    const N: usize = 12;
    std::array::from_fn(|i| {
        let n = N as f64;
        let mut x = (PI * (i as f64 + 0.75) / (n + 0.5)).cos();
        let mut slope = 0.0;
        for _ in 0..20 {
            let (mut last, mut legendre) = (1.0, x);
            for k in 2..=N {
                let k = k as f64;
                let next = ((2.0 * k - 1.0) * x * legendre - (k - 1.0) * last) / k;
                (last, legendre) = (legendre, next);
            }
            slope = n * (x * legendre - last) / (x * x - 1.0);
            x -= legendre / slope;
        }
        (x, 2.0 / ((1.0 - x * x) * slope * slope))
    })
}

/// Ends of panels from `low` to `high` that halve towards both and towards `middle`, down to
/// `least`.
fn graded(low: f64, high: f64, middle: f64, least: f64) -> Vec<f64> {
    let mut ends = vec![low, high, middle];
    let mut width = high - low;
    while width > least {
        ends.extend([low + width, high - width, middle - width, middle + width]);
        width *= 0.5;
    }
    ends.retain(|x| (low..=high).contains(x));
    ends.sort_by(f64::total_cmp);
    ends.dedup();
    ends
}

fn integrate(nodes: &[(f64, f64)], ends: &[f64], of: impl Fn(f64) -> f64) -> f64 {
    let panel = |ends: &[f64]| {
        let (middle, half) = (0.5 * (ends[0] + ends[1]), 0.5 * (ends[1] - ends[0]));
        let node = |&(x, weight): &(f64, f64)| weight * of(middle + half * x);
        half * nodes.iter().map(node).sum::<f64>()
    };
    ends.windows(2).map(panel).sum()
}

fn dot(a: Vector, b: Vector) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

fn length(a: Vector) -> f64 {
    dot(a, a).sqrt()
}

fn unit(a: Vector) -> Vector {
    let length = length(a);
    a.map(|x| x / length)
}
