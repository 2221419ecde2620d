//! Scenes: what each of the committed ones needs, and what is refused, with its place.

#[path = "scene/gltf.rs"]
mod gltf;
#[path = "scene/refused.rs"]
mod refused;

use corput::catalog::{Profile, SEQUENCES, maps};
use corput::scene::{Draw, Needs, Part, Scene, parse, read};
use std::path::{Path, PathBuf};

pub fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/scenes")
}

pub fn committed(name: &str) -> (Scene, Needs) {
    let scene = read(&folder().join(name)).unwrap_or_else(|error| panic!("{error}"));
    let needs = Needs::of(&scene).unwrap_or_else(|error| panic!("{name}: {error}"));
    (scene, needs)
}

/// The domains, a line each: key, what is drawn, and the first dimension.
pub fn drawn(needs: &Needs) -> Vec<String> {
    let one = |domain: &corput::scene::Domain| {
        let what = match &domain.draw {
            Draw::Between([low, high]) => format!("{low}..{high}"),
            Draw::Choice(weights) => format!("{weights:?}"),
            Draw::Map(mapping) => mapping.map().name.to_owned(),
        };
        format!("{} {what} {}", domain.key, domain.first)
    };
    needs.domains.iter().map(one).collect()
}

fn left_out<'n>(needs: &'n Needs, name: &str) -> &'n str {
    let found = needs.left_out.iter().find(|one| one.name == name);
    found.map_or_else(|| panic!("{name} is not left out"), |one| &one.reason)
}

#[test]
fn a_diffuse_quad_needs_its_two_dimensions() {
    let (scene, needs) = committed("diffuse_quad.toml");
    assert_eq!(scene.name, "diffuse_quad");
    assert_eq!(drawn(&needs), ["material.quad.diffuse cosine-hemisphere 0"]);
    assert_eq!(needs.dimensions(), 2);
    assert_eq!(needs.request.count, 256);
    let cause = &needs.domains[0].cause;
    assert_eq!(cause.line, Some(10));
    assert_eq!(cause.text, r#"lobes = [{ kind = "diffuse" }]"#);
    assert!(left_out(&needs, "light.0").contains("a point light is not drawn (line 6:"));
    assert!(left_out(&needs, "light.choice").contains("one light alone"));
    assert!(left_out(&needs, "environment").contains("there is no environment"));
    assert!(left_out(&needs, "owen").contains("sampler = \"sobol\""));
}

#[test]
fn a_sky_brings_its_tables() {
    let (_, needs) = committed("diffuse_sky.toml");
    assert_eq!(
        drawn(&needs),
        [
            "light.environment environment 0",
            "material.ground.diffuse cosine-hemisphere 2"
        ]
    );
    let sky = needs
        .domain("light.environment")
        .and_then(|one| one.draw.mapping());
    let words: usize = sky.unwrap().tables().iter().map(Vec::len).sum();
    assert!(words > 1024 * 512, "{words}");
    assert!(left_out(&needs, "environment-alias").contains("the environment is another (line 6"));
}

#[test]
fn alternatives_take_the_same_dimensions() {
    let (_, needs) = committed("glossy_sphere.toml");
    assert_eq!(
        drawn(&needs),
        [
            "camera.filter filter-blackman-harris 0",
            "light.choice [30.0, 90.0] 2",
            "light.bulb sphere-light 3",
            "light.panel spherical-rectangle 3",
            "material.brushed.ggx ggx-vndf 5",
        ]
    );
    assert_eq!(needs.dimensions(), 7);
    assert!(left_out(&needs, "material.mirror.ggx").starts_with("smooth: it has one direction"));
    let brushed = needs
        .domain("material.brushed.ggx")
        .and_then(|one| one.draw.mapping());
    assert_eq!(brushed.unwrap().values()[..2], [0.05, 0.3]);
}

#[test]
fn cameras_draw_filter_lens_and_time() {
    let (_, needs) = committed("depth_of_field.toml");
    assert_eq!(drawn(&needs), ["camera.lens regular-polygon 0"]);
    let (_, needs) = committed("motion_blur.toml");
    assert_eq!(
        drawn(&needs),
        [
            "camera.filter filter-gaussian 0",
            "camera.lens annulus 2",
            "camera.time 0..0.0208 4",
            "light.0 cone 5",
            "material.0.diffuse cosine-hemisphere 7",
        ]
    );
    assert!(left_out(&needs, "filter-box").contains("the pixel filter is another (line 7"));
}

#[test]
fn fog_draws_distances_and_directions() {
    let (_, needs) = committed("fog.toml");
    assert_eq!(
        drawn(&needs),
        [
            "camera.filter filter-tent 0",
            "medium.fog.distance exponential 2",
            "medium.fog.phase henyey-greenstein 3",
        ]
    );
    assert!(left_out(&needs, "cosine-hemisphere").contains("there is no lobe"));
}

#[test]
fn one_of_many_lights_is_chosen_by_power() {
    let (_, needs) = committed("many_lights.toml");
    let lines = drawn(&needs);
    let powers: Vec<f64> = (0..11).map(|k| f64::from(2 + 3 * k)).chain([0.0]).collect();
    assert_eq!(lines[0], format!("light.choice {powers:?} 0"));
    assert_eq!(lines.len(), 11);
    assert_eq!(needs.dimensions(), 6);
    assert!(lines.contains(&"light.8.triangle [0.5, 0.5, 0.0, 2.0, 1.25] 1".to_owned()));
    assert!(lines.contains(&"light.8.point triangle 2".to_owned()));
    assert!(left_out(&needs, "light.11").contains("its power is 0"));
}

#[test]
fn lobes_are_chosen_by_weight() {
    let (_, needs) = committed("layered.toml");
    let lines = drawn(&needs);
    assert_eq!(
        lines[..5],
        [
            "light.0 uniform-sphere 0",
            "material.varnish.lobe [3.0, 1.0, 0.5] 2",
            "material.varnish.diffuse cosine-hemisphere 3",
            "material.varnish.ggx-bounded ggx-vndf-bounded 3",
            "material.varnish.clearcoat ggx-vndf 3",
        ]
    );
    // Two mirrors need the choice, and no direction.
    assert!(lines.contains(&"material.window.lobe [1.0, 1.0] 2".to_owned()));
    assert!(left_out(&needs, "material.window.glass").starts_with("smooth"));
    // 1000 points of r2 lose nothing; it is a recurrence.
    assert!(needs.warnings.is_empty(), "{:?}", needs.warnings);
}

#[test]
fn everything_fits_into_fifteen_dimensions() {
    let (scene, needs) = committed("everything.toml");
    assert_eq!(scene.profile, Profile::Native);
    assert_eq!((scene.samples.value, scene.seed), (1 << 32, u64::MAX));
    assert_eq!(needs.dimensions(), 15);
    assert_eq!(needs.domains.len(), 17);
    assert_eq!(needs.request.profile, Profile::Native);
    // The alias table takes three dimensions, so that what follows begins after them.
    assert!(drawn(&needs).contains(&"material.paint.lobe [1.0, 1.0, 1.0] 9".to_owned()));
}

/// Every map and sequence is drawn or left out, never both, with a reason.
#[test]
fn what_is_not_drawn_is_left_out() {
    for entry in std::fs::read_dir(folder()).expect("scenes") {
        let path = entry.expect("a scene").path();
        let ending = path.extension().and_then(|ending| ending.to_str());
        if !matches!(ending, Some("toml" | "gltf" | "glb")) {
            continue;
        }
        let scene = read(&path).unwrap_or_else(|error| panic!("{error}"));
        let needs = Needs::of(&scene).expect("needs");
        let out = |part, name: &str| {
            let mut all = needs.left_out.iter();
            all.any(|one| one.part == part && one.name == name && !one.reason.is_empty())
        };
        for map in maps() {
            let reached = needs.domains.iter().filter_map(|one| one.draw.mapping());
            let reached = reached.map(|mapping| mapping.map()).any(|one| one == map);
            assert_ne!(reached, out(Part::Map, map.name), "{path:?}: {}", map.name);
        }
        for &one in SEQUENCES {
            let chosen = one == needs.request.sequence;
            assert_ne!(chosen, out(Part::Sequence, one.name()), "{path:?}");
        }
        for domain in &needs.domains {
            assert!(domain.range().end <= needs.dimensions(), "{}", domain.key);
            assert!(!out(Part::Domain, &domain.key), "{}", domain.key);
        }
    }
}

#[test]
fn the_target_is_asked_before_work_begins() {
    let with = |limit: &str| {
        let text = format!(
            "[target]\n{limit}\n[camera]\nfilter = {{ kind = \"box\", radius = 0.5 }}\n\
             [[light]]\nkind = \"mesh\"\nareas = [1, 2, 3, 4, 5, 6, 7, 8, 9, 9, 9, 9, 9, 9, 9, 9, 9]\n"
        );
        let scene = parse(&text, Path::new("t.toml")).expect("a scene");
        Needs::of(&scene)
            .map(drop)
            .map_err(|error| error.to_string())
    };
    for (limit, enough, message) in [
        (
            "group-invocations",
            64,
            "64 invocations of a workgroup: the target has 63",
        ),
        (
            "push-constant-bytes",
            8,
            "8 bytes of push constants: the target has 7",
        ),
        (
            "storage-buffers",
            2,
            "2 storage buffers, for results and the tables of light.0.triangle: the target has 1, says [target] storage-buffers",
        ),
        (
            "storage-buffer-bytes",
            204,
            "for the table of light.0.triangle: the target has 203",
        ),
    ] {
        assert_eq!(with(&format!("{limit} = {enough}")), Ok(()));
        let said = with(&format!("{limit} = {}", enough - 1)).unwrap_err();
        assert!(said.contains(message), "{said}");
    }
}

#[test]
fn points_that_are_no_power_of_two_are_warned_of() {
    let text = "samples = 1000\n[[material]]\nlobes = [{ kind = \"diffuse\" }]\n";
    let needs = Needs::of(&parse(text, Path::new("t.toml")).unwrap()).unwrap();
    assert!(
        needs
            .warnings
            .iter()
            .any(|line| line.contains("no power of two"))
    );
}
