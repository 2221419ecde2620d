//! What nothing in a scene reaches, and why.

use super::Scene;
use super::kinds::{Place, places};
use super::needs::{Domain, Draw};
use crate::catalog::{Map, Request, SEQUENCES, maps};

/// What kind of thing is left out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// Something that scenes may draw, and this one does not.
    Domain,
    /// A map of the catalogue.
    Map,
    /// A sequence.
    Sequence,
    /// A randomisation of the scene's own sequence.
    Scramble,
}

impl Part {
    /// The word in tables.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Domain => "domain",
            Self::Map => "map",
            Self::Sequence => "sequence",
            Self::Scramble => "scramble",
        }
    }
}

/// Something that is left out.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LeftOut {
    /// What kind of thing.
    pub part: Part,
    /// Its name.
    pub name: String,
    /// Why.
    pub reason: String,
}

/// Maps, sequences and scrambles of the catalogue.
pub(super) fn catalogue(scene: &Scene, domains: &[Domain], request: &Request) -> Vec<LeftOut> {
    let reached: Vec<&Map> = domains
        .iter()
        .filter_map(|one| Some(one.draw.mapping()?.map()))
        .collect();
    let unreached = maps().filter(|map| !reached.contains(map));
    let mut all: Vec<LeftOut> = unreached
        .map(|map| LeftOut {
            part: Part::Map,
            name: map.name.to_owned(),
            reason: reason(map, domains),
        })
        .collect();
    let sampler = &scene.sampler;
    let chosen = format!(
        "the sampler is {} ({})",
        sampler.value.name(),
        sampler.cause
    );
    for sequence in SEQUENCES.iter().filter(|one| **one != request.sequence) {
        all.push(LeftOut {
            part: Part::Sequence,
            name: sequence.name().to_owned(),
            reason: chosen.clone(),
        });
    }
    let own = request.sequence.scrambles();
    for scramble in own.iter().filter(|one| **one != request.scramble) {
        all.push(LeftOut {
            part: Part::Scramble,
            name: scramble.name().to_owned(),
            reason: chosen.clone(),
        });
    }
    all
}

/// Why no domain goes through a map.
fn reason(map: &Map, domains: &[Domain]) -> String {
    let places = places(map);
    if places.is_empty() {
        return "nothing that a scene describes goes through it".to_owned();
    }
    let said = places.iter().map(|place| {
        let others = domains.iter().filter(|domain| stands(*place, domain));
        let others: Vec<&Domain> = others.collect();
        let word = place.word();
        match &others[..] {
            [] => format!("there is no {word}"),
            [one] => format!("the {word} is another ({})", one.cause),
            many => format!("the {} {word}s are others", many.len()),
        }
    });
    said.collect::<Vec<_>>().join(", and ")
}

/// Whether a domain stands in a place.
fn stands(place: Place, domain: &Domain) -> bool {
    let Draw::Map(mapping) = &domain.draw else {
        return false;
    };
    let of = |prefix: &str| domain.key.starts_with(prefix);
    let there = match place {
        Place::Filter => of("camera.filter"),
        Place::Lens => of("camera.lens"),
        Place::Light | Place::Environment => of("light."),
        Place::Lobe => of("material."),
        Place::Distance => domain.key.ends_with(".distance"),
        Place::Phase => domain.key.ends_with(".phase"),
    };
    there && places(mapping.map()).contains(&place)
}
