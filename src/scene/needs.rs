//! The domains of a scene, in the order of a sampler's dimensions.

use super::layout::Layout;
use super::left_out::{self, LeftOut};
use super::{Cause, Scene, target};
use crate::catalog::{Mapping, Request};
use crate::{Error, Result};
use std::collections::BTreeSet;
use std::ops::Range;

/// What one domain draws.
#[derive(Clone, Debug, PartialEq)]
pub enum Draw {
    /// A number between two, as a time.
    Between([f64; 2]),
    /// One of several, by weights of which one at least is above 0.
    Choice(Vec<f64>),
    /// A sample of a map.
    Map(Mapping),
}

impl Draw {
    /// Dimensions that it takes.
    #[must_use]
    pub fn dimensions(&self) -> u32 {
        match self {
            Self::Between(_) | Self::Choice(_) => 1,
            Self::Map(mapping) => mapping.map().dimensions,
        }
    }

    /// The map, unless it is a plain number or a choice.
    #[must_use]
    pub fn mapping(&self) -> Option<&Mapping> {
        match self {
            Self::Map(mapping) => Some(mapping),
            _ => None,
        }
    }
}

/// One thing that a renderer draws.
#[derive(Clone, Debug, PartialEq)]
pub struct Domain {
    /// Its name, as `camera.lens`: unique in the scene.
    pub key: String,
    /// What is drawn.
    pub draw: Draw,
    /// The first dimension of the points that it takes.
    pub first: u32,
    /// What decided that it is there.
    pub cause: Cause,
}

impl Domain {
    /// The dimensions of the points that it takes. Those of alternatives are the same: only one
    /// of the lights is drawn, one of a material's lobes, and one material or medium is met.
    #[must_use]
    pub fn range(&self) -> Range<u32> {
        self.first..self.first + self.draw.dimensions()
    }
}

/// What a scene needs, and what it does not.
#[derive(Clone, Debug)]
pub struct Needs {
    /// In the order of their first dimension.
    pub domains: Vec<Domain>,
    /// What nothing in the scene reaches.
    pub left_out: Vec<LeftOut>,
    /// The points that have all dimensions.
    pub request: Request,
    /// What may disappoint although it is right, a sentence each.
    pub warnings: Vec<String>,
}

impl Needs {
    /// Those of a scene.
    ///
    /// # Errors
    /// [`Error::Arguments`] for a scene that draws nothing, for a weight that is none, names
    /// that are there twice, and what the target does not have; what the sampler refuses.
    pub fn of(scene: &Scene) -> Result<Self> {
        unique("light", scene.lights.iter().map(|one| one.name.as_str()))?;
        unique(
            "material",
            scene.materials.iter().map(|one| one.name.as_str()),
        )?;
        unique("medium", scene.media.iter().map(|one| one.name.as_str()))?;
        let Layout {
            domains,
            left_out,
            end: dimensions,
            ..
        } = Layout::of(scene)?;
        let keys = domains.iter().map(|one| one.key.as_str());
        unique("domain", keys)?;
        if dimensions == 0 {
            return Err(refused(
                format!("a scene that draws nothing, {}", scene.name),
                "points have 1 dimension or more",
                "give it a filter, a lens, an area light, a lobe or a medium",
            ));
        }
        Self::with_domains(scene, domains, left_out, dimensions)
    }

    /// Those of bare points: a map over their first dimensions, where there is one, and numbers
    /// in [0, 1) of the others. The scene's sampler, samples, seed and profile count.
    ///
    /// # Errors
    /// What the sampler refuses; a map of more dimensions than the points have.
    pub fn of_points(scene: &Scene, dimensions: u32, mapping: Option<Mapping>) -> Result<Self> {
        let taken = mapping.as_ref().map_or(0, |one| one.map().dimensions);
        if dimensions < taken {
            return Err(refused(
                format!("a map of {taken} dimensions over points of {dimensions}"),
                "a map takes the first dimensions of a point",
                "ask for more dimensions",
            ));
        }
        let cause = Cause::new("as asked");
        let map = mapping.map(|mapping| Domain {
            key: mapping.map().name.to_owned(),
            draw: Draw::Map(mapping),
            first: 0,
            cause: cause.clone(),
        });
        let number = |first| Domain {
            key: format!("x{first}"),
            draw: Draw::Between([0.0, 1.0]),
            first,
            cause: cause.clone(),
        };
        let domains: Vec<Domain> = map
            .into_iter()
            .chain((taken..dimensions).map(number))
            .collect();
        Self::with_domains(scene, domains, Vec::new(), dimensions)
    }

    fn with_domains(
        scene: &Scene,
        domains: Vec<Domain>,
        mut left_out: Vec<LeftOut>,
        dimensions: u32,
    ) -> Result<Self> {
        let sampler = scene.sampler.value;
        let samples = scene.samples.value;
        let mut request = sampler.request(dimensions, samples, scene.seed)?;
        request.profile = scene.profile;
        target::check(&scene.target, &domains)?;
        left_out.extend(left_out::catalogue(scene, &domains, &request));
        let warnings = request.warnings.iter().cloned();
        let warnings = warnings.chain(sampler.lost_at(samples)).collect();
        Ok(Self {
            domains,
            left_out,
            request,
            warnings,
        })
    }

    /// Dimensions of a point.
    #[must_use]
    pub fn dimensions(&self) -> u32 {
        self.request.columns.len() as u32
    }

    /// The domain of a key.
    #[must_use]
    pub fn domain(&self, key: &str) -> Option<&Domain> {
        self.domains.iter().find(|one| one.key == key)
    }
}

/// Refuses a name that is there twice.
fn unique<'n>(what: &str, names: impl Iterator<Item = &'n str>) -> Result<()> {
    let mut met = BTreeSet::new();
    for name in names {
        if !met.insert(name) {
            return Err(refused(
                format!("{what} {name} twice"),
                "lights, materials, their lobes and media have each a name of its own",
                "give one of the two another name",
            ));
        }
    }
    Ok(())
}

pub(super) fn refused(asked: String, limit: &str, remedy: &str) -> Error {
    Error::Arguments {
        asked,
        limit: limit.to_owned(),
        remedy: remedy.to_owned(),
    }
}
