//! Maps with parameters: what is made of them, what is listed and what refused.

use super::parse::npy;
use super::refused::assert_refused;
use super::{Desk, skips};
use corput::bulk::map_sample;
use corput::catalog::{Mapping, Profile, maps};
use corput::check::examples;

/// The options that give a mapping its parameters.
fn options(mapping: &Mapping) -> String {
    let mut values = mapping.values();
    let mut line = format!("--map {}", mapping.map().name);
    for parameter in mapping.map().parameters {
        let (own, rest) = values.split_at(parameter.size);
        let numbers: Vec<String> = own.iter().map(f64::to_string).collect();
        line += &format!(" --param {}={}", parameter.name, numbers.join(","));
        values = rest;
    }
    line
}

fn first(map: &'static corput::catalog::Map) -> Option<Mapping> {
    examples(map).expect("examples").into_iter().next()
}

/// Where nothing says how many dimensions there are, there are those that the map takes.
#[test]
fn a_map_brings_its_dimensions() {
    let desk = Desk::new();
    for map in ["exponential", "gaussian"] {
        let line = format!("sobol --count 100 --device cpu --map {map}");
        let made = desk.make(&line, "p.npy");
        npy(&made).assert_is("<f4", 100, 1);
        assert_eq!(
            made,
            desk.make(&format!("{line} --dims 1"), "q.npy"),
            "{map}"
        );
    }
}

#[test]
fn samples_of_every_map_are_those_of_the_fractions() {
    if skips() {
        return;
    }
    let desk = Desk::new();
    for mapping in maps()
        .filter_map(first)
        .filter(|m| m.tables().is_empty() || m.is_prepared())
    {
        let map = mapping.map();
        let points = format!(
            "sobol --count 1000 --scramble owen --dims {}",
            map.dimensions
        );
        let fractions = npy(&desk.make(&format!("{points} --fractions"), "u.npy"));
        let line = format!("{points} {} --with-pdf", options(&mapping));
        let bytes = desk.make(&line, "d.npy");
        assert!(
            bytes == desk.make(&format!("{line} --device cpu"), "cpu.npy"),
            "{line}"
        );
        let made = npy(&bytes);
        let width = map.coordinates as usize + 1;
        made.assert_is("<f4", 1000, width);
        for row in 0..1000 {
            let mut u = [0; 3];
            u[..map.dimensions as usize].copy_from_slice(fractions.row(row));
            let expected = map_sample(&mapping, Profile::Exact, u);
            assert_eq!(made.row(row), &expected[..width], "`{line}`, row {row}");
        }
        let bare = npy(&desk.make(&format!("{points} {}", options(&mapping)), "b.npy"));
        bare.assert_is("<f4", 1000, width - 1);
        assert!(
            (0..1000).all(|row| bare.row(row) == &made.row(row)[..width - 1]),
            "{line}"
        );
    }
}

#[test]
fn the_list_says_all_of_every_map() {
    let desk = Desk::new();
    let text = desk.say("maps");
    let words = text.split_whitespace().collect::<Vec<_>>().join(" ");
    for map in maps() {
        assert!(
            text.lines().any(|line| line.starts_with(map.name)),
            "{}",
            map.name
        );
        for phrase in [
            map.summary,
            map.pdf,
            map.measure,
            map.source,
            &map.counted(),
        ] {
            let phrase = phrase.split_whitespace().collect::<Vec<_>>().join(" ");
            assert!(words.contains(&phrase), "{}: no `{phrase}`", map.name);
        }
        for parameter in map.parameters {
            assert!(words.contains(&format!("--param {}=X", parameter.name)));
            assert!(words.contains(parameter.domain), "{}", parameter.domain);
        }
        let alone = desk.say(&format!("maps {}", map.name));
        assert!(alone.starts_with(map.name) && text.contains(alone.trim_end()));
    }
    let json: serde_json::Value = serde_json::from_str(&desk.say("maps --json")).expect("JSON");
    let list = json["maps"].as_array().expect("a list");
    assert!(
        list.iter()
            .map(|one| one["name"].as_str())
            .eq(maps().map(|map| Some(map.name)))
    );
    assert_refused("maps con", &["unknown map `con`", "did you mean `cone`"]);
}

#[test]
fn parameters_outside_their_domain_are_refused() {
    for (arguments, words) in [
        (
            "--map cone",
            &["theta_max was not given", "1.3e-15 to pi"][..],
        ),
        (
            "--map cone --param theta_max=0",
            &["map cone: theta_max is 0", "1.3e-15 to pi"],
        ),
        (
            "--map cone --param theta_max=-1",
            &["theta_max is -1", "to pi"],
        ),
        (
            "--map cone --param theta_max=3.1416",
            &["theta_max is 3.1416", "to pi"],
        ),
        (
            "--map cone --param theta_max=1,2",
            &["is 2 numbers", "it takes 1"],
        ),
        (
            "--map cone --param theta_max=1 --param theta_max=1",
            &["given twice"],
        ),
        (
            "--map cone --param theta_max=x",
            &["`x` is no finite number", "theta_max=0.5"],
        ),
        (
            "--map cone --param theta_max=inf",
            &["`inf` is no finite number"],
        ),
        ("--map cone --param theta_max", &["has no value", "NAME=X"]),
        ("--map cone --param =1", &["has no name", "NAME=X"]),
        (
            "--map cone --param theta_max=1e-300",
            &["theta_max is 1e-300;"],
        ),
        (
            "--map disk-light --param center=1",
            &["is 1 number;", "it takes 3"],
        ),
        (
            "--dims 2 --map exponential",
            &["takes 1 dimension per point", "2 were given", "--dims 1"],
        ),
        (
            "--map cone --param theta=1",
            &["unknown parameter `theta`", "did you mean `theta_max`"],
        ),
        (
            "--map uniform-sphere --param theta_max=1",
            &["takes no parameters"],
        ),
        (
            "--param theta_max=1",
            &["only maps have parameters", "--map NAME"],
        ),
    ] {
        assert_refused(
            &format!("generate sobol --count 5 {arguments} --out p.npy"),
            words,
        );
    }
    assert_refused(
        "generate blue-noise --count 5 --map cone --out p.npy",
        &["theta_max was not given"],
    );
    assert_refused(
        "generate blue-noise-mask --size 8 --param a=1 --out p.png",
        &["--param"],
    );
}
