//! Lobes of the metallic-roughness model and of its extensions.

use super::named;
use super::names::Names;
use crate::Result;
use crate::scene::{Cause, Lobe, Material, mapping};
use gltf::json::{Material as Json, Value};

/// Roughness whose square is below this is that of a mirror: no map takes less.
const LEAST_ALPHA: f64 = 1e-7;

/// The lobes of a material; of `None`, of the default one, a rough metal.
pub(super) fn material(
    index: Option<usize>,
    json: Option<&Json>,
    names: &mut Names,
) -> Result<Material> {
    let default = Json::default();
    let (said, name) = match index {
        Some(index) => {
            let name = json.and_then(|one| one.name.as_deref());
            (named("material", index, name), names.give(name, index))
        }
        None => (
            "the default material".to_owned(),
            names.give(Some("default"), usize::MAX),
        ),
    };
    let lobes = lobes(json.unwrap_or(&default), &said)?;
    let cause = Cause::new(format!("{said}: {} of its lobes count", lobes.len()));
    Ok(Material { name, lobes, cause })
}

/// The radiance that it emits per area and solid angle, as luminance, on as many of its sides.
pub(super) fn emission(json: &Json) -> f64 {
    let strength = json
        .extensions
        .as_ref()
        .and_then(|all| all.emissive_strength.as_ref());
    let strength = strength.map_or(1.0, |one| f64::from(one.emissive_strength.0));
    let sides = if json.double_sided { 2.0 } else { 1.0 };
    sides * strength * luminance(json.emissive_factor.0)
}

/// Of linear RGB with the primaries of Rec. 709.
pub(super) fn luminance(rgb: [f32; 3]) -> f64 {
    let [r, g, b] = rgb.map(f64::from);
    0.2126 * r + 0.7152 * g + 0.0722 * b
}

/// A factor of an extension that the crate does not know.
fn factor(json: &Json, extension: &str, name: &str, otherwise: f64) -> Option<f64> {
    let value = json.extensions.as_ref()?.others.get(extension)?;
    Some(value.get(name).and_then(Value::as_f64).unwrap_or(otherwise))
}

fn lobes(json: &Json, said: &str) -> Result<Vec<Lobe>> {
    let extensions = json.extensions.as_ref();
    if extensions.is_some_and(|all| all.unlit.is_some()) {
        return Ok(Vec::new());
    }
    let model = &json.pbr_metallic_roughness;
    let [red, green, blue, _] = model.base_color_factor.0;
    let colour = luminance([red, green, blue]) > 0.0;
    let metallic = f64::from(model.metallic_factor.0);
    let roughness = f64::from(model.roughness_factor.0);
    // A texture multiplies the factors by 0 to 1.
    let textured = model.metallic_roughness_texture.is_some();
    let times = if textured { ", times a texture" } else { "" };
    let transmission = extensions.and_then(|all| all.transmission.as_ref());
    let transmitted = transmission.map_or(0.0, |one| f64::from(one.transmission_factor.0));
    let opaque = transmission.is_none_or(|one| one.transmission_texture.is_some());
    let dielectric = metallic < 1.0 || textured;
    let mut lobes = Vec::new();
    let mut add = |name: &str, map, why: String| {
        lobes.push(Lobe {
            name: name.to_owned(),
            weight: 1.0,
            map,
            cause: Cause::new(format!("{said}: {why}")),
        });
    };
    if colour && dielectric && (transmitted < 1.0 || opaque) {
        let why = format!("metallicFactor {metallic}{times}: a diffuse part");
        add("diffuse", Some(mapping("cosine-hemisphere", &[])?), why);
    }
    let specular = factor(json, "KHR_materials_specular", "specularFactor", 1.0);
    let ior = factor(json, "KHR_materials_ior", "ior", 1.5);
    let reflects = specular.is_none_or(|one| one > 0.0) && ior.is_none_or(|one| one != 1.0);
    if (metallic > 0.0 && colour) || (dielectric && reflects) {
        let strength = factor(json, "KHR_materials_anisotropy", "anisotropyStrength", 0.0);
        let strength = strength.unwrap_or(0.0).clamp(0.0, 1.0);
        let alpha = square(roughness);
        // As the extension has it: rough along the tangent.
        let along = alpha + (1.0 - alpha) * square(strength);
        let why = match strength > 0.0 {
            true => format!("roughnessFactor {roughness}{times}, anisotropyStrength {strength}"),
            false => format!("roughnessFactor {roughness}{times}"),
        };
        add("ggx", rough("ggx-vndf", along, alpha)?, why);
    }
    if colour && dielectric && transmitted > 0.0 {
        let why = format!("transmissionFactor {transmitted}, roughnessFactor {roughness}{times}");
        let alpha = square(roughness);
        add("transmission", rough("ggx-vndf-normal", alpha, alpha)?, why);
    }
    let clearcoat = factor(json, "KHR_materials_clearcoat", "clearcoatFactor", 0.0);
    if let Some(coat) = clearcoat.filter(|coat| *coat > 0.0) {
        let name = "clearcoatRoughnessFactor";
        let roughness = factor(json, "KHR_materials_clearcoat", name, 0.0).unwrap_or(0.0);
        let alpha = square(roughness);
        let why = format!("clearcoatFactor {coat}, clearcoatRoughnessFactor {roughness}");
        add("clearcoat", rough("ggx-vndf", alpha, alpha)?, why);
    }
    let sheen = extensions.and_then(|all| all.others.get("KHR_materials_sheen"));
    let sheen = sheen.and_then(|one| one.get("sheenColorFactor")?.as_array());
    if sheen.is_some_and(|rgb| rgb.iter().filter_map(Value::as_f64).any(|c| c > 0.0)) {
        let why = "sheenColorFactor above 0".to_owned();
        add("sheen", Some(mapping("uniform-hemisphere", &[])?), why);
    }
    Ok(lobes)
}

fn square(x: f64) -> f64 {
    let x = x.clamp(0.0, 1.0);
    x * x
}

/// A rough lobe, or none of a smooth one.
fn rough(map: &str, alpha: f64, alpha_y: f64) -> Result<Option<crate::catalog::Mapping>> {
    if alpha < LEAST_ALPHA {
        return Ok(None);
    }
    let across = if alpha_y == alpha {
        0.0
    } else {
        alpha_y.max(LEAST_ALPHA)
    };
    mapping(map, &[("alpha", &[alpha]), ("alpha_y", &[across])]).map(Some)
}
