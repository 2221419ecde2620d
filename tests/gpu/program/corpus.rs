//! Scenes to prove the kernels of scenes with: files, every sampler, every map.

#![allow(dead_code, reason = "each test uses a part of it")]

use corput::catalog::{Map, Mapping, Profile, SEQUENCES, Sampler, Scramble, maps};
use corput::scene::{Needs, Scene, Stated, read};
use std::fs;
use std::path::Path;

/// A scene, and what it draws.
pub struct Case {
    pub name: String,
    pub needs: Needs,
}

/// The scenes in tests/data/scenes.
pub fn files() -> Vec<Case> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/scenes");
    let mut paths: Vec<_> = fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .filter(|path| {
            let ending = path.extension().unwrap_or_default();
            ["toml", "gltf", "glb"].iter().any(|known| ending == *known)
        })
        .collect();
    paths.sort();
    let case = |path: &std::path::PathBuf| {
        let scene = read(path).unwrap();
        Case {
            needs: Needs::of(&scene).unwrap(),
            name: scene.name,
        }
    };
    paths.iter().map(case).collect()
}

fn scene(sampler: &str, samples: u64, seed: u64) -> Scene {
    let mut scene = Scene::new("made").unwrap();
    scene.sampler = Stated {
        value: Sampler::parse(sampler).unwrap(),
        cause: scene.sampler.cause.clone(),
    };
    scene.samples.value = samples;
    scene.seed = seed;
    scene
}

/// The names of every sequence with every scramble.
fn names() -> Vec<String> {
    let mut names = Vec::new();
    for sequence in SEQUENCES {
        let scrambles: Vec<Option<Scramble>> = match sequence.scrambles() {
            [] => vec![None],
            all => all.iter().copied().map(Some).collect(),
        };
        let samplers = scrambles.iter().map(|one| Sampler::new(*sequence, *one));
        names.extend(samplers.flatten().map(|sampler| sampler.name()));
    }
    names
}

/// Points of a sampler, of the first of these numbers of samples that it takes; `None` where it
/// has fewer dimensions.
fn points(name: &str, counts: &[u64], dimensions: u32, mapping: Option<&Mapping>) -> Option<Case> {
    let needs = counts.iter().find_map(|samples| {
        let scene = scene(name, *samples, 0x0123_4567_89ab_cdef);
        Needs::of_points(&scene, dimensions, mapping.cloned()).ok()
    })?;
    let name = format!("{name}, {dimensions} dimensions");
    Some(Case { name, needs })
}

/// Every sampler: bare points, and where there are three dimensions or more a map over the first
/// two and a number.
pub fn samplers() -> Vec<Case> {
    let map = Mapping::new(Map::from_name("cosine-hemisphere").unwrap(), &[]).unwrap();
    let mut cases = Vec::new();
    for name in names() {
        let before = cases.len();
        for (dimensions, mapping) in [(1, None), (2, None), (3, Some(&map)), (7, None)] {
            // As many as there can be in two dimensions; a number without many divisors;
            // what lattices and published generators take.
            let counts: &[u64] = match dimensions {
                2 => &[1 << 32, (1 << 32) - 1, 1 << 20, 1021],
                _ => &[46_225, 1 << 16, 1021],
            };
            cases.extend(points(&name, counts, dimensions, mapping));
        }
        assert!(cases.len() > before, "{name} has no case");
    }
    // Up to the last index of so many digits in one of the bases, and past it.
    for samples in [1, 2187, 2188, 15_625, 59_049, 59_050] {
        let scene = scene("halton", samples, 0);
        let needs = Needs::of_points(&scene, 6, None).unwrap();
        let name = format!("halton, {samples} samples");
        cases.push(Case { name, needs });
    }
    cases
}

/// Bare points of every sampler in one to nine dimensions, as many as there can be and few.
pub fn bare() -> Vec<Case> {
    let mut cases = Vec::new();
    for name in names() {
        for dimensions in 1..=9 {
            let most = &[1 << 32, (1 << 32) - 1, 1 << 20, 1 << 16, 1021];
            cases.extend(points(&name, most, dimensions, None));
            let few = points(&name, &[16, 11], dimensions, None);
            cases.extend(few.map(|case| Case {
                name: format!("few of {}", case.name),
                ..case
            }));
        }
    }
    cases
}

/// Every map, with its first and last example of parameters, or as they are by default.
pub fn every_map(profile: Profile) -> Vec<Case> {
    let mut cases = Vec::new();
    for map in maps() {
        let examples: Vec<Mapping> = match map.examples {
            [] => vec![Mapping::with_values(map, &[]).unwrap()],
            [one] => vec![Mapping::with_values(map, one).unwrap()],
            [first, .., last] => [first, last]
                .iter()
                .map(|values| Mapping::with_values(map, values).unwrap())
                .collect(),
        };
        for (number, mapping) in examples.into_iter().enumerate() {
            let mut scene = scene("sobol:owen-hash", 1 << 20, 7);
            scene.profile = profile;
            let needs = Needs::of_points(&scene, map.dimensions, Some(mapping)).unwrap();
            let name = format!("{} {number}", map.name);
            cases.push(Case { name, needs });
        }
    }
    cases
}
