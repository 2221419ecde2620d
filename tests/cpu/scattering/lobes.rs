//! The distributions under test with their parameters, in one form.

use corput::glam::{UVec2, Vec3, uvec2, vec2};
use corput::judge;
use corput::reference::ggx_lobe::{Ggx, ggx_prepare};
use corput::reference::ggx_vndf::*;
use corput::reference::ggx_vndf_bounded::*;
use corput::reference::ggx_vndf_cap::*;
use corput::reference::henyey_greenstein::*;
use corput::reference::permute::permute_mix as mix;
use corput::reference::scattered::Scattered;

/// Which map.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    HenyeyGreenstein,
    Vndf,
    Normal,
    Cap,
    Bounded,
}

/// The maps of a GGX lobe.
pub const GGX: [Kind; 4] = [Kind::Vndf, Kind::Normal, Kind::Cap, Kind::Bounded];

/// A map with its parameters.
#[derive(Clone, Copy, Debug)]
pub struct Lobe {
    pub kind: Kind,
    /// Of GGX.
    pub alpha: [f32; 2],
    /// Of GGX.
    pub wo: [f32; 3],
    /// 1 - |g|, and whether g < 0.
    pub rest: f32,
    pub backward: bool,
}

impl Lobe {
    pub fn henyey_greenstein(rest: f32, backward: bool) -> Self {
        Self {
            kind: Kind::HenyeyGreenstein,
            alpha: [1.0; 2],
            wo: [0.0, 0.0, 1.0],
            rest,
            backward,
        }
    }

    pub fn ggx(kind: Kind, alpha: [f32; 2], wo: [f32; 3]) -> Self {
        Self {
            kind,
            alpha,
            wo,
            rest: 1.0,
            backward: false,
        }
    }

    fn lobe(&self) -> Ggx {
        let (alpha, wo) = (vec2(self.alpha[0], self.alpha[1]), Vec3::from(self.wo));
        if self.kind == Kind::Bounded {
            ggx_vndf_bounded_prepare(alpha, wo)
        } else {
            ggx_prepare(alpha, wo)
        }
    }

    fn phase(&self) -> HenyeyGreenstein {
        henyey_greenstein_complement(self.rest, self.backward)
    }

    /// What the judge knows of a GGX lobe.
    pub fn judge(&self) -> judge::Ggx {
        if self.kind == Kind::Bounded {
            judge::Ggx::bounded(self.alpha, self.wo)
        } else {
            judge::Ggx::new(self.alpha, self.wo)
        }
    }

    /// Direction and pdf.
    pub fn sample(&self, u: UVec2) -> Scattered {
        match self.kind {
            Kind::HenyeyGreenstein => henyey_greenstein(self.phase(), u),
            Kind::Vndf => ggx_vndf(self.lobe(), u),
            Kind::Normal => ggx_vndf_normal(self.lobe(), u),
            Kind::Cap => ggx_vndf_cap(self.lobe(), u),
            Kind::Bounded => ggx_vndf_bounded(self.lobe(), u),
        }
    }

    /// The pdf of a direction.
    pub fn pdf(&self, d: Vec3) -> f32 {
        match self.kind {
            Kind::HenyeyGreenstein => henyey_greenstein_pdf(self.phase(), d),
            Kind::Vndf => ggx_vndf_pdf(self.lobe(), d),
            Kind::Normal => ggx_vndf_normal_pdf(self.lobe(), d),
            Kind::Cap => ggx_vndf_cap_pdf(self.lobe(), d),
            Kind::Bounded => ggx_vndf_bounded_pdf(self.lobe(), d),
        }
    }

    /// The fractions of a direction.
    pub fn invert(&self, d: Vec3) -> UVec2 {
        match self.kind {
            Kind::HenyeyGreenstein => henyey_greenstein_invert(self.phase(), d),
            Kind::Vndf => ggx_vndf_invert(self.lobe(), d),
            Kind::Normal => ggx_vndf_normal_invert(self.lobe(), d),
            Kind::Cap => ggx_vndf_cap_invert(self.lobe(), d),
            Kind::Bounded => ggx_vndf_bounded_invert(self.lobe(), d),
        }
    }

    /// The pdf of a direction, taken as exact, as the judge has it.
    pub fn truth_pdf(&self, d: [f64; 3]) -> f64 {
        match self.kind {
            Kind::HenyeyGreenstein => judge::henyey_greenstein_pdf(self.rest, self.backward, d),
            Kind::Normal => self.judge().normal_pdf(d),
            _ => self.judge().pdf(d),
        }
    }

    /// Whether the normal of a sample is within `cosine` of perpendicular to the view, where
    /// both are stretched to the unit sphere: of caps.
    pub fn perpendicular(&self, sample: [f64; 4], cosine: f64) -> bool {
        let capped = matches!(self.kind, Kind::Cap | Kind::Bounded);
        let [x, y, z, _] = sample;
        capped && self.judge().sphere_cosine([x, y, z]) < cosine
    }

    /// The cosine between a normal and the view.
    pub fn cosine(&self, normal: Vec3) -> f64 {
        let wo = Vec3::from(self.wo).as_dvec3().normalize();
        normal.as_dvec3().dot(wo).abs()
    }

    /// Direction and pdf as the judge has them.
    pub fn truth(&self, u: UVec2) -> [f64; 4] {
        let u = [u.x, u.y];
        match self.kind {
            Kind::HenyeyGreenstein => judge::henyey_greenstein(self.rest, self.backward, u),
            Kind::Vndf => self.judge().vndf(u),
            Kind::Normal => self.judge().normal(u),
            Kind::Cap | Kind::Bounded => self.judge().vndf_cap(u),
        }
    }
}

/// Directions to see a lobe from: along the normal, oblique, nearly grazing.
pub const VIEWS: [[f32; 3]; 4] = [
    [0.0, 0.0, 1.0],
    [0.8, 0.0, 0.6],
    [-0.48, 0.6, 0.64],
    [0.999_999_5, 0.0, 1e-3],
];

/// Roughnesses along x and y.
pub const ALPHAS: [[f32; 2]; 6] = [
    [1.0, 1.0],
    [0.3, 0.3],
    [0.1, 0.5],
    [1e-2, 1e-2],
    [1e-3, 1e-3],
    [1e-4, 1e-4],
];

/// 1 - |g|.
pub const RESTS: [f32; 6] = [1.0, 0.999_999, 0.5, 0.1, 1e-3, 1e-6];

/// Every map with every parameter.
pub fn lobes() -> Vec<Lobe> {
    let mut list = Vec::new();
    for rest in RESTS {
        for backward in [false, true] {
            list.push(Lobe::henyey_greenstein(rest, backward));
        }
    }
    for kind in GGX {
        for alpha in ALPHAS {
            for wo in VIEWS {
                list.push(Lobe::ggx(kind, alpha, wo));
            }
        }
    }
    list
}

/// Fractions at the edges and `random` others.
pub fn fractions(random: u32) -> Vec<UVec2> {
    let edges = [
        0,
        1,
        2,
        255,
        0x3fff_ffff,
        0x4000_0000,
        0x7fff_ffff,
        0x8000_0000,
        0xc000_0000,
        0xffff_ff00,
        u32::MAX,
    ];
    let pairs = edges
        .iter()
        .flat_map(|&x| edges.iter().map(move |&y| uvec2(x, y)));
    let random = (0..random).map(|i| uvec2(mix(2 * i), mix(2 * i + 1)));
    pairs.chain(random).collect()
}
