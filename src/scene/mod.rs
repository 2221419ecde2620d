//! What a renderer of one scene draws: read from a description or from a glTF file.
//!
//! A [`Scene`] says which things need random numbers; [`Needs`] turns them into domains: a map
//! with its parameters, the dimensions of the points that it takes, and why. Whatever is not
//! there is left out, with the reason.
//!
//! ```
//! use corput::scene::{Needs, parse};
//!
//! let text = "samples = 64\n[[material]]\nlobes = [{ kind = \"diffuse\" }]\n";
//! let scene = parse(text, "room.toml".as_ref())?;
//! let needs = Needs::of(&scene)?;
//! assert_eq!(needs.domains[0].key, "material.0.diffuse");
//! assert_eq!(needs.dimensions(), 2);
//! # Ok::<(), corput::Error>(())
//! ```

mod choice;
mod document;
mod file;
mod gltf;
mod kinds;
mod layout;
mod left_out;
mod light;
mod needs;
mod record;
mod surface;
mod table;
mod target;

pub use choice::{Choice, Share};
pub use document::{SCHEMA, document};
pub use file::{LONGEST, parse};
pub use gltf::{MOST_BYTES, MOST_JSON, MOST_TRIANGLES, SUPPORTED};
pub use left_out::{LeftOut, Part};
pub use needs::{Domain, Draw, Needs};
pub use record::{Field, Record, Span};
pub use target::{GROUP, PUSH_BYTES, Target};

use crate::catalog::{Mapping, Profile, Sampler, Scramble, Sequence};
use crate::{Error, Result};
use std::fmt;
use std::path::Path;

/// What decided something: a line of a scene file, or an object of a glTF file.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Cause {
    /// The line, from 1; `None` where the cause is no line.
    pub line: Option<usize>,
    /// The line's text, or the object with what it says.
    pub text: String,
}

impl Cause {
    /// A cause that is no line.
    #[must_use]
    pub fn new(text: impl Into<String>) -> Self {
        Self {
            line: None,
            text: text.into(),
        }
    }
}

impl fmt::Display for Cause {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.line {
            Some(line) => write!(f, "line {line}: {}", self.text),
            None => f.write_str(&self.text),
        }
    }
}

/// A value, and what decided it.
#[derive(Clone, Debug, PartialEq)]
pub struct Stated<T> {
    /// The value.
    pub value: T,
    /// What decided it.
    pub cause: Cause,
}

/// What a renderer draws from. Positions and colours that need no random number are not here.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    /// The name of its files.
    pub name: String,
    /// The points.
    pub sampler: Stated<Sampler>,
    /// Samples of a pixel, 1 to 2^32: how many points there will ever be.
    pub samples: Stated<u64>,
    /// The seed of what is random.
    pub seed: u64,
    /// Whose functions the maps use.
    pub profile: Profile,
    /// Limits of the device.
    pub target: Target,
    /// The camera.
    pub camera: Camera,
    /// The lights, an environment among them.
    pub lights: Vec<Light>,
    /// The surfaces.
    pub materials: Vec<Material>,
    /// The volumes.
    pub media: Vec<Medium>,
    /// What was found besides, a sentence each: of a glTF file, what was counted and not read.
    pub found: Vec<String>,
}

/// Points, and samples, where a scene names none.
const SAMPLER: (Sequence, Scramble) = (Sequence::Sobol, Scramble::OwenHash);
const SAMPLES: u64 = 1024;

impl Scene {
    /// A scene of nothing: 1024 samples of Owen-scrambled Sobol points by hashes.
    ///
    /// # Errors
    /// None that can be met: the default sampler exists.
    pub fn new(name: impl Into<String>) -> Result<Self> {
        let by_default = Cause::new("by default");
        Ok(Self {
            name: name.into(),
            sampler: Stated {
                value: Sampler::new(SAMPLER.0, Some(SAMPLER.1))?,
                cause: by_default.clone(),
            },
            samples: Stated {
                value: SAMPLES,
                cause: by_default,
            },
            seed: 0,
            profile: Profile::Exact,
            target: Target::default(),
            camera: Camera::default(),
            lights: Vec::new(),
            materials: Vec::new(),
            media: Vec::new(),
            found: Vec::new(),
        })
    }
}

/// What a camera draws.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Camera {
    /// The offset in a pixel; its centre where there is none.
    pub filter: Option<Stated<Mapping>>,
    /// The place on the lens; a pinhole where there is none.
    pub lens: Option<Stated<Mapping>>,
    /// When the shutter opens and closes; equal for an instant.
    pub shutter: Option<Stated<[f64; 2]>>,
}

/// A light.
#[derive(Clone, Debug, PartialEq)]
pub struct Light {
    /// Its name in keys: unique among the lights.
    pub name: String,
    /// Its weight in the choice among lights, in a unit that all share.
    pub power: f64,
    /// What it shines from.
    pub emitter: Emitter,
    /// What decided it.
    pub cause: Cause,
}

/// What a light shines from.
#[derive(Clone, Debug, PartialEq)]
pub enum Emitter {
    /// A point or a direction, which is not drawn: its kind.
    Delta(&'static str),
    /// An area, a solid angle or an environment.
    Area(Mapping),
    /// Triangles of these weights, and a point of the one that is chosen.
    Mesh(Vec<f64>),
}

/// A surface's material.
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// Its name in keys: unique among the materials.
    pub name: String,
    /// Its lobes.
    pub lobes: Vec<Lobe>,
    /// What decided it.
    pub cause: Cause,
}

/// A lobe of a material.
#[derive(Clone, Debug, PartialEq)]
pub struct Lobe {
    /// Its name in keys: unique within the material.
    pub name: String,
    /// Its weight in the choice among the material's lobes.
    pub weight: f64,
    /// How directions are drawn; `None` of a mirror, which has one.
    pub map: Option<Mapping>,
    /// What decided it.
    pub cause: Cause,
}

/// A volume that scatters.
#[derive(Clone, Debug, PartialEq)]
pub struct Medium {
    /// Its name in keys: unique among the media.
    pub name: String,
    /// The distance to the next collision.
    pub distance: Option<Stated<Mapping>>,
    /// The direction after it.
    pub phase: Option<Stated<Mapping>>,
    /// What decided it.
    pub cause: Cause,
}

/// Reads a scene: of glTF where the name ends in `.gltf` or `.glb`, else a scene file. Its
/// name is the file's.
///
/// # Errors
/// [`Error::Scene`] for a file that cannot be read, or says what cannot be.
pub fn read(path: &Path) -> Result<Scene> {
    let ending = path.extension().map(|e| e.to_string_lossy().to_lowercase());
    match ending.as_deref() {
        Some("gltf" | "glb") => {
            let mut scene = gltf::read(path)?;
            let line = "no environment: core glTF has none, and EXT_lights_image_based is not read; a scene file may add one";
            scene.found.push(line.into());
            Ok(scene)
        }
        _ => file::read(path),
    }
}

/// The name of a scene: that of its file without the ending.
fn name_of(path: &Path) -> String {
    let stem = path.file_stem().map(|stem| stem.to_string_lossy());
    stem.map_or_else(|| "scene".to_owned(), std::borrow::Cow::into_owned)
}

fn refused(path: &Path, problem: impl Into<String>, remedy: impl Into<String>) -> Error {
    Error::Scene {
        path: path.to_owned(),
        problem: problem.into(),
        remedy: remedy.into(),
    }
}

/// The map of a catalogue's name with some of its parameters.
fn mapping(name: &str, given: &[(&str, &[f64])]) -> Result<Mapping> {
    Mapping::new(crate::catalog::Map::from_name(name)?, given)
}

/// The unit triangle: its samples are barycentric coordinates of any other.
fn barycentric() -> Result<Mapping> {
    let vertices: [(&str, &[f64]); 3] =
        [("a", &[0.0, 0.0]), ("b", &[1.0, 0.0]), ("c", &[0.0, 1.0])];
    mapping("triangle", &vertices)
}
