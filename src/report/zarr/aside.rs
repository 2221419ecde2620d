//! Small files and chunks of a store, which come to their names whole, in a folder that all
//! writers share: each writes the same bytes, or those that come first stay.

use crate::error::Result;
use crate::report::aside::{Aside, ENDING};
use crate::report::place::failed;
use std::fs;
use std::path::Path;

/// Writes a file aside, in `folder`, waits until it is on the disk, and gives it its name.
pub(super) fn save(folder: &Path, path: &Path, bytes: &[u8]) -> Result<()> {
    filled(folder, path, bytes)?.commit()
}

/// The same where a file of that name that is there must stay.
pub(super) fn save_first(folder: &Path, path: &Path, bytes: &[u8]) -> Result<()> {
    filled(folder, path, bytes)?.commit_first()
}

fn filled(folder: &Path, path: &Path, bytes: &[u8]) -> Result<Aside> {
    let aside = Aside::create_in(folder, path, path.to_owned());
    let mut aside = aside.map_err(|error| failed("create", path, error))?;
    aside.fill(bytes)?;
    Ok(aside)
}

/// Removes what killed processes have left.
pub(super) fn sweep(folder: &Path) -> Result<()> {
    let entries = fs::read_dir(folder).map_err(|error| failed("read", folder, error))?;
    for entry in entries.flatten() {
        if entry.file_name().to_string_lossy().ends_with(ENDING) {
            // About one that will not go nothing can be done.
            let _ = fs::remove_file(entry.path());
        }
    }
    Ok(())
}
