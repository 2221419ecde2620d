//! The objects of a scene, where they are.

use super::container::BROKEN;
use super::named;
use crate::Result;
use crate::scene::refused;
use glam::{DMat4, DQuat, DVec3};
use gltf::json::extensions::scene::khr_lights_punctual::Light;
use gltf::json::mesh::{Primitive, Semantic};
use gltf::json::validation::Checked;
use gltf::json::{Root, Value, scene::Node};
use std::path::Path;

/// The most primitives that nodes may show, those of shared meshes counted again.
const MOST_PRIMITIVES: usize = 1 << 20;

/// An object, and the node's transform to the world.
pub(super) struct Placed {
    /// The number of the object.
    pub(super) index: usize,
    /// Its node.
    pub(super) node: usize,
    pub(super) world: DMat4,
}

/// The objects of a file's default scene, in the order of its trees.
pub(super) struct Walk<'r> {
    pub(super) root: &'r Root,
    pub(super) cameras: Vec<Placed>,
    pub(super) lights: Vec<Placed>,
    meshes: Vec<Placed>,
}

impl<'r> Walk<'r> {
    /// Walks the trees of the default scene, or of the first where none is named.
    pub(super) fn of(root: &'r Root, path: &Path) -> Result<Self> {
        let scene = root.scene.map_or(0, |index| index.value());
        let Some(scene) = root.scenes.get(scene) else {
            return Err(refused(path, "it has no scene", BROKEN));
        };
        let mut walk = Self {
            root,
            cameras: Vec::new(),
            lights: Vec::new(),
            meshes: Vec::new(),
        };
        let mut met = vec![false; root.nodes.len()];
        let trees = scene.nodes.iter().rev();
        let mut waiting: Vec<(usize, DMat4)> = trees
            .map(|index| (index.value(), DMat4::IDENTITY))
            .collect();
        let mut primitives = 0;
        while let Some((index, parent)) = waiting.pop() {
            let (Some(node), Some(met)) = (root.nodes.get(index), met.get_mut(index)) else {
                continue;
            };
            if std::mem::replace(met, true) {
                let node = named("node", index, node.name.as_deref());
                let problem = format!("{node} is reached twice: nodes form trees");
                return Err(refused(path, problem, BROKEN));
            }
            let world = parent * local(node);
            if !world.is_finite() {
                let node = named("node", index, node.name.as_deref());
                let problem = format!("the transform of {node} is not finite");
                return Err(refused(path, problem, BROKEN));
            }
            primitives += walk.place(index, node, world);
            if primitives > MOST_PRIMITIVES {
                let problem = "its nodes show more than 2^20 primitives";
                return Err(refused(path, problem, "split the scene"));
            }
            let children = node.children.iter().flatten().rev();
            waiting.extend(children.map(|child| (child.value(), world)));
        }
        Ok(walk)
    }

    /// Takes what a node holds, and says how many primitives.
    fn place(&mut self, node: usize, json: &Node, world: DMat4) -> usize {
        let placed = |index| Placed { index, node, world };
        self.cameras
            .extend(json.camera.map(|index| placed(index.value())));
        let extensions = json.extensions.as_ref();
        let light = extensions.and_then(|all| all.khr_lights_punctual.as_ref());
        self.lights
            .extend(light.map(|light| placed(light.light.value())));
        let Some(mesh) = json.mesh else { return 0 };
        self.meshes.push(placed(mesh.value()));
        let mesh = self.root.meshes.get(mesh.value());
        mesh.map_or(0, |mesh| mesh.primitives.len())
    }

    /// The primitives, with their places.
    pub(super) fn primitives(&self) -> impl Iterator<Item = (&Placed, &'r Primitive)> {
        self.meshes.iter().flat_map(|placed| {
            let mesh = self.root.meshes.get(placed.index);
            let primitives = mesh.into_iter().flat_map(|mesh| &mesh.primitives);
            primitives.map(move |primitive| (placed, primitive))
        })
    }

    /// The punctual lights of the file.
    pub(super) fn punctual(&self) -> &'r [Light] {
        let extensions = self.root.extensions.as_ref();
        let lights = extensions.and_then(|all| all.khr_lights_punctual.as_ref());
        lights.map_or(&[], |lights| &lights.lights)
    }

    /// The radius of a sphere around all meshes, by the bounds that accessors state; 1 where
    /// there is none.
    pub(super) fn radius(&self) -> f64 {
        let (mut low, mut high) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
        for (placed, primitive) in self.primitives() {
            let index = primitive
                .attributes
                .get(&Checked::Valid(Semantic::Positions));
            let accessor = index.and_then(|index| self.root.accessors.get(index.value()));
            let bounds = accessor.map(|one| [bound(one.min.as_ref()), bound(one.max.as_ref())]);
            let Some([Some(least), Some(most)]) = bounds else {
                continue;
            };
            for corner in 0..8 {
                let pick = |axis: usize| if corner >> axis & 1 == 0 { least } else { most };
                let corner = DVec3::new(pick(0).x, pick(1).y, pick(2).z);
                let point = placed.world.transform_point3(corner);
                (low, high) = (low.min(point), high.max(point));
            }
        }
        let radius = 0.5 * (high - low).length();
        if radius.is_finite() && radius > 0.0 {
            radius
        } else {
            1.0
        }
    }
}

fn bound(value: Option<&Value>) -> Option<DVec3> {
    let list = value?.as_array()?;
    let axis = |index: usize| list.get(index)?.as_f64();
    Some(DVec3::new(axis(0)?, axis(1)?, axis(2)?))
}

fn local(node: &Node) -> DMat4 {
    if let Some(matrix) = node.matrix {
        return DMat4::from_cols_array(&matrix.map(f64::from));
    }
    let vector = |v: Option<[f32; 3]>, otherwise| v.map_or(otherwise, |v| v.map(f64::from).into());
    let rotation = node.rotation.map_or([0.0, 0.0, 0.0, 1.0], |r| r.0);
    DMat4::from_scale_rotation_translation(
        vector(node.scale, DVec3::ONE),
        DQuat::from_array(rotation.map(f64::from)),
        vector(node.translation, DVec3::ZERO),
    )
}
