//! `corput scene` as its user meets it.

mod desk;
mod support;

use desk::{Desk, repository};

fn asked(options: &str, scene: &str) -> String {
    let path = repository("tests/data/scenes").join(scene);
    Desk::new().say(&format!("scene {options} {}", path.display()))
}

#[test]
fn the_table_says_what_is_drawn_and_why() {
    let said = asked("", "diffuse_sky.toml");
    for part in [
        "diffuse_sky: 1024 samples of sobol:owen-hash, 4 dimensions",
        "light.environment",
        "line 6: map = \"../sunrise.exr\"",
        "cosine-hemisphere",
        "Left out:",
        "no aperture: the camera is a pinhole",
        "there is no phase function",
    ] {
        assert!(said.contains(part), "{part} is not in:\n{said}");
    }
}

#[test]
fn the_document_has_parameters_ranges_and_causes() {
    let said = asked("--json", "studio.glb");
    let document: serde_json::Value = serde_json::from_str(&said).expect("JSON");
    assert_eq!(document["schema"], 1);
    assert_eq!(document["dimensions"], 11);
    let domains = document["domains"].as_array().expect("domains");
    let gold = domains.iter().find(|one| one["key"] == "material.gold.ggx");
    let gold = gold.expect("gold");
    assert_eq!(gold["draw"]["map"], "ggx-vndf");
    assert_eq!(gold["draw"]["parameters"]["alpha"][0], 0.0625);
    assert_eq!(
        (&gold["first"], &gold["dimensions"]),
        (&8.into(), &2.into())
    );
    assert!(
        gold["cause"]["text"]
            .as_str()
            .is_some_and(|text| text.contains("Gold"))
    );
    assert!(
        document["left_out"]
            .as_array()
            .is_some_and(|all| all.len() > 40)
    );
}

#[test]
fn what_is_refused_says_where_and_exits_with_2() {
    let desk = Desk::new();
    for (scene, parts) in [
        (
            "sampels = 4\n",
            &["line 1, column 1", "did you mean `samples`"][..],
        ),
        (
            "[environment]\nmap = \"no.exr\"\n",
            &["line 2, column 7", "no.exr"],
        ),
        (
            "sampler = \"pmj02\"\n[camera]\nshutter = [0, 1]\n",
            &["1 dimension", "it has 2"],
        ),
    ] {
        std::fs::write(desk.path("room.toml"), scene).expect("a scene");
        let run = desk.run("scene room.toml");
        run.expect(2, parts);
        assert!(run.stdout.is_empty());
    }
}
