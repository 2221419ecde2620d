//! The words of scene files, and the maps that they stand for.

use crate::catalog::Map;

/// Where in a scene a map may stand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Place {
    /// The offset in a pixel.
    Filter,
    /// The aperture.
    Lens,
    /// An area light.
    Light,
    /// The light of a picture.
    Environment,
    /// A lobe of a material.
    Lobe,
    /// The distance to a collision.
    Distance,
    /// The direction after it.
    Phase,
}

/// A word, and its map.
pub(super) type Kind = (&'static str, &'static str);

/// What a lobe of these is called is what its direction is used for: `clearcoat` reflects, and
/// `transmission` refracts at a visible normal.
const KINDS: &[(Place, &[Kind])] = &[
    (
        Place::Filter,
        &[
            ("box", "filter-box"),
            ("tent", "filter-tent"),
            ("gaussian", "filter-gaussian"),
            ("blackman-harris", "filter-blackman-harris"),
            ("mitchell", "filter-mitchell"),
        ],
    ),
    (
        Place::Lens,
        &[
            ("disk", "concentric-disk"),
            ("disk-polar", "polar-disk"),
            ("polygon", "regular-polygon"),
            ("annulus", "annulus"),
        ],
    ),
    (
        Place::Light,
        &[
            ("triangle", "triangle"),
            ("spherical-triangle", "spherical-triangle"),
            ("rectangle", "spherical-rectangle"),
            ("disk", "disk-light"),
            ("sphere", "sphere-light"),
            ("cone", "cone"),
            ("uniform", "uniform-sphere"),
        ],
    ),
    (
        Place::Environment,
        &[
            ("hierarchical", "environment"),
            ("alias", "environment-alias"),
        ],
    ),
    (
        Place::Lobe,
        &[
            ("diffuse", "cosine-hemisphere"),
            ("diffuse-polar", "cosine-hemisphere-polar"),
            ("uniform", "uniform-hemisphere"),
            ("cosine-power", "cosine-power-hemisphere"),
            ("ggx", "ggx-vndf"),
            ("ggx-cap", "ggx-vndf-cap"),
            ("ggx-bounded", "ggx-vndf-bounded"),
            ("clearcoat", "ggx-vndf"),
            ("transmission", "ggx-vndf-normal"),
            ("beckmann", "beckmann"),
            ("beckmann-transmission", "beckmann-normal"),
            ("hair", "normal-pair"),
            ("hair-polar", "box-muller"),
        ],
    ),
    (Place::Distance, &[("homogeneous", "exponential")]),
    (
        Place::Phase,
        &[
            ("henyey-greenstein", "henyey-greenstein"),
            ("isotropic", "uniform-sphere"),
        ],
    ),
];

impl Place {
    /// The words that it takes.
    pub(super) fn kinds(self) -> &'static [Kind] {
        let found = KINDS.iter().find(|(place, _)| *place == self);
        found.map_or(&[], |(_, kinds)| kinds)
    }

    /// What stands there.
    pub(super) fn word(self) -> &'static str {
        match self {
            Self::Filter => "pixel filter",
            Self::Lens => "lens",
            Self::Light => "area light",
            Self::Environment => "environment",
            Self::Lobe => "lobe",
            Self::Distance => "medium",
            Self::Phase => "phase function",
        }
    }
}

/// The places where a map may stand.
pub(super) fn places(map: &Map) -> Vec<Place> {
    let holds = |kinds: &[Kind]| kinds.iter().any(|(_, name)| *name == map.name);
    let places = KINDS.iter().filter(|(_, kinds)| holds(kinds));
    places.map(|(place, _)| *place).collect()
}
