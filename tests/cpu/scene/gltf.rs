//! Scenes of glTF: what is found in the committed ones, and files that are refused.

use super::{committed, drawn, folder};
use corput::scene::{Draw, Emitter, Needs, Scene, read};
use serde_json::{Value, json};
use std::f64::consts::PI;
use std::path::Path;

fn near(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-6 * b.abs()
}

#[test]
fn a_studio_has_punctual_lights_a_lamp_and_a_lens() {
    let (scene, needs) = committed("studio.glb");
    let lines = drawn(&needs);
    let keys: Vec<&str> = lines
        .iter()
        .filter_map(|line| line.split(' ').next())
        .collect();
    assert_eq!(
        keys,
        [
            "camera.filter",
            "camera.lens",
            "light.choice",
            "light.emissive.triangle",
            "light.emissive.point",
            "material.floor.lobe",
            "material.floor.diffuse",
            "material.floor.ggx",
            "material.gold.ggx",
            "material.car-paint.lobe",
            "material.car-paint.diffuse",
            "material.car-paint.ggx",
            "material.car-paint.clearcoat",
            "material.glass.lobe",
        ]
    );
    assert_eq!(needs.dimensions(), 11);
    let alpha = |key| {
        needs
            .domain(key)
            .and_then(|one| one.draw.mapping())
            .unwrap()
            .values()[0]
    };
    assert_eq!(alpha("material.gold.ggx"), 0.0625);
    assert_eq!(alpha("material.car-paint.clearcoat"), 0.015_625);
    let cause = &needs.domain("material.gold.ggx").unwrap().cause;
    assert_eq!(cause.to_string(), "material 1 `Gold`: roughnessFactor 0.25");
    assert!(
        scene
            .found
            .iter()
            .any(|line| line.starts_with("5 of 6 materials"))
    );
}

/// Fluxes by hand: 1 x 1 scaled to 2 x 1, of luminance 10 x (1 - 0.0722 / 2).
#[test]
fn powers_are_fluxes() {
    let (scene, _) = committed("studio.glb");
    let power = |name: &str| {
        scene
            .lights
            .iter()
            .find(|one| one.name == name)
            .unwrap()
            .power
    };
    assert!(near(power("emissive"), 2.0 * PI * 10.0 * (1.0 - 0.0361)));
    assert!(near(power("key"), 4.0 * PI * 40.0));
    let luminance = 0.2126 * 0.5 + 0.7152 * 0.75 + 0.0722;
    assert!(near(
        power("rim"),
        2.0 * PI * (1.0 - 0.5f64.cos()) * 80.0 * luminance
    ));
    // Half the diagonal of the box: the floor is 8 x 8, the lamp 4 above it.
    let radius_squared = 0.25 * (8.0 * 8.0 + 8.0 * 8.0 + 4.0 * 4.0);
    assert!(near(power("sun"), 3.0 * PI * radius_squared));
}

#[test]
fn a_lantern_reads_its_bytes_from_beside_it() {
    let (scene, needs) = committed("lantern.gltf");
    let Some(Emitter::Mesh(areas)) = scene.lights.first().map(|light| &light.emitter) else {
        panic!("no mesh emits");
    };
    // Two panes of a strip, the second by a matrix, and the cap: doubled, both sides shine.
    let luminance = 2.0 * (0.2126 + 0.7152 * 0.5 + 0.0722 * 0.25);
    assert_eq!(areas.len(), 6);
    assert!(
        areas.iter().all(|area| near(*area, 0.5 * luminance)),
        "{areas:?}"
    );
    assert!(drawn(&needs).contains(&"material.cloth.sheen uniform-hemisphere 4".to_owned()));
    let brushed = needs
        .domain("material.brushed.ggx")
        .and_then(|one| one.draw.mapping());
    assert_eq!(brushed.unwrap().values()[..2], [0.4375, 0.25]);
    assert!(
        scene
            .found
            .iter()
            .any(|line| line.contains("EXT_lights_image_based"))
    );
}

/// The filter is the file's, the lens glTF's, and the sky joins the lights.
#[test]
fn a_scene_file_adds_to_gltf() {
    let (scene, needs) = committed("studio_sky.toml");
    let (studio, _) = committed("studio.glb");
    assert_eq!(
        (scene.name.as_str(), scene.samples.value),
        ("studio_sky", 4096)
    );
    assert_eq!(scene.lights.len(), studio.lights.len() + 1);
    assert_eq!(scene.materials, studio.materials);
    assert_eq!(scene.camera.lens, studio.camera.lens);
    let lines = drawn(&needs);
    assert_eq!(
        lines[..2],
        [
            "camera.filter filter-gaussian 0",
            "camera.lens concentric-disk 2"
        ]
    );
    assert!(lines.contains(&"light.environment environment 5".to_owned()));
    assert_eq!(needs.dimensions(), 11);
}

fn lantern() -> Value {
    let text = std::fs::read_to_string(folder().join("lantern.gltf")).expect("a lantern");
    serde_json::from_str(&text).expect("JSON")
}

/// The scene of a changed lantern, in a folder with the bytes that it names.
fn changed(change: impl FnOnce(&mut Value, &Path)) -> Result<Scene, String> {
    let desk = tempfile::tempdir().expect("a folder");
    let inner = desk.path().join("scene");
    std::fs::create_dir(&inner).expect("a folder");
    for folder in [desk.path(), &inner] {
        std::fs::copy(
            super::folder().join("lantern.bin"),
            folder.join("lantern.bin"),
        )
        .unwrap();
    }
    let mut document = lantern();
    change(&mut document, &inner);
    let path = inner.join("lantern.gltf");
    std::fs::write(&path, document.to_string()).expect("a scene");
    read(&path).map_err(|error| {
        assert_eq!(error.exit_code(), 2, "{error}");
        error.to_string()
    })
}

fn refusal(change: impl FnOnce(&mut Value)) -> String {
    changed(|document, _| change(document)).expect_err("a refusal")
}

#[test]
fn broken_files_are_refused() {
    assert!(changed(|_, _| {}).is_ok());
    let cases: [(&str, Value, &str); 15] = [
        ("/asset/version", json!("3.0"), "it is of glTF 3.0"),
        (
            "/extensionsRequired",
            json!(["KHR_draco_mesh_compression"]),
            "requires the extension KHR_draco",
        ),
        (
            "/nodes/4/children",
            json!([0]),
            "node 0 `lantern` is reached twice",
        ),
        (
            "/nodes/0/children",
            json!([1, 1]),
            "node 1 is reached twice",
        ),
        (
            "/nodes/0/children",
            json!([99]),
            "nodes[0].children[0]: Index out of bounds",
        ),
        ("/scenes", json!([]), "scene"),
        (
            "/meshes/0/primitives/0/attributes/POSITION",
            json!(99),
            "an accessor that is not there",
        ),
        (
            "/accessors/0/count",
            json!(1_000_000),
            "accessor 0, of a light, passes the end",
        ),
        ("/accessors/0/count", json!(0), "has no element"),
        (
            "/accessors/0/type",
            json!("VEC2"),
            "not of a type that is read",
        ),
        (
            "/bufferViews/0/byteOffset",
            json!(4_000_000_000_u64),
            "passes the end of buffer 0",
        ),
        (
            "/buffers/0/byteLength",
            json!(1_u64 << 40),
            "the most are 2^30",
        ),
        (
            "/buffers/0/byteLength",
            json!(100_000),
            "buffer 0 says 100000 bytes; it has 872",
        ),
        (
            "/buffers/0/uri",
            json!("data:;base64,*"),
            "buffer 0 is no base64",
        ),
        (
            "/buffers/0/uri",
            json!("lantern.gltf"),
            "the scene's own file",
        ),
    ];
    for (place, value, message) in cases {
        let said = refusal(|document| {
            let (parent, key) = place.rsplit_once('/').expect("a place");
            document.pointer_mut(parent).expect("a parent")[key] = value.clone();
        });
        assert!(said.contains(message), "{place} {value}: {said}");
    }
}

/// Scales of 1e38 in a chain: an area past every float, then a transform.
#[test]
fn transforms_that_overflow_are_refused() {
    let chain = |length: usize| {
        refusal(|document| {
            let link = |k: usize| json!({ "scale": [1e38, 1e38, 1e38], "children": [k + 1] });
            let mut nodes: Vec<Value> = (0..length).map(link).collect();
            nodes.push(json!({ "mesh": 0 }));
            document["nodes"] = json!(nodes);
            document["scenes"] = json!([{ "nodes": [0] }]);
        })
    };
    assert!(chain(5).contains("not finite: material 0 `Pane`"));
    assert!(chain(9).contains("the transform of node 8 is not finite"));
}

#[test]
fn nothing_outside_the_folder_is_read() {
    for uri in [
        "../lantern.bin",
        "%2e%2e/lantern.bin",
        "/etc/hostname",
        "file:///etc/hostname",
    ] {
        let said = refusal(|document| document["buffers"][0]["uri"] = json!(uri));
        assert!(said.contains("outside its folder"), "{uri}: {said}");
    }
    #[cfg(unix)]
    {
        let said = changed(|document, folder| {
            let outside = folder.join("../lantern.bin");
            std::os::unix::fs::symlink(outside, folder.join("link.bin")).expect("a link");
            document["buffers"][0]["uri"] = json!("link.bin");
        });
        let said = said.expect_err("a refusal");
        assert!(said.contains("outside its folder"), "{said}");
    }
}

#[test]
fn cut_binaries_are_refused() {
    let whole = std::fs::read(folder().join("studio.glb")).expect("a studio");
    let desk = tempfile::tempdir().expect("a folder");
    let path = desk.path().join("cut.glb");
    for length in [
        0,
        3,
        4,
        11,
        12,
        19,
        20,
        100,
        whole.len() / 2,
        whole.len() - 1,
    ] {
        std::fs::write(&path, &whole[..length]).expect("a file");
        let error = read(&path).expect_err("a refusal");
        assert_eq!(error.exit_code(), 2, "{length}: {error}");
    }
    // A header that says less than itself.
    let mut short = whole;
    short[8..12].copy_from_slice(&4u32.to_le_bytes());
    std::fs::write(&path, &short).expect("a file");
    assert!(
        read(&path)
            .unwrap_err()
            .to_string()
            .contains("says 4 bytes")
    );
}

/// Sparse files: what is too large is not read.
#[test]
fn huge_files_are_refused() {
    let desk = tempfile::tempdir().expect("a folder");
    for (name, bytes, message) in [
        (
            "huge.glb",
            (1u64 << 30) + 1,
            "the file has 1073741825 bytes; the most are 2^30",
        ),
        (
            "huge.gltf",
            (1 << 26) + 1,
            "its JSON has 67108865 bytes; the most are 2^26",
        ),
    ] {
        let path = desk.path().join(name);
        let file = std::fs::File::create(&path).expect("a file");
        file.set_len(bytes).expect("a sparse file");
        let said = read(&path).expect_err("a refusal").to_string();
        assert!(said.contains(message), "{said}");
    }
}

#[test]
fn more_triangles_than_a_choice_takes_are_refused() {
    let with = |triangles: u64| {
        changed(|document, folder| {
            let indices = 3 * triangles;
            let file = std::fs::File::create(folder.join("many.bin")).expect("a file");
            file.set_len(indices).expect("a sparse file");
            let buffers = document["buffers"].as_array_mut().expect("buffers");
            buffers.push(json!({ "byteLength": indices, "uri": "many.bin" }));
            let views = document["bufferViews"].as_array_mut().expect("views");
            views.push(json!({ "buffer": 1, "byteLength": indices }));
            let view = views.len() - 1;
            let accessors = document["accessors"].as_array_mut().expect("accessors");
            let component = json!({
                "bufferView": view, "componentType": 5121, "count": indices, "type": "SCALAR",
            });
            accessors.push(component);
            let accessor = accessors.len() - 1;
            document["meshes"][1]["primitives"][0]["indices"] = json!(accessor);
        })
    };
    // Four triangles are on the panes.
    let most = (1 << 22) - 4;
    let lights = with(most).map(|scene| scene.lights);
    let lights = lights.expect("as many as there may be");
    assert!(matches!(&lights[0].emitter, Emitter::Mesh(all) if all.len() == 1 << 22));
    let said = with(most + 1).expect_err("a refusal");
    assert!(said.contains("more than 2^22 triangles emit"), "{said}");
}

#[test]
fn emitters_without_area_are_refused() {
    let said = refusal(|document| {
        document["nodes"][0]["scale"] = json!([0, 0, 0]);
    });
    assert!(
        said.contains("a light of area 0") && said.contains("`Pane`"),
        "{said}"
    );
}

/// What a material has not, its lobe has not either.
#[test]
fn lobes_go_with_what_makes_them() {
    let lobes = |material: Value| -> Vec<String> {
        let scene = changed(|document, _| document["materials"][2] = material).expect("a scene");
        let lobes = scene.materials.last().map(|one| &one.lobes);
        lobes
            .into_iter()
            .flatten()
            .map(|lobe| lobe.name.clone())
            .collect()
    };
    let model = |metallic: f64, more: Value| {
        lobes(json!({
            "pbrMetallicRoughness": { "metallicFactor": metallic },
            "extensions": more,
        }))
    };
    assert_eq!(model(0.0, json!({})), ["diffuse", "ggx"]);
    assert_eq!(model(1.0, json!({})), ["ggx"]);
    assert_eq!(model(0.5, json!({})), ["diffuse", "ggx"]);
    assert_eq!(
        model(0.0, json!({ "KHR_materials_ior": { "ior": 1.0 } })),
        ["diffuse"]
    );
    assert_eq!(
        model(1.0, json!({ "KHR_materials_ior": { "ior": 1.0 } })),
        ["ggx"]
    );
    let specular = json!({ "KHR_materials_specular": { "specularFactor": 0.0 } });
    assert_eq!(model(0.0, specular), ["diffuse"]);
    let glass = json!({ "KHR_materials_transmission": { "transmissionFactor": 1.0 } });
    assert_eq!(model(0.0, glass.clone()), ["ggx", "transmission"]);
    assert_eq!(model(1.0, glass), ["ggx"]);
    let half = json!({ "KHR_materials_transmission": { "transmissionFactor": 0.5 } });
    assert_eq!(model(0.0, half), ["diffuse", "ggx", "transmission"]);
    let coat = json!({ "KHR_materials_clearcoat": { "clearcoatFactor": 1.0 } });
    assert_eq!(model(0.0, coat), ["diffuse", "ggx", "clearcoat"]);
    assert_eq!(
        model(0.0, json!({ "KHR_materials_clearcoat": {} })),
        ["diffuse", "ggx"]
    );
    assert_eq!(model(0.0, json!({ "KHR_materials_unlit": {} })), [""; 0]);
}

#[test]
fn an_aperture_makes_a_lens_and_none_a_pinhole() {
    let scene = |extras: Value| {
        changed(|document, _| {
            document["cameras"] = json!([{
                "type": "perspective",
                "perspective": { "yfov": 1.0, "znear": 0.1 },
                "extras": extras,
            }]);
            document["nodes"][5]["camera"] = json!(0);
        })
        .expect("a scene")
    };
    let lens = |extras: Value| scene(extras).camera.lens.is_some();
    assert!(lens(json!({ "aperture": 0.1 })));
    assert!(!lens(json!({ "aperture": 0 })));
    assert!(!lens(json!({})) && !lens(json!(7)) && !lens(Value::Null));
    let needs = Needs::of(&scene(json!({}))).expect("needs");
    let filter = needs.domain("camera.filter").map(|one| &one.draw);
    assert!(matches!(filter, Some(Draw::Map(map)) if map.map().name == "filter-box"));
}
