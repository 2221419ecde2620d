//! The vectors as files.

use super::{Entry, Table, document, each};
use crate::Result;
use crate::report::{create_folder, save};
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

macro_rules! source {
    ($name:literal) => {
        (
            concat!($name, ".comp"),
            include_str!(concat!("../../shaders/kernels/", $name, ".comp")),
        )
    };
}

/// The kernels that evaluate functions: what the words of their files mean.
const SOURCES: [(&str, &str); 9] = [
    source!("evaluate"),
    source!("evaluate_blue_noise"),
    source!("evaluate_discrete"),
    source!("evaluate_domain"),
    source!("evaluate_elementary"),
    source!("evaluate_net"),
    source!("evaluate_random"),
    source!("evaluate_real"),
    source!("evaluate_strata"),
];

/// Writes every table and kernel, and `vectors.json` last; gives the files. `watch` sees each
/// entry and may stop. Each file is whole or not there.
///
/// # Errors
/// [`crate::Error::Output`] and [`crate::Error::Io`] for what cannot be written, and those of `watch`.
pub fn write(folder: &Path, watch: &mut dyn FnMut(&Entry) -> Result<()>) -> Result<Vec<PathBuf>> {
    let mut files = Vec::new();
    let mut folders = BTreeSet::new();
    let mut put = |name: &str, bytes: &[u8]| -> Result<()> {
        let path = folder.join(name);
        if let Some(parent) = path.parent()
            && folders.insert(parent.to_owned())
        {
            create_folder(parent, "--out")?;
        }
        save(&path, bytes)?;
        files.push(path);
        Ok(())
    };
    for (name, text) in SOURCES {
        put(&format!("kernels/{name}"), text.as_bytes())?;
    }
    let mut entries = Vec::new();
    each(&mut |entry| {
        watch(entry)?;
        for table in entry.table.iter().chain(&entry.tables) {
            put(&table.file, &Table::bytes(table))?;
        }
        entries.push(entry.json());
        Ok(())
    })?;
    let manifest = format!("{:#}\n", document(entries));
    put("vectors.json", manifest.as_bytes())?;
    Ok(files)
}
