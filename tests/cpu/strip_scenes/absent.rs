//! What is absent is absent: functions, constants, tables and buffers that a scene does not
//! need.

use super::corpus::{Case, every_map, files, samplers};
use super::{scene, stripped};
use corput::catalog::{Map, Profile, SEQUENCES, Sequence, maps};
use corput::kernels::spirv;
use corput::scene::{Draw, Needs, Scene};
use corput::spirv::describe;
use corput::strip::measure;
use corput::strip::program::{Options, program};

fn functions(words: &[u32]) -> Vec<String> {
    let facts = describe(words).unwrap();
    // glslang adds the types of parameters after a bracket.
    let plain = |name: &String| name.split('(').next().unwrap_or(name).to_owned();
    facts.functions.iter().map(plain).collect()
}

/// Names of functions that only this sequence's columns call.
fn own_functions(sequence: Sequence) -> &'static [&'static str] {
    match sequence {
        Sequence::RandomFast => &["corput_random_fast"],
        Sequence::Pcg32 => &["corput_pcg32_value"],
        Sequence::Stratified => &["corput_stratified"],
        Sequence::LatinHypercube => &["corput_latin_hypercube"],
        Sequence::MultiJittered => &["corput_cmj"],
        Sequence::Hammersley => &["corput_hammersley_value"],
        Sequence::Sobol => &["corput_owen_hash_reversed"],
        Sequence::Pmj02 => &["corput_pmj02_scramble"],
        Sequence::Lattice => &["corput_lattice"],
        Sequence::Korobov => &["corput_korobov"],
        Sequence::R2 => &["corput_additive"],
        // Strata and nets are jittered by random numbers, Hammersley's set has radical inverses.
        _ => &[],
    }
}

/// The functions of a map among these.
fn functions_of(map: &Map, found: &[String]) -> Vec<String> {
    let name = map.name.replace('-', "_");
    let names = [format!("corput_{name}"), format!("corput_native_{name}")];
    let of = found.iter().filter(|one| names.contains(one));
    of.cloned().collect()
}

/// Maps whose functions are parts of those of others.
const PARTS: &[(&str, &[&str])] = &[
    ("concentric-disk", &["cosine-hemisphere", "disk-light"]),
    ("cone", &["sphere-light"]),
    ("gaussian", &["normal-pair"]),
    ("ggx-vndf-cap", &["ggx-vndf-bounded"]),
    ("polar-disk", &["cosine-hemisphere-polar"]),
];

/// What a module has that its scene does not need.
fn superfluous(needs: &Needs, words: &[u32]) -> Vec<String> {
    let found = functions(words);
    let mut wrong = Vec::new();
    let drawn: Vec<&str> = needs
        .domains
        .iter()
        .filter_map(|one| one.draw.mapping())
        .map(|mapping| mapping.map().name)
        .collect();
    for map in maps() {
        let parts = PARTS.iter().find(|(part, _)| *part == map.name);
        let wholes = parts.map_or(&[][..], |(_, wholes)| wholes);
        let needed = |name: &&str| *name == map.name || wholes.contains(name);
        if !drawn.iter().any(needed) {
            wrong.extend(functions_of(map, &found));
        }
    }
    for sequence in SEQUENCES
        .iter()
        .filter(|one| **one != needs.request.sequence)
    {
        let own = own_functions(*sequence);
        let own = own.iter().map(ToString::to_string);
        wrong.extend(own.filter(|name| found.contains(name)));
    }
    let native = needs.request.profile == Profile::Native;
    if !native {
        let foreign = found
            .iter()
            .filter(|name| name.starts_with("corput_native_"));
        wrong.extend(foreign.cloned());
    }
    let facts = measure(words).unwrap();
    if facts.table_bytes > 0 {
        wrong.push(format!("{} bytes of tables", facts.table_bytes));
    }
    if facts.specialization > 0 {
        wrong.push(format!("{} specialization constants", facts.specialization));
    }
    let environment = |draw: &Draw| {
        draw.mapping()
            .is_some_and(|one| one.map().name.starts_with("environment"))
    };
    let many = |draw: &Draw| matches!(draw, Draw::Choice(weights) if weights.len() > 16);
    let tables = needs
        .domains
        .iter()
        .filter(|one| environment(&one.draw) || many(&one.draw));
    if facts.resources.len() > 1 + tables.count() {
        wrong.push(format!("{:?} are bound", facts.resources));
    }
    wrong
}

/// The table of parts excuses what is there and nothing else: each map by itself has the parts
/// that it says, in one profile or the other.
#[test]
fn parts_of_maps_are_those_of_the_table() {
    let mut found: Vec<(&str, &str)> = Vec::new();
    for profile in [Profile::Exact, Profile::Native] {
        for Case { name, needs } in every_map(profile) {
            let made = program(&name, &needs, Options::default()).unwrap();
            let words = made.spirv(&made.flat(false).unwrap().text).unwrap();
            let names = functions(&words);
            let whole = needs.domains[0].draw.mapping().unwrap().map().name;
            let others = maps().filter(|map| map.name != whole);
            let parts = others.filter(|map| !functions_of(map, &names).is_empty());
            found.extend(parts.map(|part| (part.name, whole)));
        }
    }
    let said = PARTS
        .iter()
        .flat_map(|(part, wholes)| wholes.iter().map(|whole| (*part, *whole)));
    let mut said: Vec<(&str, &str)> = said.collect();
    found.sort_unstable();
    found.dedup();
    said.sort_unstable();
    assert_eq!(found, said);
}

#[test]
fn what_is_absent_is_absent() {
    let cases = files();
    assert!(cases.len() >= 12);
    for Case { name, .. } in &cases {
        let (scene, needs) = scene(name);
        let made = stripped(&scene, &needs);
        let wrong = superfluous(&needs, &made.spirv);
        assert_eq!(wrong, Vec::<String>::new(), "{name}");
    }
    // The general kernel, with all that a scene's kernel has not.
    let (scene_of_quad, quad) = scene("diffuse_quad");
    let stock = spirv("generate_digits").unwrap();
    let wrong = superfluous(&quad, &stock).join(", ");
    assert!(wrong.contains("specialization constants"), "{wrong}");
    for (sampler, word) in [
        ("lattice", "corput_lattice"),
        ("cmj", "corput_cmj"),
        ("r2", "corput_additive"),
    ] {
        let case = samplers()
            .into_iter()
            .find(|case| case.name.starts_with(sampler))
            .unwrap();
        let made = stripped(&Scene::new("points").unwrap(), &case.needs);
        let wrong = superfluous(&quad, &made.spirv);
        assert!(wrong.iter().any(|one| one == word), "{sampler}: {wrong:?}");
    }
    // A part is none where nothing has it.
    let bare = Needs::of_points(&Scene::new("points").unwrap(), 2, None).unwrap();
    let wrong = superfluous(&bare, &stripped(&scene_of_quad, &quad).spirv);
    assert!(
        wrong.iter().any(|one| one == "corput_concentric_disk"),
        "{wrong:?}"
    );
    // Each of these is found where it is: the needs of one scene, the module of another.
    for (other, word) in [
        ("glossy_sphere", "corput_ggx_vndf"),
        ("everything", "corput_native_ggx_vndf_cap"),
        ("diffuse_sky", "are bound"),
        ("fog", "corput_henyey_greenstein"),
    ] {
        let (scene, needs) = scene(other);
        let wrong = superfluous(&quad, &stripped(&scene, &needs).spirv);
        assert!(
            wrong.iter().any(|one| one.contains(word)),
            "{other}: {wrong:?}"
        );
    }
}
