//! The page of extreme cases: each is a row of `docs/extremes.md` and an assertion.

use std::sync::Mutex;

/// One writer of the page at a time.
static PAGE: Mutex<()> = Mutex::new(());

const HEAD: &str = "# Extreme cases

What the common formula of each function gives in float, and what this crate gives in its exact
profile, where the input is extreme: errors relative to the truth, which `tests/data` has to 25
digits, or as the input says. `inf` stands for an infinity, a NaN, or a value that should not be 0.
The numbers of the first column are those of the tests. `CORPUT_WRITE_TABLES=1 cargo test
--all-features extreme` writes this page; without it the same tests compare the columns that are ours,
and fail where an error exceeds its bound.

| case | input | common formula | here | bound |
|---|---|---|---|---|
";

/// Demands that ours is within the bound, and that the page has this row.
pub fn extreme(case: u32, input: &str, naive: f64, ours: f64, bound: f64) {
    assert!(ours <= bound, "case {case}, {input}: {ours:e}");
    let start = format!("| {case} | {input} | ");
    let end = format!("| {ours:.1e} | {bound:.0e} |");
    let _only = PAGE.lock().expect("no test died while writing");
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/docs/extremes.md");
    let page = std::fs::read_to_string(path).unwrap_or_else(|_| HEAD.to_owned());
    let found = |line: &&str| line.starts_with(&start) && line.ends_with(&end);
    if std::env::var_os("CORPUT_WRITE_TABLES").is_some() {
        let rows = page.strip_prefix(HEAD).unwrap_or_default();
        let others = rows.lines().filter(|line| !line.starts_with(&start));
        let mut rows: Vec<String> = others.map(str::to_owned).collect();
        rows.push(format!("{start}{naive:.1e} {end}"));
        rows.sort_by_key(|row| (number(row), row.clone()));
        std::fs::write(path, format!("{HEAD}{}\n", rows.join("\n"))).expect("the page is written");
    } else {
        assert!(
            page.lines().any(|line| found(&line)),
            "docs/extremes.md lacks {start}... {end}"
        );
    }
}

fn number(row: &str) -> u32 {
    let mut words = row.split_whitespace().skip(1);
    words
        .next()
        .and_then(|word| word.parse().ok())
        .unwrap_or(u32::MAX)
}
