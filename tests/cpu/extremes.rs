//! Extreme inputs: each case is within its bound, and a row of `docs/extremes.md`.

use corput::extreme::{Case, Subject, cases, page};

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
    let expected: Vec<u32> = [2, 3, 4].into_iter().chain(12..=41).collect();
    assert_eq!(numbers, expected);
    let mild: Vec<_> = worst.iter().filter(|(_, ratio)| **ratio <= 1.0).collect();
    assert!(mild.is_empty(), "{mild:?}");
}

/// The page but for the errors of common formulas, which depend on the host's functions.
fn ours(page: &str) -> String {
    let cut = |line: &str| {
        let mut fields: Vec<&str> = line.split(" | ").collect();
        if fields.len() == 5 {
            fields.remove(2);
        }
        fields.join(" | ")
    };
    page.lines().map(cut).collect::<Vec<_>>().join("\n")
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
