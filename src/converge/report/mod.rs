//! The report of a study: a page, figures, a document and a table.

mod earlier;
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

/// The document of a report.
const DOCUMENT: &str = "results.json";

/// Writes the report of a study into a folder, which must exist; gives the files, each of which
/// is replaced whole: the figures as SVG and PNG, `results.csv`, `report.html` and
/// `results.json`, which names them all. Figures that a report before it in this folder names,
/// and this one does not have, are removed; nothing else is. The same results give the same
/// bytes.
///
/// # Errors
/// [`Error::Output`] and [`Error::Io`] for a file that cannot be written, or an old figure that
/// cannot be removed; those of [`check_folder`].
pub fn write(results: &Results, folder: &Path) -> Result<Vec<PathBuf>> {
    check_folder(folder)?;
    let earlier = earlier::figures(folder);
    let mut names: Vec<String> = Vec::new();
    let mut save = |name: &str, bytes: &[u8]| -> Result<()> {
        report::save(&folder.join(name), bytes)?;
        names.push(name.to_owned());
        Ok(())
    };
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
    save("results.csv", results.csv().as_bytes())?;
    save("report.html", page::page(results, &parts).as_bytes())?;
    names.push(DOCUMENT.to_owned());
    // The document last: until then the one before names the figures that may be left.
    earlier::remove(folder, &earlier, &names)?;
    report::save(
        &folder.join(DOCUMENT),
        document(results, &names, folder)?.as_bytes(),
    )?;
    Ok(names.iter().map(|name| folder.join(name)).collect())
}

/// That [`write()`] may replace the page in a folder: for what takes long before there is something
/// to write.
///
/// # Errors
/// [`Error::Output`] for a folder with the report card of a device, whose page has the same name.
pub fn check_folder(folder: &Path) -> Result<()> {
    report::CARD.refuse(folder)
}

/// The document with the names of the report's files.
fn document(results: &Results, names: &[String], folder: &Path) -> Result<String> {
    let mut document = results.document();
    if let Some(object) = document.as_object_mut() {
        object.insert("files".to_owned(), names.into());
    }
    let text = serde_json::to_string_pretty(&document).map_err(|error| Error::Output {
        path: folder.join(DOCUMENT),
        problem: error.to_string(),
        remedy: "report this".into(),
    })?;
    Ok(text + "\n")
}
