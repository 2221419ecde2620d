//! Extreme inputs: each case is within its bound, and a row of `docs/extremes.md`.

use std::sync::LazyLock;

use corput::extreme::{Case, Counts, Given, Row, Subject, cases, page};

fn all() -> Vec<Case> {
    static CASES: LazyLock<Vec<Case>> =
        LazyLock::new(|| cases().expect("the tables of truth are whole"));
    CASES.clone()
}

#[test]
fn every_case_is_within_its_bound() {
    let beyond: Vec<String> = all()
        .iter()
        .filter(|case| case.ours > case.bound || case.ours.is_nan())
        .map(|case| {
            format!(
                "case {}, {}: {:e} of {:e}",
                case.number, case.input, case.ours, case.bound
            )
        })
        .collect();
    assert!(beyond.is_empty(), "{}", beyond.join("\n"));
}

/// Where common formulas hold there is nothing extreme.
#[test]
fn common_formulas_fail_in_nearly_every_kind_of_case() {
    let mut worst = std::collections::BTreeMap::<u32, f64>::new();
    for case in all() {
        let ratio = case.naive / case.bound.max(1e-10);
        let found = worst.entry(case.number).or_default();
        *found = found.max(ratio);
    }
    let numbers: Vec<u32> = worst.keys().copied().collect();
    assert_eq!(numbers, (1..=55).collect::<Vec<u32>>());
    // Ishigami's function and Sobol's g keep to their scale: floats do.
    let mild = worst.iter().filter(|(_, ratio)| **ratio <= 1.0);
    let mild: Vec<u32> = mild.map(|(number, _)| *number).collect();
    assert_eq!(mild, [52, 53]);
}

/// The page but for the errors of common formulas, which depend on the host's functions.
fn ours(page: &str) -> String {
    let cut = |line: &str| {
        let mut fields: Vec<&str> = line.split(" | ").collect();
        if fields.len() == 8 {
            fields.remove(3);
        }
        fields.join(" | ")
    };
    page.lines().map(cut).collect::<Vec<_>>().join("\n")
}

#[test]
fn the_readme_counts_them() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/README.md");
    let readme = std::fs::read_to_string(path).expect("it is there");
    let line = format!("# {} extreme inputs", all().len());
    assert!(readme.contains(&line), "{line}");
}

/// A row says which formula it is beside.
#[test]
fn every_case_names_its_common_formula() {
    let made = page(&all());
    let rows: Vec<&str> = made.lines().filter(|line| line.starts_with("| ")).collect();
    assert_eq!(rows.len(), all().len() + 1);
    for row in rows {
        let fields: Vec<&str> = row.split(" | ").collect();
        assert_eq!(fields.len(), 8, "{row}");
        assert!(fields.iter().all(|field| !field.trim().is_empty()), "{row}");
    }
}

#[test]
fn extreme_cases_are_those_of_the_page() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/docs/extremes.md");
    let made = page(&all());
    if std::env::var_os("CORPUT_WRITE_TABLES").is_some() {
        std::fs::write(path, &made).expect("the page is written");
    }
    let page = std::fs::read_to_string(path).expect("the page");
    assert!(ours(&page) == ours(&made), "docs/extremes.md is another");
}

/// Results of the common formula are beyond the bound, and a flipped bit is seen.
#[test]
fn errors_are_seen() {
    let all = all();
    let case = all
        .iter()
        .find(|case| case.input == "-ln(1 - u), u = 1 2^-32")
        .expect("a case");
    let words = case.subject.reference().expect("a function");
    assert!(case.error(&words) <= case.bound);
    assert!(case.error(&[words[0] ^ 4, 0, 0, 0]) > case.bound);
    assert_eq!(case.error(&[f32::NAN.to_bits()]), f64::INFINITY);
    assert_eq!(case.error(&[]), f64::INFINITY);
    assert!(case.naive > case.bound);
}

#[test]
fn names_of_functions_are_those_of_the_catalogue() {
    for case in all() {
        if let Subject::Function { name, .. } = case.subject {
            let known = corput::catalog::FUNCTIONS.iter().any(|f| f.name == name);
            assert!(known, "{name}");
        }
    }
}

fn found(input: &str) -> Case {
    let mut all = all().into_iter();
    all.find(|case| case.input == input).expect("a case")
}

#[test]
fn each_verdict_can_fail() {
    let case = found("-ln(1 - u), u = 1 2^-32");
    let words = case.subject.reference().expect("a function");
    let given = |exact: &[u32]| Given {
        exact: Some(exact.to_vec()),
        ..Given::default()
    };
    let failure = |case: &Case, given: &Given| Row::judged(case.clone(), given).failure;
    assert_eq!(failure(&case, &given(&words)), None);
    // A bound below the error, one bit of one word, no words, and no result.
    let tight = Case {
        bound: 1e-11,
        ..case.clone()
    };
    let why = failure(&tight, &given(&words)).expect("beyond the bound");
    assert!(why.contains("the CPU errs"), "{why}");
    for bit in 0..128 {
        let mut flipped = words.clone();
        flipped[bit / 32] ^= 1 << (bit % 32);
        let why = failure(&case, &given(&flipped)).expect("another word");
        assert!(why.contains("the device gave"), "{why}");
    }
    assert!(failure(&case, &given(&[])).is_some());
    assert!(failure(&case, &Given::default()).is_some());
    // A case of the host fails by its own error alone.
    let host = found("0.5^100");
    assert!(matches!(host.subject, Subject::Host));
    assert_eq!(failure(&host, &Given::default()), None);
    let broken = Case {
        ours: f64::NAN,
        ..host
    };
    assert!(failure(&broken, &Given::default()).is_some());
}

/// A device that is not asked neither passes nor fails, unless the CPU does.
#[test]
fn what_does_not_apply_is_refused_and_counted() {
    let case = found("20,011 fractions in groups of 1024");
    let given = Given {
        refused: Some("groups of 256 at most".into()),
        ..Given::default()
    };
    let row = Row::judged(case.clone(), &given);
    assert_eq!((row.verdict(), &row.failure), ("refused", &None));
    assert_eq!(row.further().skipped, given.refused);
    let counts = Counts::of(&[row]);
    assert_eq!((counts.refused, counts.device, counts.failed), (1, 0, 0));
    let broken = Case { ours: 1.0, ..case };
    assert_eq!(Row::judged(broken, &given).verdict(), "failed");
}

/// One word of a sum, of its squares or of a count is another error or another word.
#[test]
fn sums_are_judged_by_all_their_words() {
    for input in [
        "Ishigami's function, 2^14 points: these terms",
        "20,011 fractions in groups of 32",
    ] {
        let case = found(input);
        let words = case.subject.reference().expect("sums");
        let passes = |words: &[u32]| {
            let given = Given {
                exact: Some(words.to_vec()),
                ..Given::default()
            };
            Row::judged(case.clone(), &given).verdict() == "passed"
        };
        assert!(passes(&words));
        for place in 0..words.len() {
            let mut other = words.clone();
            other[place] ^= 1;
            assert!(!passes(&other), "{input}: word {place}");
        }
    }
}

#[test]
fn native_errors_are_reported_and_not_judged() {
    let case = found("-ln(1 - u), u = 1 2^-32");
    let words = case.subject.reference().expect("a function");
    let row = Row::judged(
        case,
        &Given {
            exact: Some(words),
            native: Some(vec![f32::NAN.to_bits(), 0, 0, 0]),
            refused: None,
        },
    );
    assert_eq!(row.native, Some(f64::INFINITY));
    assert_eq!(row.failure, None);
    let counts = Counts::of(&[row]);
    assert_eq!((counts.rows, counts.failed), (1, 0));
    assert_eq!((counts.native, counts.native_beyond), (1, 1));
    assert_eq!((counts.device, counts.naive_beyond), (1, 1));
}

/// No number of the catalogue is without a row.
#[test]
fn every_number_has_a_row() {
    let mut numbers: Vec<u32> = all().iter().map(|case| case.number).collect();
    numbers.dedup();
    assert_eq!(numbers, (1..=55).collect::<Vec<u32>>());
}
