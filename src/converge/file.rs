//! Study files.
//!
//! ```toml
//! replicates = 32                       # each setting may be left out
//! seed = 1
//! min-count = 16
//! max-count = 262144
//! targets = [1e-2, 1e-3, 1e-4]
//! samplers = ["random", "sobol:owen"]   # of the integrands that name none
//!
//! [[integrand]]
//! name = "genz-gaussian:d=8"
//!
//! [[integrand]]
//! name = "irradiance:map=tests/data/sunrise.exr"
//! estimators = ["cosine", "mis"]        # by default all
//! samplers = ["random"]
//! ```
//!
//! Paths of maps count from the folder in which the command runs, as on the command line.

use super::study::{Row, Settings, rows};
use crate::catalog::Sampler;
use crate::report::bounded_text;
use crate::{Error, Result};
use serde::Deserialize;
use std::path::Path;
use toml::Spanned;

/// The default study: six integrands, six samplers.
pub const DEFAULT: &str = include_str!("../../tests/data/study.toml");

/// A study file of more bytes is none.
const LONGEST: u64 = 1 << 20;

#[derive(Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
struct File {
    replicates: Option<u32>,
    seed: Option<u64>,
    min_count: Option<u64>,
    max_count: Option<u64>,
    targets: Option<Vec<f64>>,
    #[serde(default)]
    samplers: Vec<Spanned<String>>,
    #[serde(default)]
    integrand: Vec<Entry>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
struct Entry {
    name: Spanned<String>,
    #[serde(default)]
    estimators: Vec<Spanned<String>>,
    #[serde(default)]
    samplers: Vec<Spanned<String>>,
}

/// Reads a study file.
///
/// # Errors
/// [`Error::Study`] for one that cannot be read, or says what cannot be: with line and
/// column.
pub fn read(path: &Path) -> Result<(Vec<Row>, Settings)> {
    let failed = |problem: String| Error::Study {
        path: path.to_owned(),
        problem,
        remedy: "give a study file as the README shows it".into(),
    };
    let text = bounded_text(path, LONGEST).map_err(failed)?;
    parse(&text, path)
}

/// The same of its text; messages name the path.
///
/// # Errors
/// [`Error::Study`], as above.
pub fn parse(text: &str, path: &Path) -> Result<(Vec<Row>, Settings)> {
    let failed = |at: usize, problem: String| {
        let (line, column) = place(text, at);
        Error::Study {
            path: path.to_owned(),
            problem: format!("line {line}, column {column}: {problem}"),
            remedy: "mend it and run again".into(),
        }
    };
    let file: File = toml::from_str(text).map_err(|error| {
        let at = error.span().map_or(0, |span| span.start);
        failed(at, error.message().to_owned())
    })?;
    let samplers = |names: &[Spanned<String>]| -> Result<Vec<Sampler>> {
        let one = |name: &Spanned<String>| {
            Sampler::parse(name.get_ref())
                .map_err(|error| failed(name.span().start, error.to_string()))
        };
        names.iter().map(one).collect()
    };
    let common = samplers(&file.samplers)?;
    let mut all = Vec::new();
    for entry in &file.integrand {
        let at = entry.name.span().start;
        let own = samplers(&entry.samplers)?;
        let tried = if own.is_empty() { &common } else { &own };
        if tried.is_empty() {
            let problem = format!("{} has no samplers", entry.name.get_ref());
            return Err(failed(at, problem));
        }
        let name = entry.name.get_ref();
        if entry.estimators.is_empty() {
            let made = rows(name, &[], tried);
            all.extend(made.map_err(|error| failed(at, error.to_string()))?);
        }
        for estimator in &entry.estimators {
            let made = rows(name, std::slice::from_ref(estimator.get_ref()), tried);
            let at = estimator.span().start;
            all.extend(made.map_err(|error| failed(at, error.to_string()))?);
        }
    }
    let default = Settings::default();
    let settings = Settings {
        min_count: file.min_count.unwrap_or(default.min_count),
        max_count: file.max_count.unwrap_or(default.max_count),
        replicates: file.replicates.unwrap_or(default.replicates),
        seed: file.seed.unwrap_or(default.seed),
        targets: file.targets.unwrap_or(default.targets),
    };
    Ok((all, settings))
}

/// Line and column of a byte, both counted from 1.
fn place(text: &str, at: usize) -> (usize, usize) {
    let before = text.get(..at).unwrap_or(text);
    let line = before.matches('\n').count() + 1;
    let start = before.rfind('\n').map_or(0, |newline| newline + 1);
    (
        line,
        before.get(start..).map_or(0, |rest| rest.chars().count()) + 1,
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    fn said(text: &str) -> String {
        parse(text, Path::new("study.toml"))
            .unwrap_err()
            .to_string()
    }

    #[test]
    fn the_default_study_is_six_by_six() {
        let (rows, settings) = parse(DEFAULT, Path::new("default")).unwrap();
        assert_eq!(settings, Settings::default());
        assert_eq!(rows.len(), 6);
        assert!(rows.iter().all(|row| row.samplers.len() == 6));
    }

    #[test]
    fn what_is_wrong_is_named_with_its_place() {
        let text = said("replicates = 32\nreplicats = 4\n");
        assert!(
            text.contains("line 2, column 1") && text.contains("replicats"),
            "{text}"
        );
        let text = said("samplers = [\"random\",\n  \"sobl\"]\n");
        assert!(
            text.contains("line 2, column 3") && text.contains("`sobol`"),
            "{text}"
        );
        let text = said("samplers = [\"random\"]\n[[integrand]]\nname = \"x-cubed\"\n");
        assert!(
            text.contains("line 3, column 8") && text.contains("x-squared"),
            "{text}"
        );
        let text = said("[[integrand]]\nname = \"x-squared\"\n");
        assert!(text.contains("no samplers"), "{text}");
        assert!(said("seed = -1").contains("line 1, column 8"));
        assert!(said("seed = ").contains("line 1"));
    }
}
