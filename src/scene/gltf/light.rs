//! Punctual lights, and triangles that emit.

use super::buffers::{Buffers, Elements};
use super::material::{emission, luminance};
use super::names::Names;
use super::nodes::{Placed, Walk};
use super::{MOST_TRIANGLES, named};
use crate::Result;
use crate::scene::{Cause, Emitter, Light, Scene};
use gltf::json::accessor::{ComponentType, Type};
use gltf::json::extensions::scene::khr_lights_punctual::{Light as Punctual, Type as Kind};
use gltf::json::mesh::{Mode, Primitive, Semantic};
use gltf::json::validation::Checked;
use std::f64::consts::PI;

/// The lights of a scene; their powers are luminous fluxes in lumens.
pub(super) fn lights(scene: &mut Scene, walk: &Walk, buffers: &mut Buffers) -> Result<()> {
    let mut names = Names::default();
    emissive(scene, walk, buffers, &mut names)?;
    let radius = walk.radius();
    let mut dark = 0;
    for placed in &walk.lights {
        let Some(light) = walk.punctual().get(placed.index) else {
            continue;
        };
        let (kind, flux) = flux(light, radius);
        if flux <= 0.0 {
            dark += 1;
            continue;
        }
        let said = named("light", placed.index, light.name.as_deref());
        scene.lights.push(Light {
            name: names.give(light.name.as_deref(), scene.lights.len()),
            power: flux,
            emitter: Emitter::Delta(kind),
            cause: Cause::new(format!("{said} of node {}: {kind}", placed.node)),
        });
    }
    if dark > 0 {
        scene
            .found
            .push(format!("punctual lights without intensity: {dark}"));
    }
    Ok(())
}

/// The kind, and the flux: of a directional light that through the scene's sphere.
fn flux(light: &Punctual, radius: f64) -> (&'static str, f64) {
    let intensity = f64::from(light.intensity) * luminance(light.color);
    match light.type_ {
        Checked::Valid(Kind::Directional) => ("directional", intensity * PI * radius * radius),
        Checked::Valid(Kind::Spot) => {
            let angle = light.spot.as_ref().map_or(PI / 4.0, |spot| {
                f64::from(spot.outer_cone_angle).clamp(0.0, PI / 2.0)
            });
            let half = (0.5 * angle).sin();
            ("spot", intensity * 4.0 * PI * half * half)
        }
        _ => ("point", intensity * 4.0 * PI),
    }
}

/// All triangles that emit, as one light: a triangle is chosen by its flux.
fn emissive(
    scene: &mut Scene,
    walk: &Walk,
    buffers: &mut Buffers,
    names: &mut Names,
) -> Result<()> {
    let mut weights = Vec::new();
    let mut cause: Option<String> = None;
    let (mut primitives, mut without) = (0, 0);
    for (placed, primitive) in walk.primitives() {
        let Some(index) = primitive.material.map(|index| index.value()) else {
            continue;
        };
        let Some(material) = walk.root.materials.get(index) else {
            continue;
        };
        let radiance = emission(material);
        if radiance <= 0.0 {
            continue;
        }
        let before = weights.len();
        areas(buffers, placed, primitive, radiance, &mut weights)?;
        if weights.len() == before {
            without += 1;
            continue;
        }
        primitives += 1;
        let said = named("material", index, material.name.as_deref());
        cause.get_or_insert_with(|| format!("{said} emits, on node {}", placed.node));
    }
    if without > 0 {
        let line = format!("primitives that emit and are no triangles: {without}; no light");
        scene.found.push(line);
    }
    let Some(mut cause) = cause else {
        return Ok(());
    };
    let flux: f64 = PI * weights.iter().sum::<f64>();
    if flux <= 0.0 || !flux.is_finite() {
        let problem = format!("a light of area 0, or not finite: {cause}");
        return Err(buffers.refuse(problem));
    }
    if primitives > 1 {
        cause = format!("{cause}, and {} more primitives", primitives - 1);
    }
    let empty = weights.iter().filter(|weight| **weight == 0.0).count();
    let triangles = weights.len();
    scene.found.push(format!(
        "triangles that emit: {triangles}, {empty} of them of area 0; primitives: {primitives}"
    ));
    scene.lights.push(Light {
        name: names.give(Some("emissive"), 0),
        power: flux,
        emitter: Emitter::Mesh(weights),
        cause: Cause::new(cause),
    });
    Ok(())
}

/// Appends the area of each triangle in the world, times a factor.
fn areas(
    buffers: &mut Buffers,
    placed: &Placed,
    primitive: &Primitive,
    radiance: f64,
    weights: &mut Vec<f64>,
) -> Result<()> {
    let Checked::Valid(mode) = primitive.mode else {
        return Ok(());
    };
    let positions = primitive
        .attributes
        .get(&Checked::Valid(Semantic::Positions));
    let Some(positions) = positions else {
        return Ok(());
    };
    let positions = buffers.elements(positions.value(), Type::Vec3, &[ComponentType::F32])?;
    let unsigned = [ComponentType::U8, ComponentType::U16, ComponentType::U32];
    let indices = primitive.indices.map(|index| index.value());
    let indices = indices.map(|index| buffers.elements(index, Type::Scalar, &unsigned));
    let indices = indices.transpose()?;
    let count = indices.map_or(positions.count, |indices| indices.count);
    let triangles = match mode {
        Mode::Triangles => count / 3,
        Mode::TriangleStrip | Mode::TriangleFan => count.saturating_sub(2),
        _ => 0,
    };
    if triangles > MOST_TRIANGLES - weights.len() {
        return Err(buffers.refuse("more than 2^22 triangles emit"));
    }
    for triangle in 0..triangles {
        let corners = match mode {
            Mode::TriangleStrip => [triangle, triangle + 1, triangle + 2],
            Mode::TriangleFan => [0, triangle + 1, triangle + 2],
            _ => [3 * triangle, 3 * triangle + 1, 3 * triangle + 2],
        };
        let corner = |at| vertex(buffers, positions, indices, at);
        let [Some(a), Some(b), Some(c)] = corners.map(corner) else {
            let problem = format!("a triangle of node {} has no vertex", placed.node);
            return Err(buffers.refuse(problem));
        };
        let [a, b, c] = [a, b, c].map(|point| placed.world.transform_point3(point));
        weights.push(radiance * 0.5 * (b - a).cross(c - a).length());
    }
    Ok(())
}

fn vertex(
    buffers: &Buffers,
    positions: Elements,
    indices: Option<Elements>,
    at: usize,
) -> Option<glam::DVec3> {
    let index = match indices {
        Some(indices) => buffers.index(indices, at)?,
        None => at,
    };
    buffers.position(positions, index)
}
