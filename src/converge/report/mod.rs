//! The report of a study: a page, figures, a document and a table.

mod figures;
mod method;
mod page;
mod section;
mod summary;
mod words;

use super::{Results, Series};
use crate::plot::to_png;
use crate::{Error, Result, report};
use figures::Pair;
use std::path::{Path, PathBuf};

/// Pixels of a PNG for one of its SVG.
const SCALE: f32 = 2.0;

/// Writes the report of a study into a folder, which must exist; gives the files, each of which
/// is replaced whole: `report.html`, the figures as SVG and PNG, `results.json` and
/// `results.csv`. The same results give the same bytes.
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
    let mut parts: Vec<(&str, Vec<&Series>, Vec<Pair>)> = Vec::new();
    for (index, (integrand, group)) in results.by_integrand().into_iter().enumerate() {
        let pairs = figures::pairs(results, index, &group)?;
        for figure in pairs.iter().flat_map(|pair| &pair.figures) {
            save(&format!("{}.svg", figure.name), figure.svg.as_bytes())?;
            save(
                &format!("{}.png", figure.name),
                &to_png(&figure.svg, SCALE)?,
            )?;
        }
        parts.push((integrand, group, pairs));
    }
    save("report.html", page::page(results, &parts).as_bytes())?;
    Ok(files)
}
