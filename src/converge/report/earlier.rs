//! Figures of an earlier report that a new one in the same folder does not have.

use crate::report::{STUDY, read_json};
use crate::{Error, Result};
use serde_json::Value;
use std::path::Path;

/// Bytes of a document at most.
const MOST: u64 = 1 << 30;

/// The figures that the report in a folder says it wrote; none where there is none of this form.
/// Other names in it are not believed: a report's figures are called `01-name-time.svg` and so on.
pub fn figures(folder: &Path) -> Vec<String> {
    let document = read_json(&folder.join(STUDY.document), MOST, "").unwrap_or(Value::Null);
    let schema = document.get("schema").and_then(Value::as_str);
    if !schema.is_some_and(|schema| schema.starts_with(STUDY.schema)) {
        return Vec::new();
    }
    let files = document.get("files").and_then(Value::as_array);
    let names = files.into_iter().flatten().filter_map(Value::as_str);
    names
        .filter(|name| is_figure(name))
        .map(str::to_owned)
        .collect()
}

/// Whether a name is one that [`figures`](super::figures) gives: no path is.
fn is_figure(name: &str) -> bool {
    let stem = name
        .strip_suffix(".svg")
        .or_else(|| name.strip_suffix(".png"));
    let stem = stem.and_then(|stem| {
        let points = stem.strip_suffix("-points");
        points.or_else(|| stem.strip_suffix("-time"))
    });
    let plain = |c: char| c.is_ascii_digit() || c.is_ascii_lowercase() || c == '-';
    stem.is_some_and(|stem| {
        let digits = stem.chars().take_while(char::is_ascii_digit).count();
        digits >= 2 && stem.chars().all(plain)
    })
}

/// Removes those of the names that the new report does not have.
///
/// # Errors
/// [`Error::Io`] for one that cannot be removed.
pub fn remove(folder: &Path, names: &[String], kept: &[String]) -> Result<()> {
    for name in names.iter().filter(|name| !kept.contains(name)) {
        let path = folder.join(name);
        // Whatever else has such a name is none of ours.
        if !path.symlink_metadata().is_ok_and(|found| found.is_file()) {
            continue;
        }
        match std::fs::remove_file(&path) {
            Err(source) if source.kind() != std::io::ErrorKind::NotFound => {
                return Err(Error::Io {
                    action: "remove",
                    path,
                    source,
                });
            }
            _ => {}
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::is_figure;

    #[test]
    fn only_names_of_figures_are_believed() {
        for name in ["01-one-time.svg", "112-a-b-2-mis-points.png"] {
            assert!(is_figure(name), "{name}");
        }
        for name in [
            "../01-one-time.svg",
            "01-a/b-time.svg",
            "thesis.svg",
            "1-one-time.svg",
            "01-one-time.txt",
            "01-one.svg",
            "01-ONE-time.svg",
            "",
        ] {
            assert!(!is_figure(name), "{name}");
        }
    }
}
