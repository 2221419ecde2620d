//! Extreme inputs: each case is within its bound, and a row of `docs/extremes.md`.

use corput::extreme::{By, COVERED, Case, Counts, Given, Row, Subject, cases, page};

fn all() -> Vec<Case> {
    cases().expect("the tables of truth are whole")
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
        let ratio = case.naive / case.bound.max(1e-9);
        let found = worst.entry(case.number).or_default();
        *found = found.max(ratio);
    }
    let numbers: Vec<u32> = worst.keys().copied().collect();
    let expected: Vec<u32> = [2, 3, 4].into_iter().chain(12..=41).chain([54]).collect();
    assert_eq!(numbers, expected);
    let mild: Vec<_> = worst.iter().filter(|(_, ratio)| **ratio <= 1.0).collect();
    assert!(mild.is_empty(), "{mild:?}");
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
    let words = case.subject.reference().expect("a function").to_vec();
    let given = |exact: &[u32]| Given {
        exact: Some(exact.to_vec()),
        native: None,
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
    assert_eq!(host.subject, Subject::Host);
    assert_eq!(failure(&host, &Given::default()), None);
    let broken = Case {
        ours: f64::NAN,
        ..host
    };
    assert!(failure(&broken, &Given::default()).is_some());
}

#[test]
fn native_errors_are_reported_and_not_judged() {
    let case = found("-ln(1 - u), u = 1 2^-32");
    let words = case.subject.reference().expect("a function").to_vec();
    let row = Row::judged(
        case,
        &Given {
            exact: Some(words),
            native: Some(vec![f32::NAN.to_bits(), 0, 0, 0]),
        },
    );
    assert_eq!(row.native, Some(f64::INFINITY));
    assert_eq!(row.failure, None);
    let counts = Counts::of(&[row]);
    assert_eq!((counts.rows, counts.failed), (1, 0));
    assert_eq!((counts.native, counts.native_beyond), (1, 1));
    assert_eq!((counts.device, counts.naive_beyond), (1, 1));
}

/// Every number of the catalogue is judged here or covered elsewhere, by what there is.
#[test]
fn what_covers_the_others_exists() {
    let mut numbers: Vec<u32> = COVERED.iter().map(|one| one.number).collect();
    numbers.extend(all().iter().map(|case| case.number));
    numbers.sort_unstable();
    numbers.dedup();
    assert_eq!(numbers, (1..=55).collect::<Vec<u32>>());
    for one in COVERED {
        let exists = match one.by {
            By::Test { file, name } => {
                let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join(file);
                let text = std::fs::read_to_string(path).expect("the file");
                let at = text.find(&format!("\nfn {name}()")).unwrap_or(0);
                let marks: Vec<&str> = text[..at].lines().rev().take(2).collect();
                let ignored = marks[0].starts_with("#[ignore");
                ignored == one.input.ends_with("(--ignored)")
                    && marks[usize::from(ignored)] == "#[test]"
            }
            By::Check { only } => {
                let functions = corput::catalog::FUNCTIONS.iter().map(|f| f.name);
                let integrands = corput::catalog::integrands().map(|i| i.name);
                functions.chain(integrands).any(|name| name == only)
            }
        };
        assert!(exists, "{one:?}");
    }
}
