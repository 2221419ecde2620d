//! What a distribution is, in `f64` and without the shaders' formulas: its domain by a chart
//! that is not the map's, its pdf, and the fractions that lead to a point.

use super::{line, lobes, plane, solid};
use corput::bulk::map_sample;
use corput::catalog::{Group, Mapping, Profile, maps};
use corput::check::{examples, truth};
use corput::glam::{DVec2, DVec3, dvec2, dvec3};
use corput::judge;
use std::f64::consts::TAU;

/// A distribution of points: a length uses x, an area x and y, a solid angle unit vectors.
pub trait Law: Sync {
    /// The point of the domain at t in the unit square.
    fn at(&self, t: DVec2) -> DVec3;
    /// Length, area or solid angle per unit of t.
    fn stretch(&self, t: DVec2) -> f64;
    /// The t of a point.
    fn chart(&self, x: DVec3) -> DVec2;
    /// The density.
    fn pdf(&self, x: DVec3) -> f64;
    /// The fractions that the map takes to a point.
    fn fractions(&self, x: DVec3) -> DVec2;
}

/// A map with parameters, and its law.
pub struct Case {
    pub mapping: Mapping,
    /// Of its parameters among the examples.
    pub index: usize,
    pub law: Box<dyn Law>,
}

impl Case {
    pub fn name(&self) -> String {
        format!("{} {:?}", self.mapping.map().name, self.mapping.values())
    }

    /// Whether points lie on a line.
    pub fn line(&self) -> bool {
        self.mapping.map().coordinates == 1
    }

    /// A sample of the exact profile.
    pub fn sample(&self, u: [u32; 2]) -> DVec3 {
        self.point(self.numbers(u))
    }

    /// The pdf that comes with it.
    pub fn own_pdf(&self, u: [u32; 2]) -> f64 {
        self.numbers(u)[self.mapping.map().coordinates as usize]
    }

    fn numbers(&self, u: [u32; 2]) -> [f64; 4] {
        let second = if self.line() { 0 } else { u[1] };
        let words = map_sample(&self.mapping, Profile::Exact, [u[0], second, 0]);
        words.map(|word| f64::from(f32::from_bits(word)))
    }

    /// A sample of the judge, and its pdf.
    pub fn truth(&self, u: [u32; 2]) -> Option<(DVec3, f64)> {
        let second = if self.line() { 0 } else { u[1] };
        let found = truth(&self.mapping, [u[0], second, 0])?;
        let width = self.mapping.map().coordinates as usize;
        let mut s = found;
        s[width..].fill(0.0);
        Some((dvec3(s[0], s[1], s[2]), found[width]))
    }

    fn point(&self, s: [f64; 4]) -> DVec3 {
        match self.mapping.map().coordinates {
            1 => dvec3(s[0], 0.0, 0.0),
            2 => dvec3(s[0], s[1], 0.0),
            _ => refined(s),
        }
    }
}

/// A unit vector, its largest coordinate from the other two: near an axis they say more, and
/// of a lobe nearly along it the largest has a few values only.
fn refined(s: [f64; 4]) -> DVec3 {
    let mut d = [s[0], s[1], s[2]];
    let largest = (0..3)
        .max_by(|&a, &b| d[a].abs().total_cmp(&d[b].abs()))
        .unwrap_or(2);
    let others: f64 = (0..3).filter(|&k| k != largest).map(|k| d[k] * d[k]).sum();
    d[largest] = (1.0 - others).max(0.0).sqrt().copysign(d[largest]);
    DVec3::from_array(d)
}

/// Every map of the catalogue with each of its example parameters, but environment maps.
pub fn cases() -> Vec<Case> {
    maps()
        .filter(|map| map.group != Group::Environment)
        .flat_map(|map| {
            let all = examples(map).expect("examples in their domains");
            all.into_iter().enumerate()
        })
        .map(|(index, mapping)| Case {
            law: law(&mapping),
            index,
            mapping,
        })
        .collect()
}

/// The case of a map with these parameters.
pub fn case(name: &str, values: &[f64]) -> Case {
    let map = corput::catalog::Map::from_name(name).expect("a map");
    let mapping = Mapping::with_values(map, values).expect("parameters in their domain");
    Case {
        law: law(&mapping),
        index: 0,
        mapping,
    }
}

fn law(mapping: &Mapping) -> Box<dyn Law> {
    let (name, p) = (mapping.map().name, mapping.parameters().map(f64::from));
    let found = match mapping.map().group {
        Group::Planar => plane::figure(name, mapping.parameters()),
        Group::Line
        | Group::Normal
        | Group::Filter
        | Group::GaussianFilter
        | Group::WindowFilter
        | Group::MitchellFilter => line::line(name, &p),
        Group::Phase | Group::Ggx | Group::GgxCap | Group::Beckmann => lobes::lobe(name, &p),
        _ => plane::figure(name, mapping.parameters()).or_else(|| solid::solid(name, &p)),
    };
    found.unwrap_or_else(|| panic!("no law of {name}"))
}

/// The angle of (x, y) in turns.
pub fn turns(x: f64, y: f64) -> f64 {
    let turns = y.atan2(x) / TAU;
    if turns < 0.0 { turns + 1.0 } else { turns }
}

/// The point at this distance and angle in turns.
pub fn polar(radius: f64, turns: f64) -> DVec2 {
    let (s, c) = (TAU * turns).sin_cos();
    dvec2(radius * c, radius * s)
}

/// Axes around a normal: those of Duff et al. 2017, as the maps have them.
pub fn axes(normal: DVec3) -> [DVec3; 3] {
    let [x, y] = judge::frame(normal.to_array());
    [DVec3::from_array(x), DVec3::from_array(y), normal]
}

/// The fractions of Shirley and Chiu's disk.
pub fn concentric(p: DVec2) -> DVec2 {
    let radius = p.length();
    // Both signs of the radius reach a point.
    let (a, b) = if p.x.abs() >= p.y.abs() {
        let a = radius.copysign(p.x);
        (a, a * (p.y / p.x).atan() * 4.0 / std::f64::consts::PI)
    } else {
        let b = radius.copysign(p.y);
        (b * (p.x / p.y).atan() * 4.0 / std::f64::consts::PI, b)
    };
    dvec2(0.5 * (a + 1.0), 0.5 * (b + 1.0))
}

/// Independent pairs of fractions (SplitMix64).
pub fn random(seed: u64, index: u32) -> [u32; 2] {
    let step = (seed << 32 | u64::from(index)) + 1;
    let mut z = step.wrapping_mul(0x9e37_79b9_7f4a_7c15);
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^= z >> 31;
    [z as u32, (z >> 32) as u32]
}

/// What `work` makes of each case, by as many threads as there are processors.
pub fn each<T: Send>(cases: &[Case], work: impl Fn(u64, &Case) -> T + Sync) -> Vec<T> {
    let next = std::sync::atomic::AtomicUsize::new(0);
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    let run = || {
        let mut made = Vec::new();
        loop {
            let i = next.fetch_add(1, std::sync::atomic::Ordering::Relaxed);
            let Some(case) = cases.get(i) else {
                return made;
            };
            made.push((i, work(i as u64, case)));
        }
    };
    let mut all: Vec<(usize, T)> = std::thread::scope(|scope| {
        let handles: Vec<_> = (0..threads).map(|_| scope.spawn(run)).collect();
        let joined = handles.into_iter().map(|handle| handle.join());
        joined.flat_map(|made| made.expect("no panic")).collect()
    });
    all.sort_by_key(|(i, _)| *i);
    all.into_iter().map(|(_, made)| made).collect()
}
