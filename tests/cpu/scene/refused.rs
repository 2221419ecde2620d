//! Scene files that are refused: message, place and exit code.

use corput::scene::{Needs, parse, read};
use std::path::Path;

/// The message of a scene file that is refused as it is read, or when its needs are asked for.
fn said(text: &str) -> String {
    let found = parse(text, Path::new("room.toml")).and_then(|scene| Needs::of(&scene));
    let error = found.map(drop).expect_err("a refusal");
    assert_eq!(error.exit_code(), 2, "{error}");
    error.to_string()
}

fn says(text: &str, parts: &[&str]) {
    let said = said(text);
    for part in parts {
        assert!(said.contains(part), "{part} is not in: {said}");
    }
}

#[test]
fn unknown_keys_and_words_have_a_place_and_a_guess() {
    says(
        "sampels = 4\n",
        &["room.toml", "line 1, column 1", "`samples`"],
    );
    says(
        "samples = 4\nsampler = \"sobl\"\n",
        &["line 2, column 11", "`sobol`"],
    );
    says(
        "sampler = \"sobol:owne\"\n",
        &["line 1", "did you mean `owen`"],
    );
    says(
        "[camera]\nlense = 1\n",
        &["line 2, column 1", "did you mean `lens`"],
    );
    let lens = "[camera]\nlens = { shape = \"disc\" }\n";
    says(lens, &["line 2, column 18", "did you mean `disk`"]);
    let filter = "[camera]\nfilter = { kind = \"box\", radus = 1 }\n";
    says(filter, &["did you mean `radius`", "line 2, column 26"]);
    says(
        "[[light]]\nkind = \"spher\"\n",
        &["line 2, column 8", "`sphere`"],
    );
    let lobe = "[[material]]\nlobes = [{ kind = \"ggx\", alhpa = 1 }]\n";
    says(lobe, &["line 2, column 26", "did you mean `alpha`"]);
    let lobe = "[[material]]\nlobes = [{ kind = \"diffuse\", alpha = 0 }]\n";
    says(lobe, &["unknown key `alpha`"]);
    says("[target]\nstorage-bufers = 1\n", &["`storage-buffers`"]);
    says("profile = \"exakt\"\n", &["line 1, column 11", "`exact`"]);
    says("samples = 4\nsamples = 5\n", &["line 2"]);
    says("samples = ", &["line 1"]);
}

#[test]
fn values_out_of_their_domain_have_a_place() {
    says(
        "samples = 0\n",
        &["line 1, column 11", "from 1 to 4294967296"],
    );
    says("samples = 4294967297\n", &["from 1 to 4294967296"]);
    says("samples = -1\n", &["from 1 to 4294967296"]);
    says("seed = 1.5\n", &["a whole number"]);
    says("[camera]\nshutter = [1, 0]\n", &["line 2", "opens, closes"]);
    let filter = "[camera]\nfilter = { kind = \"box\", radius = -1 }\n";
    says(filter, &["line 2, column 35", "filter-box", "radius is -1"]);
    says(
        "[camera]\nfilter = { kind = \"box\" }\n",
        &["radius was not given"],
    );
    let lobe = "[[material]]\nlobes = [{ kind = \"ggx\", alpha = 0, alpha_y = 0.5 }]\n";
    says(lobe, &["a mirror has neither"]);
    says("[[material]]\nlobes = [1]\n", &["a list of tables"]);
    says(
        "[[medium]]\nphase = { kind = \"henyey-greenstein\", g = 1 }\n",
        &["g is 1"],
    );
    says(
        "[[light]]\nkind = \"point\"\npower = -1\n",
        &["line 3", "at least 0"],
    );
    says(
        "[[light]]\nname = \"a b\"\nkind = \"point\"\n",
        &["line 2, column 8", "letters"],
    );
}

#[test]
fn lights_without_area_are_refused() {
    let flat = "[[light]]\nkind = \"triangle\"\na = [0, 0, 0]\nb = [1, 1, 1]\nc = [2, 2, 2]\n";
    says(flat, &["line 2, column 8", "a light of area 0"]);
    let disk = "[[light]]\nkind = \"disk\"\ncenter = [0, 0, 1]\nnormal = [0, 0, 1]\nradius = 0\n";
    says(disk, &["line 5, column 10", "radius is 0"]);
    let sphere = "[[light]]\nkind = \"sphere\"\ncenter = [0, 0, 1]\nradius = 0\n";
    says(sphere, &["line 4", "radius is 0"]);
    says(
        "[[light]]\nkind = \"mesh\"\nareas = [0, 0]\n",
        &["line 3", "a light of area 0"],
    );
    let side =
        "[[light]]\nkind = \"rectangle\"\ncorner = [0, 0, 1]\nx = [0, 0, 0]\ny = [0, 1, 0]\n";
    says(side, &["line 4", "spherical-rectangle"]);
}

#[test]
fn budgets_that_a_sampler_does_not_have_are_refused() {
    let four =
        "[camera]\nlens = { shape = \"disk\" }\n[[material]]\nlobes = [{ kind = \"diffuse\" }]\n";
    says(
        &format!("sampler = \"pmj02\"\n{four}"),
        &["pmj02", "4 dimensions", "has 2"],
    );
    says(
        &format!("sampler = \"vdc\"\n{four}"),
        &["4 dimensions", "it has 1"],
    );
    says("samples = 4\n", &["draws nothing", "1 dimension or more"]);
    let dark = "[[light]]\nkind = \"point\"\npower = 0\n";
    says(
        &format!("{four}{dark}"),
        &["each power is 0", "something must be drawn"],
    );
}

#[test]
fn names_are_there_once() {
    let twice = "[[light]]\nname = \"a\"\nkind = \"point\"\n".repeat(2);
    says(&twice, &["light a twice", "another name"]);
    says(
        "[[material]]\nlobes = [{ kind = \"diffuse\" }, { kind = \"diffuse\" }]\n",
        &["lobe diffuse twice"],
    );
    let choice = "[[light]]\nname = \"choice\"\nkind = \"uniform\"\n[[light]]\nkind = \"point\"\n";
    says(choice, &["domain light.choice twice"]);
}

#[test]
fn missing_files_are_refused() {
    says(
        "[environment]\nmap = \"no.exr\"\n",
        &["line 2, column 7", "no.exr"],
    );
    says(
        "[environment]\npower = 1\n",
        &["line 1, column 2", "`map` is missing"],
    );
    says("gltf = \"no.glb\"\n", &["line 1, column 8", "no.glb"]);
    for path in ["no.toml", "no.glb", "no.gltf", "."] {
        let error = read(Path::new(path)).expect_err("a refusal");
        assert_eq!(error.exit_code(), 2, "{error}");
    }
}
