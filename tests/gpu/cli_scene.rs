//! `corput scene` as its user meets it.

use std::process::{Command, Output};

fn corput(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_corput"))
        .args(arguments)
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .output()
        .expect("corput runs")
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

#[test]
fn the_table_says_what_is_drawn_and_why() {
    let run = corput(&["scene", "tests/data/scenes/diffuse_sky.toml"]);
    assert_eq!(run.status.code(), Some(0), "{}", text(&run.stderr));
    let said = text(&run.stdout);
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
    assert!(run.stderr.is_empty(), "{}", text(&run.stderr));
}

#[test]
fn the_document_has_parameters_ranges_and_causes() {
    let run = corput(&["scene", "--json", "tests/data/scenes/studio.glb"]);
    assert_eq!(run.status.code(), Some(0), "{}", text(&run.stderr));
    let document: serde_json::Value = serde_json::from_slice(&run.stdout).expect("JSON");
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
    let desk = tempfile::tempdir().expect("a folder");
    let path = desk.path().join("room.toml");
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
        std::fs::write(&path, scene).expect("a scene");
        let run = corput(&["scene", &path.to_string_lossy()]);
        assert_eq!(run.status.code(), Some(2), "{scene}");
        assert!(run.stdout.is_empty());
        let said = text(&run.stderr);
        assert!(parts.iter().all(|part| said.contains(part)), "{said}");
    }
}
