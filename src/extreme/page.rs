//! The cases as a page of text.

use super::Case;
use super::formulas::formula;

const HEAD: &str = "# Extreme cases

What the common formula of each function gives in float, and what this crate gives in its exact
profile, where the input is extreme: errors relative to the truth, or as the input says. Truths are
closed forms in `f64`, integers, or of 25 digits by mpmath, which `assets/truth` has. `inf` stands for
an infinity, a NaN, or a value that should not be 0. Solid angles are the reciprocals of pdfs. Means
over points are judged by the integral, from which they may be five standard errors of as many
random points, and by the mean of the same terms in `f64`.
`corput check --extreme` computes the rows, and those of a device beside them.
`CORPUT_WRITE_TABLES=1 cargo test --all-features --test extremes` writes this page; without it the
same test compares the columns that are ours, and fails where an error exceeds its bound.

| case | input | common formula | its error | error here | bound | verdict | truth |
|---|---|---|---|---|---|---|---|
";

/// `docs/extremes.md` of these cases.
#[must_use]
pub fn page(cases: &[Case]) -> String {
    let row = |case: &Case| {
        // A NaN is within no bound.
        let verdict = if case.ours <= case.bound {
            "within"
        } else {
            "beyond"
        };
        format!(
            "| {} | {} | {} | {:.1e} | {:.1e} | {:.0e} | {verdict} | {} |\n",
            case.number,
            case.input,
            formula(case),
            case.naive,
            case.ours,
            case.bound,
            case.truth.source.name()
        )
    };
    let rows: Vec<String> = cases.iter().map(row).collect();
    format!("{HEAD}{}", rows.concat())
}
