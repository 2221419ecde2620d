//! `corput converge`.

use super::refused::assert_refused;
use super::{Desk, repository, skips};
use serde_json::Value;

fn document(text: &[u8]) -> Value {
    serde_json::from_slice(text).unwrap_or_else(|error| panic!("{error}"))
}

/// The document of a study that ends well, with warnings or without.
fn measured(desk: &Desk, line: &str) -> Value {
    let run = desk.run(line);
    run.expect(0, &[]);
    document(&run.stdout)
}

#[test]
fn errors_are_the_same_on_the_device_and_the_cpu() {
    if skips() {
        return;
    }
    let desk = Desk::new();
    let line = "converge --integrand disk-step --integrand genz-gaussian:d=5 --max-count 1024 \
                --sampler random,halton,sobol:owen,stratified --replicates 8 --json";
    let [cpu, device] =
        ["--device cpu", ""].map(|device| measured(&desk, &format!("{line} {device}")));
    let series = |document: &Value| document["series"].as_array().expect("series").clone();
    let (cpu, device) = (series(&cpu), series(&device));
    assert_eq!(cpu.len(), 8);
    for (one, other) in cpu.iter().zip(&device) {
        assert_eq!(one["slope"], other["slope"]);
        for (a, b) in one["points"]
            .as_array()
            .unwrap()
            .iter()
            .zip(other["points"].as_array().unwrap())
        {
            for key in ["count", "error", "bias", "means"] {
                assert_eq!(a[key], b[key], "{} {}", one["sampler"], key);
                assert!(!a[key].is_null());
            }
            assert!(b["seconds"]["median"].as_f64().is_some_and(|s| s > 0.0));
        }
    }
}

#[test]
fn the_text_names_who_is_first_at_each_target() {
    let desk = Desk::new();
    let line = "converge --integrand x-squared --sampler random,sobol:owen,halton --max-count 4096 \
                --replicates 32 --device cpu --target 1e-2,1e-9";
    let text = desk.say(line);
    assert!(text.contains("to 1e-2: use "), "{text}");
    assert!(text.contains("to 1e-9: none reaches it"), "{text}");
    assert!(text.contains("(one run)"), "{text}");
}

#[test]
fn a_report_is_whole_and_leaves_no_cells_behind() {
    let desk = Desk::new();
    let line = "converge --integrand x-squared --sampler random,sobol --max-count 256 --replicates 4 \
                --device cpu --report out";
    desk.run(line).expect(0, &["report.html"]);
    let json = document(&desk.bytes("out/results.json"));
    assert_eq!(json["schema"], "corput-converge/2");
    assert_eq!(
        json["command"],
        format!("corput {line}").replace("                ", "")
    );
    let csv = String::from_utf8(desk.bytes("out/results.csv")).unwrap();
    // Two samplers at 16, 32, 64, 128 and 256 points.
    assert_eq!(csv.lines().count(), 11);
    assert!(!desk.path("out/unfinished.jsonl").exists());
}

#[test]
fn a_study_goes_on_and_says_what_it_measures_anew() {
    use corput::converge::{self, Engine, Kept, Setting, Settings, Study};
    let desk = Desk::new();
    std::fs::create_dir(desk.path("out")).unwrap();
    let path = desk.path("out/unfinished.jsonl");
    let samplers = ["random", "sobol"].map(|name| corput::catalog::Sampler::parse(name).unwrap());
    let settings = Settings {
        max_count: 64,
        replicates: 4,
        ..Settings::default()
    };
    let rows = converge::rows("x-squared", &[], &samplers).unwrap();
    let study = Study::new(rows, settings).unwrap();
    let device = "cpu (the reference, every core)";
    let setting = Setting::new(&study, device.into(), "test".into());
    let mut kept = Kept::open(&path).unwrap();
    let watch = &mut |_: &str, _, _| Ok(());
    converge::run(&Engine::Cpu, &study, setting, Some(&mut kept), watch).unwrap();
    let text = std::fs::read_to_string(&path).unwrap();
    let program = Engine::Cpu.program(&study, &study.rows()[0], samplers[0]);
    let other = text.replace(&program.unwrap(), "0.0.0 of another kernel");
    assert_ne!(other, text);
    let line = "converge --integrand x-squared --sampler random,sobol --max-count 64 \
                --replicates 4 --device cpu --report out";
    let words = "of other kernels or of another version";
    std::fs::write(&path, &text).unwrap();
    let run = desk.run(line);
    run.expect(0, &[]);
    assert!(!run.stderr.contains(words));
    std::fs::write(&path, &other).unwrap();
    desk.run(line)
        .expect(0, &["1 cell of out/unfinished.jsonl was of other kernels"]);
}

#[test]
fn warnings_say_what_a_count_costs() {
    let desk = Desk::new();
    let line = "converge --integrand x-squared --sampler sobol:owen,lattice --min-count 1000 \
                --max-count 3000000 --replicates 2 --device cpu";
    desk.run(line).expect(
        0,
        &[
            "warning: sobol:owen: ",
            "power of two",
            "warning: lattice on x-squared has no",
        ],
    );
}

#[test]
fn studies_that_cannot_be_made() {
    for (arguments, words) in [
        ("--integrand x-sqared", &["did you mean `x-squared`"][..]),
        (
            "--integrand x-squared --sampler sobl",
            &["unknown sampler", "`sobol`"],
        ),
        (
            "--integrand x-squared --sampler sobol:owne",
            &["unknown scramble", "`owen`"],
        ),
        (
            "--integrand x-squared --estimator mis",
            &["estimator", "x-squared"],
        ),
        (
            "--integrand x-squared --replicates 1",
            &["an interval needs 2"],
        ),
        ("--integrand x-squared --max-count 0", &["1 to 2^32"]),
        ("--integrand x-squared --target 0", &["above 0"]),
        (
            "--integrand x-squared --study s.toml",
            &["cannot be used with"],
        ),
        ("--study none.toml", &["cannot use study none.toml"]),
        ("--estimator mis", &["--integrand"]),
        ("--fresh", &["--report"]),
    ] {
        assert_refused(&format!("converge --device cpu {arguments}"), words);
    }
    let desk = Desk::new();
    std::fs::write(desk.path("s.toml"), "seed = 1\nreplicats = 32\n").unwrap();
    desk.run("converge --study s.toml")
        .expect(2, &["s.toml", "line 2, column 1", "replicats"]);
    std::fs::write(desk.path("file"), "").unwrap();
    desk.run("converge --report file --device cpu")
        .expect(2, &["cannot write file"]);
}

/// What has no end, and what has more bytes than any such document: neither is read to the end.
#[test]
fn documents_are_read_within_bounds() {
    let desk = Desk::new();
    let large = |name: &str, bytes: u64| {
        let file = std::fs::File::create(desk.path(name)).unwrap();
        file.set_len(bytes).unwrap();
    };
    large("s.toml", (1 << 20) + 1);
    large("card.json", (64 << 20) + 1);
    let study = [
        "cannot use study",
        "more than 1048576 bytes, the limit",
        "as the README shows",
    ];
    desk.run("converge --study s.toml --device cpu")
        .expect(2, &study);
    desk.run("scene s.toml").expect(
        2,
        &[
            "cannot use scene",
            "more than 1048576 bytes, the limit",
            "give a scene file",
        ],
    );
    let card = [
        "cannot use card.json",
        "more than 67108864 bytes, the limit",
        "--report DIR",
    ];
    desk.run("check --compare card.json card.json")
        .expect(2, &card);
    if cfg!(unix) {
        desk.run("converge --study /dev/zero --device cpu")
            .expect(2, &study);
        desk.run("check --compare /dev/zero /dev/zero")
            .expect(2, &["cannot use /dev/zero", "67108864 bytes, the limit"]);
    }
}

/// The page of a study and that of a driver's card have one name.
#[test]
fn a_report_is_not_written_over_another() {
    let desk = Desk::new();
    let line = "converge --integrand x-squared --sampler random --max-count 64 --replicates 2 \
                --device cpu --report";
    desk.run(&format!("{line} study")).expect(0, &[]);
    let page = desk.bytes("study/report.html");
    desk.run("check --only unit_stratum --report study").expect(
        2,
        &[
            "cannot write study/report.html: it is the report of `corput converge`",
            "another folder with --report",
        ],
    );
    assert_eq!(desk.bytes("study/report.html"), page);
    std::fs::create_dir(desk.path("card")).unwrap();
    std::fs::write(desk.path("card/report.html"), "a card").unwrap();
    std::fs::write(
        desk.path("card/report.json"),
        "{\"schema\":\"corput-card/2\"}",
    )
    .unwrap();
    for line in [format!("{line} card"), format!("{line} card --shard 0/1")] {
        let words = ["card/report.html: it is the report of `corput check`, whose report.json"];
        desk.run(&line).expect(2, &words);
    }
    assert_eq!(desk.bytes("card/report.html"), b"a card");
    // Its own it replaces.
    desk.run(&format!("{line} study")).expect(0, &[]);
}

#[test]
fn the_study_of_the_tests_can_be_run() {
    let desk = Desk::new();
    let study = repository("tests/data/study.toml");
    let line = format!(
        "converge --device cpu --max-count 64 --replicates 2 --json --study {}",
        study.display()
    );
    let json = measured(&desk, &line);
    assert_eq!(json["series"].as_array().map(Vec::len), Some(36));
    assert_eq!(json["not_finite"], 0);
}
