//! Scenes of glTF 2.0 files: what their lights, materials and camera draw.
//!
//! glTF knows neither samplers nor budgets, pixel filters, environments or apertures. The first
//! two are the defaults of [`Scene`], and a scene file with `gltf = "FILE"` states them; a camera has the filter of the pixel's square, and a lens
//! where its `extras` have an `aperture` above 0. Texels are not read: a factor above 0 is taken
//! to count somewhere.

mod buffers;
mod container;
mod light;
mod material;
mod names;
mod nodes;

use super::{Camera, Cause, Scene, Stated, mapping, name_of};
use crate::Result;
use buffers::Buffers;
use names::Names;
use nodes::{Placed, Walk};
use std::collections::BTreeSet;
use std::path::Path;

/// The most bytes of a file, and of all its buffers together: 2^30.
pub const MOST_BYTES: u64 = 1 << 30;

/// The most bytes of its JSON: 2^26.
pub const MOST_JSON: u64 = 1 << 26;

/// The most triangles that emit: 2^22.
pub const MOST_TRIANGLES: usize = 1 << 22;

/// Extensions that a file may require. Those of textures change no draw, and those of volumes,
/// iridescence and dispersion only what a direction weighs.
pub const SUPPORTED: &[&str] = &[
    "EXT_texture_webp",
    "KHR_lights_punctual",
    "KHR_materials_anisotropy",
    "KHR_materials_clearcoat",
    "KHR_materials_dispersion",
    "KHR_materials_emissive_strength",
    "KHR_materials_ior",
    "KHR_materials_iridescence",
    "KHR_materials_sheen",
    "KHR_materials_specular",
    "KHR_materials_transmission",
    "KHR_materials_unlit",
    "KHR_materials_variants",
    "KHR_materials_volume",
    "KHR_texture_basisu",
    "KHR_texture_transform",
];

/// Reads a `.gltf` or `.glb` file, and of its buffers those with triangles that emit, from its
/// folder alone.
pub(super) fn read(path: &Path) -> Result<Scene> {
    let opened = container::open(path)?;
    let root = opened.document.as_json();
    let walk = Walk::of(root, path)?;
    let mut scene = Scene::new(name_of(path))?;
    scene.found = opened.unread.clone();
    camera(&mut scene, &walk)?;
    materials(&mut scene, &walk)?;
    let mut buffers = Buffers::new(root, opened.blob.as_deref(), path);
    light::lights(&mut scene, &walk, &mut buffers)?;
    Ok(scene)
}

/// The camera that is met first.
fn camera(scene: &mut Scene, walk: &Walk) -> Result<()> {
    let Some(Placed { index, .. }) = walk.cameras.first() else {
        scene
            .found
            .push("no camera: no filter, lens or shutter".into());
        return Ok(());
    };
    let cameras = &walk.root.cameras;
    let camera = cameras.get(*index);
    let said = named("camera", *index, camera.and_then(|one| one.name.as_deref()));
    if walk.cameras.len() > 1 {
        let many = walk.cameras.len();
        scene
            .found
            .push(format!("{many} cameras, of which {said} is met first"));
    }
    scene.camera = Camera {
        filter: Some(Stated {
            value: mapping("filter-box", &[("radius", &[0.5])])?,
            cause: Cause::new(format!("{said}: glTF has no filter but the pixel's square")),
        }),
        ..Camera::default()
    };
    let extras = camera.and_then(|one| one.extras.as_ref());
    let extras: Option<serde_json::Value> =
        extras.and_then(|extras| serde_json::from_str(extras.get()).ok());
    let aperture = extras
        .as_ref()
        .and_then(|extras| extras["aperture"].as_f64());
    match aperture {
        Some(aperture) if aperture > 0.0 => {
            scene.camera.lens = Some(Stated {
                value: mapping("concentric-disk", &[])?,
                cause: Cause::new(format!("{said}: extras.aperture {aperture}")),
            });
        }
        _ => scene
            .found
            .push(format!("{said} has no aperture in its extras: a pinhole")),
    }
    Ok(())
}

/// The materials of meshes that the scene shows, in the order of the file.
fn materials(scene: &mut Scene, walk: &Walk) -> Result<()> {
    let used: BTreeSet<Option<usize>> = walk
        .primitives()
        .map(|(_, primitive)| primitive.material.map(|index| index.value()))
        .collect();
    let mut names = Names::default();
    for &index in &used {
        let json = index.and_then(|index| walk.root.materials.get(index));
        scene
            .materials
            .push(material::material(index, json, &mut names)?);
    }
    let all = walk.root.materials.len();
    let shown = used.iter().flatten().count();
    scene.found.push(format!(
        "{shown} of {all} materials are on a mesh of the scene"
    ));
    Ok(())
}

/// An object as messages name it.
fn named(what: &str, index: usize, name: Option<&str>) -> String {
    match name {
        Some(name) => format!("{what} {index} `{}`", names::short(name)),
        None => format!("{what} {index}"),
    }
}
