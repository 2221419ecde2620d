//! Studies on the CPU's reference, whose sums are those of every device: the rates of the
//! theory, means without bias, and what a study keeps.

#[allow(dead_code, reason = "seeds are of other tests")]
#[path = "parsers/damage.rs"]
mod damage;
#[path = "converge/shards.rs"]
mod shards;

use corput::catalog::{Integrand, Problem, SEQUENCES, Sampler, Scramble, Sequence, integrands};
use corput::converge::{self, Engine, Kept, Results, Row, Setting, Settings, Study, fit};

fn sampler(name: &str) -> Sampler {
    Sampler::parse(name).unwrap_or_else(|error| panic!("{error}"))
}

fn row(integrand: &str, samplers: &[&str]) -> Row {
    Row {
        name: integrand.to_owned(),
        problem: Problem::parse(integrand).unwrap_or_else(|error| panic!("{error}")),
        samplers: samplers.iter().map(|name| sampler(name)).collect(),
    }
}

fn study(rows: Vec<Row>, counts: [u64; 2], replicates: u32) -> Study {
    let settings = Settings {
        min_count: counts[0],
        max_count: counts[1],
        replicates,
        ..Settings::default()
    };
    Study::new(rows, settings).unwrap_or_else(|error| panic!("{error}"))
}

fn results(study: &Study) -> Results {
    let setting = Setting::new(study, "cpu".into(), "test".into());
    converge::run(&Engine::Cpu, study, setting, None, &mut |_, _, _| Ok(()))
        .unwrap_or_else(|error| panic!("{error}"))
}

/// The slopes of one integrand's samplers, with their names.
fn slopes(integrand: &str, samplers: &[&str], counts: [u64; 2]) -> Vec<(String, f64)> {
    let found = results(&study(vec![row(integrand, samplers)], counts, 64));
    let slope = |one: &converge::Series| {
        let slope = one
            .analysis
            .slope
            .unwrap_or_else(|| panic!("{integrand}: no slope"));
        assert_eq!(one.analysis.slope_has_interval, one.analysis.random);
        (one.sampler.clone(), slope.value)
    };
    found.series.iter().map(slope).collect()
}

#[test]
fn random_points_converge_with_the_root_of_their_number() {
    for integrand in [
        "x-squared",
        "disk-step",
        "ishigami",
        "genz-oscillatory:d=4,difficulty=3",
    ] {
        for (name, slope) in slopes(
            integrand,
            &["random", "random-fast", "pcg32"],
            [64, 1 << 14],
        ) {
            assert!((slope + 0.5).abs() < 0.1, "{integrand}, {name}: {slope}");
        }
    }
}

/// Owen 1997: the variance is n^-3 (log n)^(d-1), so the error of smooth integrands falls as
/// n^-3/2 but for the logarithm, which at d = 2 and these counts is worth 0.07.
#[test]
fn scrambled_nets_converge_with_the_power_three_halves() {
    let samplers = ["sobol:owen", "sobol:owen-hash"];
    for (integrand, log_factor) in [
        ("x-squared", 0.0),
        ("square-of-sum:d=2", 0.0),
        ("genz-gaussian:d=2,difficulty=3", 0.07),
    ] {
        for (name, slope) in slopes(integrand, &samplers, [256, 1 << 15]) {
            assert!(
                (slope + 1.5 - log_factor).abs() < 0.1,
                "{integrand}, {name}: {slope}"
            );
        }
    }
}

#[test]
fn low_discrepancy_beats_chance_on_the_step_of_a_disk() {
    let counts = [64, 1 << 16];
    let names = [
        "random",
        "halton",
        "hammersley",
        "halton:permute",
        "sobol:owen",
    ];
    let found = slopes("disk-step", &names, counts);
    let random = found[0].1;
    for (name, slope) in &found[1..] {
        assert!(*slope < random - 0.1, "{name}: {slope}, random {random}");
    }
}

/// Without a variance, the mean square says nothing: the median of the magnitudes does.
#[test]
fn infinite_variance_is_reported_by_the_median() {
    let study = study(
        vec![row("inverse-root", &["random", "sobol:owen"])],
        [64, 1 << 12],
        64,
    );
    for series in results(&study).series {
        assert_eq!(
            series.analysis.statistic,
            converge::Statistic::MedianAbsolute
        );
        assert!(
            series
                .analysis
                .slope
                .is_some_and(|slope| slope.value < -0.3)
        );
    }
}

/// The fit can fail: another law is not taken for that of chance.
#[test]
fn a_wrong_law_is_told_from_the_right_one() {
    let counts: Vec<u64> = (6..=14).map(|log| 1 << log).collect();
    let law = |power: f64| counts.iter().map(move |&n| (n as f64).powf(power));
    assert!(fit(&counts, law(-0.7)).is_some_and(|slope| (slope + 0.5).abs() > 0.1));
}

/// Estimators of which fewer than a hundred of all points meet what they are to find: no spread
/// tells of what never came.
const RARE: [(&str, &str); 3] = [
    ("gaussian-peak", "uniform"),
    ("irradiance", "uniform"),
    ("irradiance", "cosine"),
];

/// Every sampler that is random, on every integrand of finite variance that points hit often:
/// the mean over replicates lies within four standard errors and the floor of the truth.
#[test]
fn means_have_no_bias() {
    let mut compared = 0;
    let mut expected = 0;
    let named = |one: &Integrand| match one.needs_map {
        true => format!("{}:map=tests/data/sunrise.exr", one.name),
        false => one.name.to_owned(),
    };
    let problems = integrands()
        .filter(|one| one.finite_variance)
        .flat_map(|one| {
            let first = Problem::parse(&named(one)).unwrap();
            let estimators = one.estimators.iter();
            let all: Vec<Problem> = match one.estimators {
                [] => vec![first],
                _ => estimators
                    .map(|name| first.with_estimator(name).unwrap())
                    .collect(),
            };
            all
        });
    for problem in problems {
        if RARE.contains(&(problem.integrand().name, problem.estimator().unwrap_or(""))) {
            continue;
        }
        let name = problem.integrand().name;
        let samplers = SEQUENCES.iter().flat_map(|&sequence| {
            let scrambles = sequence.scrambles().iter().copied().map(Some);
            scrambles
                .chain([None])
                .filter_map(move |scramble: Option<Scramble>| {
                    Sampler::new(sequence, scramble)
                        .ok()
                        .filter(|one| one.is_random())
                })
        });
        for sampler in samplers {
            let (least, most) = sampler.sequence().dimensions();
            if !(least..=most).contains(&problem.dimensions()) {
                continue;
            }
            expected += 1;
            // A number for which Korobov generators are published, too; it is prime.
            let count = match sampler.sequence() {
                Sequence::MultiJittered => 1020,
                _ => 1021,
            };
            let row = Row {
                name: name.into(),
                problem: problem.clone(),
                samplers: vec![sampler],
            };
            let settings = Settings {
                min_count: count,
                max_count: count,
                replicates: 64,
                ..Settings::default()
            };
            let study = Study::new(vec![row], settings).unwrap_or_else(|error| panic!("{error}"));
            for one in results(&study).series {
                let at = one.analysis.errors[0];
                let allowed = 4.0 * at.bias_error + one.truth.floor();
                // Drawn by the peak itself, every term is the integral.
                let varies = at.bias_error > 0.0 || name == "gaussian-peak";
                assert!(varies, "{name}, {}", one.label());
                assert!(
                    at.bias.abs() <= allowed,
                    "{name}, {}: {} of {allowed}",
                    one.label(),
                    at.bias
                );
                compared += 1;
            }
        }
    }
    assert_eq!(compared, expected);
    assert!(expected > 500, "{expected}");
}

/// A peak that fills a 400th of the square: few points meet it, and slopes leave their counts
/// out, whatever the sampler; of x^2 all points tell.
#[test]
fn few_hits_are_told_and_left_out() {
    let problem = Problem::parse("gaussian-peak:d=2,sigma=0.02").unwrap();
    let peak = Row {
        name: "peak".into(),
        problem: problem.with_estimator("uniform").unwrap(),
        samplers: vec![sampler("random"), sampler("halton"), sampler("sobol:owen")],
    };
    let plain = row("x-squared", &["random", "halton"]);
    let found = results(&study(vec![peak, plain], [16, 1 << 14], 16));
    for series in &found.series {
        let analysis = &series.analysis;
        let few = analysis.errors.iter().filter(|at| at.few_hits()).count();
        let counts = analysis.slope_counts;
        assert_eq!(
            counts.fitted + counts.small + counts.few_hits + counts.near_floor,
            11,
            "{}",
            series.label()
        );
        match series.integrand.as_str() {
            "peak" => {
                let last = analysis.errors.last().unwrap();
                let runs = if analysis.random { 16.0 } else { 1.0 };
                let share = last.hits.unwrap() / (runs * last.count as f64);
                assert!(last.hits.unwrap() <= runs * last.count as f64);
                // (integral of f^2)^2 / integral of f^4 = 2 pi sigma^2.
                assert!((1.2e-3..5e-3).contains(&share), "{share:e}");
                assert!((7..=9).contains(&few), "{few}");
                assert_eq!(counts.small, 2);
                assert_eq!(counts.few_hits, few as u64 - 2);
            }
            _ => assert_eq!((few, counts.few_hits), (0, 0), "{:?}", analysis.errors),
        }
    }
}

/// The same without the randomisation: the bias of a fixed sequence would be found.
#[test]
fn a_bias_is_found() {
    let found = results(&study(vec![row("x-squared", &["sobol"])], [1024, 1024], 8));
    let at = found.series[0].analysis.errors[0];
    assert!(at.bias.abs() > 4.0 * at.bias_error + found.series[0].truth.floor());
}

/// x^2 as if no one knew its integral: a larger reference stands in, with its interval.
static UNKNOWN: std::sync::LazyLock<Integrand> = std::sync::LazyLock::new(|| Integrand {
    truth: |_| f64::NAN,
    ..*Integrand::from_name("x-squared").unwrap_or_else(|error| panic!("{error}"))
});

#[test]
fn a_missing_truth_is_measured_and_said() {
    let row = Row {
        name: "unknown".into(),
        problem: Problem::new(&UNKNOWN, &[]).unwrap(),
        samplers: vec![sampler("random"), sampler("sobol:owen")],
    };
    let found = results(&study(vec![row], [16, 1024], 16));
    for series in &found.series {
        let truth = series.truth;
        let uncertainty = truth.uncertainty.expect("a measured reference");
        assert!(
            uncertainty > 0.0 && truth.floor() > uncertainty,
            "{truth:?}"
        );
        // The 95 % interval of 16 means: of twice as wide ones, nearly all.
        assert!(
            (truth.value - 1.0 / 3.0).abs() < 2.0 * truth.floor(),
            "{truth:?}"
        );
    }
    let document = found.document();
    assert!(document["series"][0]["truth_uncertainty"].is_f64());
    // Errors near the reference's own are not fitted.
    let owen = &found.series[1].analysis;
    assert!(owen.errors.iter().any(|one| one.above_floor));
}

#[test]
fn a_study_that_was_cut_off_ends_with_the_same_errors() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("cells.jsonl");
    let samplers = ["random", "halton", "sobol:owen"];
    let study = study(
        vec![row("disk-step", &samplers), row("x-squared", &samplers)],
        [16, 1024],
        8,
    );
    let whole = results(&study);
    let setting = || Setting::new(&study, "cpu".into(), "test".into());
    // Stops after so many cells, and once more.
    for most in [1, 4] {
        let mut kept = Kept::open(&path).unwrap();
        let stopped = converge::run(
            &Engine::Cpu,
            &study,
            setting(),
            Some(&mut kept),
            &mut |_, done, total| match done >= most {
                true => Err(corput::Error::Interrupted { done, total }),
                false => Ok(()),
            },
        );
        assert!(stopped.is_err());
        let lines = std::fs::read_to_string(&path).unwrap().lines().count() as u64;
        assert_eq!(lines, most);
    }
    let goes_on = || {
        let mut kept = Kept::open(&path).unwrap();
        let watch = &mut |_: &str, _, _| Ok(());
        converge::run(&Engine::Cpu, &study, setting(), Some(&mut kept), watch).unwrap()
    };
    let resumed = goes_on();
    assert_eq!(without_times(&resumed), without_times(&whole));
    // And all that is kept is the same, times included.
    let again = goes_on();
    assert_eq!(again.document(), resumed.document());
}

/// What is in the file of a study that was cut off may be anything.
#[test]
fn a_kept_cell_that_cannot_be_is_measured_anew() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("cells.jsonl");
    let study = study(vec![row("disk-step", &["random"])], [16, 64], 4);
    let goes_on = || {
        let mut kept = Kept::open(&path).unwrap();
        let setting = Setting::new(&study, "cpu".into(), "test".into());
        let watch = &mut |_: &str, _, _| Ok(());
        converge::run(&Engine::Cpu, &study, setting, Some(&mut kept), watch).unwrap()
    };
    let first = goes_on();
    let text = std::fs::read_to_string(&path).unwrap();
    let times = text.find("\"device_ns\":[").expect("times") + 13;
    let mut negative = text.clone();
    negative.insert(times, '-');
    let empty = text.replacen(
        &text[times..times + text[times..].find(']').expect("an end")],
        "",
        1,
    );
    for harmed in [
        text.replace("\"count\":16", "\"count\":15"),
        negative,
        empty,
    ] {
        assert_ne!(harmed, text);
        std::fs::write(&path, &harmed).unwrap();
        let again = goes_on();
        assert_eq!(without_times(&again), without_times(&first));
        let lines = std::fs::read_to_string(&path).unwrap().lines().count();
        assert_eq!(lines, 2, "measured anew");
    }
}

/// A cell that another kernel summed is measured anew, the others are taken.
#[test]
fn a_changed_kernel_is_not_mixed_with_old_cells() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("cells.jsonl");
    let samplers = ["random", "halton", "sobol:owen"];
    let study = study(vec![row("disk-step", &samplers)], [16, 256], 4);
    let goes_on = |outdated: u64| {
        let mut kept = Kept::open(&path).unwrap();
        let setting = Setting::new(&study, "cpu".into(), "test".into());
        let watch = &mut |_: &str, _, _| Ok(());
        let results = converge::run(&Engine::Cpu, &study, setting, Some(&mut kept), watch);
        assert_eq!(kept.outdated(), outdated);
        results.unwrap().document()
    };
    let first = goes_on(0);
    assert_eq!(goes_on(0), first);
    // As if the kernel of Halton's points had been another.
    let text = std::fs::read_to_string(&path).unwrap();
    let program = |sampler: &str| {
        let row = &study.rows()[0];
        let program = Engine::Cpu.program(&study, row, self::sampler(sampler));
        program.unwrap_or_else(|error| panic!("{error}"))
    };
    let (version, kernel) = (env!("CARGO_PKG_VERSION"), program("halton"));
    assert!(kernel.starts_with(version) && kernel.len() == version.len() + 65);
    assert_eq!(text.matches(&kernel).count(), 1);
    assert_ne!(kernel, program("random"));
    std::fs::write(
        &path,
        text.replace(&kernel, &format!("{version} {:064}", 0)),
    )
    .unwrap();
    let again = goes_on(1);
    for place in [0, 2] {
        assert_eq!(again["series"][place], first["series"][place]);
    }
    let seconds = |document: &serde_json::Value| document["series"][1]["points"][3].clone();
    assert_eq!(seconds(&again)["means"], seconds(&first)["means"]);
    assert_ne!(seconds(&again), seconds(&first), "times of another run");
    assert_eq!(goes_on(0), again);
}

/// A word of a kernel that can run, and a value of its constants, are in its fingerprint.
#[test]
fn fingerprints_tell_kernels_apart() {
    use corput::kernels::{fingerprint, spirv};
    let words = spirv("estimate").unwrap_or_else(|error| panic!("{error}"));
    let whole = fingerprint(&words, &[(0, 64)]);
    assert_eq!(whole, fingerprint(&words, &[(0, 64)]));
    assert_ne!(whole, fingerprint(&words, &[(0, 32)]));
    let mut other = words.clone();
    // The generator's mark, which no pruning removes.
    other[2] ^= 1;
    assert_ne!(whole, fingerprint(&other, &[(0, 64)]));
}

/// The table without its columns of times, which are the last four.
fn without_times(results: &Results) -> Vec<String> {
    let line = |line: &str| {
        let cells: Vec<&str> = line.split(',').collect();
        cells[..cells.len() - 4].join(",")
    };
    results.csv().lines().map(line).collect()
}

#[test]
fn studies_that_say_nothing_are_refused() {
    let settings = |change: fn(&mut Settings)| {
        let mut settings = Settings::default();
        change(&mut settings);
        let rows = vec![row("x-squared", &["random"])];
        Study::new(rows, settings).unwrap_err().to_string()
    };
    assert!(settings(|s| s.replicates = 1).contains("an interval needs 2"));
    assert!(settings(|s| s.max_count = 8).contains("the fewest first"));
    assert!(settings(|s| s.min_count = 0).contains("1 to 2^32"));
    assert!(settings(|s| s.targets = vec![0.0]).contains("above 0"));
    let said = |rows| {
        Study::new(rows, Settings::default())
            .unwrap_err()
            .to_string()
    };
    assert!(said(Vec::new()).contains("nothing"));
    assert!(said(vec![row("x-squared", &["random", "random"])]).contains("twice"));
    assert!(said(vec![row("disk-step", &["vdc"])]).contains("vdc"));
    let twice = vec![row("x-squared", &["random"]), row("x-squared", &["sobol"])];
    assert!(said(twice).contains("twice"));
}

#[test]
fn counts_are_powers_of_two_and_the_last() {
    let counts = |min, max| {
        study(vec![row("x-squared", &["random"])], [min, max], 2)
            .counts()
            .to_vec()
    };
    assert_eq!(counts(16, 64), [16, 32, 64]);
    assert_eq!(counts(10, 100), [16, 32, 64, 100]);
    assert_eq!(counts(1, 1), [1]);
}
