//! The domains of a scene, in the order of a sampler's dimensions.

use super::left_out::{self, LeftOut, Part};
use super::{Cause, Emitter, Scene, Stated, barycentric, target};
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
        let mut made = Domains::default();
        made.camera(scene);
        made.lights(scene)?;
        made.materials(scene)?;
        made.media(scene);
        let Domains {
            domains,
            mut left_out,
            end: dimensions,
            ..
        } = made;
        let keys = domains.iter().map(|one| one.key.as_str());
        unique("domain", keys)?;
        if dimensions == 0 {
            return Err(refused(
                format!("a scene that draws nothing, {}", scene.name),
                "points have 1 dimension or more",
                "give it a filter, a lens, an area light, a lobe or a medium",
            ));
        }
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

/// Domains as they are laid out.
#[derive(Default)]
struct Domains {
    domains: Vec<Domain>,
    left_out: Vec<LeftOut>,
    /// Where the next one begins.
    next: u32,
    /// The dimensions so far.
    end: u32,
}

impl Domains {
    fn push(&mut self, key: String, draw: Draw, cause: &Cause) {
        let first = self.next;
        self.next += draw.dimensions();
        self.end = self.end.max(self.next);
        self.domains.push(Domain {
            key,
            draw,
            first,
            cause: cause.clone(),
        });
    }

    fn map(&mut self, key: &str, stated: Option<&Stated<Mapping>>) {
        if let Some(Stated { value, cause }) = stated {
            self.push(key.to_owned(), Draw::Map(value.clone()), cause);
        }
    }

    fn skip(&mut self, key: &str, reason: String) {
        self.left_out.push(LeftOut {
            part: Part::Domain,
            name: key.to_owned(),
            reason,
        });
    }

    fn camera(&mut self, scene: &Scene) {
        let camera = &scene.camera;
        self.map("camera.filter", camera.filter.as_ref());
        if camera.filter.is_none() {
            self.skip(
                "camera.filter",
                "no filter: samples are at a pixel's centre".into(),
            );
        }
        self.map("camera.lens", camera.lens.as_ref());
        if camera.lens.is_none() {
            self.skip("camera.lens", "no aperture: the camera is a pinhole".into());
        }
        match &camera.shutter {
            Some(Stated { value, cause }) if value[0] < value[1] => {
                self.push("camera.time".into(), Draw::Between(*value), cause);
            }
            Some(Stated { cause, .. }) => {
                self.skip("camera.time", format!("open for an instant ({cause})"));
            }
            None => self.skip("camera.time", "no shutter: nothing moves".into()),
        }
    }

    fn lights(&mut self, scene: &Scene) -> Result<()> {
        let lights = &scene.lights;
        let powers: Vec<f64> = lights.iter().map(|light| light.power).collect();
        if !powers.is_empty() {
            weights(&powers, "lights", "power")?;
        }
        match &lights[..] {
            [] => self.skip("light.choice", "the scene has no light".into()),
            [one] => self.skip("light.choice", format!("one light alone ({})", one.cause)),
            // A choice there is because of the second.
            [_, two, ..] => self.push("light.choice".into(), Draw::Choice(powers), &two.cause),
        }
        let base = self.next;
        for light in lights {
            self.next = base;
            let key = format!("light.{}", light.name);
            match &light.emitter {
                _ if light.power == 0.0 => {
                    self.skip(
                        &key,
                        format!("never chosen: its power is 0 ({})", light.cause),
                    );
                }
                Emitter::Delta(kind) => {
                    self.skip(
                        &key,
                        format!("a {kind} light is not drawn ({})", light.cause),
                    );
                }
                Emitter::Area(mapping) => self.push(key, Draw::Map(mapping.clone()), &light.cause),
                Emitter::Mesh(areas) => {
                    weights(areas, &key, "area")?;
                    let choice = format!("{key}.triangle");
                    match areas.len() {
                        1 => self.skip(&choice, format!("one triangle alone ({})", light.cause)),
                        _ => self.push(choice, Draw::Choice(areas.clone()), &light.cause),
                    }
                    let point = Draw::Map(barycentric()?);
                    self.push(format!("{key}.point"), point, &light.cause);
                }
            }
        }
        self.next = self.end;
        Ok(())
    }

    fn materials(&mut self, scene: &Scene) -> Result<()> {
        let base = self.next;
        for material in &scene.materials {
            self.next = base;
            let key = format!("material.{}", material.name);
            let shares: Vec<f64> = material.lobes.iter().map(|lobe| lobe.weight).collect();
            if !shares.is_empty() {
                weights(&shares, &key, "weight")?;
            }
            let choice = format!("{key}.lobe");
            match &material.lobes[..] {
                [] => self.skip(&choice, format!("it scatters nothing ({})", material.cause)),
                [one] => self.skip(&choice, format!("one lobe alone ({})", one.cause)),
                _ => self.push(choice, Draw::Choice(shares), &material.cause),
            }
            let base = self.next;
            for lobe in &material.lobes {
                self.next = base;
                let key = format!("{key}.{}", lobe.name);
                match &lobe.map {
                    _ if lobe.weight == 0.0 => {
                        self.skip(
                            &key,
                            format!("never chosen: its weight is 0 ({})", lobe.cause),
                        );
                    }
                    Some(mapping) => self.push(key, Draw::Map(mapping.clone()), &lobe.cause),
                    None => {
                        let cause = &lobe.cause;
                        self.skip(&key, format!("smooth: it has one direction ({cause})"));
                    }
                }
            }
        }
        self.next = self.end;
        Ok(())
    }

    fn media(&mut self, scene: &Scene) {
        let base = self.next;
        for medium in &scene.media {
            self.next = base;
            let key = format!("medium.{}", medium.name);
            for (what, stated) in [("distance", &medium.distance), ("phase", &medium.phase)] {
                let key = format!("{key}.{what}");
                self.map(&key, stated.as_ref());
                if stated.is_none() {
                    self.skip(&key, format!("none is stated ({})", medium.cause));
                }
            }
        }
        self.next = self.end;
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

/// Refuses weights that are none, or of which none is above 0.
fn weights(all: &[f64], of: &str, what: &str) -> Result<()> {
    if let Some(wrong) = all.iter().find(|w| !(w.is_finite() && **w >= 0.0)) {
        return Err(refused(
            format!("{of}: {what} {wrong}"),
            "a weight is finite and at least 0",
            "mend it",
        ));
    }
    if all.iter().any(|w| *w > 0.0) {
        return Ok(());
    }
    Err(refused(
        format!("{of}: each {what} is 0"),
        "something must be drawn",
        "drop what does not count, or give one more than 0",
    ))
}

pub(super) fn refused(asked: String, limit: &str, remedy: &str) -> Error {
    Error::Arguments {
        asked,
        limit: limit.to_owned(),
        remedy: remedy.to_owned(),
    }
}
