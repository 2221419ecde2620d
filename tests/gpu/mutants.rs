//! Mutations: each mistake put into the shaders must turn a check red, and the linter
//! counts as a check.

#[path = "mutants/harness.rs"]
mod harness;
#[path = "mutants/list.rs"]
mod list;
mod support;

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex};

use corput::check::Verdict;
use corput::compile;
use corput::kernels;
use corput::spirv::{exact_policy, lint, remove_no_contraction};
use corput::vulkan::Device;
use harness::{Edit, Outcome, Target, run, spirv};
use list::{Killer, Mutant, mutants};

/// What kills a mutant, in order of precedence, and the figures; `None`: it survives.
fn death(outcome: &Outcome) -> Option<(Killer, String)> {
    let row = match outcome {
        Outcome::Refused(words) => {
            let first = words.lines().nth(1).unwrap_or(words);
            return Some((Killer::Linter, first.to_owned()));
        }
        Outcome::Ran(row) => row,
    };
    let judge = match (row.worst, row.bound) {
        (Some(worst), Some(bound)) if worst > bound || worst.is_nan() => {
            format!("{worst:.3e} {} exceeds {bound:.3e}", row.unit)
        }
        _ => String::new(),
    };
    match row.mismatches {
        Some(count) if count > 0 => {
            let and = if judge.is_empty() { "" } else { "; judge: " };
            Some((
                Killer::Mismatch,
                format!("{count} of {}{and}{judge}", row.compared),
            ))
        }
        _ if !judge.is_empty() => Some((Killer::Judge, judge)),
        _ => None,
    }
}

fn passes(outcome: &Outcome) -> bool {
    matches!(outcome, Outcome::Ran(row) if row.verdict == Verdict::Passed)
}

#[test]
fn every_mutant_is_killed() {
    support::on_one_device(|device| {
        device.keep_pipelines();
        let survivors = Mutex::new(Vec::new());
        let survived = |what| survivors.lock().expect("no panic").push(what);
        let all: Vec<&Mutant> = mutants().collect();
        support::at_once(&all, |mutant| {
            let Mutant {
                name,
                edit,
                target,
                killer,
            } = mutant;
            if harness::is_missing(device, *target) {
                if device.info().name.contains("llvmpipe") {
                    survived(format!("{name}: not tried, and llvmpipe has every kernel"));
                }
                println!("{name}: not tried, for want of a device with that kernel");
                return;
            }
            match death(&run(device, Some(edit), *target)) {
                Some((by, figures)) => {
                    println!("{name}: {by:?}: {figures}");
                    if by != *killer {
                        survived(format!(
                            "{name}: killed by {by:?}, not {killer:?}\n{}",
                            edit.diff()
                        ));
                    }
                }
                None => survived(format!("{name} on {target:?}\n{}", edit.diff())),
            }
        });
        let survivors = survivors.into_inner().expect("no panic");
        assert!(survivors.is_empty(), "survivors:\n{}", survivors.join("\n"));
    });
}

/// The harness alone changes nothing: the same words as the shipped module, and a pass.
#[test]
fn the_unmutated_source_passes_on_the_same_path() {
    support::on_one_device(|device| {
        device.keep_pipelines();
        let targets = mutants().map(|mutant| (format!("{:?}", mutant.target), mutant.target));
        let targets: Vec<_> = targets.collect::<BTreeMap<_, _>>().into_iter().collect();
        support::at_once(&targets, |(label, target)| {
            let row = harness::row(device, *target);
            let words = compile::check(&spirv(row, None), row.profile).expect("a clean module");
            let shipped = kernels::spirv(row.name).unwrap_or_else(|error| panic!("{error}"));
            assert_eq!(words, shipped, "{}", row.name);
            assert!(passes(&run(device, None, *target)), "{label}");
        });
    });
}

#[test]
fn no_no_contraction_can_go_from_the_frame() {
    let words = kernels::spirv("evaluate_frame").unwrap_or_else(|error| panic!("{error}"));
    let clean = |words: &[u32]| lint(words, &exact_policy()).expect("a module").is_clean();
    assert!(clean(&words));
    let mut removed = 0;
    while let Some(bare) = remove_no_contraction(&words, removed) {
        assert!(!clean(&bare), "decoration {removed}");
        removed += 1;
    }
    println!("{removed} decorations, each missed by the linter");
    assert!(removed > 10);
}

/// Moves a seed by so many units.
fn disturbed(device: &Arc<Device>, function: &'static str, scale: &str, units: i32) -> Outcome {
    let find = format!("* {scale});");
    let replace = format!("* {scale}) + uint({units});");
    let edit = Edit {
        file: "corput/elementary.glsl",
        find: &find,
        replace: &replace,
        times: 1,
    };
    run(device, Some(&edit), Target::Function(function))
}

/// What Vulkan permits is corrected; at the least disturbance whose residual leaves 31
/// bits the checks turn red. Between the two, up to 31 and 127 units, a device with
/// well-rounded seeds still gives the same bits.
#[test]
fn seeds_may_be_off_by_what_vulkan_permits_and_not_by_more() {
    support::on_one_device(|device| {
        for (function, scale, permitted, breaks) in
            [("sqrt", "512.0", 20, 32), ("divide", "16777216.0", 6, 128)]
        {
            for sign in [1, -1] {
                let kept = disturbed(device, function, scale, sign * permitted);
                assert!(passes(&kept), "{function} {}", sign * permitted);
                let killed = death(&disturbed(device, function, scale, sign * breaks));
                let (by, figures) = killed.expect("a kill");
                println!("{function} {}: {by:?}: {figures}", sign * breaks);
                assert_eq!(by, Killer::Mismatch);
            }
        }
    });
}
