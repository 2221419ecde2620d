//! The report of a study: a page, figures, a document and a table.

use super::Results;
use crate::{Error, Result, report};
use std::path::{Path, PathBuf};

/// Writes the report of a study into a folder, which must exist; gives the files, each of which
/// is replaced whole.
///
/// # Errors
/// [`Error::Output`] and [`Error::Io`] for a file that cannot be written.
pub fn write(results: &Results, folder: &Path) -> Result<Vec<PathBuf>> {
    let mut document =
        serde_json::to_string_pretty(&results.document()).map_err(|error| Error::Output {
            path: folder.join("results.json"),
            problem: error.to_string(),
            remedy: "report this".into(),
        })?;
    document.push('\n');
    let mut files = Vec::new();
    let mut save = |name: &str, bytes: &[u8]| -> Result<()> {
        let path = folder.join(name);
        report::save(&path, bytes)?;
        files.push(path);
        Ok(())
    };
    save("results.json", document.as_bytes())?;
    save("results.csv", results.csv().as_bytes())?;
    Ok(files)
}
