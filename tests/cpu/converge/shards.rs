//! Shards of a study, as a program that calls the library meets them.

use super::damage::{apply, damage};
use super::{UNKNOWN, row, sampler, study, without_times};
use corput::catalog::{Problem, Shard};
use corput::converge::{
    Engine, Gathered, Kept, Row, Setting, Study, item_count, open_shard, run, run_shard,
};
use corput::{Error, Result};
use proptest::prelude::*;
use std::fs;
use std::path::Path;

fn measure(folder: &Path, study: &Study, index: u64, count: u64, most: u64) -> Result<usize> {
    let shard = Shard::new(index, count)?;
    let mut kept = open_shard(folder, study, shard, ["a command", "a device"], false)?;
    let watch = &mut |_: &str, done, total| match done < most {
        true => Ok(()),
        false => Err(Error::Interrupted { done, total }),
    };
    let done = run_shard(&Engine::Cpu, study, shard, "a device", &mut kept, watch)?;
    Ok(done.iter().filter(|one| one.anew).count())
}

fn small() -> Study {
    let samplers = ["random", "halton", "sobol:owen"];
    study(
        vec![row("disk-step", &samplers), row("x-squared", &samplers)],
        [16, 256],
        4,
    )
}

#[test]
fn an_interrupted_shard_goes_on_where_it_was() {
    let folder = tempfile::tempdir().unwrap();
    let study = small();
    assert!(measure(folder.path(), &study, 0, 2, 2).is_err());
    let lacking = Gathered::open(folder.path())
        .unwrap()
        .lacking(None)
        .unwrap();
    let cells: Vec<&str> = lacking.iter().map(|one| one.cell.as_str()).collect();
    assert_eq!(
        cells,
        [
            "disk-step, halton",
            "x-squared, random",
            "x-squared, halton",
            "x-squared, sobol:owen"
        ]
    );
    assert_eq!(measure(folder.path(), &study, 0, 2, 9).unwrap(), 1);
    assert_eq!(measure(folder.path(), &study, 1, 2, 9).unwrap(), 3);
    let gathered = Gathered::open(folder.path()).unwrap();
    assert_eq!(
        (gathered.total(), gathered.lacking(None).unwrap()),
        (6, Vec::new())
    );
    let merged = gathered.results("merge").unwrap();
    let setting = Setting::new(&study, "a device".into(), "test".into());
    let whole = run(&Engine::Cpu, &study, setting, None, &mut |_, _, _| Ok(())).unwrap();
    assert_eq!(without_times(&merged), without_times(&whole));
}

#[test]
fn a_study_of_no_catalogue_has_no_shards() {
    let folder = tempfile::tempdir().unwrap();
    let own = Row {
        name: "unknown".into(),
        problem: Problem::new(&UNKNOWN, &[]).unwrap(),
        samplers: vec![sampler("random")],
    };
    let refused = measure(folder.path(), &study(vec![own], [16, 64], 2), 0, 2, 9);
    assert!(
        refused
            .unwrap_err()
            .to_string()
            .contains("unknown integrand `unknown`")
    );
    assert_eq!(folder.path().read_dir().unwrap().count(), 0);
}

#[test]
fn two_names_of_one_integrand_merge() {
    let names = [
        "genz-gaussian:d=3,difficulty=2",
        "genz-gaussian:difficulty=2,d=3",
    ];
    let study = study(names.map(|name| row(name, &["random"])).into(), [16, 64], 2);
    for count in 1..3 {
        let folder = tempfile::tempdir().unwrap();
        for index in 0..count {
            measure(folder.path(), &study, index, count, 9).unwrap();
        }
        let gathered = Gathered::open(folder.path()).unwrap();
        assert_eq!(gathered.lacking(None).unwrap(), []);
        let merged = gathered.results("merge").unwrap();
        let setting = Setting::new(&study, "a device".into(), "test".into());
        let whole = run(&Engine::Cpu, &study, setting, None, &mut |_, _, _| Ok(())).unwrap();
        assert_eq!(without_times(&merged), without_times(&whole));
    }
}

#[test]
fn a_shard_of_another_study_measures_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let of = |most| study(vec![row("x-squared", &["random"])], [16, most], 2);
    fs::write(folder.path().join("cells-2-of-3.jsonl"), "{\"schema\":").unwrap();
    measure(folder.path(), &of(64), 0, 3, 9).unwrap();
    let refused = measure(folder.path(), &of(128), 1, 3, 9).unwrap_err();
    assert_eq!(refused.exit_code(), 2);
    let refused = refused.to_string();
    assert!(
        refused.contains("cells-0-of-3.jsonl: it has cells of another study: counts has 3"),
        "{refused}"
    );
    assert!(!folder.path().join("cells-1-of-3.jsonl").exists());
    measure(folder.path(), &of(64), 1, 3, 9).unwrap();
    fs::write(folder.path().join("cells-2-of-3.jsonl"), "mine\n").unwrap();
    let refused = measure(folder.path(), &of(64), 1, 3, 9).unwrap_err();
    assert!(
        refused
            .to_string()
            .contains("cells-2-of-3.jsonl: its first line is none of"),
        "{refused}"
    );
}

#[test]
fn a_first_line_is_begun_again_only_if_it_is_its_own() {
    let folder = tempfile::tempdir().unwrap();
    let study = small();
    let path = folder.path().join("cells-0-of-2.jsonl");
    measure(folder.path(), &study, 0, 2, 9).unwrap();
    let whole = fs::read_to_string(&path).unwrap();
    let head = whole.lines().next().unwrap();
    for left in [0, 1, head.len() / 2, head.len()] {
        fs::write(&path, &head[..left]).unwrap();
        measure(folder.path(), &study, 0, 2, 9).unwrap();
        let text = fs::read_to_string(&path).unwrap();
        assert_eq!(text.lines().next(), Some(head));
        assert_eq!(text.lines().count(), 4);
    }
    for text in ["mine", "{\"mine\":1}"] {
        fs::write(&path, text).unwrap();
        let refused = measure(folder.path(), &study, 0, 2, 9).unwrap_err();
        assert_eq!(refused.exit_code(), 2);
        assert!(
            refused.to_string().contains("its first line has no end"),
            "{refused}"
        );
        assert_eq!(fs::read_to_string(&path).unwrap(), text);
    }
}

#[test]
fn shards_are_those_whose_cells_are_taken() {
    let folder = tempfile::tempdir().unwrap();
    let study = small();
    for (index, count) in [(0, 2), (1, 2), (1, 3)] {
        measure(folder.path(), &study, index, count, 9).unwrap();
    }
    let merged = Gathered::open(folder.path())
        .unwrap()
        .results("merge")
        .unwrap();
    assert_eq!(merged.setting.shards, 2);
    assert_eq!(merged.setting.command, "a command\na command\nmerge");
}

#[test]
fn references_are_dealt_too() {
    let own = Row {
        name: "unknown".into(),
        problem: Problem::new(&UNKNOWN, &[]).unwrap(),
        samplers: vec![sampler("random"), sampler("halton")],
    };
    let study = study(vec![own, row("x-squared", &["random"])], [16, 64], 2);
    assert_eq!((study.cells(), item_count(&study).unwrap()), (3, 4));
}

/// A reference takes longer than a cell: a run that goes on has it too.
#[test]
fn a_reference_is_kept_with_the_cells() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("cells.jsonl");
    let own = Row {
        name: "unknown".into(),
        problem: Problem::new(&UNKNOWN, &[]).unwrap(),
        samplers: vec![sampler("random")],
    };
    let study = study(vec![own], [16, 64], 4);
    let goes_on = || {
        let mut kept = Kept::open(&path).unwrap();
        let setting = Setting::new(&study, "cpu".into(), "test".into());
        let watch = &mut |_: &str, _, _| Ok(());
        let results = run(&Engine::Cpu, &study, setting, Some(&mut kept), watch).unwrap();
        (results, std::fs::read_to_string(&path).unwrap())
    };
    let (first, kept) = goes_on();
    assert_eq!(kept.lines().count(), 2);
    assert_eq!(goes_on(), (first, kept));
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, failure_persistence: None, ..ProptestConfig::default() })]

    /// What lies in the folder may be anything: cells are taken or lacking, or all is refused.
    #[test]
    fn damaged_cells_are_read_or_refused(damages in proptest::collection::vec(damage(), 1..4)) {
        static WHOLE: std::sync::LazyLock<Vec<u8>> = std::sync::LazyLock::new(|| {
            let folder = tempfile::tempdir().unwrap();
            let study = study(vec![row("x-squared", &["random", "sobol"])], [16, 64], 2);
            measure(folder.path(), &study, 0, 1, 9).unwrap();
            std::fs::read(folder.path().join("cells-0-of-1.jsonl")).unwrap()
        });
        let mut bytes = WHOLE.clone();
        for damage in &damages {
            apply(&mut bytes, damage);
        }
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join("cells-0-of-1.jsonl"), bytes).unwrap();
        match Gathered::open(folder.path()) {
            Ok(gathered) => {
                let lacking = gathered.lacking(None).unwrap().len();
                prop_assert!(lacking <= gathered.total());
                prop_assert_eq!(gathered.results("merge").is_ok(), lacking == 0);
            }
            Err(error) => prop_assert_eq!(error.exit_code(), 2, "{}", error),
        }
    }
}
